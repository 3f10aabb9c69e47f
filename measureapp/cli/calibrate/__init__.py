"""`calibrate cameras|projector|axis|hand-eye|guide|rig|check`: calibrations from recorded images and tables."""

from __future__ import annotations

import typer


def register(app: typer.Typer) -> None:
    """Add the command group."""
    from measureapp.cli.calibrate import again, axis, cameras, check, guide, hand_eye, projector, rig

    group = typer.Typer(
        help="Calibrate cameras, projector, rotation axis, hand-eye, guide or the whole rig; check them.", no_args_is_help=True
    )
    for command in (cameras, projector, axis, hand_eye, guide, rig, check, again):
        command.register(group)
    app.add_typer(group, name="calibrate")
