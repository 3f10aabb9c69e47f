"""How the poses of the joint estimate follow errors of the cameras' calibration, which bend all clouds alike."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.view_errors import CloudBends
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import Following
from measureapp.register.pairs.icp import FLOOR_MM, PairMeasurement
from measureapp.register.pairs.prepare import PreparedCloud

HELD = 1e-3  # singular value over the largest, from which on the common surface holds a motion


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

    def bent(self, source: PreparedCloud, source_from_target: RigidTransform, bends: CloudBends) -> FloatArray:
        """Return the motions (6, K) of the source where the calibration bends both clouds."""
        gap = bends.along(self.points_mm, self.normals)
        gap -= bends.along(source.points_mm[self.pair.matched_source], source_from_target.rotate(self.normals))
        return np.asarray(self.gain @ gap)


def by_calibration(
    following: Following, influences: Sequence[PairInfluence], clouds: Sequence[PreparedCloud], poses: Sequence[RigidTransform],
    by_axes: FloatArray, bends: CloudBends,
) -> FloatArray:  # fmt: skip
    """Return the motions (6N, K) of all views by errors of the calibration, which bend the clouds and move the poses by the axes."""
    right = following.by_axes @ by_axes
    for one, weight in zip(influences, following.by_pairs, strict=True):
        source_from_target = poses[one.pair.source].inverse() @ poses[one.pair.target]
        right[_rows(one.pair)] += weight @ one.bent(clouds[one.pair.source], source_from_target, bends)
    return np.asarray(following.inverse @ right)


def _rows(pair: PairMeasurement) -> IntArray:
    return np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])
