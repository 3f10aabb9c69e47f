"""`calibrate rig`: hand-eye, guide and axis in one joint solution."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.limits import RequiredLimits, limit_lines, limits_answer
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import Answer, BoardSource
from measureapp.cli.calibrate.pose_options import RigTables, RobotNoise, observe_rig
from measureapp.cli.reply import TerminalProgress

if TYPE_CHECKING:
    from measureapp.calibrate.rig.joint_solution import RigSolution
    from measureapp.calibrate.rig.stages import RigStages


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def rig(
        ctx: typer.Context,
        tables: RigTables,
        source: BoardSource,
        robot: RobotNoise,
        asked: RequiredLimits,
        answer: Answer,
        table_sigma_arcsec: Annotated[float, typer.Option(min=1e-6, help="Standard deviation of table angles, seconds of arc.")] = 10.0,
    ) -> None:
        """Find hand-eye transform, guide and rotation axis together from images of one board fixed on the table."""
        from measureapp.calibrate.draft.draft import Setup
        from measureapp.calibrate.draft.solve import solve
        from measureapp.calibrate.kinds.table import KINDS
        from measureapp.calibrate.rig.limits import IN_RIG, rig_limits

        wanted, progress = asked.values(tuple(IN_RIG)), TerminalProgress()
        seen = observe_rig(tables, source, "the calibration of the rig", progress)
        setup = Setup(KINDS["rig"], seen.board, seen.camera_names, seen.cameras, noise=robot.axis_noise(table_sigma_arcsec))
        with seen.explain_failure():
            solved = solve(seen.draft(setup), progress)
        solution, (rejected, _) = solved.solution, seen.outcome(solved)
        carried_on = {"camera_uncertainty_carried_on": seen.cameras.covariance is not None}
        limits = rig_limits(solution, wanted)
        document = rig_answer(solution) | limits_answer(limits) | carried_on | {"images_rejected": rejected}
        answer.give(ctx, document, _lines(document, limit_lines(limits)))
        asked.exit_unless_met(limits)


def rig_answer(solution: RigSolution) -> dict[str, Any]:
    """Return the JSON answer of a solution."""
    from measureapp.project.documents import link_document

    motions = solution.calibration.motions
    return _parts(solution.calibration) | {
        "stages": _parts(solution.stages),
        "guide_from_board": solution.guide_from_board.matrix,
        "standard_deviations": dict(solution.standard_deviations),
        "parameters": list(solution.parameters),
        "covariance": solution.covariance,
        "sigma_ratio": solution.sigma_ratio,
        "paper_cost_mm": solution.paper_cost_mm,
        "not_observable": list(solution.not_observable),
        "warnings": list(solution.warnings),
        "weak_directions": [
            {"sentence": one.sentence, "sigma_mm": one.sigma_mm, "parameters": dict(zip(one.parameters, one.components, strict=True))}
            for one in solution.weak_directions
        ],
        "error_motions": None if motions is None else link_document(motions),
        "error_motions_words": [] if motions is None else motions.sentences,
        "stop_scatter_mm": solution.chain.noise.stop_mm,
        "stations": [{"read": one.read.matrix, "true": one.true.matrix} for one in solution.calibration.stations],
        "sightings": [
            {
                "name": one.name,
                "distance_mm": one.distance_mm,
                "angle_deg": one.angle_deg,
                "robot_error_mm": one.robot_error_mm,
                "robot_error_deg": one.robot_error_deg,
            }
            for one in solution.residuals
        ],
        "rejected": dict(solution.rejected),
    }


def _parts(solved: Any | RigStages) -> dict[str, Any]:
    return {
        "flange_from_camera": solved.hand_eye.flange_from_camera.matrix,
        "guide": {"direction": solved.guide.direction, "scale": solved.guide.scale},
        "axis": {"frame": solved.axis.frame, "direction": solved.axis.direction, "point_mm": solved.axis.point_mm},
    }


def _lines(document: dict[str, Any], limits: list[str]) -> list[str]:
    lines = [f"Rig from {len(document['sightings'])} sightings; residuals {document['sigma_ratio']:.2f} times what was expected."]
    lines += [f"  {name:<28} ± {value:.3g}" for name, value in document["standard_deviations"].items()]
    lines += limits
    lines += [f"  {words}" for words in document["error_motions_words"]]
    if document["stop_scatter_mm"] > 0:
        lines.append(f"  scatter from stop to stop: {1000 * document['stop_scatter_mm']:.1f} µm in every coordinate")
    lines.append(
        f"  a guide taken to run along +Y with scale 1 would have cost {document['paper_cost_mm']:.3f} mm over the travel of these views"
    )
    lines += [f"  {one['sentence']}" for one in document["weak_directions"]]
    lines += [f"  {warning}" for warning in document["warnings"]]
    lines += [f"  not observable: {what}" for what in document["not_observable"]]
    lines += [f"  rejected: {name}: {reason}" for name, reason in document["rejected"].items()]
    return lines + [f"  rejected: {one['image']} ({one['camera']}): {one['reason']}" for one in document["images_rejected"]]
