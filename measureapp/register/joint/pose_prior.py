"""What the axes know about where the views stand, before any surface is compared."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import block_diag

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import moved_to, turned


@dataclass(frozen=True, slots=True, eq=False)
class KinematicPrior:
    """How far the axes can be trusted: standard deviations of a station's pose, and of views of one station to each other."""

    station_mm: float
    station_rad: float
    view_mm: float
    view_rad: float

    def covariance(self, stations: Sequence[Hashable]) -> FloatArray:
        """Return the covariance (6N, 6N) of all pose errors in the camera's frame; views of one station share most of theirs."""
        common = np.diag([self.station_mm**2] * 3 + [self.station_rad**2] * 3)
        own = np.diag([self.view_mm**2] * 3 + [self.view_rad**2] * 3)
        same = np.array([[a == b for b in stations] for a in stations], float).reshape(len(stations), len(stations))
        return np.asarray(np.kron(same, common) + np.kron(np.eye(len(stations)), own))


def with_cloud_errors(
    covariance: FloatArray, kinematic: Sequence[RigidTransform], centres_mm: FloatArray, radii_mm: FloatArray, clouds_mm: FloatArray
) -> FloatArray:
    """Add what each cloud errs as a whole (decision 9) to a covariance (6N, 6N) of poses by the axes.

    Parameters
    ----------
    kinematic : N poses part_from_camera
    centres_mm, radii_mm : (N, 3) in the part's frame and (N,), the middle of each view and how far its points lie from there
    clouds_mm : (N,), standard deviation of a cloud's shift along each coordinate, and of what a turn moves its outer points
    """
    total = np.array(covariance, float)
    for i, (pose, centre, radius, cloud_mm) in enumerate(zip(kinematic, centres_mm, radii_mm, clouds_mm, strict=True)):
        own = np.diag([cloud_mm**2] * 3 + [(cloud_mm / max(float(radius), 1.0)) ** 2] * 3)
        carry = turned(pose.rotation.T) @ moved_to(pose.translation_mm, centre)
        block = slice(6 * i, 6 * i + 6)
        total[block, block] += carry @ own @ carry.T
    return total


def about_centres(covariance: FloatArray, kinematic: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Return the same covariance (6N, 6N) as small motions of each view about its centre, in the part's frame."""
    carry = block_diag(
        *(moved_to(centre, pose.translation_mm) @ turned(pose.rotation) for pose, centre in zip(kinematic, centres_mm, strict=True))
    )
    return np.asarray(carry @ covariance @ carry.T)


def largest_sigmas(covariance: FloatArray) -> tuple[float, float]:
    """Return the standard deviations of shift (mm) and turn (rad) of a covariance (6, 6), each in its worst direction."""
    return (
        float(np.sqrt(max(np.linalg.eigvalsh(covariance[:3, :3])[-1], 0.0))),
        float(np.sqrt(max(np.linalg.eigvalsh(covariance[3:, 3:])[-1], 0.0))),
    )
