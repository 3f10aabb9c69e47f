"""Connection of the rig for calibrations, and the ground truth of a virtual rig for the result page."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from measureapp.errors import DeviceError

if TYPE_CHECKING:
    from measureapp.data.board import BoardDescription
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.rig import RigDescription
    from measureapp.devices.rig import Rig

VIRTUAL = "virtual_rig"
PART = "flat"  # the quickest to make; it is not used


@dataclass(frozen=True, eq=False)
class RigConnection:
    """A connected rig; a ``borrowed`` one belongs to the Rig page."""

    rig: Rig
    borrowed: bool = False


def connect(description: RigDescription, board: BoardDescription, held: Rig | None = None) -> RigConnection:
    """Connect the rig through its driver, or borrow the connection ``held``; on the virtual rig ``board`` is on the table.

    Raises
    ------
    DeviceError
        A device does not answer, or the rig's seed is not a whole number.
    PluginError
        The driver cannot be loaded.
    """
    if description.driver != VIRTUAL:
        if held is not None and held.description == description:
            return RigConnection(held, borrowed=True)
        from measureapp.devices.connect import connect_rig

        return RigConnection(connect_rig(description))
    from measureapp.devices.plugin_loader import load_driver
    from measureapp.simulate.parts import make_part
    from measureapp.simulate.world import World

    world = World(description, make_part(PART), _seed(description), board)
    return RigConnection(load_driver(None, VIRTUAL, "rig").module.rig_of(world))


def truth_of(description: RigDescription, board: BoardDescription) -> RigCalibration | None:
    """Return the ground truth of a virtual rig, including its projector; None for a real rig.

    It depends only on the description and its seed, so it is available before the rig is connected.

    Raises
    ------
    DeviceError
        The rig's seed is not a whole number.
    """
    if description.driver != VIRTUAL:
        return None
    from measureapp.data.calibration import ProjectorCalibration
    from measureapp.simulate.options import WorldOptions
    from measureapp.simulate.truth import draw_truth

    truth = draw_truth(description, board, WorldOptions().errors, _seed(description))
    projector = ProjectorCalibration(truth.projector, truth.camera_from_projector)
    return replace(truth.calibration, cameras=replace(truth.calibration.cameras, projector=projector))


def _seed(description: RigDescription) -> int:
    seed = description.driver_settings.get("seed", 1)
    if not isinstance(seed, int):
        raise DeviceError(f"The seed {seed!r} of the virtual rig is not a whole number.", "Correct `seed` in its driver_settings.")
    return seed
