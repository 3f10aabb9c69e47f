"""`calibrate cameras`: lenses and places of 1…n cameras from images of a board."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.camera_corners import CornerSource
from measureapp.cli.calibrate.camera_quality import quality_answer, quality_lines, quality_of, write_map
from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.made_from import MadeFrom, made_from
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import OutOption
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.calibrate.cameras.array import CameraArraySolution
    from measureapp.data.calibration import CameraArrayCalibration


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def cameras(
        ctx: typer.Context,
        source: CornerSource,
        asked: RequiredLimits,
        out: OutOption = None,
        standoff_mm: Annotated[float | None, typer.Option(help="Distance at which parts are measured; default: that of the board.")] = None,
        uncertainty_map: Annotated[Path | None, typer.Option(help="npz to write the uncertainty map to; a PNG goes beside it.")] = None,
        corners_out: Annotated[
            Path | None, typer.Option(help="File for the corners found, to solve again with --corners.", dir_okay=False)
        ] = None,
        temperature_c: Annotated[float | None, typer.Option(help="Temperature when the images were taken.")] = None,
        valid_days: Annotated[float | None, typer.Option(help="Days after which the calibration expires.", min=0)] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Calibrate lenses and relative poses of all cameras, and state the uncertainty of the result."""
        from measureapp.calibrate.cameras.array import solve
        from measureapp.calibrate.rig.limits import camera_limits
        from measureapp.progress import PartOf
        from measureapp.project.calibration.camera_file import write_cameras
        from measureapp.project.calibration.camera_inputs import write_camera_inputs

        wanted, progress = asked.values(("shape",)), TerminalProgress()
        inputs = source.inputs(PartOf(progress, 0.0, 0.6))
        solved = solve(inputs.problem, PartOf(progress, 0.6, 0.7))
        solution = _with_date(solved, source.serials(tuple(inputs.problem.sizes_px)), temperature_c, valid_days)
        quality = quality_of(inputs.problem, solution, standoff_mm, PartOf(progress, 0.7, 1.0))
        written: dict[str, Path] = {}
        if uncertainty_map is not None:
            written |= write_map(uncertainty_map, quality)
        if corners_out is not None:
            write_camera_inputs(corners_out, inputs)
            written["corners"] = corners_out
        if out is not None:
            write_cameras(out, _with_inputs(solution.calibration, made_from(ctx, out)))
            written["cameras"] = out
        limits = camera_limits(quality.uncertainty, wanted)
        document = cameras_answer(solution, inputs.images) | quality_answer(quality) | limits_answer(limits) | {"files": written}
        lines = [*_lines(solution, document), *quality_lines(quality), *limit_lines(limits), *_saved_lines(written)]
        reply(document, "\n".join(lines), as_json)
        asked.exit_unless_met(limits)


def _saved_lines(files: Mapping[str, Path]) -> list[str]:
    return [f"Saved to {path}" for path in files.values()]


def _with_inputs(calibration: CameraArrayCalibration, made: MadeFrom) -> CameraArrayCalibration:
    from dataclasses import replace

    return replace(
        calibration,
        provenance=replace(calibration.provenance, inputs=made.inputs, arguments=made.arguments, folder=made.folder),
    )


def _with_date(
    solution: CameraArraySolution, serials: Mapping[str, str], temperature_c: float | None, valid_days: float | None
) -> CameraArraySolution:
    """Return the solution with today's date and the cameras' serial numbers."""
    from dataclasses import replace

    provenance = replace(
        solution.calibration.provenance,
        created=datetime.now(UTC).isoformat(timespec="seconds"),
        temperature_c=temperature_c,
        valid_days=valid_days,
    )
    cameras = {name: replace(camera, serial=serials.get(name, "")) for name, camera in solution.calibration.cameras.items()}
    return replace(solution, calibration=replace(solution.calibration, cameras=cameras, provenance=provenance))


