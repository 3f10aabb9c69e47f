"""How the slide's own errors enter the poses of the board: only where it carried a robot that stood still."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.motions.axis_noise import AxisNoise

PERFECT = 1e-4  # of the images' covariance stays, so that it can be inverted


def travel_in_camera(base_from_flange: FloatArray, flange_from_camera: FloatArray, direction: FloatArray) -> FloatArray:
    """Return the guide's ``direction`` (3,) in the reference camera's frame, (N, 3), at poses (N, 4, 4)."""
    return np.asarray(direction @ base_from_flange[:, :3, :3] @ flange_from_camera[:3, :3])


def slide_covariance(noise: AxisNoise, approaches: IntArray, slide_mm: FloatArray, travel: FloatArray) -> FloatArray:
    """Return what the slide adds to the covariance of the board's places in the camera, (N, 3, 3).

    Sightings between which the guide carried the robot past the board have it; elsewhere the slide's error is one with the robot's.

    Parameters
    ----------
    approaches : (N,), which approach of the robot
    slide_mm : (N,), displayed positions
    travel : (N, 3), see `travel_in_camera`
    """
    slid = np.array([np.ptp(slide_mm[approaches == approach]) > 0 for approach in approaches], bool)
    along = travel[:, :, None] * travel[:, None, :]
    added = noise.guide_mm**2 * (np.eye(3) - along) + noise.guide_along_mm**2 * along
    return np.asarray(slid[:, None, None] * added)


def with_slide(roots: FloatArray, added: FloatArray) -> FloatArray:
    """Return upper triangular roots (N, 6, 6) of the poses' information with ``added`` (N, 3, 3) to the covariance of their places."""
    return _changed(roots, 1.0, added)


def with_perfect_images(roots: FloatArray, slide: FloatArray | None) -> FloatArray:
    """Return the roots (N, 6, 6) that next to perfect images would leave, with the slide's part (N, 3, 3) in them as it is."""
    if slide is None:
        return roots / np.sqrt(PERFECT)
    return _changed(roots, PERFECT, (1 - PERFECT) * slide)


def _changed(roots: FloatArray, share: float, added: FloatArray) -> FloatArray:
    """Return the roots of ``share`` times the covariance, with ``added`` to that of the places; others than slid poses are not inverted."""
    slid = np.any(added != 0, axis=(1, 2))
    result = np.array(roots) / np.sqrt(share)
    if slid.any():
        covariance = share * np.linalg.inv(np.swapaxes(roots[slid], 1, 2) @ roots[slid])
        covariance[:, 3:, 3:] += added[slid]
        result[slid] = np.swapaxes(np.linalg.cholesky(np.linalg.inv(covariance)), 1, 2)
    return result
