"""`program of`: a project becomes a template for new ones."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.program.show import facts_document, facts_lines
from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("of")
    def make_template(
        project: Annotated[Path, typer.Argument(help="Project folder.")],
        out: Annotated[Path, typer.Option("--out", help="The part program to write (.mpart).", dir_okay=False)],
        name: Annotated[str, typer.Option("--name", help="Name of the part; by default that of the project's part.")] = "",
        part_number: Annotated[str, typer.Option("--part-number", help="Number of the part, as on its label or drawing.")] = "",
        remarks: Annotated[str, typer.Option("--remarks", help="How to mount the part, or what else an operator should know.")] = "",
        as_json: JsonOption = False,
    ) -> None:
        """Make a template of a project: its rig, plan, part, inspection program and report template, without any data."""
        from measureapp.pipeline.templates import template_of_project
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.part_program_file import with_former_revision, write_part_program

        template = template_of_project(ProjectFolder.open(project), name, part_number, remarks)
        path = write_part_program(with_former_revision(template, out), out)
        lines = [*facts_lines(template), f"Saved to {path}."]
        reply({**facts_document(template), "files": {"part_program": path}}, "\n".join(lines), as_json)
