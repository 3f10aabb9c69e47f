"""Fine registration of two views by symmetric point-to-plane distances, with GICP where the start is too far for that.

GICP: A. Segal et al., Robotics: Science and Systems, 2009, as in small_gicp (K. Koide, JOSS 9(100), 2024). Symmetric
point-to-plane: S. Rusinkiewicz, ACM Transactions on Graphics 38(4), 2019; exact to second order on curved surfaces.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.prepare import GICP_NEIGHBOURS, PreparedCloud

LEAST_AGREEMENT = 0.85  # cosine between the normals of corresponding points
LEAST_MATCHES = 30
SIDEWAYS = 1.2  # in voxels: corresponding points lie no further apart along the surface
ROBUST_SIGMAS = 3.5
MAD_TO_SIGMA = 1.4826
FLOOR_MM = 0.01  # errors smaller than this are never trusted
CORRELATION_MM = 5.0  # neighbouring residuals within this length are one observation: calibration errors are smooth
NORMAL_BIAS_RAD = 0.02  # errors that neighbouring normals have in common, so that comparing views does not show them
WEAK = 1e-4  # share of the strongest direction's information below which a direction is not measured at all
SHARED_ERROR_MM = 0.01
STEPS = 12
MOST_MATCHES = 40_000  # source points per pair; neighbouring ones err together, so that more say little more
STILL_MM, STILL_RAD = 1e-3, 1e-5
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
    matrix = result.T_target_source
    return RigidTransform.from_parts(_rotation(matrix[:3, :3]), matrix[:3, 3], start.to_frame, start.from_frame)


def _rotation(matrix: FloatArray) -> FloatArray:
    u, _, vt = np.linalg.svd(matrix)
    return np.asarray(u @ vt)


def register_pair(
    target: PreparedCloud, source: PreparedCloud, start: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Register two views from a start (target_from_source); nothing moves in directions that the common surface does not hold."""
    pose = start
    measured = measure_pair(target, source, pose, indices, search_mm)
    for _ in range(STEPS):
        if not measured.found or (np.linalg.norm(measured.change[:3]) < STILL_MM and np.linalg.norm(measured.change[3:]) < STILL_RAD):
            break
        pose = stepped(pose, measured.change, measured.centre_mm)
        measured = measure_pair(target, source, pose, indices, search_mm)
    return measured


def stepped(pose: RigidTransform, change: FloatArray, centre_mm: FloatArray) -> RigidTransform:
    """Return ``pose`` followed by a small motion (translation, rotation about ``centre_mm``) in its ``to_frame``."""
    turn = RigidTransform.from_vector(change[3:], np.zeros(3), pose.to_frame, pose.to_frame)
    shift = centre_mm + change[:3] - turn.rotation @ centre_mm
    return RigidTransform.from_parts(turn.rotation, shift, pose.to_frame, pose.to_frame) @ pose


def measure_pair(
    target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, indices: tuple[int, int], search_mm: float
) -> PairMeasurement:
    """Linearise the symmetric point-to-plane problem of two views at ``pose`` (target_from_source)."""
    p, q, normal, variance, tilt, own, other = _correspondences(target, source, pose, search_mm)
    if len(own) < LEAST_MATCHES:
        none = np.empty(0, np.int64)
        return PairMeasurement(*indices, pose, target.centroid_mm, np.zeros(6), np.zeros((6, 6)), 0.0, none, none)
    residual = np.einsum("ij,ij->i", p - q, normal)
    centre = p.mean(axis=0)
    jacobian = np.column_stack([normal, np.cross(p - centre, normal)])
    change, matrix, variance_factor, kept = _solved(jacobian, residual, variance, _tilted(p - centre, normal, tilt))
    share = min(1.0, (target.voxel_mm / CORRELATION_MM) ** 2)
    left = residual[kept]
    information = _with_shared_errors(matrix * (share / variance_factor), float(np.sqrt(np.mean(np.sum((p - centre) ** 2, axis=1)))))
    return PairMeasurement(*indices, pose, centre, change, information, float(np.sqrt(np.mean(left**2))), other[kept], own[kept])


def _with_shared_errors(information: FloatArray, radius_mm: float) -> FloatArray:
    """Add the errors that all points of a view share (camera calibration, table) to the covariance: H (I + Σ H)⁻¹."""
    shared = np.diag([SHARED_ERROR_MM**2] * 3 + [(SHARED_ERROR_MM / max(radius_mm, 1.0)) ** 2] * 3)
    both = information @ np.linalg.inv(np.eye(6) + shared @ information)
    return np.asarray((both + both.T) / 2)


