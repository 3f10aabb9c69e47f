"""Surface point: a point of a curved surface, measured along its nominal normal (vector point)."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import FitError
from measureapp.inspection.measured_points import MeasuredPoints

QUADRIC = 6  # unknowns


def fit_surface_point(nominal: Feature, used: MeasuredPoints, all_points_mm: FloatArray) -> tuple[Feature, FloatArray]:
    """Fit a quadric height field to a patch, and evaluate it at the nominal point.

    A plane would be biased on a curved surface by the mean sagitta of the patch (patch²/8R).

    Returns
    -------
    feature : the surface point on the nominal's normal, with the standard deviation of its position along it
    distances : (N,) of ``all_points_mm`` from the fitted patch, along the normal

    Raises
    ------
    FitError
        The points of the patch are on one side of the nominal point, which would require extrapolation.
    """
    normal = nominal.direction
    assert normal is not None
    across = _across(normal)
    design, heights = _design(used.points_mm, nominal.point_mm, normal, across)
    if _one_sided(design[:, 1:3]):
        raise FitError("the points of the patch do not surround the nominal point", "Scan this area from another side.")
    solution, _, rank, _ = np.linalg.lstsq(design, heights, rcond=1e-9)
    if rank < QUADRIC:
        raise FitError("the points of the patch do not determine a surface", "Scan this area more densely.")
    residuals = heights - design @ solution
    variance = float(residuals @ residuals) / max(len(heights) - QUADRIC, 1)
    position_sigma = float(np.sqrt(variance * np.linalg.inv(design.T @ design)[0, 0]))
    feature = Feature(
        nominal.name,
        "point",
        nominal.point_mm + solution[0] * normal,
        normal,
        points=len(heights),
        rms_mm=float(np.sqrt(np.mean(residuals**2))),
        form_error_mm=float(np.ptp(residuals)),
        standard_deviations={"position_mm": position_sigma},
    )
    every, every_height = _design(all_points_mm, nominal.point_mm, normal, across)
    return feature, every_height - every @ solution


def linearise_surface_point(nominal: Feature, used: MeasuredPoints) -> tuple[FloatArray, MeasuredPoints, FloatArray]:
    """Return the Jacobian (6, N) of point and direction, the points, and the directions (N, 3) of their displacements.

    The directions are normal to the fitted patch, as a displacement along it does not change the height.
    """
    normal = nominal.direction
    assert normal is not None
    across = _across(normal)
    design, heights = _design(used.points_mm, nominal.point_mm, normal, across)
    inverse = np.linalg.pinv(design)
    _, slope_u, slope_v, uu, uv, vv = inverse @ heights
    u, v = design[:, 1], design[:, 2]
    slopes = np.column_stack([slope_u + 2 * uu * u + uv * v, slope_v + uv * u + 2 * vv * v])
    follows = np.zeros((6, len(heights)))
    follows[:3] = np.outer(normal, inverse[0])
    return follows, used, normal - slopes @ across


def _across(normal: FloatArray) -> FloatArray:
    """Return two unit tangents (2, 3) of the plane normal to ``normal``."""
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(normal, first)])


def _design(points_mm: FloatArray, centre_mm: FloatArray, normal: FloatArray, across: FloatArray) -> tuple[FloatArray, FloatArray]:
    offset = points_mm - centre_mm
    u, v = (offset @ across.T).T
    return np.column_stack([np.ones_like(u), u, v, u * u, u * v, v * v]), offset @ normal


def _one_sided(uv_mm: FloatArray) -> bool:
    """Return whether there is an angular gap of more than 150° around the nominal point."""
    angles = np.sort(np.arctan2(uv_mm[:, 1], uv_mm[:, 0]))
    gaps = np.diff(np.append(angles, angles[0] + 2 * np.pi))
    return bool(gaps.max() > np.radians(150))
