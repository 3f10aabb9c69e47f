"""`calibrate collect`: everything a calibration wizard does, with recorded images: collect, take out, undo, be coached, solve, compare, accept."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

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
        kind: Annotated[str, typer.Argument(help="cameras, axis, hand-eye, guide or rig.")],
        session: Annotated[Path, typer.Option(help="Folder of the session: a new one starts it, one that is there is continued.")],
        source: BoardSource,
        noise: RobotNoise,
        views: Annotated[
            Path | None, typer.Option(help="Project whose stored views of the board are added; board and axis errors are then its rig's.")
        ] = None,
        hand_eye: Annotated[Path | None, typer.Option(help="Calibrated hand-eye transform, for the guide.")] = None,
        robot_poses: Annotated[Path | None, typer.Option(help="base_from_flange: one line per board position.")] = None,
        guide_positions: Annotated[Path | None, typer.Option(help="Slide positions: one line per board position.")] = None,
        angles: Annotated[Path | None, typer.Option(help="Table angles: one line per board position.")] = None,
        reference: Annotated[str | None, typer.Option(help="Reference camera; default: the first given.")] = None,
        distortion: Annotated[int, typer.Option(help="Distortion coefficients: 4, 5 or 8.")] = 5,
        standoff_mm: Annotated[float | None, typer.Option(min=1e-3, help="Distance at which parts are measured.")] = None,
        remove: Annotated[list[str] | None, typer.Option(help="Observation to take out; once per observation.")] = None,
        undo: Annotated[bool, typer.Option("--undo", help="Take back the last change of the session.")] = False,
        redo: Annotated[bool, typer.Option("--redo", help="Do again what was undone last.")] = False,
        advise: Annotated[bool, typer.Option("--coach", help="Say what to show next.")] = False,
        solve: Annotated[bool, typer.Option("--solve", help="Solve what was collected, and judge it in mm.")] = False,
        validate: Annotated[bool, typer.Option("--validate", help="Solve, and check the cameras with views held back.")] = False,
        compare: Annotated[Path | None, typer.Option(help="Solve, and compare with a session or an earlier result.")] = None,
        accept: Annotated[Path | None, typer.Option(help="Solve afresh and write the result; for the rig a project or folder.")] = None,
        valid_days: Annotated[float | None, typer.Option(min=0, help="Days after which an accepted calibration expires.")] = None,
        good_mm: Annotated[float | None, typer.Option(help="Expanded uncertainty (k = 2) up to which the verdict is good, mm.")] = None,
        usable_mm: Annotated[
            float | None, typer.Option(help="The same up to which it is usable, mm; default: four times --good-mm.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Collect views of a board for one calibration, in a session that can be left and continued.

        In one call these follow in this order: undo, redo, images, remove, solve, compare, accept, coach.
        """
        from measureapp.cli.calibrate.collect_answer import collect_answer, collect_lines
        from measureapp.cli.calibrate.collect_session import Given, Sources, add_sources, limits_of, opened, previous_result
        from measureapp.pipeline import collecting
        from measureapp.progress import PartOf

        limits = limits_of(good_mm, usable_mm)
        progress = TerminalProgress()
        sources = Sources(tuple(source.images or ()), views, collecting.ReadbackFiles(robot_poses, guide_positions, angles))
        given = Given(kind, source.board, source.cameras, hand_eye, reference, distortion, standoff_mm, noise.axis_noise())
        collection = opened(session, given, sources)
        steps = {"undone": [collection.undo().observation] if undo else [], "redone": [collection.redo().observation] if redo else []}
        steps |= {"added": add_sources(collection, sources, PartOf(progress, 0.0, 0.6)), "removed": list(remove or ())}
        for name in remove or ():
            collection.remove(name)
        verdict, comparison = None, None
        if accept is not None:
            collecting.accept(collection, accept, PartOf(progress, 0.6, 0.8), valid_days=valid_days)
        elif solve or validate or compare is not None:
            collection.solve(PartOf(progress, 0.6, 0.8))
        if collection.solved is not None:
            held_back = collecting.check_held_back(collection, PartOf(progress, 0.8, 1.0)) if validate else None
            verdict = collecting.judge(collection, limits, held_back=held_back)
        if compare is not None:
            comparison = collecting.compare(previous_result(compare), collection)
        progress.report(1, 1)
        advice = collecting.coach(collection) if advise else None
        document = collect_answer(collection, steps, advice, verdict, comparison) | {"accepted": accept}
        reply(document, "\n".join(collect_lines(document)), as_json)
        if (verdict is not None and verdict.level == "bad") or (comparison is not None and not comparison.within):
            raise typer.Exit(OUT_OF_TOLERANCE)
