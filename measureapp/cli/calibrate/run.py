"""`calibrate run`: a connected rig takes the images of all its calibrations, and they are solved together."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.collect_answer import verdict_answer
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import BoardChoice
from measureapp.cli.calibrate.rig import rig_answer
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import report_event
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.data.board import AnyBoard
    from measureapp.pipeline.events import Event
    from measureapp.pipeline.rig_calibration import CalibratedRig

PlanOption = Annotated[Path | None, typer.Option("--plan", help="Scan plan: the board is also taken from its robot poses.")]


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def run(
        rig: Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")],
        project: Annotated[
            Path, typer.Option("--project", help="Project folder, new or of this rig; views stored there are not taken again.")
        ],
        board: BoardChoice,
        plan: PlanOption = None,
        as_json: JsonOption = False,
    ) -> None:
        """Let a connected rig take images of the board on its table from all sides, and calibrate cameras, hand-eye, guide and axis.

        Fix the board in the centre of the table first, tilted towards the robot. Started again after a stop, the command takes the
        missing views only. Exit code 1 if the verdict on the calibration is bad.
        """
        from measureapp.devices.recorded_rig import require_devices
        from measureapp.pipeline.rig_calibration import CalibrationRequest, calibrate_into_project
        from measureapp.project.plan_file import read_plan
        from measureapp.project.rig_file import read_rig

        description = read_rig(rig)
        require_devices(description)
        request = CalibrationRequest(description, project, None if plan is None else read_plan(plan), _board_of(board))
        calibrated, kept_in = calibrate_into_project(request, _report, TerminalProgress())
        reply(run_answer(calibrated, kept_in.path), "\n".join(run_lines(calibrated)), as_json)
        if calibrated.solved.verdict.level == "bad":
            raise typer.Exit(OUT_OF_TOLERANCE)


def _report(event: Event) -> None:
    """Print events but the calibration itself: the answer states it with everything that limits it."""
    from measureapp.pipeline.events import CalibrationReady

    if not isinstance(event, CalibrationReady):
        report_event(event)


def _board_of(board: BoardChoice) -> AnyBoard | None:
    """Return the board; None where no option names one. Raises InputError."""
    return None if board == BoardChoice() else board.description()  # type: ignore[return-value]


def run_answer(calibrated: CalibratedRig, project: Path) -> dict[str, Any]:
    """Return the JSON answer: that of `calibrate rig`, the verdict, the cameras and the views."""
    solved = calibrated.solved
    cameras = solved.solution.calibration.cameras
    return {
        **rig_answer(solved.solution),
        "project": project,
        "verdict": verdict_answer(solved.verdict),
        "cameras": {
            name: {"matrix": one.pinhole.matrix, "distortion": one.pinhole.distortion, "rms_px": one.rms_px}
            for name, one in cameras.cameras.items()
        },
        "views": {
            "taken": calibrated.taken,
            "kept": calibrated.kept,
            "failed": {one.viewpoint_id: one.reason for one in calibrated.failed},
            "without_board": dict(calibrated.unseen),
        },
        "images_rejected": [{"image": one.id, "camera": one.camera, "reason": one.reason} for one in solved.refused],
    }


def run_lines(calibrated: CalibratedRig) -> list[str]:
    """Return the answer for people."""
    solved = calibrated.solved
    lines = [f"{len(calibrated.taken)} views taken, {len(calibrated.kept)} stored before.", solved.verdict.sentence]
    lines += [f"  {solved.verdict.reason}", *([f"  {solved.verdict.remedy}"] if solved.verdict.remedy else [])]
    lines += [f"  but: {reason}" for reason in solved.verdict.reasons]
    lines += [f"  not determined: {what}" for what in solved.solution.not_observable]
    lines += [f"  failed: {one.viewpoint_id}: {one.reason}" for one in calibrated.failed]
    return lines + [f"  no board: {name}: {reason}" for name, reason in calibrated.unseen.items()]
