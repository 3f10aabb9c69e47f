"""Relative motions of flange and camera between poses, A X = X B, and whether they determine X."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.poses import invert_poses
from measureapp.errors import CalibrationError

LEAST_ANGLE_RAD = np.deg2rad(3.0)  # the axis of a smaller motion is mostly noise
LARGEST_ANGLE_RAD = np.deg2rad(170.0)  # beyond, flange and camera may have the axis in opposite senses
PARALLEL_DEG = 2.0
WEAK_DEG = 12.0
MOST_PAIRS = 3000


@dataclass(frozen=True, slots=True, eq=False)
class Motions:
    """Pairs of motions: ``flange`` A and ``camera`` B with A X = X B."""

    flange: FloatArray  # (K, 4, 4)
    camera: FloatArray  # (K, 4, 4)

    def quaternions(self) -> tuple[FloatArray, FloatArray]:
        """Return the unit quaternions (K, 4), scalar first and not negative, of flange and camera."""
        a, b = (np.roll(Rotation.from_matrix(part[:, :3, :3]).as_quat(canonical=True), 1, axis=1) for part in (self.flange, self.camera))
        return a, b


@dataclass(frozen=True, slots=True, eq=False)
class Degeneracy:
    """How well the motions determine the hand-eye transform."""

    axis_spread_deg: float  # 0: all rotation axes parallel; 45: two perpendicular ones weigh the same
    largest_angle_deg: float
    pairs: int
    left_out: int  # pairs turned too little or by nearly half a turn
    verdict: str  # "good", or what is weak and what to add


def motions_between(base_from_flange: FloatArray, camera_from_board: FloatArray) -> tuple[Motions, Degeneracy]:
    """Return the motions between all pairs of poses (N, 4, 4) that turn neither too little nor by half a turn.

    Raises
    ------
    CalibrationError
        Fewer than three poses, hardly any rotation, or rotation axes that are all parallel.
    """
    count = len(base_from_flange)
    if count < 3:
        raise CalibrationError(f"{count} poses do not determine the hand-eye transform.", "Give at least 3, better 10 or more.")
    first, second = np.array(list(combinations(range(count), 2))).T
    a = invert_poses(base_from_flange[second]) @ base_from_flange[first]
    b = camera_from_board[second] @ invert_poses(camera_from_board[first])
    angle_a, angle_b = (Rotation.from_matrix(part[:, :3, :3]).magnitude() for part in (a, b))
    good = (np.minimum(angle_a, angle_b) >= LEAST_ANGLE_RAD) & (np.maximum(angle_a, angle_b) <= LARGEST_ANGLE_RAD)
    if good.sum() < 2:
        raise CalibrationError(
            f"The poses turn the camera by at most {np.rad2deg(angle_a.max()):.1f}° against each other"
            + (", or by nearly half a turn." if angle_a.max() > LARGEST_ANGLE_RAD else "."),
            "Add poses turned by 20° to 90° about different axes.",
        )
    _check_angles(angle_a[good], angle_b[good])
    chosen = np.flatnonzero(good)
    chosen = chosen[:: max(1, -(-len(chosen) // MOST_PAIRS))]
    spread, axis = _spread(a[chosen], angle_a[chosen])
    verdict = _verdict(spread, axis)
    largest = float(np.rad2deg(angle_a[good].max()))
    return Motions(a[chosen], b[chosen]), Degeneracy(spread, largest, len(chosen), int((~good).sum()), verdict)


def _check_angles(flange_rad: FloatArray, camera_rad: FloatArray) -> None:
    difference = np.abs(flange_rad - camera_rad)
    if np.median(difference) > np.deg2rad(3.0):
        raise CalibrationError(
            f"Flange and camera turn by different angles (median difference {np.rad2deg(np.median(difference)):.1f}°).",
            "Check that robot and board poses are in the same order, and that the rotations are unit quaternions, not degrees.",
        )


def _spread(flange: FloatArray, angle: FloatArray) -> tuple[float, FloatArray]:
    """Return how far the rotation axes are from parallel, and the common axis."""
    axes = Rotation.from_matrix(flange[:, :3, :3]).as_rotvec() / angle[:, None] * np.sin(angle / 2)[:, None]
    values, vectors = np.linalg.eigh(axes.T @ axes)
    return float(np.rad2deg(np.arctan(np.sqrt(max(values[1], 0.0) / values[2])))), vectors[:, 2]


def _verdict(spread_deg: float, axis: FloatArray) -> str:
    direction = ", ".join(f"{value:.2f}" for value in axis)
    if spread_deg < PARALLEL_DEG:
        raise CalibrationError(
            f"All motions turn about nearly the same axis of the flange ({direction}; {spread_deg:.1f}° from parallel): "
            "the camera's position along that axis is not observable.",
            "Add poses turned about a second axis, best at right angles to it.",
        )
    if spread_deg < WEAK_DEG:
        return f"weak: the motions turn mostly about one axis of the flange ({direction}); add poses turned about another"
    return "good"
