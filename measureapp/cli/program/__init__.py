"""`program …`: part programs."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.program import of_project, pack, release, show, start, unpack

    group = typer.Typer(
        help="Part programs: scan plan, inspection program, nominal and report template of a part in one file.", no_args_is_help=True
    )
    for command in (pack, of_project, release, show, start, unpack):
        command.register(group)
    app.add_typer(group, name="program")
