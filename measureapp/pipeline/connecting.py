"""The rig of a task: the one that is connected already, or one that is connected for the task."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig import Rig
from measureapp.errors import InputError


@contextmanager
def connected(description: RigDescription, held: Rig | None) -> Iterator[Rig]:
    """Yield the connected rig ``held``, which stays connected, or connect ``description`` and release it at the end.

    Raises
    ------
    InputError
        Another rig is connected.
    DeviceError, PluginError
        The rig cannot be connected.
    """
    if held is not None:
        if held.description != description:
            raise InputError(
                f"The connected rig ({held.description.name}) is described differently than the rig of this task ({description.name}).",
                "Disconnect the rig first; it is then connected as the task needs it.",
            )
        yield held
        return
    rig = connect_rig(description)
    try:
        yield rig
    finally:
        rig.close()
