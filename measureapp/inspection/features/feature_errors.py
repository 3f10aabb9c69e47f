"""Errors of features as independent errors, one standard deviation each, by source.

Features share the errors of the views they were measured in, so that these partly cancel in values computed from several features
(JCGM 102, 6.2.1).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.dimension import CONTRIBUTIONS
from measureapp.data.feature import Feature
from measureapp.geometry.contours import contour_sensitivities, is_contour
from measureapp.geometry.fits import point_sensitivities
from measureapp.inspection.features.shapes import outward_normals
from measureapp.inspection.measured_points import MeasuredPoints

NOISE, STITCHING, CALIBRATION, FORM, EDGES, *_, CERTIFICATE, TEMPERATURE, SCALE = CONTRIBUTIONS
MOST_POINTS = 4000  # sufficient, as the errors of views vary slowly over a feature
TURN_MM = 100.0  # lever arm that makes rotations comparable with lengths
NEGLIGIBLE = 1e-6  # share of the largest variance below which an error is dropped
STEP = 1e-5  # mm and rad, of numerical derivatives


class ErrorSource(NamedTuple):
    """Source of independent errors; those of one source are common to all features."""

    contribution: str  # of `CONTRIBUTIONS`
    owner: str = ""  # the feature, where it alone has them


Errors = Mapping[ErrorSource, FloatArray]  # (6 + S, M): of point (mm), direction and sizes, in the order of a feature's covariance


def size_names(feature: Feature) -> tuple[str, ...]:
    """Return the names of the size parameters of a feature."""
    return tuple(name for name in ("radius_mm", "half_angle_rad", "minor_radius_mm", "length_mm") if getattr(feature, name) is not None)


def estimate_view_errors(
    feature: Feature, used: MeasuredPoints, weights: FloatArray | None, placement_mm: float, views: float
) -> dict[ErrorSource, FloatArray]:
    """Propagate the errors of the views to a fitted feature.

    Without an error model, an independent displacement of ``placement_mm`` over the root of the number of views is assumed for the
    feature's position and radii.
    """
    if used.errors is None or used.view is None:
        return assume_placement_errors(feature, placement_mm / max(views, 1.0) ** 0.5)
    step = max(1, -(-len(used) // MOST_POINTS))
    few = used.where(np.arange(0, len(used), step))
    sensitivities = contour_sensitivities if is_contour(feature) else point_sensitivities
    follows = sensitivities(feature, few.points_mm, None if weights is None else weights[::step])
    return propagate_point_errors(follows, few, outward_normals(feature, few.points_mm))


def propagate_point_errors(follows: FloatArray, used: MeasuredPoints, directions: FloatArray) -> dict[ErrorSource, FloatArray]:
    """Propagate displacements of points along ``directions`` (N, 3) to values with the Jacobian ``follows`` (P, N)."""
    assert used.errors is not None and used.view is not None
    displaced = used.errors.along(used.points_mm, directions, used.view)
    return {ErrorSource(contribution): follows @ columns for contribution, columns in displaced.items()}


def assume_placement_errors(feature: Feature, placement_mm: float) -> dict[ErrorSource, FloatArray]:
    """Return assumed errors of a feature: ``placement_mm`` independently for each coordinate and radius."""
    sizes = size_names(feature)
    columns = np.zeros((6 + len(sizes), 3 + len(sizes)))
    columns[:3, :3] = placement_mm * np.eye(3)
    for number, name in enumerate(sizes):
        columns[6 + number, 3 + number] = placement_mm if name.endswith("_mm") else 0.0
    return {ErrorSource(STITCHING, feature.name): columns}


def principal_errors(columns: FloatArray, scale: FloatArray) -> FloatArray:
    """Principal components: reduce errors ``columns`` (P, M) to the fewest (P, R) of equal covariance; rows are scaled by ``scale``."""
    vectors, sizes, _ = np.linalg.svd(columns * scale[:, None], full_matrices=False)
    kept = sizes**2 > NEGLIGIBLE * max(float(sizes[0]) ** 2, 1e-300) if len(sizes) else np.zeros(0, bool)
    return np.asarray(vectors[:, kept] * sizes[kept] / scale[:, None])


def perturb(feature: Feature, by: FloatArray) -> Feature:
    """Return a feature with a small change ``by`` (6 + S,) of point, direction and sizes."""
    direction = feature.direction
    if direction is not None:
        direction = direction + by[3:6]
        direction = direction / np.linalg.norm(direction)
    grown = {name: getattr(feature, name) + size for name, size in zip(size_names(feature), by[6:], strict=True)}
    return replace(feature, point_mm=feature.point_mm + by[:3], direction=direction, **grown)


def propagate_construction(
    make: Callable[[Sequence[Feature]], Feature], features: Sequence[Feature], errors: Sequence[Errors]
) -> dict[ErrorSource, FloatArray]:
    """Propagate errors to a feature constructed by ``make`` from others (JCGM 102, 6.2.1.3)."""
    total: dict[ErrorSource, FloatArray] = {}
    for number, (feature, own) in enumerate(zip(features, errors, strict=True)):
        size = 6 + len(size_names(feature))
        slopes = []
        for change in STEP * np.eye(size)[: size if feature.direction is not None else 3]:
            there, back = (
                _parameters(make([*features[:number], perturb(feature, sign * change), *features[number + 1 :]])) for sign in (1.0, -1.0)
            )
            slopes.append((there - back) / (2 * STEP))
        follows = np.column_stack(slopes)
        for source, columns in own.items():
            total[source] = total.get(source, 0.0) + follows @ columns[: follows.shape[1]]
    return total


def _parameters(feature: Feature) -> FloatArray:
    direction = np.zeros(3) if feature.direction is None else feature.direction
    return np.concatenate([feature.point_mm, direction, [getattr(feature, name) for name in size_names(feature)]])


def noise_errors(feature: Feature, factor: float) -> FloatArray:
    """Return the errors (6 + S, M) of a feature by point noise: from its covariance, or the deviation of a point along its normal."""
    size = 6 + len(size_names(feature))
    if feature.covariance is None:
        columns = np.zeros((size, 1))
        if feature.direction is not None:
            columns[:3, 0] = feature.standard_deviations.get("position_mm", 0.0) * factor * feature.direction
        return columns
    kept = np.arange(size) if feature.direction is not None else np.r_[0:3, 6:size]
    covariance = np.zeros((size, size))
    covariance[np.ix_(kept, kept)] = feature.covariance[np.ix_(kept, kept)]
    values, vectors = np.linalg.eigh(covariance)
    return np.asarray(factor * vectors * np.sqrt(np.maximum(values, 0.0)))
