"""`patterns list|check|export|compare`: pattern sets of the projector."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.patterns import check, compare, export, list_sets

    group = typer.Typer(help="Pattern sets of the projector.", no_args_is_help=True)
    for command in (list_sets, check, export, compare):
        command.register(group)
    app.add_typer(group, name="patterns")