def _tilted(arm_mm: FloatArray, normal: FloatArray, tilt: float) -> FloatArray:
    """Return (2, N, 6) what an error of ``tilt`` (rad) of the normals adds to the derivatives, along both tangents.

    Normals that err make a plane look as if it held sideways motion; this much of the information is not real.
    """
    helper = np.eye(3)[np.argmin(np.abs(normal), axis=1)]
    first = np.cross(normal, helper)
    first *= tilt / np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normal, first)
    return np.stack([np.column_stack([side, np.cross(arm_mm, side)]) for side in (first, second)])


def _correspondences(
    target: PreparedCloud, source: PreparedCloud, pose: RigidTransform, search_mm: float
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, float, IntArray, IntArray]:
    """Return moved source points, their nearest target points, mean normals, variances, the normals' error (rad) and both indices."""
    empty = np.empty((0, 3))
    if len(target) == 0 or len(source) == 0:
        return empty, empty, empty, np.empty(0), 0.0, np.empty(0, np.int64), np.empty(0, np.int64)
    moved, turned = pose.apply(source.points_mm), pose.rotate(source.normals)
    low, high = target.points_mm.min(axis=0) - search_mm, target.points_mm.max(axis=0) + search_mm
    near = np.flatnonzero(np.all((moved > low) & (moved < high), axis=1))
    near = near[:: max(1, len(near) // MOST_MATCHES)]
    distance, index = target.tree.query(moved[near], distance_upper_bound=search_mm, workers=-1)
    found = np.isfinite(distance)
    own, other = near[found], index[found]
    normal = turned[own] + target.normals[other]
    length = np.linalg.norm(normal, axis=1)
    across = np.einsum("ij,ij->i", moved[own] - target.points_mm[other], normal) / np.maximum(length, 1e-9)
    sideways = distance[found] ** 2 - across**2
    keep = (np.einsum("ij,ij->i", turned[own], target.normals[other]) > LEAST_AGREEMENT) & (sideways < (SIDEWAYS * target.voxel_mm) ** 2)
    own, other = own[keep], other[keep]
    variance = source.variance_mm2[own] + target.variance_mm2[other] + FLOOR_MM**2
    disagreement = np.sum((turned[own] - target.normals[other]) ** 2, axis=1) / 8  # per tangent, of the mean of the two
    tilt = float(np.hypot(np.sqrt(np.mean(disagreement)) if len(own) else 0.0, NORMAL_BIAS_RAD))
    return moved[own], target.points_mm[other], normal[keep] / length[keep, None], variance, tilt, own, other


def _solved(
    jacobian: FloatArray, residual: FloatArray, variance: FloatArray, tilted: FloatArray
) -> tuple[FloatArray, FloatArray, float, BoolArray]:
    """Solve robustly (Tukey weights about the median); returns change, weighted normal matrix, variance factor and the points used."""
    left = residual
    weight: FloatArray = 1 / variance
    change: FloatArray = np.zeros(6)
    matrix: FloatArray = np.eye(6)
    for _ in range(3):
        scale = max(MAD_TO_SIGMA * float(np.median(np.abs(left - np.median(left)))), FLOOR_MM)
        distance = (left - (np.median(left) if not change.any() else 0.0)) / (ROBUST_SIGMAS * scale)
        weight = np.where(np.abs(distance) < 1, (1 - distance**2) ** 2, 0) / variance
        matrix = jacobian.T @ (jacobian * weight[:, None]) - sum(side.T @ (side * weight[:, None]) for side in tilted)
        change, matrix = _observable(matrix, -jacobian.T @ (weight * residual))
        left = residual + jacobian @ change
    kept = weight > 0
    factor = float(np.sum(weight * left**2) / np.sum(weight * variance))
    floor = FLOOR_MM**2 / float(np.median(variance))
    return change, matrix, max(factor, floor), kept


def _observable(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve ``matrix @ x = right`` in the directions that are measured; the others get neither change nor information."""
    diagonal = np.diag(matrix)
    size = np.sqrt(np.maximum(diagonal, 1e-9 * np.array([diagonal[:3].max()] * 3 + [diagonal[3:].max()] * 3)))
    values, vectors = np.linalg.eigh(matrix / np.outer(size, size))
    strong = values > WEAK * values[-1]
    inverse = np.divide(1, values, out=np.zeros_like(values), where=strong)
    change = (vectors @ (inverse * (vectors.T @ (right / size)))) / size
    cleaned = (vectors * np.where(strong, values, 0)) @ vectors.T * np.outer(size, size)
    return change, cleaned
