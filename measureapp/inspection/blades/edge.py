"""The leading and trailing edge of a blade section: its outermost point and its radius there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

LEAST_POINTS = 24
ROUNDS = 12
WEIGHTINGS = 5
DEPTH = 0.75  # of the radius: how far from the outermost point the edge reaches inwards
ROUGH = 4.0  # times the scatter of the sides: above this the edge is not round
GREATEST = 1.6  # times half the thickness beside the edge


@dataclass(frozen=True, slots=True, eq=False)
class Edge:
    """One edge, or why there is none."""

    apex_mm: FloatArray | None  # (2,)
    radius_mm: float = 0.0
    points: int = 0
    reason: str = ""


def fit_edge(points_mm: FloatArray, start_mm: FloatArray, inwards: FloatArray, half_thickness_mm: float, scatter_mm: float) -> Edge:
    """Fit the conic that is symmetric to the mean line's direction to the points of an edge.

    In coordinates a inwards and b across, (b - b0)² = 2ρ(a - a0) + D(a - a0)²: for every circle, ellipse and parabola ρ is
    the radius of curvature at the outermost point (a0, b0). It is linear in b², b, a, a² and is weighted by its gradient
    (P. D. Sampson, Computer Graphics and Image Processing 18(1), 1982).

    Parameters
    ----------
    points_mm : (N, 2), of the whole section
    start_mm : (2,), about where the edge is; ``inwards`` : (2,), unit, along the mean line into the blade
    half_thickness_mm : of the blade beside the edge
    scatter_mm : standard deviation of the points from the blade's sides
    """
    offset = points_mm - start_mm
    a, b = offset @ inwards, offset @ np.array([-inwards[1], inwards[0]])
    apex, centre, radius = float(np.percentile(a[a < 2 * half_thickness_mm], 1)) if (a < 2 * half_thickness_mm).any() else 0.0, 0.0, half_thickness_mm
    near = np.zeros(len(a), bool)
    for _ in range(ROUNDS):
        chosen = (a - apex < DEPTH * radius) & (np.abs(b - centre) < 1.5 * half_thickness_mm + 3 * scatter_mm)
        if chosen.sum() < LEAST_POINTS:
            return Edge(None, reason=f"only {chosen.sum()} points were measured on its edge")
        solution, distances = _conic(a[chosen], b[chosen])
        constant, linear, square = solution[0] + solution[1] ** 2 / 4, solution[2], solution[3]
        squared = linear**2 - 4 * square * constant
        if squared <= 0 or linear + np.sqrt(squared) <= 0:
            return Edge(None, reason="its edge is not round, or was not measured")
        root = float(np.sqrt(squared))
        apex, centre = -2 * constant / (linear + root), solution[1] / 2
        radius = min(max(root / 2, half_thickness_mm / 20), 2 * half_thickness_mm)
        if np.array_equal(chosen, near):
            break
        near = chosen
    if reason := _unfit(a[chosen] - apex, b[chosen] - centre, root / 2, distances, half_thickness_mm, scatter_mm):
        return Edge(None, reason=reason)
    place = start_mm + apex * inwards + centre * np.array([-inwards[1], inwards[0]])
    return Edge(place, root / 2, int(chosen.sum()))


def _conic(a: FloatArray, b: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve b² = A + B·b + C·a + D·a²; return the unknowns, and the distances of the points to first order."""
    design = np.column_stack([np.ones_like(a), b, a, a * a])
    weights = np.ones_like(a)
    for _ in range(WEIGHTINGS):
        solution = np.linalg.lstsq(design * weights[:, None], b * b * weights, rcond=None)[0]
        gradient = np.hypot(solution[2] + 2 * solution[3] * a, 2 * b - solution[1])
        weights = 1 / np.maximum(gradient, 1e-3 * gradient.max())
    return solution, (b * b - design @ solution) * weights


def _unfit(
    depth: FloatArray, across: FloatArray, radius_mm: float, distances: FloatArray, half_thickness_mm: float, scatter_mm: float
) -> str:
    if min(np.mean(across > 0.3 * radius_mm), np.mean(across < -0.3 * radius_mm)) < 0.05 or np.mean(np.abs(across) < 0.3 * radius_mm) < 0.05:
        return "its edge was measured on one side only"
    rough = float(np.sqrt(np.mean(distances**2)))
    if radius_mm > GREATEST * half_thickness_mm or rough > ROUGH * scatter_mm + 0.02 * radius_mm:
        return "its edge is not round"
    return ""
