"""`process` and `verify`: recompute a project from its stored images, and check every stored byte."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, passed, tell_failures
from measureapp.cli.reply import JsonOption, TerminalProgress, reply


def register(app: typer.Typer) -> None:
    """Add the commands."""

    @app.command()
    def process(project: Annotated[Path, typer.Argument(help="Project folder.")], as_json: JsonOption = False) -> None:
        """Recompute everything, calibration included, from the stored images."""
        from measureapp.pipeline import process_project
        from measureapp.project.folder import ProjectFolder

        outcome = process_project(ProjectFolder.open(project), tell_failures, TerminalProgress())
        reply(outcome.document, "\n".join(measurement_lines(outcome.measurement)), as_json)
        if not passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)

    @app.command()
    def verify(project: Annotated[Path, typer.Argument(help="Project folder.")], as_json: JsonOption = False) -> None:
        """Compare every stored image, of the part and of the board, with its checksum."""
        from measureapp.project.folder import ProjectFolder

        folder = ProjectFolder.open(project)
        checked, damaged = folder.verify()
        lines = [problem for problems in damaged.values() for problem in problems]
        summary = f"{len(checked)} viewpoints checked: " + ("all as stored." if not damaged else f"{len(lines)} files damaged.")
        reply({"checked": checked, "damaged": damaged}, "\n".join([*lines, summary]), as_json)
        if damaged:
            raise typer.Exit(OUT_OF_TOLERANCE)
