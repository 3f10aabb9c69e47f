"""The rig that takes images of the board. What a virtual rig hides is kept apart from it, for the result page alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from measureapp.errors import DeviceError

if TYPE_CHECKING:
    from measureapp.data.board import BoardDescription
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.rig import RigDescription
    from measureapp.devices.rig import Rig

VIRTUAL = "virtual_rig"
PART = "flat"  # the quickest to make; it is never looked at


@dataclass(frozen=True, eq=False)
class RigConnection:
    """A connected rig, and its true geometry where it is simulated."""

    rig: Rig
    truth: RigCalibration | None = None


def connect(description: RigDescription, board: BoardDescription) -> RigConnection:
    """Connect the rig by its driver; on the virtual rig ``board`` lies on the table.

    Raises
    ------
    DeviceError
        A device does not answer, or the rig's seed is no whole number.
    PluginError
        The driver cannot be loaded.
    """
    if description.driver != VIRTUAL:
        from measureapp.devices.connect import connect_rig

        return RigConnection(connect_rig(description))
    from measureapp.devices.plugin_loader import load_plugin
    from measureapp.resources import plugin_folder
    from measureapp.simulate.parts import make_part
    from measureapp.simulate.world import World

    seed = description.driver_settings.get("seed", 1)
    if not isinstance(seed, int):
        raise DeviceError(f"The virtual rig has the seed {seed!r}.", "Give a whole number as `seed` of its driver_settings.")
    world = World(description, make_part(PART), seed, board)
    rig = load_plugin(plugin_folder(), VIRTUAL).module.rig_of(world)
    return RigConnection(rig, world.truth().calibration)
