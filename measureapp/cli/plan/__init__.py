"""`plan …`: scan plans."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.plan import check, edit, extend, make, predict, show

    group = typer.Typer(help="Scan plans: make, check, show, edit and extend them, and predict what they give.", no_args_is_help=True)
    for command in (make, check, show, edit, predict, extend):
        command.register(group)
    app.add_typer(group, name="plan")
