"""Pairwise registration: symmetric point-to-plane ICP, and GICP for starts too far away for it.

GICP: A. Segal et al., Robotics: Science and Systems, 2009, as in small_gicp (K. Koide, JOSS 9(100), 2024). Symmetric
point-to-plane: S. Rusinkiewicz, ACM Transactions on Graphics 38(4), 2019; exact to second order on curved surfaces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.pairs.prepare import GICP_NEIGHBOURS, PreparedCloud
from measureapp.register.pairs.smooth_errors import estimate_smooth_errors

LEAST_AGREEMENT = 0.85  # cosine between the normals of corresponding points
LEAST_MATCHES = 30
SIDEWAYS = 1.2  # in voxels: largest offset of corresponding points along the surface
ROBUST_SIGMAS = 3.5
MAD_TO_SIGMA = 1.4826
FLOOR_MM = 0.01  # least standard deviation of a distance
NORMAL_BIAS_RAD = 0.02  # correlated error of neighbouring normals, which a comparison of views does not show
UNDETERMINED = 1e-4  # directions with less than this share of the largest eigenvalue are not determined
STEPS = 20
MOST_MATCHES = 20_000  # source points per pair; neighbouring points are correlated, so that more add little
COARSE_MATCHES = 4_000  # during the iterations
CONVERGED_MM, CONVERGED_RAD = 2e-3, 2e-5  # convergence limit; with weak constraints, steps become small long before the end
SMALLEST_BLOCK_MM = 2.0  # smallest patch of correlated residuals …
BLOCK_SIZES = 5  # … and number of sizes, each twice the previous
LEAST_FACTOR, LEAST_STEEPNESS = 1e-9, 0.2
LEAST_SUPPORT = (
    0.4  # least share of robust over full weight in a direction; points that scatter `ROBUST_SIGMAS` times as far as usual keep as little
)
WELL_DETERMINED = 0.05  # directions above this share of the largest eigenvalue use one common variance factor
LEAST_BLOCKS = 24  # least number of patches for an estimate of their scatter
GICP_ITERATIONS = 30


@dataclass(frozen=True, slots=True, eq=False)
class PairMeasurement:
    """Relative pose of two views, measured on their common surface.

    ``change`` (translation mm, rotation rad; about ``centre_mm`` in the target's frame) is the remaining correction of the source beyond
    ``target_from_source``; ``information`` is its inverse covariance, zero in undetermined directions.
    """

    target: int
    source: int
    target_from_source: RigidTransform
    centre_mm: FloatArray  # (3,)
    change: FloatArray  # (6,)
    information: FloatArray  # (6, 6), 1/mm², 1/(mm rad), 1/rad²
    residual_mm: float  # rms point-to-plane distance of corresponding points
    matched_target: IntArray  # indices of thinned points
    matched_source: IntArray
    smooth_sigma_mm: float  # standard deviation of the smooth (correlated) errors of both clouds; contained in `information`

    @property
    def is_valid(self) -> bool:
        """Whether there are enough corresponding points."""
        return len(self.matched_source) >= LEAST_MATCHES


def build_gicp_model(prepared: PreparedCloud) -> tuple[Any, Any]:
    """Return small_gicp's cloud with covariances and its search tree."""
    import small_gicp

    cloud = small_gicp.PointCloud(prepared.points_mm)
    tree = small_gicp.KdTree(cloud)
    small_gicp.estimate_covariances(cloud, tree, GICP_NEIGHBOURS, 2)
    return cloud, tree


def align_by_gicp(target: tuple[Any, Any], source: tuple[Any, Any], start: RigidTransform, search_mm: float) -> RigidTransform:
    """Generalised ICP: return target_from_source from a start within ``search_mm``; the start itself with too few correspondences."""
    import small_gicp

    result = small_gicp.align(
        target[0], source[0], target[1], start.matrix, "GICP", search_mm, 2, GICP_ITERATIONS, 1e-5, 1e-3
    )  # fmt: skip
    if result.num_inliers < LEAST_MATCHES or not np.isfinite(result.T_target_source).all():
        return start
    matrix = result.T_target_source
    return RigidTransform.from_parts(_nearest_rotation(matrix[:3, :3]), matrix[:3, 3], start.to_frame, start.from_frame)


def _nearest_rotation(matrix: FloatArray) -> FloatArray:
    u, _, vt = np.linalg.svd(matrix)
    return np.asarray(u @ vt)


def register_pair(
    target: PreparedCloud, source: PreparedCloud, start: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Register two views by symmetric point-to-plane ICP from a start (target_from_source); undetermined directions keep the start."""
    pose = start
    for _ in range(STEPS):
        common = _find_correspondences(target, source, pose, search_mm, COARSE_MATCHES)
        if len(common.own) < LEAST_MATCHES:
            break
        change = _solve_robustly(common, settled=False).change
        pose = apply_motion(pose, change, common.centre_mm)
        if np.linalg.norm(change[:3]) < CONVERGED_MM and np.linalg.norm(change[3:]) < CONVERGED_RAD:
            break
    return measure_pair(target, source, pose, indices, search_mm)


def apply_motion(pose: RigidTransform, change: FloatArray, centre_mm: FloatArray) -> RigidTransform:
    """Apply a small motion (translation, rotation about ``centre_mm``, in ``to_frame``) after ``pose``."""
    turn = RigidTransform.from_vector(change[3:], np.zeros(3), pose.to_frame, pose.to_frame)
    shift = centre_mm + change[:3] - turn.rotation @ centre_mm
    return RigidTransform.from_parts(turn.rotation, shift, pose.to_frame, pose.to_frame) @ pose


def measure_pair(
    target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Linearise the symmetric point-to-plane problem of two views at ``pose`` (target_from_source).

    Parameters
    ----------
    search_mm : largest distance of corresponding points
    """
    common = _find_correspondences(target, source, pose, search_mm, MOST_MATCHES)
    solved = _solve_robustly(common, settled=True) if len(common.own) >= LEAST_MATCHES else None
    # where views lie far from where they belong, robust weights may leave no point, or surfaces that determine nothing together
    if solved is None or not len(_determined_directions(solved.matrix)[0]):
        none = np.empty(0, np.int64)
        return PairMeasurement(*indices, pose, target.centroid_mm, np.zeros(6), np.zeros((6, 6)), 0.0, none, none, 0.0)
    kept = solved.weight > 0
    smooth_sigma_mm, shared = _estimate_shared_errors(common, solved)
    information = _add_shared_errors(_estimate_information(common, solved), shared)
    residual = float(np.sqrt(np.mean(solved.left_mm[kept] ** 2)))
    return PairMeasurement(
        *indices, pose, common.centre_mm, solved.change, information, residual, common.other[kept], common.own[kept], smooth_sigma_mm
    )


def _add_shared_errors(information: FloatArray, shared: FloatArray) -> FloatArray:
    """Add the covariance Σ of errors shared by all points to the information H of a pair: H (I + Σ H)⁻¹."""
    both = information @ np.linalg.inv(np.eye(6) + shared @ information)
    return np.asarray((both + both.T) / 2)


def _estimate_shared_errors(common: _Correspondences, solved: _RobustSolution) -> tuple[float, FloatArray]:
    """Estimate errors that vary too slowly for patches to show: standard deviation (mm), and covariance (6, 6) of the change."""
    kept = solved.weight > 0
    smooth_sigma_mm, scatter = estimate_smooth_errors(
        common.arm_mm[kept], common.normal[kept], solved.jacobian[kept], solved.weight[kept], solved.left_mm[kept]
    )
    values, axes, _ = _determined_directions(solved.matrix)
    lever = (axes / values) @ axes.T
    return smooth_sigma_mm, np.asarray(lever @ scatter @ lever)


@dataclass(frozen=True, slots=True, eq=False)
class _Correspondences:
    """Corresponding points of two views at a pose."""

    own: IntArray  # (K,), indices of source points
    other: IntArray  # (K,), indices of target points
    centre_mm: FloatArray  # (3,), of the moved source points
    arm_mm: FloatArray  # (K, 3), from the centre to each of them
    normal: FloatArray  # (K, 3), mean of both, unit
    distance_mm: FloatArray  # (K,), along the normal
    variance_mm2: FloatArray  # (K,), of the distance, from the noise of the points
    tilt_rad: float  # standard deviation of the normals

    @property
    def radius_mm(self) -> float:
        return float(np.sqrt(np.mean(np.sum(self.arm_mm**2, axis=1))))


def _find_correspondences(
    target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, search_mm: float, most: int
) -> _Correspondences:
    """Nearest-neighbour correspondences of about ``most`` source points, limited in distance, tangential offset and normal angle."""
    from measureapp.register.pairs.kernels import MatchLimits, match_points

    stride = max(1, -(-len(source) // most))
    limits = MatchLimits(search_mm, LEAST_AGREEMENT, SIDEWAYS * target.voxel_mm)
    own, other, rows, disagreement = match_points(
        source.points_mm, source.normals, stride, pose.rotation, pose.translation_mm, target.sorted_points, limits
    )
    centre = rows[:, :3].mean(axis=0) if len(rows) else np.zeros(3)
    variance = source.variance_mm2[own] + target.variance_mm2[other] + FLOOR_MM**2
    tilt = float(np.hypot(np.sqrt(max(disagreement, 0.0)), NORMAL_BIAS_RAD))
    return _Correspondences(own, other, centre, rows[:, :3] - centre, rows[:, 3:6], rows[:, 6], variance, tilt)


@dataclass(frozen=True, slots=True, eq=False)
class _RobustSolution:
    change: FloatArray  # (6,)
    matrix: FloatArray  # (6, 6), weighted normal matrix
    jacobian: FloatArray  # (K, 6), of the distances
    weight: FloatArray  # (K,)
    left_mm: FloatArray  # (K,), distances after the change
    steepness: float  # of the weighted distances against the distances, over the weights: below one, as outliers' weights fall


def _solve_robustly(common: _Correspondences, *, settled: bool) -> _RobustSolution:
    """Iteratively reweighted least squares (Tukey biweight about the median); if ``settled``, without weakly supported directions."""
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
        if last and settled:  # earlier, a surface that starts too far away would be rejected for good
            matrix_disputed, right_disputed = _weakly_supported_part(jacobian, weight, 1 / common.variance_mm2, right)
            matrix, right = matrix - (1 + common.tilt_rad**2) * matrix_disputed, right - right_disputed
        change, matrix = _solve_determined(matrix, right)
        left = common.distance_mm + jacobian @ change
        middle = 0.0
    slope = (1 - away) * (1 - 5 * away) / common.variance_mm2
    return _RobustSolution(
        change, matrix, jacobian, weight, left, max(float(slope.sum() / max(weight.sum(), LEAST_FACTOR)), LEAST_STEEPNESS)
    )


def _estimate_information(common: _Correspondences, solved: _RobustSolution) -> FloatArray:
    """Cluster-robust covariance: return the inverse covariance (6, 6) of the change from the scatter of sums over surface patches.

    Residuals of neighbouring points are correlated, as calibration errors are smooth, so that there are far fewer independent
    observations than points. Their number follows from the scatter of the gradient summed over patches, in units of the normal matrix
    (K.-Y. Liang, S. L. Zeger, Biometrika 73(1), 13-22, 1986). Patches miss the correlation across their borders, a bias inversely
    proportional to their size, which is extrapolated from patches of half the size (D. N. Politis, J. P. Romano, Journal of Time Series
    Analysis 16(1), 67-103, 1995). The patch size with the largest result counts.
    """
    kept = solved.weight > 0
    values, axes, forms = _determined_directions(solved.matrix)
    sums: FloatArray = solved.jacobian[kept] * (solved.weight[kept] * solved.left_mm[kept])[:, None] @ axes
    cells: IntArray = np.floor(common.arm_mm[kept] / SMALLEST_BLOCK_MM).astype(np.int64)
    well = values > WELL_DETERMINED * values[-1]
    own, usual, smaller = np.zeros(len(values)), LEAST_FACTOR, None
    for _ in range(BLOCK_SIZES):
        cells, sums = _sum_per_cell(cells, sums)
        if len(sums) < LEAST_BLOCKS and smaller is not None:
            break
        scatter = np.sum(sums**2, axis=0) / values * (len(sums) / max(len(sums) - len(values), 1))
        whole = scatter if smaller is None else np.maximum(scatter, 2 * scatter - smaller)
        own, usual = np.maximum(own, whole), max(usual, float(np.mean(whole[well])))
        smaller, cells = scatter, cells >> 1
    # one common factor is known better than one per direction, but is too small where the errors of the normals dominate the matrix
    factor = np.where(well, usual, np.maximum(own, usual)) / solved.steepness**2
    return np.asarray((forms * (values / factor)) @ forms.T)


def _sum_per_cell(cells: IntArray, rows: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the occupied cells (C, 3) and the sums of their rows (C, K)."""
    keys = ((cells[:, 0] + (1 << 19)) << 40) | ((cells[:, 1] + (1 << 19)) << 20) | (cells[:, 2] + (1 << 19))
    _, first, block = np.unique(keys, return_index=True, return_inverse=True)
    return cells[first], np.column_stack([np.bincount(block, column, len(first)) for column in rows.T])


def _parameter_scales(matrix: FloatArray) -> FloatArray:
    """Return the scales (6,) that make the parameters of a normal matrix comparable."""
    diagonal = np.diag(matrix)
    floor = 1e-9 * np.array([diagonal[:3].max()] * 3 + [diagonal[3:].max()] * 3)
    return np.sqrt(np.maximum(np.maximum(diagonal, floor), np.finfo(float).tiny))


def _weakly_supported_part(
    jacobian: FloatArray, weight: FloatArray, stated: FloatArray, right: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the part of the normal equations (matrix, right side) in directions where robust weighting rejected most of the weight.

    A wall of which two views share only stray points along an edge would otherwise be measured by those that happen to lie as far off as
    the poses do: they agree with each other because the others were rejected.

    The directions are generalised eigenvectors, orthogonal to all others both with and without robust weights, so that nothing else is
    removed with them. This holds for the plain sums over the points, before the correction for the errors of the normals.

    Parameters
    ----------
    jacobian : (M, 6), of the distances
    weight, stated : (M,), weights of the points with and without the robust factor
    """
    whole, left = ((jacobian * each[:, None]).T @ jacobian for each in (stated, weight))
    size = _parameter_scales(whole)
    values, vectors = np.linalg.eigh(whole / np.outer(size, size))
    whitened = vectors / np.sqrt(np.maximum(values, LEAST_FACTOR * values[-1])) / size[:, None]
    kept, directions = np.linalg.eigh(whitened.T @ left @ whitened)
    disputed = whitened @ directions[:, kept < LEAST_SUPPORT]
    along = left @ disputed
    gain = along @ np.linalg.pinv(disputed.T @ along)
    matrix = gain @ along.T
    return (matrix + matrix.T) / 2, gain @ (disputed.T @ right)


def _determined_directions(matrix: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the determined directions of a normal matrix: eigenvalues (K,), axes (6, K), and dual forms (6, K).

    Excluded are directions of negligible information, and those whose information is negative after the correction for the normals.
    """
    if not (np.diag(matrix)[:3].max() > 0 and np.diag(matrix)[3:].max() > 0):
        return np.empty(0), np.empty((6, 0)), np.empty((6, 0))
    size = _parameter_scales(matrix)
    values, vectors = np.linalg.eigh(matrix / np.outer(size, size))
    strong = values > UNDETERMINED * values[-1]
    return values[strong], vectors[:, strong] / size[:, None], vectors[:, strong] * size[:, None]


def _solve_determined(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve ``matrix @ x = right`` by a truncated eigenvalue decomposition; undetermined directions get neither change nor information."""
    values, axes, forms = _determined_directions(matrix)
    return axes @ ((axes.T @ right) / values), (forms * values) @ forms.T
