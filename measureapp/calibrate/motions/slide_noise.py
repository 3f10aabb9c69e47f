"""Noise of the slide and of every stop in the board poses, where slide or table moved between sightings and the robot did not."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.calibrate.motions.axis_noise import AxisNoise

PERFECT = 1e-4  # of the images' covariance stays, so that it can be inverted


def travel_in_camera(base_from_flange: FloatArray, flange_from_camera: FloatArray, direction: FloatArray) -> FloatArray:
    """Return the guide's ``direction`` (3,) in the reference camera's frame, (N, 3), at poses (N, 4, 4)."""
    return np.asarray(direction @ base_from_flange[:, :3, :3] @ flange_from_camera[:3, :3])


def slide_covariance(noise: AxisNoise, approaches: IntArray, slide_mm: FloatArray, travel: FloatArray) -> FloatArray:
    """Return the contribution (N, 3, 3) of the slide to the covariance of the board's positions in the camera.

    Only sightings between which the slide moved and the robot did not have it; elsewhere the slide's error is part of the robot's.

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


def stop_covariance(stop_mm: float, approaches: IntArray) -> FloatArray:
    """Return the contribution (N, 3, 3) of stops with a scatter ``stop_mm`` to the covariance of the board's positions in the camera.

    Only sightings that share one of the robot's ``approaches`` (N,) with others; elsewhere the scatter is part of the robot's error.
    """
    shared = np.bincount(approaches)[approaches] > 1
    return np.asarray(shared[:, None, None] * stop_mm**2 * np.eye(3))


def add_place_covariance(roots: FloatArray, added: FloatArray) -> FloatArray:
    """Return upper triangular roots (N, 6, 6) of the poses' information with ``added`` (N, 3, 3) to the covariance of their places."""
    return _scale_and_add(roots, 1.0, added)


def suppress_image_noise(roots: FloatArray, slide: FloatArray | None) -> FloatArray:
    """Return the roots (N, 6, 6) for almost noise-free images, with the contribution (N, 3, 3) of the slide unchanged."""
    if slide is None:
        return roots / np.sqrt(PERFECT)
    return _scale_and_add(roots, PERFECT, (1 - PERFECT) * slide)


def _scale_and_add(roots: FloatArray, factor: float, added: FloatArray) -> FloatArray:
    """Return the roots of ``factor`` times the covariance, with ``added`` to that of the positions; other than slid poses are not inverted."""
    slid = np.any(added != 0, axis=(1, 2))
    result = np.array(roots) / np.sqrt(factor)
    if slid.any():
        covariance = factor * np.linalg.inv(np.swapaxes(roots[slid], 1, 2) @ roots[slid])
        covariance[:, 3:, 3:] += added[slid]
        result[slid] = np.swapaxes(np.linalg.cholesky(np.linalg.inv(covariance)), 1, 2)
    return result
