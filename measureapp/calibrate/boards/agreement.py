"""Rejection of board poses in which calibrated cameras contradict each other: other cameras, or a board that moved between images."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Generic

import numpy as np

from measureapp.calibrate.boards.pose import BoardPose, Name, with_residual_noise
from measureapp.errors import CalibrationError

CONTRADICTION_FACTOR = 3.0  # of the median rms of all board poses
LEAST_CONTRADICTION_PX = 0.5
HOPELESS_PX = 2.0  # median rms beyond which the cameras are not those that were calibrated
CONTRADICTED = "its images contradict each other by {rms:.2f} px: the board moved between them, or they belong to different positions"
EXCHANGED = (
    "The images contradict the calibration of the cameras by {rms:.1f} px in most observations.",
    "Check that no two cameras are exchanged, that images of one position belong together, and that the board's size is right.",
)


@dataclass(frozen=True, slots=True, eq=False)
class BoardPoses(Generic[Name]):
    """The board pose of each observation, and the observations whose cameras contradict each other."""

    poses: Mapping[Name, BoardPose]
    rejected: Mapping[Name, str]


def reject_contradicting(poses: Mapping[Name, BoardPose]) -> BoardPoses[Name]:
    """Reject poses in which the cameras contradict each other; weight the others with their common residual noise.

    Raises
    ------
    CalibrationError
        In most observations the images contradict the cameras.
    """
    median = float(np.median([pose.rms_px for pose in poses.values()])) if poses else 0.0
    if median > HOPELESS_PX:
        raise CalibrationError(EXCHANGED[0].format(rms=median), EXCHANGED[1])
    limit = max(CONTRADICTION_FACTOR * median, LEAST_CONTRADICTION_PX)
    rejected = {name: CONTRADICTED.format(rms=pose.rms_px) for name, pose in poses.items() if pose.rms_px > limit}
    return BoardPoses(with_residual_noise({name: pose for name, pose in poses.items() if name not in rejected}), rejected)
