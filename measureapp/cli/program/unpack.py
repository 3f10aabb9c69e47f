"""`program unpack`: the files of a part program, to be edited."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.program.show import facts_document
from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def unpack(
        program: Annotated[Path, typer.Argument(help="Part program (.mpart).")],
        out: Annotated[Path, typer.Option("--out", help="Folder for its files, new or empty.", file_okay=False)],
        as_json: JsonOption = False,
    ) -> None:
        """Write the files of a part program into a folder, to edit them and pack them again."""
        from measureapp.project.part_program_file import read_part_program, unpack_part_program

        found = read_part_program(program)
        files = unpack_part_program(found, out)
        reply({**facts_document(found), "files": files}, "\n".join(str(path) for path in files.values()), as_json)
