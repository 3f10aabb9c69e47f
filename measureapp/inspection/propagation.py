"""Propagation of the errors of features and extracted surfaces to values computed from them (JCGM 100, 5.2.2)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.inspection.features.cells import Cells
from measureapp.inspection.features.feature_errors import TURN_MM, Errors, ErrorSource, perturb, principal_errors, size_names
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.value import Budget, require_feature


def propagate(value: Callable[[Sequence[Feature]], float], found: Sequence[FoundFeature]) -> tuple[float, Budget]:
    """Return ``value`` of the features, and the contributions to its standard uncertainty.

    All features are perturbed together by one standard deviation to both sides along every principal direction of each error source; the
    larger change counts, and the squares are summed. Errors shared by several features therefore cancel as far as they do in the value.
    For a smooth value this is the law of propagation with correlations (JCGM 100, 5.2.2); at a kink, such as a distance of zero, it
    retains the uncertainty that a derivative loses.
    """
    return _propagate(lambda features, _: value(features), found, None)


def propagate_with_surface(
    value: Callable[[Sequence[Feature], FloatArray], float], found: Sequence[FoundFeature], cells: Cells
) -> tuple[float, Budget]:
    """Return the same for a value of features and of the cell means (K, 3) of a surface, perturbed by the errors of their views."""
    return _propagate(lambda features, heights: value(features, cells.displace(heights)), found, cells)


def _propagate(
    value: Callable[[Sequence[Feature], FloatArray], float], found: Sequence[FoundFeature], cells: Cells | None
) -> tuple[float, Budget]:
    features = [require_feature(one) for one in found]
    ends = np.cumsum([0, *(6 + len(size_names(feature)) for feature in features)])
    still = np.zeros(0 if cells is None else len(cells))
    base = value(features, still)
    scale = np.concatenate([*(_scale(feature) for feature in features), np.ones(len(still))])
    variances: dict[str, float] = {}
    for source, columns in _stack_errors(
        [*(one.errors for one in found), *([] if cells is None else [cells.view_contributions])], [*np.diff(ends), len(still)]
    ):
        variance = 0.0
        for change in principal_errors(columns, scale).T:
            sides = [
                ([perturb(feature, sign * change[ends[i] : ends[i + 1]]) for i, feature in enumerate(features)], sign * change[ends[-1] :])
                for sign in (1.0, -1.0)
            ]
            variance += max((value(*side) - base) ** 2 for side in sides)
        variances[source.contribution] = variances.get(source.contribution, 0.0) + variance
    return base, {contribution: float(np.sqrt(variance)) for contribution, variance in variances.items()}


def covariance(values: Callable[[Sequence[Feature]], FloatArray], found: Sequence[FoundFeature]) -> FloatArray:
    """Return the covariance (V, V) of ``values`` (V,) of the features by the errors that these share, from central differences."""
    features = [require_feature(one) for one in found]
    size = len(values(features))
    total = np.zeros((size, size))
    for change in _changes(found):
        forth, back = (
            values([perturb(feature, sign * one) for feature, one in zip(features, change, strict=True)]) for sign in (1.0, -1.0)
        )
        total += np.outer(forth - back, forth - back) / 4
    return total


def displaced_features(found: Sequence[FoundFeature]) -> Iterator[list[Feature]]:
    """Return the features displaced by one standard deviation along every principal direction of each error source."""
    features = [require_feature(one) for one in found]
    for change in _changes(found):
        yield [perturb(feature, one) for feature, one in zip(features, change, strict=True)]


def _changes(found: Sequence[FoundFeature]) -> Iterator[list[FloatArray]]:
    """Return the changes of each feature by one standard deviation along every principal direction of each error source."""
    features = [require_feature(one) for one in found]
    ends = np.cumsum([0, *(6 + len(size_names(feature)) for feature in features)])
    scale = np.concatenate([_scale(feature) for feature in features])
    for _, columns in _stack_errors([one.errors for one in found], [int(size) for size in np.diff(ends)]):
        for change in principal_errors(columns, scale).T:
            yield np.split(change, ends[1:-1])


def _stack_errors(
    errors: Sequence[Errors | Mapping[ErrorSource, FloatArray]], sizes: Sequence[int]
) -> Iterable[tuple[ErrorSource, FloatArray]]:
    """Stack the errors of all items by source, with zeros for items without this source."""
    for source in dict.fromkeys(source for own in errors for source in own):
        width = next(own[source].shape[1] for own in errors if source in own)
        yield source, np.vstack([own.get(source, np.zeros((size, width))) for own, size in zip(errors, sizes, strict=False)])


def _scale(feature: Feature) -> FloatArray:
    """Return the scales that make point, direction and sizes comparable."""
    return np.array([1.0] * 3 + [TURN_MM] * 3 + [TURN_MM if name.endswith("_rad") else 1.0 for name in size_names(feature)])
