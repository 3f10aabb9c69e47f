"""What robot and hand-eye add to a guide or an axis that was found through them.

Direction of the guide and place of the axis are told in the robot's frames, but seen by cameras on its flange: the error of the
robot's pose and that of hand-eye turn and shift them as a whole. No residual shows it, since all observations share it.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.data.calibration import HandEye, LinearGuide, RotationAxis


def guide_carried(guide: LinearGuide, hand_eye: HandEye, noise: AxisNoise) -> LinearGuide:
    """Return a guide whose direction is as uncertain as robot and hand-eye make it."""
    return replace(guide, direction_sigma_rad=hypot(guide.direction_sigma_rad, turn_sigma_rad(hand_eye, noise)))


def axis_sigmas(seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> tuple[float, float]:
    """Return what robot and hand-eye add to an axis that the reference camera saw: standard deviation of its direction (rad) and point (mm).

    Parameters
    ----------
    seen : in the frame of the camera; a turn of the camera moves it the more, the farther away it is
    """
    turn_rad = turn_sigma_rad(hand_eye, noise)
    return turn_rad, hypot(hand_eye.translation_sigma_mm, noise.robot_mm, turn_rad * hypot(*seen.point_mm))


def axis_carried(axis: RotationAxis, seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> RotationAxis:
    """Return ``axis``, which is ``seen`` told in the guide's frame, as uncertain as robot and hand-eye make it."""
    turn_rad, shift_mm = axis_sigmas(seen, hand_eye, noise)
    return replace(axis, point_sigma_mm=hypot(axis.point_sigma_mm, shift_mm), direction_sigma_rad=hypot(axis.direction_sigma_rad, turn_rad))


def turn_sigma_rad(hand_eye: HandEye, noise: AxisNoise) -> float:
    """Return by how much robot and hand-eye may turn what the cameras see, one standard deviation."""
    return hypot(hand_eye.rotation_sigma_rad, noise.robot_rad)
