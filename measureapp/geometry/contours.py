"""Orthogonal distance regression of contours in a given plane: circle, slot and line.

The plane is known, so that a narrow slice of a surface suffices. Parameters, in the plane's coordinates u, v: circle (u, v, radius),
slot (u, v, angle, half the length of its straight sides, half its width), line (v at the centroid, slope).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import FitError
from measureapp.geometry.feature import Feature, Shape
from measureapp.geometry.shapes import tangents

ITERATIONS, CONVERGED = 60, 1e-10  # mm and rad
SINGULAR = 1e-6  # ratio of singular values below which the points do not determine the contour
TINY = 1e-12

Evaluation = tuple[FloatArray, FloatArray, FloatArray]  # distances (N,), derivatives (N, P), outward directions (N, 2)


@dataclass(frozen=True, slots=True, eq=False)
class ContourFrame:
    """Coordinates u, v in the plane of a contour."""

    origin_mm: FloatArray  # (3,)
    axes: FloatArray  # (2, 3), unit, at right angles

    @classmethod
    def of(cls, feature: Feature) -> ContourFrame:
        """Return the frame of a nominal contour: u along a slot or line, v along the face normal of a line."""
        direction = feature.direction
        if direction is None:
            raise FitError(f"The contour {feature.name} has no direction.", "Give its direction.")
        if feature.shape == "circle":
            return cls(feature.point_mm, tangents(direction))
        normal = feature.normal
        if normal is None:
            raise FitError(f"The contour {feature.name} has no normal.", "Give the normal of its plane or face.")
        second = np.cross(normal, direction) if feature.shape == "slot" else normal - (normal @ direction) * direction
        return cls(feature.point_mm, np.stack([direction, second / np.linalg.norm(second)]))

    def flatten(self, points_mm: FloatArray) -> FloatArray:
        """Return the coordinates (N, 2) of points (N, 3)."""
        return np.asarray((points_mm - self.origin_mm) @ self.axes.T)


def is_contour(feature: Feature) -> bool:
    """Return whether a feature is fitted as a contour in its plane; a line without a face is not."""
    return feature.shape in ("circle", "slot") or (feature.shape == "line" and feature.normal is not None)


def contour_distances(feature: Feature, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return signed distances (N,) of points from a contour in its plane, positive outside, and outward directions (N, 3)."""
    frame = ContourFrame.of(feature)
    distances, _, outward = MODELS[feature.shape](_parameters(feature), frame.flatten(points_mm))
    return distances, outward @ frame.axes


def fit_contour(nominal: Feature, points_mm: FloatArray, weights: FloatArray | None = None) -> Feature:
    """Fit a circle, slot or line in the plane of ``nominal``, starting there (Gauss-Newton).

    Returns
    -------
    Feature
        Its plane, and for a circle its direction, are those of ``nominal``; ``covariance`` is scaled by the residual scatter.

    Raises
    ------
    FitError
        The points do not determine the contour.
    """
    frame = ContourFrame.of(nominal)
    flat = frame.flatten(points_mm)
    start = _parameters(nominal)
    if nominal.shape == "line":
        frame = ContourFrame(frame.origin_mm + float(flat[:, 0].mean()) * frame.axes[0], frame.axes)
        flat = frame.flatten(points_mm)
    root = np.sqrt(np.ones(len(flat)) if weights is None else weights)
    values = _solve(nominal, start, flat, root)
    distances, derivatives, _ = MODELS[nominal.shape](values, flat)
    inverse = np.linalg.pinv(derivatives * root[:, None])
    variance = float(np.sum((root * distances) ** 2)) / max(len(flat) - len(values), 1)
    spread = _spread(nominal, frame, values)
    return _feature(nominal, frame, values, distances, spread @ (variance * inverse @ inverse.T) @ spread.T)


def contour_sensitivities(feature: Feature, points_mm: FloatArray, weights: FloatArray | None) -> FloatArray:
    """Sensitivity of a fitted contour to its points: Jacobian (6 + S, N) of point, direction and sizes for outward displacements."""
    frame = ContourFrame.of(feature)
    values = _parameters(feature)
    root = np.sqrt(np.ones(len(points_mm)) if weights is None else weights)
    _, derivatives, _ = MODELS[feature.shape](values, frame.flatten(points_mm))
    return np.asarray(_spread(feature, frame, values) @ (-np.linalg.pinv(derivatives * root[:, None]) * root))


def _solve(nominal: Feature, values: FloatArray, flat: FloatArray, root: FloatArray) -> FloatArray:
    for _ in range(ITERATIONS):
        distances, derivatives, _ = MODELS[nominal.shape](values, flat)
        solved = np.linalg.lstsq(derivatives * root[:, None], -distances * root, rcond=None)
        step, sizes = solved[0], solved[3]
        if not np.isfinite(step).all() or sizes[-1] <= SINGULAR * sizes[0]:
            raise FitError(f"The points do not determine a {nominal.shape}.", f"Give points spread over more of the {nominal.shape}.")
        values = values + step
        if np.abs(step).max() < CONVERGED:
            return values
    raise FitError(f"The points do not determine a {nominal.shape}: the fit does not converge.", "Correct its nominal, or its limits.")


