"""Coarse alignment of two set-ups of one part that was turned over or moved: starts in all orientations, improved by ICP."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import BoolArray, FloatArray
from measureapp.register.setups.empty_space import SeenSpace, contradicted_share
from measureapp.register.setups.setup_cloud import PreparedSetUp

TURN_STEP_DEG = 10.0
STEPS, REACH_SHARE, LAST_REACH_VOXELS = 10, 0.08, 2.0  # of the ICP: from a share of the diagonal to a few voxels
AGREEMENT = 0.7  # cosine between corresponding normals
LEAST_MATCHES = 40
DAMPING = 1e-6
VIEWS_CHECKED = 6  # evenly chosen, while there are many candidates
MOST_DISTINCT = 60
SAME_DEG, SAME_MM = 3.0, 5.0
FPFH_VOXELS, FPFH_NORMALS, FPFH_RADIUS, FPFH_RUNS = 3.0, 2.0, 5.0, 6
RANSAC_ITERATIONS, RANSAC_CONFIDENCE = 60_000, 0.999


@dataclass(frozen=True, slots=True, eq=False)
class CoarseCandidate:
    """A coarse position of one set-up relative to another."""

    matrix: FloatArray  # (4, 4), target_from_source
    overlap: float  # share of the source's sample with a corresponding target point
    contradicted: float  # share of both samples where the other set-up saw empty space

    @property
    def score(self) -> float:
        """Overlap, less what contradicts it."""
        return self.overlap - 3.0 * self.contradicted


def improve(target: PreparedSetUp, source: PreparedSetUp, starts: Iterable[FloatArray]) -> list[CoarseCandidate]:
    """Improve every start by point-to-plane ICP with a shrinking search radius; return distinct candidates, best first."""
    reach = LAST_REACH_VOXELS * target.prepared.voxel_mm
    improved = [_icp(target, source, start) for start in starts]
    overlaps = [float(match_sample(target, source, matrix, reach).near.mean()) for matrix in improved]
    distinct: list[tuple[FloatArray, float]] = []
    for number in np.argsort(overlaps)[::-1]:
        if len(distinct) < MOST_DISTINCT and all(differ(improved[number], other) for other, _ in distinct):
            distinct.append((improved[number], overlaps[number]))
    found = [CoarseCandidate(matrix, overlap, contradicted(target, source, matrix, VIEWS_CHECKED)) for matrix, overlap in distinct]
    return sorted(found, key=lambda one: -one.score)


def differ(one: FloatArray, other: FloatArray) -> bool:
    """Whether two positions are not the same within the coarse alignment."""
    turn = Rotation.from_matrix(one[:3, :3].T @ other[:3, :3]).magnitude()
    return bool(turn > np.radians(SAME_DEG) or np.linalg.norm(one[:3, 3] - other[:3, 3]) > SAME_MM)


def all_starts(target: PreparedSetUp, source: PreparedSetUp) -> Iterator[FloatArray]:
    """Yield starts for an unknown rotation: principal axes with all rotations about each, and matched local features."""
    turns = np.arange(0, 360, TURN_STEP_DEG)
    for axis in range(3):
        order = [axis, (axis + 1) % 3, (axis + 2) % 3]
        ours, theirs = target.principal_axes[order], source.principal_axes[order]
        for flip in (np.eye(3), np.diag([-1.0, 1.0, -1.0])):
            for turn in turns:
                rotation = ours.T @ Rotation.from_euler("x", turn, degrees=True).as_matrix() @ flip @ theirs
                yield _centred(target, source, rotation)
    yield from feature_starts(target, source)


def starts_near(target: PreparedSetUp, source: PreparedSetUp, rotation: FloatArray, within_deg: float) -> Iterator[FloatArray]:
    """Yield starts about a rough rotation (3, 3), target from source: the rotation itself, and turned about each principal axis."""
    yield _centred(target, source, rotation)
    for axis in target.principal_axes:
        for turn in np.arange(TURN_STEP_DEG, within_deg + TURN_STEP_DEG / 2, TURN_STEP_DEG):
            for sign in (1.0, -1.0):
                yield _centred(target, source, Rotation.from_rotvec(np.radians(sign * turn) * axis).as_matrix() @ rotation)


def starts_turned(target: PreparedSetUp, start: FloatArray) -> Iterator[FloatArray]:
    """Yield a known position, and those turned about the principal axes through the target's middle: others of a symmetric part."""
    yield start
    middle = _middle(target.prepared.points_mm, target.principal_axes)
    for axis in target.principal_axes:
        for turn in np.arange(TURN_STEP_DEG, 360, TURN_STEP_DEG):
            rotation = Rotation.from_rotvec(np.radians(turn) * axis).as_matrix()
            turned = np.eye(4)
            turned[:3, :3], turned[:3, 3] = rotation, middle - rotation @ middle
            yield turned @ start


