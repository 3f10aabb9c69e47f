"""Robust point-to-plane registration of points to a mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import AlignmentSettings
from measureapp.inspection.surface.nominal import Closest, NominalSurface
from measureapp.progress import NoProgress, Progress

ROBUST_SIGMA = 1.4826  # median absolute deviation of a normal distribution to its σ
TUKEY = 4.685
COOLING = 0.6
DETERMINED = 2e-4  # relative eigenvalue below which a motion is undetermined
CONVERGED_MM = 1e-5
MOTIONS = ("rotation about x", "rotation about y", "rotation about z", "translation along x", "translation along y", "translation along z")


@dataclass(frozen=True, slots=True, eq=False)
class Registration:
    """Result of the registration."""

    matrix: FloatArray  # (4, 4) nominal_from_part
    rms_mm: float  # of the points near the nominal
    overlap: float
    undetermined: tuple[str, ...]


def register(
    points: MeasuredPoints,
    surface: NominalSurface,
    start: FloatArray,
    settings: AlignmentSettings,
    *,
    iterations: int | None = None,
    reach_mm: float | None = None,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Registration:
    """Point-to-plane ICP of ``points`` to ``surface`` from ``start``, by Gauss-Newton steps with Tukey weights.

    Method: Y. Chen and G. Medioni, Image and Vision Computing 10(3), 1992; motions with too small an eigenvalue stay zero, so that a flat
    or round part keeps its start in undetermined directions.

    Parameters
    ----------
    reach_mm : initial limit of the distances; by default 5 % of the nominal's diagonal
    progress : where it can be cancelled, at every step
    """
    matrix = np.array(start, float)
    reach = 0.05 * surface.diagonal_mm if reach_mm is None else reach_mm
    annealed = reach  # wide at first: if half of the points fit already, the scatter alone would reject the other half for good
    undetermined: tuple[str, ...] = ()
    near: IntArray | None = None
    for _ in range(settings.iterations if iterations is None else iterations):
        progress.check()
        moved, closest, residual, counts = _match(points, surface, matrix, settings, reach, near)
        near = closest.triangles
        if counts.sum() < 12:
            reach *= 2
            continue
        scale = ROBUST_SIGMA * float(np.median(np.abs(residual[counts])))
        narrow = max(TUKEY * scale, 1e-4 * surface.diagonal_mm)
        width = max(narrow, annealed)
        annealed *= COOLING
        weights = np.where(counts & (np.abs(residual) < width), (1 - np.minimum(np.abs(residual) / width, 1) ** 2) ** 2, 0.0)
        step, undetermined = _step(moved, closest.normals, residual, weights, surface.diagonal_mm / 2)
        matrix = step @ matrix
        reach = max(0.7 * reach, 3 * width, 0.01 * surface.diagonal_mm)
        if (
            width == narrow
            and np.linalg.norm(step[:3, 3]) < CONVERGED_MM
            and np.abs(step[:3, :3] - np.eye(3)).max() * surface.diagonal_mm < CONVERGED_MM
        ):
            break
    return _summary(points, surface, matrix, settings, undetermined)


def _match(
    points: MeasuredPoints,
    surface: NominalSurface,
    matrix: FloatArray,
    settings: AlignmentSettings,
    reach_mm: float,
    near: IntArray | None = None,
) -> tuple[FloatArray, Closest, FloatArray, BoolArray]:
    """Return moved points, closest surface points, signed distances along their normals, and the mask of valid ones."""
    moved = points.points_mm @ matrix[:3, :3].T + matrix[:3, 3]
    closest = surface.closest(moved, near)
    offset = moved - closest.points_mm
    residual = np.einsum("nd,nd->n", offset, closest.normals)
    counts = np.linalg.norm(offset, axis=1) < reach_mm
    if points.normals is not None:
        facing = np.einsum("nd,nd->n", np.asarray(points.normals, float) @ matrix[:3, :3].T, closest.normals)
        counts &= facing > np.cos(np.radians(settings.normals_within_deg))
    return moved, closest, residual, counts


def _step(
    moved: FloatArray, normals: FloatArray, residual: FloatArray, weights: FloatArray, size_mm: float
) -> tuple[FloatArray, tuple[str, ...]]:
    """Solve one Gauss-Newton step; rotations are scaled by ``size_mm`` so that all unknowns are lengths."""
    centre = np.average(moved, axis=0, weights=weights) if weights.sum() > 0 else moved.mean(axis=0)
    jacobian = np.hstack([np.cross(moved - centre, normals) / size_mm, normals])
    normal_matrix = jacobian.T @ (weights[:, None] * jacobian)
    values, vectors = np.linalg.eigh(normal_matrix)
    free = values > DETERMINED * values[-1]
    inverse = np.where(free, 1 / np.maximum(values, 1e-300), 0.0)
    solution = -vectors @ (inverse * (vectors.T @ (jacobian.T @ (weights * residual))))
    rotation = Rotation.from_rotvec(solution[:3] / size_mm).as_matrix()
    step = np.eye(4)
    step[:3, :3] = rotation
    step[:3, 3] = centre + solution[3:] - rotation @ centre
    return step, tuple(MOTIONS[int(np.abs(vectors[:, k]).argmax())] for k in np.flatnonzero(~free))


def cost(points: MeasuredPoints, surface: NominalSurface, matrix: FloatArray, limit_mm: float, settings: AlignmentSettings) -> float:
    """Return the mean squared distance, each truncated at ``limit_mm``, as a share of the truncation (0…1)."""
    moved, closest, _, counts = _match(points, surface, matrix, settings, limit_mm)
    squared = np.sum((moved - closest.points_mm) ** 2, axis=1)
    return float(np.mean(np.where(counts, squared, limit_mm**2)) / limit_mm**2)


def _summary(
    points: MeasuredPoints, surface: NominalSurface, matrix: FloatArray, settings: AlignmentSettings, undetermined: tuple[str, ...]
) -> Registration:
    near = settings.near_share * surface.diagonal_mm
    _, _, residual, counts = _match(points, surface, matrix, settings, near)
    rms = float(np.sqrt(np.mean(residual[counts] ** 2))) if counts.any() else float("inf")
    return Registration(matrix, rms, float(counts.mean()), undetermined)
