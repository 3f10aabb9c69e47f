"""Connection of the rig for calibrations, and the ground truth of a virtual rig for the result page."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

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
        A device does not answer.
    PluginError
        The driver cannot be loaded.
    InputError
        A setting of a driver is invalid, for example the seed of the virtual rig.
    """
    from measureapp.devices.connect import connect_rig

    if description.driver == VIRTUAL:
        return RigConnection(connect_rig(_with_board(description, board)))
    if held is not None and held.description == description:
        return RigConnection(held, borrowed=True)
    return RigConnection(connect_rig(description))


def truth_of(description: RigDescription, board: BoardDescription) -> RigCalibration | None:
    """Return the ground truth of a virtual rig, including its projector; None for a real rig.

    It depends only on the description, so it is available before images are taken; runs on a job's thread. Raises as `connect`.
    """
    if description.driver != VIRTUAL:
        return None
    rig = connect(description, board).rig
    try:
        return rig.truth()
    finally:
        rig.close()


def _with_board(description: RigDescription, board: BoardDescription) -> RigDescription:
    """Return the description of the virtual rig with this board, and a part that costs no time."""
    settings = {**description.driver_settings, "part": PART, "board": board.model_dump(mode="json")}
    return description.model_copy(update={"driver_settings": settings})
