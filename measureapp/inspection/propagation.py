"""From the errors of features and of extracted surfaces to the uncertainty of what is computed from them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.inspection.features.cells import Cells
from measureapp.inspection.features.feature_errors import TURN_MM, Errors, ErrorSource, perturb, principal_errors, size_names
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.value import Budget, require_feature


def propagate(value: Callable[[Sequence[Feature]], float], found: Sequence[FoundFeature]) -> tuple[float, Budget]:
    """Return ``value`` of the features and what each share of their errors adds to its standard uncertainty.

    All features are moved together by one standard deviation to either side along every principal direction of each source of
    errors, and the larger change counts; the squares are summed. Errors that features share so cancel as far as they do in the
    value. Where the value is smooth this is the law of propagation with correlations (JCGM 100, 5.2.2); at a kink, like a distance
    that is zero, it keeps the uncertainty that the derivative loses.
    """
    return _propagate(lambda features, _: value(features), found, None)


def propagate_with_surface(
    value: Callable[[Sequence[Feature], FloatArray], float], found: Sequence[FoundFeature], cells: Cells
) -> tuple[float, Budget]:
    """Return the same for a value of features and of the means (K, 3) of a surface, which moves with the views it was measured in."""
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
    return base, {share: float(np.sqrt(variance)) for share, variance in variances.items()}


def _stack_errors(
    errors: Sequence[Errors | Mapping[ErrorSource, FloatArray]], sizes: Sequence[int]
) -> Iterable[tuple[ErrorSource, FloatArray]]:
    """Give the errors of everything below each other, by source; zero for what does not have them."""
    for source in dict.fromkeys(source for own in errors for source in own):
        width = next(own[source].shape[1] for own in errors if source in own)
        yield source, np.vstack([own.get(source, np.zeros((size, width))) for own, size in zip(errors, sizes, strict=False)])


def _scale(feature: Feature) -> FloatArray:
    """What makes point, direction and sizes comparable."""
    return np.array([1.0] * 3 + [TURN_MM] * 3 + [TURN_MM if name.endswith("_rad") else 1.0 for name in size_names(feature)])
