"""`program release`: a part program may be used by operators."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from measureapp.cli.program.show import facts_document, release_words
from measureapp.cli.reply import JsonOption, reply


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def release(
        program: Annotated[Path, typer.Argument(help="Part program (.mpart).")],
        by: Annotated[str, typer.Option("--by", help="Name of who releases it, printed in every report.")],
        as_json: JsonOption = False,
    ) -> None:
        """Release a part program for operator mode, as its next revision; any change afterwards needs another release."""
        from datetime import UTC, datetime

        from measureapp.project.part_program_file import release_file

        released = release_file(program, by, datetime.now(UTC).isoformat(timespec="seconds"))
        reply(facts_document(released), f"{released.facts.name}: {release_words(released)}", as_json)
