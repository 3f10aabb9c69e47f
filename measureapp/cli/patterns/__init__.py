"""`patterns list|check|export|compare`: what the projector shows."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.patterns import check, compare, export, list_sets

    group = typer.Typer(help="Pattern sets: what the projector shows.", no_args_is_help=True)
    for command in (list_sets, check, export, compare):
        command.register(group)
    app.add_typer(group, name="patterns")
