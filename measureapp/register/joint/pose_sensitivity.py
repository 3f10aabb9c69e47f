"""Propagation of errors shared by all clouds, such as those of the camera calibration, to the poses of the joint estimate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import PoseSensitivity
from measureapp.register.pairs.icp import FLOOR_MM, PairMeasurement
from measureapp.register.pairs.prepare import PreparedCloud

RANK_TOLERANCE = 1e-3  # relative singular value above which the common surface determines a motion


class CloudErrorModel(Protocol):
    """Independent errors that displace the points of all clouds in the same way."""

    @property
    def count(self) -> int:
        """The number of errors."""

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (M, K) of points (M, 3) along directions (M, 3), all in the camera's frame."""


@dataclass(frozen=True, slots=True, eq=False)
class PairSensitivity:
    """Sensitivity of a pair's relative pose to point displacements, by point-to-plane least squares."""

    pair: PairMeasurement
    points_mm: FloatArray  # (M, 3), of the target, in its frame
    normals: FloatArray  # (M, 3)
    gain: FloatArray  # (6, M), motion of the source about the pair's centre per point-to-plane distance

    @classmethod
    def of(cls, pair: PairMeasurement, target: PreparedCloud, source: PreparedCloud) -> PairSensitivity:
        """Linearise the pair at its corresponding points; undetermined motions are zero."""
        points, normals = target.points_mm[pair.matched_target], np.asarray(target.normals[pair.matched_target], float)
        variance = target.variance_mm2[pair.matched_target] + source.variance_mm2[pair.matched_source] + FLOOR_MM**2
        arms, root = points - pair.centre_mm, 1 / np.sqrt(variance)
        length = max(float(np.sqrt(np.mean(np.sum(arms**2, axis=1)))), 1.0)
        jacobian = np.hstack([normals, np.cross(arms, normals) / length]) * root[:, None]
        gain = np.linalg.pinv(jacobian, rcond=RANK_TOLERANCE) * root
        gain[3:] /= length
        return cls(pair, points, normals, gain)

    def propagate(self, source: PreparedCloud, source_from_target: RigidTransform, errors: CloudErrorModel) -> FloatArray:
        """Propagate errors of both clouds to the motions (6, K) of the source."""
        gap = errors.along(self.points_mm, self.normals)
        gap -= errors.along(source.points_mm[self.pair.matched_source], source_from_target.rotate(self.normals))
        return np.asarray(self.gain @ gap)


@dataclass(frozen=True, slots=True, eq=False)
class JointSensitivity:
    """Sensitivity of the joint estimate to errors shared by all clouds, through its pairs and its kinematic poses."""

    sensitivity: PoseSensitivity
    pairs: Sequence[PairSensitivity]
    clouds: Sequence[PreparedCloud]
    poses: Sequence[RigidTransform]

    def propagate_cloud_errors(self, errors: CloudErrorModel) -> FloatArray:
        """Propagate errors shared by all clouds to the motions (6N, K) of all views."""
        right = np.zeros((6 * len(self.poses), errors.count))
        for one, weight, moved in zip(self.pairs, self.sensitivity.by_pairs, self.propagate_to_pairs(errors), strict=True):
            right[_rows(one.pair)] += weight @ moved
        return np.asarray(self.sensitivity.inverse @ right)

    def propagate_to_pairs(self, errors: CloudErrorModel) -> FloatArray:
        """Propagate errors shared by all clouds to the motions (E, 6, K) that all pairs measure."""
        moved = np.zeros((len(self.pairs), 6, errors.count))
        for one, motions in zip(self.pairs, moved, strict=True):
            target, source = one.pair.target, one.pair.source
            source_from_target = self.poses[source].inverse() @ self.poses[target]
            motions[:] = one.propagate(self.clouds[source], source_from_target, errors)
        return moved

    def propagate_kinematic_errors(self, motions: FloatArray) -> FloatArray:
        """Propagate motions (6N, K) of the kinematic poses to the motions (6N, K) of all views."""
        return np.asarray(self.sensitivity.inverse @ (self.sensitivity.by_axes @ motions))


def _rows(pair: PairMeasurement) -> IntArray:
    return np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])
