"""`program pack`: files become a part program."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.program.show import facts_document, facts_lines
from measureapp.cli.reply import JsonOption, reply
from measureapp.data.raw_policy import RawPolicy


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def pack(
        plan: Annotated[Path, typer.Argument(help="Scan plan (JSON or TOML).")],
        out: Annotated[Path, typer.Option("--out", help="The part program to write (.mpart).")],
        inspection: Annotated[
            Path | None, typer.Option("--inspection", help="Inspection program (TOML); the nominal that it names is packed with it.")
        ] = None,
        report_template: Annotated[Path | None, typer.Option("--report-template", help="Template of the report (Typst).")] = None,
        picture: Annotated[Path | None, typer.Option("--picture", help="Picture of the part (PNG).")] = None,
        name: Annotated[str, typer.Option("--name", help="Name of the part; by default that of the plan.")] = "",
        part_number: Annotated[str, typer.Option("--part-number", help="Number of the part, as on its label or drawing.")] = "",
        remarks: Annotated[str, typer.Option("--remarks", help="How to mount the part, or what else an operator should know.")] = "",
        raw: Annotated[
            RawPolicy | None, typer.Option("--raw", help="What becomes of raw images after a scan; default: as the project states.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Pack scan plan, inspection program, nominal and report template of a part into one file."""
        from measureapp.data.part_program import PartProgramFacts
        from measureapp.project.part_program_file import pack_part_program, write_part_program
        from measureapp.project.plan_file import read_plan

        facts = PartProgramFacts(name=name or read_plan(plan).name, part_number=part_number, remarks=remarks, raw=raw)
        program = pack_part_program(facts, plan, inspection, report_template, picture)
        path = write_part_program(program, out)
        reply(
            {**facts_document(program), "files": {"part_program": path}}, "\n".join([*facts_lines(program), f"Saved to {path}."]), as_json
        )
