"""`calibrate …`: calibrations from recorded images, tables or a session; their check and history."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.calibrate import again, axis, cameras, check, collect, guide, hand_eye, history, projector, rig, run

    group = typer.Typer(
        help="Calibrate cameras, projector, rotation axis, hand-eye, guide or the whole rig; check them.", no_args_is_help=True
    )
    for command in (cameras, projector, axis, hand_eye, guide, rig, run, collect, check, history, again):
        command.register(group)
    app.add_typer(group, name="calibrate")
