"""`program start`: a new project from a template."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def start(
        program: Annotated[Path, typer.Argument(help="Part program (.mpart), such as a template made by `program of`.")],
        project: Annotated[Path, typer.Option("--project", help="Folder of the new project, new or empty.")],
        rig: Annotated[
            str | None, typer.Option("--rig", help="Rig description in place of the template's: a TOML file, or a name in resources/rigs.")
        ] = None,
        name: Annotated[str, typer.Option("--name", help="Name of the project; by default that of its folder.")] = "",
        as_json: JsonOption = False,
    ) -> None:
        """Create a project from a template, ready to be scanned; the calibration is copied from where the template names it, if it is there."""
        from measureapp.pipeline.templates import new_project
        from measureapp.project.part_program_file import read_part_program
        from measureapp.project.rig_file import read_rig

        made = new_project(read_part_program(program), project, name=name, rig=None if rig is None else read_rig(rig))
        calibrated = made.calibration() is not None
        lines = [
            f"Project {made.name} for {made.settings.part} on {made.rig().name}: {made.path}.",
            "It is calibrated." if calibrated else "It is not calibrated: calibrate the rig into it, or scan with --calibration PROJECT.",
            f"Scan it: measureapp scan {made.path / 'plan.json'} --rig RIG --project {made.path}.",
        ]
        document = {"name": made.name, "part": made.settings.part, "rig": made.rig().name, "calibrated": calibrated}
        reply({**document, "files": {"project": made.path}}, "\n".join(lines), as_json)
