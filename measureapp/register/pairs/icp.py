"""Fine registration of two views by symmetric point-to-plane distances, with GICP where the start is too far for that.

GICP: A. Segal et al., Robotics: Science and Systems, 2009, as in small_gicp (K. Koide, JOSS 9(100), 2024). Symmetric
point-to-plane: S. Rusinkiewicz, ACM Transactions on Graphics 38(4), 2019; exact to second order on curved surfaces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.register.pairs.prepare import GICP_NEIGHBOURS, PreparedCloud
from measureapp.register.pairs.smooth_errors import smooth_errors

LEAST_AGREEMENT = 0.85  # cosine between the normals of corresponding points
LEAST_MATCHES = 30
SIDEWAYS = 1.2  # in voxels: corresponding points lie no further apart along the surface
ROBUST_SIGMAS = 3.5
MAD_TO_SIGMA = 1.4826
FLOOR_MM = 0.01  # errors smaller than this are never trusted
NORMAL_BIAS_RAD = 0.02  # errors that neighbouring normals have in common, so that comparing views does not show them
WEAK = 1e-4  # share of the strongest direction's information below which a direction is not measured at all
STEPS = 20
MOST_MATCHES = 20_000  # source points per pair; neighbouring ones err together, so that more say little more
COARSE_MATCHES = 4_000  # while a pair still moves
STILL_MM, STILL_RAD = 2e-3, 2e-5  # a smaller step is the last; where little holds the views, steps are small long before the end
SMALLEST_BLOCK_MM = 2.0  # patches of the surface within which residuals may be alike …
BLOCK_SIZES = 5  # … and so many times twice as large ones
LEAST_FACTOR, LEAST_STEEPNESS = 1e-9, 0.2
LEAST_KEPT = (
    0.4  # of the weight of the points that see a direction; as little is left of points that scatter `ROBUST_SIGMAS` times as far as usual
)
WELL_HELD = 0.05  # share of the strongest direction's information from which directions scatter alike
LEAST_BLOCKS = 24  # fewer say too little about how much they scatter
GICP_ITERATIONS = 30


@dataclass(frozen=True, slots=True, eq=False)
class PairMeasurement:
    """How two views lie to each other by their common surface.

    ``change`` (translation mm, rotation rad; about ``centre_mm`` in the target's frame) is what the source should still
    move by, beyond ``target_from_source``; ``information`` is the inverse covariance of it, zero in directions unseen.
    """

    target: int
    source: int
    target_from_source: RigidTransform
    centre_mm: FloatArray  # (3,)
    change: FloatArray  # (6,)
    information: FloatArray  # (6, 6), 1/mm², 1/(mm rad), 1/rad²
    residual_mm: float  # rms distance across the surface of corresponding points
    matched_target: IntArray  # indices of thinned points
    matched_source: IntArray
    smooth_mm: float  # standard deviation of what the two clouds err by, alike over the whole surface; `information` knows of it

    @property
    def found(self) -> bool:
        """Whether there are enough common points."""
        return len(self.matched_source) >= LEAST_MATCHES


def gicp_model(prepared: PreparedCloud) -> tuple[Any, Any]:
    """Return small_gicp's cloud with covariances and its tree; made once per view."""
    import small_gicp

    cloud = small_gicp.PointCloud(prepared.points_mm)
    tree = small_gicp.KdTree(cloud)
    small_gicp.estimate_covariances(cloud, tree, GICP_NEIGHBOURS, 2)
    return cloud, tree


def gicp(target: tuple[Any, Any], source: tuple[Any, Any], start: RigidTransform, search_mm: float) -> RigidTransform:
    """Return target_from_source by GICP from a start within ``search_mm``; the start when there is nothing to go by."""
    import small_gicp

    result = small_gicp.align(
        target[0], source[0], target[1], start.matrix, "GICP", search_mm, 2, GICP_ITERATIONS, 1e-5, 1e-3
    )  # fmt: skip
    if result.num_inliers < LEAST_MATCHES or not np.isfinite(result.T_target_source).all():
        return start
    return RigidTransform(orthonormalise(result.T_target_source), start.to_frame, start.from_frame)


def register_pair(
    target: PreparedCloud, source: PreparedCloud, start: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Register two views from a start (target_from_source); nothing moves in directions that the common surface does not hold."""
    pose = start
    for _ in range(STEPS):
        common = _common_surface(target, source, pose, search_mm, COARSE_MATCHES)
        if len(common.own) < LEAST_MATCHES:
            break
        change = _solved(common, settled=False).change
        pose = stepped(pose, change, common.centre_mm)
        if np.linalg.norm(change[:3]) < STILL_MM and np.linalg.norm(change[3:]) < STILL_RAD:
            break
    return measure_pair(target, source, pose, indices, search_mm)


def stepped(pose: RigidTransform, change: FloatArray, centre_mm: FloatArray) -> RigidTransform:
    """Return ``pose`` followed by a small motion (translation, rotation about ``centre_mm``) in its ``to_frame``."""
    turn = RigidTransform.from_vector(change[3:], np.zeros(3), pose.to_frame, pose.to_frame)
    shift = centre_mm + change[:3] - turn.rotation @ centre_mm
    return RigidTransform.from_parts(turn.rotation, shift, pose.to_frame, pose.to_frame) @ pose


def measure_pair(
    target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Linearise the symmetric point-to-plane problem of two views at ``pose`` (target_from_source).

    Parameters
    ----------
    search_mm : furthest distance of corresponding points
    """
    common = _common_surface(target, source, pose, search_mm, MOST_MATCHES)
    if len(common.own) < LEAST_MATCHES:
        none = np.empty(0, np.int64)
        return PairMeasurement(*indices, pose, target.centroid_mm, np.zeros(6), np.zeros((6, 6)), 0.0, none, none, 0.0)
    solved = _solved(common, settled=True)
    kept = solved.weight > 0
    smooth_mm, shared = _shared(common, solved)
    information = _with_shared_errors(_information(common, solved), shared)
    residual = float(np.sqrt(np.mean(solved.left_mm[kept] ** 2)))
    return PairMeasurement(
        *indices, pose, common.centre_mm, solved.change, information, residual, common.other[kept], common.own[kept], smooth_mm
    )


def _with_shared_errors(information: FloatArray, shared: FloatArray) -> FloatArray:
    """Add the covariance of errors that all points share to a pair's own: H (I + Σ H)⁻¹."""
    both = information @ np.linalg.inv(np.eye(6) + shared @ information)
    return np.asarray((both + both.T) / 2)


def _shared(common: _Common, solved: _Solved) -> tuple[float, FloatArray]:
    """Return the errors that vary too slowly over the surface for its patches to show: their size (mm), their covariance (6, 6) of the change."""
    kept = solved.weight > 0
    smooth_mm, scatter = smooth_errors(
        common.arm_mm[kept], common.normal[kept], solved.jacobian[kept], solved.weight[kept], solved.left_mm[kept]
    )
    values, axes, _ = _measured(solved.matrix)
    lever = (axes / values) @ axes.T
    return smooth_mm, np.asarray(lever @ scatter @ lever)


@dataclass(frozen=True, slots=True, eq=False)
class _Common:
    """What two views have in common at a pose."""

    own: IntArray  # (K,), of the source's points
    other: IntArray  # (K,), of the target's
    centre_mm: FloatArray  # (3,), of the moved source points
    arm_mm: FloatArray  # (K, 3), from the centre to each of them
    normal: FloatArray  # (K, 3), mean of both, unit
    distance_mm: FloatArray  # (K,), along the normal
    variance_mm2: FloatArray  # (K,), of the distance by the points' own noise
    tilt_rad: float  # error of the normals

    @property
    def radius_mm(self) -> float:
        return float(np.sqrt(np.mean(np.sum(self.arm_mm**2, axis=1))))


def _common_surface(target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, search_mm: float, most: int) -> _Common:
    """Pair every source point (about ``most`` of them) with the nearest target point, where they face alike and lie on each other."""
    from measureapp.register.pairs.kernels import corresponding

    index = target.index
    stride = max(1, -(-len(source) // most))
    own, other, rows, disagreement = corresponding(
        source.points_mm, source.normals, stride, pose.rotation, pose.translation_mm, target.points_mm, target.normals,
        index.edge_mm, index.keys, index.starts, index.table, search_mm, LEAST_AGREEMENT, SIDEWAYS * target.voxel_mm,
    )  # fmt: skip
    centre = rows[:, :3].mean(axis=0) if len(rows) else np.zeros(3)
    variance = source.variance_mm2[own] + target.variance_mm2[other] + FLOOR_MM**2
    tilt = float(np.hypot(np.sqrt(max(disagreement, 0.0)), NORMAL_BIAS_RAD))
    return _Common(own, other, centre, rows[:, :3] - centre, rows[:, 3:6], rows[:, 6], variance, tilt)


@dataclass(frozen=True, slots=True, eq=False)
class _Solved:
    change: FloatArray  # (6,)
    matrix: FloatArray  # (6, 6), weighted normal matrix
    jacobian: FloatArray  # (K, 6), of the distances
    weight: FloatArray  # (K,)
    left_mm: FloatArray  # (K,), distances after the change
    steepness: float  # of the weighted distances against the distances, over the weights: below one, as outliers' weights fall


def _solved(common: _Common, *, settled: bool) -> _Solved:
    """Solve robustly (Tukey weights about the median); once views are ``settled``, only in directions that most of the points agree in."""
    from measureapp.register.pairs.kernels import normal_equations

    jacobian = np.column_stack([common.normal, np.cross(common.arm_mm, common.normal)])
    left, middle = common.distance_mm, float(np.median(common.distance_mm))
    away: FloatArray = np.zeros(len(left))
    weight: FloatArray = 1 / common.variance_mm2
    change: FloatArray = np.zeros(6)
    matrix: FloatArray = np.eye(6)
    for last in (False, False, True):
        scale = max(MAD_TO_SIGMA * float(np.median(np.abs(left - np.median(left)))), FLOOR_MM)
        away = np.minimum(((left - middle) / (ROBUST_SIGMAS * scale)) ** 2, 1.0)
        weight = (1 - away) ** 2 / common.variance_mm2
        matrix, right = normal_equations(common.arm_mm, common.normal, common.distance_mm, weight, common.tilt_rad)
        if last and settled:  # before that, a surface that the start puts too far away would be rejected for good
            matrix_disputed, right_disputed = _disputed(jacobian, weight, 1 / common.variance_mm2, right)
            matrix, right = matrix - (1 + common.tilt_rad**2) * matrix_disputed, right - right_disputed
        change, matrix = _solution(matrix, right)
        left = common.distance_mm + jacobian @ change
        middle = 0.0
    slope = (1 - away) * (1 - 5 * away) / common.variance_mm2
    return _Solved(change, matrix, jacobian, weight, left, max(float(slope.sum() / weight.sum()), LEAST_STEEPNESS))


def _information(common: _Common, solved: _Solved) -> FloatArray:
    """Return the inverse covariance (6, 6) of the change, by the scatter of sums over patches of the surface.

    Residuals of neighbouring points are alike, as calibration errors are smooth, so that far fewer observations are independent
    than there are points. The gradient summed over patches tells how many: its scatter, in units of the normal matrix
    (cluster-robust covariance; K.-Y. Liang, S. L. Zeger, Biometrika 73(1), 13-22, 1986). What patches miss is what lies across
    their borders, in inverse proportion to their size, so that patches half as large tell the rest (D. N. Politis, J. P. Romano,
    Journal of Time Series Analysis 16(1), 67-103, 1995). The size that makes most of it counts.
    """
    kept = solved.weight > 0
    values, axes, forms = _measured(solved.matrix)
    sums: FloatArray = solved.jacobian[kept] * (solved.weight[kept] * solved.left_mm[kept])[:, None] @ axes
    cells: IntArray = np.floor(common.arm_mm[kept] / SMALLEST_BLOCK_MM).astype(np.int64)
    well = values > WELL_HELD * values[-1]
    own, usual, smaller = np.zeros(len(values)), LEAST_FACTOR, None
    for _ in range(BLOCK_SIZES):
        cells, sums = _summed(cells, sums)
        if len(sums) < LEAST_BLOCKS and smaller is not None:
            break
        scatter = np.sum(sums**2, axis=0) / values * (len(sums) / max(len(sums) - len(values), 1))
        whole = scatter if smaller is None else np.maximum(scatter, 2 * scatter - smaller)
        own, usual = np.maximum(own, whole), max(usual, float(np.mean(whole[well])))
        smaller, cells = scatter, cells >> 1
    # one factor for all directions is known better than one for each, but where the normals' errors take most of the matrix it is not enough
    factor = np.where(well, usual, np.maximum(own, usual)) / solved.steepness**2
    return np.asarray((forms * (values / factor)) @ forms.T)


def _summed(cells: IntArray, rows: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return every cell (N, 3) once, and the sums of its rows."""
    keys = ((cells[:, 0] + (1 << 19)) << 40) | ((cells[:, 1] + (1 << 19)) << 20) | (cells[:, 2] + (1 << 19))
    _, first, block = np.unique(keys, return_index=True, return_inverse=True)
    return cells[first], np.column_stack([np.bincount(block, column, len(first)) for column in rows.T])


def _sizes(matrix: FloatArray) -> FloatArray:
    """Return the scales (6,) that make the parameters of a normal matrix comparable."""
    diagonal = np.diag(matrix)
    return np.sqrt(np.maximum(diagonal, 1e-9 * np.array([diagonal[:3].max()] * 3 + [diagonal[3:].max()] * 3)))


def _disputed(jacobian: FloatArray, weight: FloatArray, stated: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return what the normal equations know by directions that too few of the points which see them agree in: of matrix and right side.

    A wall of which two views share no more than stray points along an edge would otherwise be measured by those of them that happen
    to lie as far off as the poses do: they agree with each other because the others were rejected.

    The directions are apart from all others both for all points and for those left, so that nothing else is taken away with them.
    That holds of the sums over the points as they are, not once the errors of their normals are taken off.

    Parameters
    ----------
    jacobian : (M, 6), of the distances
    weight, stated : (M,), of the points with and without what rejects outliers
    """
    whole, left = ((jacobian * each[:, None]).T @ jacobian for each in (stated, weight))
    size = _sizes(whole)
    values, vectors = np.linalg.eigh(whole / np.outer(size, size))
    whitened = vectors / np.sqrt(np.maximum(values, LEAST_FACTOR * values[-1])) / size[:, None]
    kept, directions = np.linalg.eigh(whitened.T @ left @ whitened)
    disputed = whitened @ directions[:, kept < LEAST_KEPT]
    along = left @ disputed
    gain = along @ np.linalg.pinv(disputed.T @ along)
    matrix = gain @ along.T
    return (matrix + matrix.T) / 2, gain @ (disputed.T @ right)


def _measured(matrix: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the directions that a normal matrix knows something of: how much (K,), the axes (6, K), and their dual forms (6, K).

    Left out are directions of next to no information, and those that have less than none once the normals' errors are taken off.
    """
    size = _sizes(matrix)
    values, vectors = np.linalg.eigh(matrix / np.outer(size, size))
    strong = values > WEAK * values[-1]
    return values[strong], vectors[:, strong] / size[:, None], vectors[:, strong] * size[:, None]


def _solution(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve ``matrix @ x = right`` in the directions that are measured; the others get neither change nor information."""
    values, axes, forms = _measured(matrix)
    return axes @ ((axes.T @ right) / values), (forms * values) @ forms.T
