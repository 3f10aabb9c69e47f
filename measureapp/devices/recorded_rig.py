"""Rigs that are recordings: there is nothing to connect."""

from __future__ import annotations

from measureapp.data.rig import RECORDED, RigDescription
from measureapp.errors import InputError


def require_devices(rig: RigDescription) -> None:
    """Refuse a rig that is a recording. Raises InputError."""
    if rig.driver == RECORDED:
        raise InputError(
            f"Rig {rig.name} is a recording: it has no devices that could be connected, moved or triggered.",
            "Process its project with `measureapp process PROJECT`, or name the description of a connected rig.",
        )
