"""From the covariance of features to the uncertainty of what is computed from them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.inspection.features.found import Found
from measureapp.inspection.value import feature_of

NEGLIGIBLE = 1e-12  # of the largest variance


def propagated(value: Callable[[Sequence[Feature]], float], found: Sequence[Found]) -> tuple[float, float]:
    """Return ``value`` of the features and its standard uncertainty from their covariances.

    Each feature is moved by one standard deviation to either side along every principal direction of its covariance, and
    the larger change counts; the squares are summed. Where the value is smooth this is the law of propagation
    (JCGM 100, 5.1.2); at a kink, like a distance that is zero, it keeps the uncertainty that the derivative loses.
    """
    features = [feature_of(one) for one in found]
    base, variance = value(features), 0.0
    for number, one in enumerate(found):
        for change in _principal_changes(one):
            moved = [[*features[:number], _changed(features[number], sign * change), *features[number + 1 :]] for sign in (1.0, -1.0)]
            variance += max((value(changed) - base) ** 2 for changed in moved)
    return base, float(np.sqrt(variance))


def _principal_changes(found: Found) -> list[FloatArray]:
    values, vectors = np.linalg.eigh(_covariance(found))
    largest = max(float(values[-1]), 0.0)
    return [np.sqrt(size) * vector for size, vector in zip(values, vectors.T, strict=True) if size > NEGLIGIBLE * largest]


def _covariance(found: Found) -> FloatArray:
    """Covariance of point and direction, and of the sizes of a fit; that of a constructed feature is the same in all its directions."""
    feature = feature_of(found)
    if feature.covariance is not None:
        size = len(feature.covariance) - (0 if feature.direction is not None else 3)
        rows = np.r_[0:3, 6 : len(feature.covariance)] if feature.direction is None else np.arange(size)
        kept = np.zeros_like(feature.covariance)
        kept[np.ix_(rows, rows)] = feature.covariance[np.ix_(rows, rows)]
        return kept * found.error_factor**2
    made = np.zeros((6, 6))
    made[:3, :3] = found.position_sigma**2 * np.eye(3)
    if feature.direction is not None:
        made[3:, 3:] = found.direction_sigma**2 * (np.eye(3) - np.outer(feature.direction, feature.direction))
    return made


def _changed(feature: Feature, by: FloatArray) -> Feature:
    sizes = dict(zip(_sizes(feature), by[6:], strict=False))
    direction = feature.direction
    if direction is not None:
        direction = direction + by[3:6]
        direction = direction / np.linalg.norm(direction)
    grown = {name: getattr(feature, name) + size for name, size in sizes.items()}
    return replace(feature, point_mm=feature.point_mm + by[:3], direction=direction, **grown)


def _sizes(feature: Feature) -> tuple[str, ...]:
    return tuple(name for name in ("radius_mm", "half_angle_rad", "minor_radius_mm") if getattr(feature, name) is not None)