def feature_starts(target: PreparedSetUp, source: PreparedSetUp) -> Iterator[FloatArray]:
    """Yield starts by matched local features: FPFH (R. B. Rusu et al., ICRA 2009) and RANSAC, several runs with fixed seeds."""
    import open3d as o3d

    registration = o3d.pipelines.registration
    size = FPFH_VOXELS * target.prepared.voxel_mm
    clouds = [_with_features(one, size) for one in (source, target)]
    o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)  # few correspondences are no news here
    for seed in range(FPFH_RUNS):
        o3d.utility.random.seed(seed)
        result = registration.registration_ransac_based_on_feature_matching(
            clouds[0][0],
            clouds[1][0],
            clouds[0][1],
            clouds[1][1],
            True,
            1.5 * size,
            registration.TransformationEstimationPointToPoint(False),
            3,
            [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9), registration.CorrespondenceCheckerBasedOnDistance(1.5 * size)],
            registration.RANSACConvergenceCriteria(RANSAC_ITERATIONS, RANSAC_CONFIDENCE),
        )
        if len(result.correspondence_set) >= 3:
            yield np.array(result.transformation)


def _with_features(setup: PreparedSetUp, size_mm: float) -> tuple[Any, Any]:
    import open3d as o3d

    features: Any = o3d.pipelines.registration.compute_fpfh_feature  # its stub lacks the default of an argument
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(setup.prepared.points_mm))
    cloud.normals = o3d.utility.Vector3dVector(setup.prepared.normals)
    cloud = cloud.voxel_down_sample(size_mm)
    search = o3d.geometry.KDTreeSearchParamHybrid(radius=FPFH_RADIUS * size_mm, max_nn=100)
    return cloud, features(cloud, search)


def _middle(points_mm: FloatArray, axes: FloatArray) -> FloatArray:
    low, high = np.percentile(points_mm @ axes.T, [1, 99], axis=0)
    return np.asarray((low + high) / 2 @ axes)


def _centred(target: PreparedSetUp, source: PreparedSetUp, rotation: FloatArray) -> FloatArray:
    """Return the start with this rotation whose bounding boxes, along the target's principal axes, have the same middle."""
    axes = target.principal_axes
    sample = source.prepared.points_mm[source.sample] @ rotation.T
    start = np.eye(4)
    start[:3, :3] = rotation
    start[:3, 3] = _middle(target.prepared.points_mm[target.sample], axes) - _middle(sample, axes)
    return start


@dataclass(frozen=True, slots=True, eq=False)
class SampleMatches:
    """Corresponding points of the source's sample at a position."""

    points_mm: FloatArray  # (N, 3), moved sample
    near: BoolArray  # (N,), has a target point within the search radius that faces the same way
    normals: FloatArray  # (N, 3), of those target points
    distance_mm: FloatArray  # (N,), along them
    apart_mm: FloatArray  # (N,), between the points; infinite without one


def match_sample(target: PreparedSetUp, source: PreparedSetUp, matrix: FloatArray, reach_mm: float) -> SampleMatches:
    """Find the nearest target points of the source's sample within ``reach_mm``."""
    rotation = matrix[:3, :3]
    moved = source.prepared.points_mm[source.sample] @ rotation.T + matrix[:3, 3]
    apart, nearest = target.tree.query(moved, distance_upper_bound=reach_mm)
    found = np.isfinite(apart)
    nearest = np.where(found, nearest, 0)
    normals = target.prepared.normals[nearest]
    facing = np.einsum("ij,ij->i", source.prepared.normals[source.sample] @ rotation.T, normals) > AGREEMENT
    distance = np.einsum("ij,ij->i", moved - target.prepared.points_mm[nearest], normals)
    return SampleMatches(moved, found & facing, normals, distance, apart)


def _icp(target: PreparedSetUp, source: PreparedSetUp, start: FloatArray) -> FloatArray:
    matrix = np.array(start, float)
    voxel = target.prepared.voxel_mm
    for reach in np.geomspace(REACH_SHARE * target.diagonal_mm, LAST_REACH_VOXELS * voxel, STEPS):
        matched = match_sample(target, source, matrix, float(reach))
        if np.count_nonzero(matched.near) < LEAST_MATCHES:
            continue
        points, normals = matched.points_mm[matched.near], matched.normals[matched.near]
        centre, length = points.mean(axis=0), target.diagonal_mm / 2
        jacobian = np.hstack([normals, np.cross(points - centre, normals) / length])
        normal_matrix = jacobian.T @ jacobian + DAMPING * len(points) * np.eye(6)
        change = -np.linalg.solve(normal_matrix, jacobian.T @ matched.distance_mm[matched.near])
        step = np.eye(4)
        step[:3, :3] = Rotation.from_rotvec(change[3:] / length).as_matrix()
        step[:3, 3] = centre + change[:3] - step[:3, :3] @ centre
        matrix = step @ matrix
    return matrix


def contradicted(target: PreparedSetUp, source: PreparedSetUp, matrix: FloatArray, views: int | None = None) -> float:
    """Return the larger share of points of either set-up in space that the other one saw as empty; by ``views`` of each, None: all."""
    rotation, shift = matrix[:3, :3], matrix[:3, 3]
    ours, theirs = target.prepared.points_mm[target.sample], source.prepared.points_mm[source.sample]
    return max(
        contradicted_share(_some(target.seen, views), theirs @ rotation.T + shift),
        contradicted_share(_some(source.seen, views), (ours - shift) @ rotation),
    )


def _some(seen: tuple[SeenSpace, ...], count: int | None) -> tuple[SeenSpace, ...]:
    return seen if count is None else seen[:: max(1, len(seen) // count)]
