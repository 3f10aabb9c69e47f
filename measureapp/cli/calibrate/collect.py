"""`calibrate collect`: everything a calibration wizard does, with recorded images: collect, remove, undo, get guidance, solve, compare, accept."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.calibrate.collect_options import Recorded, SessionStart, Steps
from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.calibrate.options import BoardSource
from measureapp.cli.calibrate.pose_options import RobotNoise
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import JsonOption, TerminalProgress, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    @with_groups
    def collect(
        kind: Annotated[str, typer.Argument(help="cameras, projector, axis, hand-eye, guide or rig.")],
        session: Annotated[Path, typer.Option(help="Folder of the session: a new one starts it, one that is there is continued.")],
        source: BoardSource,
        noise: RobotNoise,
        recorded: Recorded,
        start: SessionStart,
        steps: Steps,
        as_json: JsonOption = False,
    ) -> None:
        """Collect views of a board for one calibration, in a session that can be left and continued.

        In one call these follow in this order: undo, redo, images, remove, solve, compare, accept, guidance.
        """
        from measureapp.calibration_session.recorded import ReadbackFiles
        from measureapp.cli.calibrate.collect_answer import collect_lines
        from measureapp.cli.calibrate.collect_session import Given, Sources, limits_of, open_session
        from measureapp.cli.calibrate.collect_steps import run_steps
        from measureapp.project.folder_lock import lock_folder

        limits = limits_of(steps.good_mm, steps.usable_mm)
        readbacks = ReadbackFiles(recorded.robot_poses, recorded.guide_positions, recorded.angles)
        sources = Sources(tuple(source.images or ()), tuple(recorded.fringes or ()), recorded.views, readbacks)
        collected = open_session(session, Given(kind, source.board, source.cameras, start, noise.axis_noise()), sources)
        with lock_folder(collected.folder):
            done = run_steps(steps, limits, collected, sources, TerminalProgress())
        reply(done.document, "\n".join(collect_lines(done.document)), as_json)
        if not done.within:
            raise typer.Exit(OUT_OF_TOLERANCE)
