"""Leading and trailing edge of a blade section: circle fit with apex and radius."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

LEAST_POINTS = 20
ROUNDS = 12
STEPS = 6
CONVERGED_MM = 1e-11  # where the next step is smaller by as much as the scatter is smaller than the radius
DEPTH = 0.75  # of the radius: extent of the edge inwards from the apex
ROUGH = 2.0  # times the scatter of the sides: above this the edge is not round
GREATEST = 1.6  # times half the thickness beside the edge
LEAST_SHARE = 0.05  # of the points in each third across the edge


@dataclass(frozen=True, slots=True, eq=False)
class Edge:
    """One edge, or the reason why there is none."""

    apex_mm: FloatArray | None  # (2,)
    radius_mm: float = 0.0
    points: int = 0
    reason: str = ""


def fit_edge(points_mm: FloatArray, start_mm: FloatArray, inwards: FloatArray, half_thickness_mm: float, scatter_mm: float) -> Edge:
    """Fit a circle to the points of an edge, from the apex to three quarters of the radius inwards.

    Orthogonal distances, Gauss-Newton. The apex is that of the circle, against the direction of the mean line, so that it does not depend
    on the outermost noisy point.

    Parameters
    ----------
    points_mm : (N, 2), of the whole section
    start_mm : (2,), approximate position of the edge; ``inwards`` : (2,), unit, along the mean line into the blade
    half_thickness_mm : of the blade beside the edge
    scatter_mm : standard deviation of the points from the blade's sides
    """
    offset = points_mm - start_mm
    frame = np.stack([inwards, [-inwards[1], inwards[0]]])
    local = offset @ frame.T
    local = local[(local[:, 0] < 4 * half_thickness_mm) & (np.abs(local[:, 1]) < 2 * half_thickness_mm + 4 * scatter_mm)]
    if len(local) < LEAST_POINTS:
        return Edge(None, reason=f"only {len(local)} points were measured on its edge")
    radius = half_thickness_mm
    centre = np.array([np.percentile(local[:, 0], 1) + radius, 0.0])
    count = 0
    for _ in range(ROUNDS):
        chosen = local[local[:, 0] - (centre[0] - radius) < DEPTH * radius]
        if len(chosen) < LEAST_POINTS:
            return Edge(None, reason=f"only {len(chosen)} points were measured on its edge, {LEAST_POINTS} are needed")
        centre, radius, distances = _circle(chosen, centre, radius)
        if not half_thickness_mm / 30 < radius < 3 * half_thickness_mm:
            return Edge(None, reason="its edge is not round, or was not measured")
        if len(chosen) == count:
            break
        count = len(chosen)
    if reason := _implausible((chosen[:, 1] - centre[1]) / radius, radius, distances, half_thickness_mm, scatter_mm):
        return Edge(None, reason=reason)
    return Edge(start_mm + (centre - [radius, 0.0]) @ frame, float(radius), len(chosen))


def _circle(points_mm: FloatArray, centre: FloatArray, radius: float) -> tuple[FloatArray, float, FloatArray]:
    for _ in range(STEPS):
        away = points_mm - centre
        length = np.maximum(np.linalg.norm(away, axis=1), 1e-9)
        design = np.column_stack([-away / length[:, None], -np.ones(len(length))])
        step = np.linalg.lstsq(design, radius - length, rcond=1e-9)[0]
        centre, radius = centre + step[:2], float(radius + step[2])
        if np.abs(step).max() < CONVERGED_MM:
            break
    return centre, radius, np.linalg.norm(points_mm - centre, axis=1) - radius


def _implausible(across: FloatArray, radius_mm: float, distances: FloatArray, half_thickness_mm: float, scatter_mm: float) -> str:
    thirds = (np.mean(across < -0.33), np.mean(np.abs(across) <= 0.33), np.mean(across > 0.33))
    if min(thirds) < LEAST_SHARE:
        return "its edge was measured only partly"
    if radius_mm > GREATEST * half_thickness_mm or float(np.sqrt(np.mean(distances**2))) > ROUGH * scatter_mm + 0.03 * radius_mm:
        return "its edge is not round"
    return ""
