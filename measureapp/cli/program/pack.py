"""`program pack`: files become a part program."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.program.show import facts_document, facts_lines
from measureapp.cli.reply import JsonOption, reply
from measureapp.data.raw_policy import RawPolicy
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgramFacts


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def pack(
        plan: Annotated[Path, typer.Argument(help="Scan plan (JSON or TOML).")],
        out: Annotated[Path, typer.Option("--out", help="The part program to write (.mpart).", dir_okay=False)],
        inspection: Annotated[
            Path | None, typer.Option("--inspection", help="Inspection program (TOML); the nominal that it names is packed with it.")
        ] = None,
        report_template: Annotated[
            Path | None, typer.Option("--report-template", help="Template of the report: a folder with a template.toml, or a Typst file.")
        ] = None,
        picture: Annotated[Path | None, typer.Option("--picture", help="Picture of the part (PNG).")] = None,
        name: Annotated[str, typer.Option("--name", help="Name of the part; by default that of the plan.")] = "",
        part_number: Annotated[str, typer.Option("--part-number", help="Number of the part, as on its label or drawing.")] = "",
        drawing: Annotated[str, typer.Option("--drawing", help="Drawing number.")] = "",
        revision: Annotated[str, typer.Option("--revision", help="Drawing revision.")] = "",
        remarks: Annotated[str, typer.Option("--remarks", help="How to clamp the part, or what else an operator should know.")] = "",
        code_pattern: Annotated[
            str,
            typer.Option("--code-pattern", help="Regular expression of the part's bar code, with named groups: part, serial, order."),
        ] = "",
        required: Annotated[
            list[str] | None, typer.Option("--required", help="What an operator must state: serial, order, remarks. Default: serial.")
        ] = None,
        raw: Annotated[
            RawPolicy | None, typer.Option("--raw", help="What becomes of raw images after a scan; default: as the project states.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Pack scan plan, inspection program, nominal and report template of a part into one file."""
        from measureapp.project.part_program_file import pack_part_program, with_former_revision, write_part_program
        from measureapp.project.plan_file import read_plan

        facts = checked_facts(
            name=name or read_plan(plan).name,
            part_number=part_number,
            identification={"drawing": drawing, "revision": revision},
            remarks=remarks,
            code_pattern=code_pattern,
            raw=raw,
            required=tuple(required) if required else ("serial",),
        )
        program = pack_part_program(facts, plan, inspection, report_template, picture)
        path = write_part_program(with_former_revision(program, out), out)
        reply(
            {**facts_document(program), "files": {"part_program": path}}, "\n".join([*facts_lines(program), f"Saved to {path}."]), as_json
        )


def checked_facts(**values: Any) -> PartProgramFacts:
    """Return the facts of a part program. Raises InputError for a bar-code pattern or a field that cannot be."""
    from pydantic import ValidationError

    from measureapp.data.model import first_problem
    from measureapp.data.part_program import PartProgramFacts

    try:
        return PartProgramFacts(**values)
    except ValidationError as error:
        raise InputError(f"{first_problem(error, 'the part program')}.", "See `measureapp program pack --help`.") from error
