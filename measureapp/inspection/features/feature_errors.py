"""What a feature errs by, as independent errors of one standard deviation each, by where they come from.

Features share the errors of the views they were seen in, so that what is computed from several of them is uncertain by what does not
cancel (JCGM 102, 6.2.1).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.dimension import CONTRIBUTIONS
from measureapp.data.feature import Feature
from measureapp.geometry.fits import point_sensitivities
from measureapp.inspection.features.shapes import outward_normals
from measureapp.inspection.measured_points import MeasuredPoints

NOISE, STITCHING, CALIBRATION, *_, SCALE = CONTRIBUTIONS
MOST_POINTS = 4000  # the errors of views change slowly over a feature
TURN_MM = 100.0  # a turn counts as what it moves so far away, where errors are compared in size
NEGLIGIBLE = 1e-6  # of the largest variance: each of some dozens
STEP = 1e-5  # mm and rad: small beside what the shapes are curved by, large beside rounding


class ErrorSource(NamedTuple):
    """Where independent errors come from; those of one source are the same in all features."""

    contribution: str  # of `CONTRIBUTIONS`
    owner: str = ""  # the feature, where it alone has them


Errors = Mapping[ErrorSource, FloatArray]  # (6 + S, M): of point (mm), direction and sizes, in the order of a feature's covariance


def size_names(feature: Feature) -> tuple[str, ...]:
    """Return the names of the sizes that a feature has."""
    return tuple(name for name in ("radius_mm", "half_angle_rad", "minor_radius_mm") if getattr(feature, name) is not None)


def estimate_view_errors(
    feature: Feature, used: MeasuredPoints, weights: FloatArray | None, placement_mm: float, views: float
) -> dict[ErrorSource, FloatArray]:
    """Return how a fitted feature follows the errors of the views that its points were measured in.

    Where these are not known, every feature stands off on its own by ``placement_mm`` over the root of its views, and so do its radii.
    """
    if used.errors is None or used.view is None:
        return assume_placement_errors(feature, placement_mm / max(views, 1.0) ** 0.5)
    step = max(1, -(-len(used) // MOST_POINTS))
    few = used.where(np.arange(0, len(used), step))
    follows = point_sensitivities(feature, few.points_mm, None if weights is None else weights[::step])
    return propagate_point_errors(follows, few, outward_normals(feature, few.points_mm))


def propagate_point_errors(follows: FloatArray, used: MeasuredPoints, directions: FloatArray) -> dict[ErrorSource, FloatArray]:
    """Return the errors of values (P, M) that follow displacements of points along ``directions`` (N, 3) by ``follows`` (P, N)."""
    assert used.errors is not None and used.view is not None
    displaced = used.errors.along(used.points_mm, directions, used.view)
    return {ErrorSource(share): follows @ columns for share, columns in displaced.items()}


def assume_placement_errors(feature: Feature, placement_mm: float) -> dict[ErrorSource, FloatArray]:
    """Return the errors of a feature that stands off along every axis, and whose radii err, by ``placement_mm`` independently."""
    sizes = size_names(feature)
    columns = np.zeros((6 + len(sizes), 3 + len(sizes)))
    columns[:3, :3] = placement_mm * np.eye(3)
    for number, name in enumerate(sizes):
        columns[6 + number, 3 + number] = placement_mm if name.endswith("_mm") else 0.0
    return {ErrorSource(STITCHING, feature.name): columns}


def principal_errors(columns: FloatArray, scale: FloatArray) -> FloatArray:
    """Return the fewest independent errors (P, R) that are together like ``columns`` (P, M); ``scale`` (P,) makes the rows comparable."""
    vectors, sizes, _ = np.linalg.svd(columns * scale[:, None], full_matrices=False)
    kept = sizes**2 > NEGLIGIBLE * max(float(sizes[0]) ** 2, 1e-300) if len(sizes) else np.zeros(0, bool)
    return np.asarray(vectors[:, kept] * sizes[kept] / scale[:, None])


def perturb(feature: Feature, by: FloatArray) -> Feature:
    """Return a feature with a small change (6 + S,) of point, direction and sizes."""
    direction = feature.direction
    if direction is not None:
        direction = direction + by[3:6]
        direction = direction / np.linalg.norm(direction)
    grown = {name: getattr(feature, name) + size for name, size in zip(size_names(feature), by[6:], strict=True)}
    return replace(feature, point_mm=feature.point_mm + by[:3], direction=direction, **grown)


def propagate_construction(
    make: Callable[[Sequence[Feature]], Feature], features: Sequence[Feature], errors: Sequence[Errors]
) -> dict[ErrorSource, FloatArray]:
    """Return the errors of a feature that ``make`` makes of others, by the law of propagation (JCGM 102, 6.2.1.3)."""
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
    """Return the errors (6 + S, M) of a feature by the noise of its points, from its covariance or, for a point along a normal, its deviation."""
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
