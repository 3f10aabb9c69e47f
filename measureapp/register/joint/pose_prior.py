"""Prior of the poses: covariance of the kinematic positions."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import block_diag

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.view_errors import CalibrationErrors
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.axis_doubt import AxisPattern
from measureapp.register.joint.pose_graph import twist_rotation, twist_shift


@dataclass(frozen=True, slots=True, eq=False)
class PosePrior:
    """What is known about the errors of N kinematic poses before registration; None where not known."""

    stations: Sequence[Hashable] | None = (
        None  # one label per view, equal for views that differ by the table angle only (`number_stations`)
    )
    covariance: FloatArray | None = (
        None  # (6N, 6N), motions of each camera in its frame (mm, rad), from the rig calibration; else from the settings
    )
    calibration: CalibrationErrors | None = None  # effect of the camera calibration on clouds and kinematic poses
    patterns: Sequence[AxisPattern] = ()  # in which the axes may depart from their calibration

    def select(self, rows: IntArray) -> PosePrior:
        """Return the prior of the poses to which ``rows`` of the covariance belong; the stations stay those of all poses."""
        calibration, covariance = self.calibration, self.covariance
        if calibration is not None:
            calibration = replace(calibration, kinematic_motions=np.asarray(calibration.kinematic_motions)[rows])
        if covariance is not None:
            covariance = np.asarray(covariance)[np.ix_(rows, rows)]
        return PosePrior(self.stations, covariance, calibration, tuple(pattern.select(rows) for pattern in self.patterns))


NO_PRIOR = PosePrior()


@dataclass(frozen=True, slots=True, eq=False)
class KinematicPrior:
    """Standard deviations of the kinematic positions: of a station, and between views of one station."""

    station_mm: float
    station_rad: float
    view_mm: float
    view_rad: float

    def covariance(self, stations: Sequence[Hashable]) -> FloatArray:
        """Return the covariance (6N, 6N) of all pose errors in the camera's frame; those of one station are correlated."""
        common = np.diag([self.station_mm**2] * 3 + [self.station_rad**2] * 3)
        own = np.diag([self.view_mm**2] * 3 + [self.view_rad**2] * 3)
        same = np.array([[a == b for b in stations] for a in stations], float).reshape(len(stations), len(stations))
        return np.asarray(np.kron(same, common) + np.kron(np.eye(len(stations)), own))


def add_cloud_errors(
    covariance: FloatArray, kinematic: Sequence[RigidTransform], centres_mm: FloatArray, radii_mm: FloatArray, clouds_mm: FloatArray
) -> FloatArray:
    """Add the rigid part of each cloud's errors (decision 9) to a covariance (6N, 6N) of kinematic poses.

    Parameters
    ----------
    kinematic : N poses part_from_camera
    centres_mm, radii_mm : (N, 3) in the part's frame and (N,), centre and rms radius of each view
    clouds_mm : (N,), standard deviation of a cloud's translation along each coordinate, and of its outer points by a rotation
    """
    total = np.array(covariance, float)
    for i, (pose, centre, radius, cloud_mm) in enumerate(zip(kinematic, centres_mm, radii_mm, clouds_mm, strict=True)):
        own = np.diag([cloud_mm**2] * 3 + [(cloud_mm / max(float(radius), 1.0)) ** 2] * 3)
        carry = twist_rotation(pose.rotation.T) @ twist_shift(pose.translation_mm, centre)
        block = slice(6 * i, 6 * i + 6)
        total[block, block] += carry @ own @ carry.T
    return total


def transform_to_centres(covariance: FloatArray, kinematic: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Transform a covariance (6N, 6N) to small motions of each view about its centre, in the part's frame."""
    carry = carry_to_centres(kinematic, centres_mm)
    return np.asarray(carry @ covariance @ carry.T)


def carry_to_centres(kinematic: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Return the matrix (6N, 6N) from motions of each camera in its frame to those about the centres, in the part's frame."""
    blocks = (
        twist_shift(centre, pose.translation_mm) @ twist_rotation(pose.rotation) for pose, centre in zip(kinematic, centres_mm, strict=True)
    )
    return np.asarray(block_diag(*blocks))


def largest_sigmas(covariance: FloatArray) -> tuple[float, float]:
    """Return the standard deviations of translation (mm) and rotation (rad) of a covariance (6, 6), each in its worst direction."""
    return (
        float(np.sqrt(max(np.linalg.eigvalsh(covariance[:3, :3])[-1], 0.0))),
        float(np.sqrt(max(np.linalg.eigvalsh(covariance[3:, 3:])[-1], 0.0))),
    )