def cameras_answer(solution: CameraArraySolution, images: Mapping[tuple[str, str], str]) -> dict[str, Any]:
    """Return the JSON answer of a solution. ``images`` names the file of each (camera, view)."""
    calibration = solution.calibration
    return {
        "reference": calibration.reference,
        "rms_px": {name: camera.rms_px for name, camera in calibration.cameras.items()} | dict(calibration.pair_rms_px),
        "joint_rms_px": solution.joint_rms_px,
        "blur_px": {name: camera.blur_px for name, camera in calibration.cameras.items()},
        "corner_sigma_px": solution.sigma_px,
        "corner_sigmas_px": dict(solution.sigmas_px),
        "cameras": {name: _parameters(solution, name) for name in calibration.names},
        "pairs": _pairs(solution),
        "loops": [{"cameras": loop.cameras, "angle_deg": loop.angle_deg, "distance_mm": loop.distance_mm} for loop in solution.loops],
        "views": [
            {
                "camera": view.camera,
                "view": view.view,
                "image": images[view.camera, view.view],
                "rms_px": view.rms_px,
                "corners": view.corners,
            }
            for view in solution.views
        ],
        "rejected": [
            {"camera": one.camera, "view": one.view, "image": images[one.camera, one.view], "reason": one.reason}
            for one in solution.rejected
        ],
        "rejected_corners": [
            {
                "camera": one.camera,
                "view": one.view,
                "image": images[one.camera, one.view],
                "corner": one.corner,
                "distance_px": one.distance_px,
                "reason": one.reason,
            }
            for one in solution.rejected_corners
        ],
    }


def _parameters(solution: CameraArraySolution, name: str) -> dict[str, Any]:
    from measureapp.calibrate.projection import intrinsic_names

    camera = solution.calibration.cameras[name]
    matrix, distortion = camera.pinhole.matrix, camera.pinhole.distortion
    values = dict(zip(intrinsic_names(len(distortion)), [matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], *distortion], strict=True))
    place = camera.reference_from_camera
    values |= dict(
        zip(
            ("rotation_x_rad", "rotation_y_rad", "rotation_z_rad", "x_mm", "y_mm", "z_mm"),
            [*place.rotation_vector, *place.translation_mm],
            strict=True,
        )
    )
    deviations = camera.standard_deviations
    return {
        "width": camera.pinhole.width_px,
        "height": camera.pinhole.height_px,
        "matrix": matrix,
        "distortion": distortion,
        "reference_from_camera": place.matrix,
        "parameters": {key: {"value": value, "standard_deviation": deviations.get(key, 0.0)} for key, value in values.items()},
    }


def _pairs(solution: CameraArraySolution) -> dict[str, Any]:
    import numpy as np

    from measureapp.calibrate.cameras.array import left_from_right

    pairs = {}
    for pair, rms_px in solution.calibration.pair_rms_px.items():
        names = [name for name in solution.calibration.cameras if pair.startswith(f"{name}-")]
        left = max(names, key=len)
        transform = left_from_right(solution.calibration, left, pair.removeprefix(f"{left}-"))
        pairs[pair] = {
            "rms_px": rms_px,
            "left_from_right": transform.matrix,
            "baseline_mm": float(np.linalg.norm(transform.translation_mm)),
            "angle_deg": float(np.rad2deg(transform.angle_rad)),
        }
    return pairs


def _lines(solution: CameraArraySolution, document: dict[str, Any]) -> list[str]:
    lines = [f"Joint rms {solution.joint_rms_px:.3f} px over {len(solution.views)} views of {len(solution.calibration.cameras)} cameras."]
    for name, entry in document["cameras"].items():
        focal = entry["parameters"]["fx"]
        lines.append(f"  {name}: fx {focal['value']:.2f} ± {focal['standard_deviation']:.2f} px, rms {document['rms_px'][name]:.3f} px")
        if document["blur_px"][name]:
            lines[-1] += f", blur {document['blur_px'][name]:.2f} px"
    for pair, entry in document["pairs"].items():
        lines.append(f"  {pair}: baseline {entry['baseline_mm']:.3f} mm, {entry['angle_deg']:.3f}°, rms {entry['rms_px']:.3f} px")
    for loop in document["loops"]:
        lines.append(f"  loop {' → '.join(loop['cameras'])}: {loop['angle_deg']:.4f}°, {loop['distance_mm']:.3f} mm")
    lines += [f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["rejected"]]
    lines += [
        f"  corner {one['corner']} rejected: {one['image']} ({one['camera']}): it {one['reason']}" for one in document["rejected_corners"]
    ]
    return lines
