"""How the poses of the joint estimate follow errors that displace all clouds alike, as those of the cameras' calibration do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import Following
from measureapp.register.pairs.icp import FLOOR_MM, PairMeasurement
from measureapp.register.pairs.prepare import PreparedCloud

HELD = 1e-3  # singular value over the largest, from which on the common surface holds a motion


class CloudErrors(Protocol):
    """Independent errors that displace all clouds alike."""

    @property
    def count(self) -> int:
        """How many."""

    def along(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the displacements (M, K) of points (M, 3) along directions (M, 3), all in the camera's frame."""


@dataclass(frozen=True, slots=True, eq=False)
class PairInfluence:
    """What a pair's points do to where its source comes to lie: the common surface by least squares of distances along the target's normals."""

    pair: PairMeasurement
    points_mm: FloatArray  # (M, 3), of the target, in its frame
    normals: FloatArray  # (M, 3)
    gain: FloatArray  # (6, M), motion of the source about the pair's centre by the distances that it has to close

    @classmethod
    def of(cls, pair: PairMeasurement, target: PreparedCloud, source: PreparedCloud) -> PairInfluence:
        """Take the pair's corresponding points; what their surface does not hold stays."""
        points, normals = target.points_mm[pair.matched_target], np.asarray(target.normals[pair.matched_target], float)
        variance = target.variance_mm2[pair.matched_target] + source.variance_mm2[pair.matched_source] + FLOOR_MM**2
        arms, root = points - pair.centre_mm, 1 / np.sqrt(variance)
        length = max(float(np.sqrt(np.mean(np.sum(arms**2, axis=1)))), 1.0)
        jacobian = np.hstack([normals, np.cross(arms, normals) / length]) * root[:, None]
        gain = np.linalg.pinv(jacobian, rcond=HELD) * root
        gain[3:] /= length
        return cls(pair, points, normals, gain)

    def moved(self, source: PreparedCloud, source_from_target: RigidTransform, errors: CloudErrors) -> FloatArray:
        """Return the motions (6, K) of the source where both clouds err."""
        gap = errors.along(self.points_mm, self.normals)
        gap -= errors.along(source.points_mm[self.pair.matched_source], source_from_target.rotate(self.normals))
        return np.asarray(self.gain @ gap)


@dataclass(frozen=True, slots=True, eq=False)
class JointInfluence:
    """What the joint estimate makes of errors that all clouds share: by its pairs, and by the poses by the axes."""

    following: Following
    pairs: Sequence[PairInfluence]
    clouds: Sequence[PreparedCloud]
    poses: Sequence[RigidTransform]

    def by_clouds(self, errors: CloudErrors) -> FloatArray:
        """Return the motions (6N, K) of all views by errors that displace all clouds alike."""
        right = np.zeros((6 * len(self.poses), errors.count))
        for one, weight in zip(self.pairs, self.following.by_pairs, strict=True):
            target, source = one.pair.target, one.pair.source
            source_from_target = self.poses[source].inverse() @ self.poses[target]
            right[_rows(one.pair)] += weight @ one.moved(self.clouds[source], source_from_target, errors)
        return np.asarray(self.following.inverse @ right)

    def by_axes(self, motions: FloatArray) -> FloatArray:
        """Return the motions (6N, K) of all views by those (6N, K) of the poses by the axes."""
        return np.asarray(self.following.inverse @ (self.following.by_axes @ motions))


def _rows(pair: PairMeasurement) -> IntArray:
    return np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])
