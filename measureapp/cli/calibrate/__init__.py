"""`calibrate cameras|axis|hand-eye|guide|rig|check|history|collect`: from recorded images, tables or a session; and what was said of them since."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.calibrate import axis, cameras, check, collect, guide, hand_eye, history, rig

    group = typer.Typer(help="Calibrate cameras, rotation axis, hand-eye, guide or the whole rig; check them.", no_args_is_help=True)
    for command in (cameras, axis, hand_eye, guide, rig, check, history, collect):
        command.register(group)
    app.add_typer(group, name="calibrate")
