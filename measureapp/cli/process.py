"""`process` and `verify`: recompute a project from its stored images, and check every stored byte."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.import_recording import process_imported
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import has_passed, measurement_lines, report_event
from measureapp.cli.reply import JsonOption, TerminalProgress, reply

if TYPE_CHECKING:
    from measureapp.project.folder import ProjectFolder


def register(app: typer.Typer) -> None:
    """Add the commands."""

    @app.command()
    def process(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        accept: Annotated[
            list[str] | None, typer.Option(help="Use this view regardless of its quality, now and later; may be given several times.")
        ] = None,
        refuse: Annotated[list[str] | None, typer.Option(help="Do not use this view, now and later; may be given several times.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Recompute everything, calibration included, from the stored images.

        Of an imported recording, everything that its images suffice for is computed, and what is missing for the rest is stated.
        """
        from measureapp.pipeline import process_project
        from measureapp.pipeline.recording.stages import is_recording
        from measureapp.project.folder import ProjectFolder

        folder = ProjectFolder.open(project)
        _choose(folder, accept or [], refuse or [])
        if is_recording(folder):
            process_imported(folder, as_json)
            return
        outcome = process_project(folder, report_event, TerminalProgress())
        reply(outcome.document, "\n".join(measurement_lines(outcome.measurement)), as_json)
        if not has_passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)

    @app.command()
    def verify(project: Annotated[Path, typer.Argument(help="Project folder.")], as_json: JsonOption = False) -> None:
        """Compare every stored image, of the part and of the board, with its checksum."""
        from measureapp.project.folder import ProjectFolder

        folder = ProjectFolder.open(project)
        checked, damaged = folder.verify()
        lines = [problem for problems in damaged.values() for problem in problems]
        summary = f"{len(checked)} viewpoints checked: " + ("no damage." if not damaged else f"{len(lines)} files damaged.")
        reply({"checked": checked, "damaged": damaged}, "\n".join([*lines, summary]), as_json)
        if damaged:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _choose(project: ProjectFolder, accepted: list[str], refused: list[str]) -> None:
    """Store the views accepted or refused by hand in the project."""
    from measureapp.errors import InputError
    from measureapp.pipeline.chosen_views import check_choices

    if both := sorted(set(accepted) & set(refused)):
        raise InputError(f"The view {both[0]!r} is both accepted and refused.", "Name it once.")
    choices = project.view_choices()
    for name in accepted:
        choices = choices.with_choice(name, "use")
    for name in refused:
        choices = choices.with_choice(name, "refuse")
    if accepted or refused:
        check_choices(choices, project.stored_viewpoints())
        project.save_view_choices(choices)
