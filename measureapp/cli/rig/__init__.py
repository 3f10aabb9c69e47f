"""`rig …`: the connected devices."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.rig import check, latency, peers, teach

    group = typer.Typer(help="The connected devices.", no_args_is_help=True)
    for command in (check, latency, peers, teach):
        command.register(group)
    app.add_typer(group, name="rig")