def _circle(values: FloatArray, flat: FloatArray) -> Evaluation:
    away = flat - values[:2]
    rho = np.linalg.norm(away, axis=1)
    outward = away / np.maximum(rho, TINY)[:, None]
    return rho - values[2], np.column_stack([-outward, -np.ones(len(flat))]), outward


def _slot(values: FloatArray, flat: FloatArray) -> Evaluation:
    """Distance from the outline of a rectangle with semicircular ends: from its middle line, less half the width."""
    angle, half, radius = values[2:]
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    own = (flat - values[:2]) @ turn.T
    beyond = np.maximum(np.abs(own[:, 0]) - half, 0.0) * np.sign(own[:, 0])
    away = np.column_stack([beyond, own[:, 1]])
    rho = np.linalg.norm(away, axis=1)
    unit = away / np.maximum(rho, TINY)[:, None]
    outward = unit @ turn
    turning = unit[:, 0] * own[:, 1] - unit[:, 1] * own[:, 0]
    derivatives = np.column_stack([-outward, turning, -np.abs(unit[:, 0]), -np.ones(len(flat))])
    return rho - radius, derivatives, outward


def _line(values: FloatArray, flat: FloatArray) -> Evaluation:
    lean = np.hypot(1.0, values[1])
    outward = np.tile(np.array([-values[1], 1.0]) / lean, (len(flat), 1))
    distances = (flat[:, 1] - values[0] - values[1] * flat[:, 0]) / lean
    return distances, np.column_stack([-np.ones(len(flat)), -flat[:, 0]]) / lean, outward


MODELS: Mapping[Shape, Callable[[FloatArray, FloatArray], Evaluation]] = {"circle": _circle, "slot": _slot, "line": _line}


def _parameters(feature: Feature) -> FloatArray:
    """Return the parameters of a feature in its own frame."""
    if feature.shape == "circle":
        return np.array([0.0, 0.0, feature.radius_mm or 0.0])
    if feature.shape == "slot":
        radius = feature.radius_mm or 0.0
        return np.array([0.0, 0.0, 0.0, (feature.length_mm or 0.0) / 2 - radius, radius])
    return np.zeros(2)


def _spread(feature: Feature, frame: ContourFrame, values: FloatArray) -> FloatArray:
    """Return the Jacobian (6 + S, P) of point, direction and sizes by the parameters."""
    first, second = frame.axes
    if feature.shape == "circle":
        made = np.zeros((7, 3))
        made[:3, 0], made[:3, 1], made[6, 2] = first, second, 1.0
        return made
    if feature.shape == "slot":
        made = np.zeros((8, 5))
        made[:3, 0], made[:3, 1] = first, second
        made[3:6, 2] = -np.sin(values[2]) * first + np.cos(values[2]) * second
        made[6, 4], made[7, 3], made[7, 4] = 1.0, 2.0, 2.0
        return made
    made = np.zeros((6, 2))
    made[:3, 0], made[3:6, 1] = second, second
    return made


def _feature(nominal: Feature, frame: ContourFrame, values: FloatArray, distances: FloatArray, covariance: FloatArray) -> Feature:
    first, second = frame.axes
    point = frame.origin_mm + (values[0] * first + values[1] * second if nominal.shape != "line" else values[0] * second)
    direction = nominal.direction
    if nominal.shape == "slot":
        direction = np.cos(values[2]) * first + np.sin(values[2]) * second
    elif nominal.shape == "line":
        direction = (first + values[1] * second) / np.hypot(1.0, values[1])
    radius, length = None, None
    if nominal.shape == "circle":
        radius = float(values[2])
    elif nominal.shape == "slot":
        radius, length = float(values[4]), float(2 * (values[3] + values[4]))
    if (radius is not None and radius <= 0) or (length is not None and radius is not None and length <= 2 * radius):
        raise FitError(f"The points are not on a {nominal.shape}.", "Correct its nominal, or its limits.")
    deviations = {"position_mm": _largest(covariance[:3, :3]), "direction_rad": _largest(covariance[3:6, 3:6])}
    for number, name in enumerate(name for name, size in (("radius_mm", radius), ("length_mm", length)) if size is not None):
        deviations[name] = float(np.sqrt(max(covariance[6 + number, 6 + number], 0.0)))
    return Feature(
        nominal.name,
        nominal.shape,
        point,
        direction,
        radius,
        length_mm=length,
        normal=nominal.normal,
        points=len(distances),
        rms_mm=float(np.sqrt(np.mean(distances**2))),
        form_error_mm=float(np.ptp(distances)),
        standard_deviations=deviations,
        covariance=covariance,
    )


def _largest(covariance: FloatArray) -> float:
    return float(np.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0)))
