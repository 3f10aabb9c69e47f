"""One position of the board: the marks each camera detected, the axis positions, and the pose of the board once the cameras are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.sightings import Sighting
from measureapp.data.fringe import AxisReadback, Readback
from measureapp.errors import CalibrationError


@dataclass(frozen=True, slots=True, eq=False)
class Observation:
    """One position of the board, observed by all cameras at the same time.

    Every calibration starts from these: detection fills `seen`, `locate` adds the pose; a pose from a table needs no `seen`.
    """

    id: str
    readback: Readback = field(default_factory=Readback)
    board: BoardPose | None = None  # in the reference camera's frame; None before the cameras are known
    camera_jacobian: FloatArray | None = None  # (6, C), derivative of the board pose with respect to a `LabelledCovariance` of the cameras
    approach: int | None = None  # of the robot, see `approaches_to`; None: equal poses in succession are one approach
    seen: Mapping[str, Sighting] = field(default_factory=dict)  # camera -> marks

    @property
    def pose(self) -> BoardPose:
        """The board in the reference camera's frame. Raises CalibrationError where it was not determined."""
        if self.board is None:
            raise CalibrationError(f"The pose of the board in observation {self.id} is not known.", "Give images of calibrated cameras.")
        return self.board

    @property
    def axes(self) -> AxisReadback:
        """The positions of all axes. Raises CalibrationError where one is missing."""
        return self.readback.full()


def camera_jacobians_of(observations: Sequence[Observation]) -> FloatArray | None:
    """Return the derivatives (N, 6, C) of the board poses with respect to the cameras; None where not all observations have them."""
    known = [one.camera_jacobian for one in observations if one.camera_jacobian is not None]
    return np.array(known) if known and len(known) == len(observations) else None


def flanges_of(observations: Sequence[Observation]) -> FloatArray:
    """Return base_from_flange (N, 4, 4) as read back."""
    return np.array([one.readback.base_from_flange.matrix for one in observations if one.readback.base_from_flange is not None])


def slides_of(observations: Sequence[Observation]) -> FloatArray:
    """Return the guide positions (N,) in mm as read back."""
    return np.array([one.readback.guide_mm for one in observations], float)
