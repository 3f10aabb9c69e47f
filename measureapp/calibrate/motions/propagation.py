"""Propagation of the uncertainty of robot and hand-eye to a guide or an axis observed by cameras on the robot's flange.

Both are given in the robot's frames: an error of the robot's pose or of hand-eye turns and shifts them as a whole. It does not appear
in any residual, since all observations share it.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.data.calibration import HandEye, LinearGuide, RotationAxis


def guide_through_robot(guide: LinearGuide, hand_eye: HandEye, noise: AxisNoise) -> LinearGuide:
    """Add the uncertainty of robot and hand-eye to that of the guide's direction."""
    return replace(guide, direction_sigma_rad=hypot(guide.direction_sigma_rad, turn_sigma_rad(hand_eye, noise)))


def axis_through_robot(axis: RotationAxis, seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> RotationAxis:
    """Add the uncertainty of robot and hand-eye to ``axis``, which is ``seen`` transformed into the guide's frame."""
    turn_rad, shift_mm = axis_sigmas(seen, hand_eye, noise)
    return replace(axis, point_sigma_mm=hypot(axis.point_sigma_mm, shift_mm), direction_sigma_rad=hypot(axis.direction_sigma_rad, turn_rad))


def axis_sigmas(seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> tuple[float, float]:
    """Return the standard deviations of direction (rad) and point (mm) that robot and hand-eye add to an axis.

    Parameters
    ----------
    seen : in the frame of the reference camera, whose rotation displaces the axis in proportion to its distance
    """
    turn_rad = turn_sigma_rad(hand_eye, noise)
    return turn_rad, hypot(hand_eye.translation_sigma_mm, noise.robot_mm, turn_rad * hypot(*seen.point_mm))


def turn_sigma_rad(hand_eye: HandEye, noise: AxisNoise) -> float:
    """Return the standard deviation of the cameras' orientation by robot and hand-eye."""
    return hypot(hand_eye.rotation_sigma_rad, noise.robot_rad)
