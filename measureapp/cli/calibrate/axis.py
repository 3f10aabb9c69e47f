"""`calibrate axis`: the table's rotation axis in the reference camera's frame."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardSource
from measureapp.cli.reply import TerminalProgress, triple
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Draft
    from measureapp.calibrate.motions.axis_diagnostics import AxisDiagnostics
    from measureapp.calibrate.motions.rotation_axis import AxisEstimate, AxisProblem, AxisSolution
    from measureapp.cli.calibrate.observed_files import ObservedFiles
    from measureapp.progress import Progress


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def axis(
        ctx: typer.Context,
        source: BoardSource,
        asked: RequiredLimits,
        answer: Answer,
        corners: Annotated[Path | None, typer.Option(help="Corners: position,corner,x_mm,y_mm,z_mm[,angle_deg].")] = None,
        angles: Annotated[Path | None, typer.Option(help="Table angles: position,angle_deg, in the order of the images.")] = None,
        power: Annotated[float, typer.Option(help="p of the distance weighting, above 1.")] = 2.0,
        free_angles: Annotated[bool, typer.Option("--free-angles", help="Estimate the angles as well.")] = False,
        closure_radius_mm: Annotated[float, typer.Option(min=1e-3, help="Radius at which the closure is reported, mm.")] = 250.0,
    ) -> None:
        """Find the rotation axis by least squares, distance weighting and maximum likelihood."""
        from dataclasses import replace

        from measureapp.calibrate.kinds.axis import solve_draft
        from measureapp.calibrate.motions.inlier_solutions import solve_axis
        from measureapp.calibrate.motions.rotation_axis import AxisOptions
        from measureapp.calibrate.rig.limits import axis_limits

        if not 1 < power < 100:
            raise InputError(f"--power {power:g} is not above 1.", "The paper's weighting needs p > 1; 2 is usual.")
        if (corners is None) == (not source.images):
            raise InputError("Give either --corners or --images.", "With --images also --cameras, --board and --square-mm.")
        wanted, progress = asked.values(("axis direction", "axis position")), TerminalProgress()
        options, rejected = AxisOptions(power, free_angles, closure_radius_mm), list[dict[str, Any]]()
        if corners is not None:
            found = solve_axis(replace(_from_corners(corners, angles), options=options))
            solution, moved = found.solution, {str(index): reason for index, reason in found.rejected.items()}
        else:
            seen, draft = _from_images(source, angles, progress)
            with seen.explain_failure():
                solved = solve_draft(draft, progress, options)
            solution, (rejected, moved) = solved.solution, seen.outcome(solved)
        limits = axis_limits(solution, wanted)
        document = axis_answer(solution, solution.best.axis.frame) | limits_answer(limits) | {"rejected": rejected, "moved": moved}
        answer.give(ctx, document, [*_lines(document), *limit_lines(limits)])
        asked.exit_unless_met(limits)


def _from_corners(corners: Path, angles: Path | None) -> AxisProblem:
    import numpy as np

    from measureapp.calibrate.motions.rotation_axis import AxisProblem
    from measureapp.project.tables import read_angles, read_corners

    table = read_corners(corners)
    known = table.angles_rad
    if angles is not None:
        given = list(read_angles(angles).values())
        if len(given) != len(table.corners_mm):
            raise InputError(f"{angles} has {len(given)} angles for {len(table.corners_mm)} positions.", "Give one angle per position.")
        known = np.array(given)
    return AxisProblem(table.corners_mm, known)


def _from_images(source: BoardSource, angles: Path | None, progress: Progress) -> tuple[ObservedFiles, Draft]:
    from measureapp.calibrate.draft.draft import Setup
    from measureapp.calibrate.kinds.table import KINDS
    from measureapp.cli.calibrate.observed_files import observe_files
    from measureapp.data.fringe import Readback
    from measureapp.project.tables import read_angles

    readbacks = None if angles is None else {str(n): Readback(table_rad=one) for n, one in enumerate(read_angles(angles).values())}
    seen = observe_files(source, "the rotation axis", progress, readbacks)
    return seen, seen.draft(Setup(KINDS["axis"], seen.board, seen.camera_names, seen.cameras))


def axis_answer(solution: AxisSolution, frame: str) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    document: dict[str, Any] = {name: _estimate(estimate) for name, estimate in solution.estimates.items()}
    if "distance_weighted" in document:
        document["distance_weighted"]["p"] = solution.power
    return document | {
        "refused": dict(solution.refused),
        "frame": frame,
        "positions": len(solution.best.angles_rad),
        "sweep_deg": math.degrees(solution.sweep_rad),
        "diagnostics": _diagnostics(solution.diagnostics),
        "warnings": list(solution.warnings),
    }


def _diagnostics(diagnostics: AxisDiagnostics) -> dict[str, Any]:
    import numpy as np

    arcs, closure = diagnostics.arcs, diagnostics.closure
    return {
        "arcs": {
            "radii_mm": arcs.radii_mm,
            "lengths_mm": arcs.lengths_mm,
            "centre_sigma_mm": arcs.centre_sigma_mm,
            "corner_sigma_mm": arcs.point_sigma_mm,
        },
        "closure": {
            "board_mm": closure.board_mm,
            "positions_mm": closure.positions_mm,
            "radius_mm": closure.radius_mm,
            "at_radius_mm": closure.at_radius_mm,
            "angles_were_read": closure.angles_were_read,
        },
        "wobble_deg": {"rms": math.degrees(np.sqrt(np.mean(closure.wobble_rad**2))), "positions": np.degrees(closure.wobble_rad)},
        "angle_error_deg": {
            "rms": math.degrees(np.sqrt(np.mean(closure.angle_error_rad**2))),
            "positions": np.degrees(closure.angle_error_rad),
        },
    }


def _estimate(estimate: AxisEstimate) -> dict[str, Any]:
    import numpy as np

    axis = estimate.axis
    return {
        "direction": axis.direction,
        "point_mm": axis.point_mm,
        "residuals": {
            "rms_mm": axis.residual_mm,
            "radial_mm": float(np.sqrt(np.mean(estimate.radial_mm**2))),
            "axial_mm": float(np.sqrt(np.mean(estimate.axial_mm**2))),
            "positions": [
                {"angle_deg": math.degrees(angle), "radial_mm": float(radial), "axial_mm": float(axial)}
                for angle, radial, axial in zip(estimate.angles_rad, estimate.radial_mm, estimate.axial_mm, strict=True)
            ],
        },
        "standard_deviations": {"direction_deg": math.degrees(axis.direction_sigma_rad), "point_mm": axis.point_sigma_mm},
    }


def _lines(document: dict[str, Any]) -> list[str]:
    lines = [f"Rotation axis from {document['positions']} positions over {document['sweep_deg']:.1f}°, in frame {document['frame']}:"]
    for name in ("least_squares", "distance_weighted", "maximum_likelihood"):
        if name in document:
            entry = document[name]
            direction, point = triple(entry["direction"], 6), triple(entry["point_mm"], 3)
            deviations = entry["standard_deviations"]
            lines.append(
                f"  {name:<19} direction {direction} ± {deviations['direction_deg']:.4f}°, point {point} ± {deviations['point_mm']:.4f} mm, "
                f"residual {entry['residuals']['rms_mm']:.4f} mm"
            )
    closure, arcs = document["diagnostics"]["closure"], document["diagnostics"]["arcs"]
    lines.append(
        f"  turned back by the {'table' if closure['angles_were_read'] else 'estimated'} angles: {closure['board_mm']:.4f} mm at the board, "
        f"{closure['at_radius_mm']:.4f} mm at radius {closure['radius_mm']:.0f} mm; wobble {document['diagnostics']['wobble_deg']['rms']:.4f}°"
    )
    lines.append(
        f"  arcs of radius {min(arcs['radii_mm']):.1f} to {max(arcs['radii_mm']):.1f} mm, centres ± {max(arcs['centre_sigma_mm']):.4f} mm"
    )
    lines += [f"  {name}: {reason}" for name, reason in document["refused"].items()]
    lines += [f"  rejected: position {name}: {reason}" for name, reason in document["moved"].items()]
    lines += [f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["rejected"]]
    return lines + [f"  {warning}" for warning in document["warnings"]]
