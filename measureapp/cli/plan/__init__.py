"""`plan …`: scan plans."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.plan import extend, make, predict

    group = typer.Typer(help="Scan plans: make, check, show and edit them.", no_args_is_help=True)
    for command in (make, predict, extend):
        command.register(group)
    app.add_typer(group, name="plan")
