"""Constructed features and their covariance, with the correlations of parents that share errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from measureapp.data.feature import Feature
from measureapp.data.feature_program import ConstructedFeature, copy_names, parent_sets
from measureapp.errors import FitError, InspectionError
from measureapp.inspection.features.constructions import MAKERS, Maker
from measureapp.inspection.features.feature_errors import Errors, propagate_construction, size_names
from measureapp.inspection.features.found_feature import FoundFeature


def construct(described: ConstructedFeature, known: Mapping[str, FoundFeature]) -> Mapping[str, FoundFeature]:
    """Construct a feature, or each copy of its pattern, from features already found."""
    made = {}
    for name, parents in zip(copy_names(described.name, described.repeat), parent_sets(described), strict=True):
        maker: Maker = partial(MAKERS[described.shape], name, described.distance_mm or 0.0)
        of = [known[parent] for parent in parents]
        nominal = construct_one(maker, name, [_as_nominal(one) for one in of]).feature
        made[name] = replace(construct_one(maker, name, of), nominal=nominal)
    return made


def _as_nominal(found: FoundFeature) -> FoundFeature:
    return FoundFeature(found.name, found.nominal, f"{found.name} has no nominal position")


def construct_one(make: Maker, name: str, of: Sequence[FoundFeature]) -> FoundFeature:
    """Construct one feature; without a result where a parent has none."""
    parents = [one.feature for one in of if one.feature is not None]
    if len(parents) < len(of):
        return FoundFeature(name, None, next(one.reason for one in of if one.feature is None))
    try:
        made = make(parents)
    except (InspectionError, FitError) as error:
        return FoundFeature(name, None, error.message)
    errors = propagate_construction(make, parents, [one.errors for one in of])
    known = replace(made, points=sum(parent.points for parent in parents), standard_deviations=_deviations(made, errors))
    view_errors = next((one.view_errors for one in of if one.view_errors is not None), None)
    return FoundFeature(name, known, views=min(one.views for one in of), other_errors=errors, view_errors=view_errors)


def _deviations(made: Feature, errors: Errors) -> dict[str, float]:
    """Return the standard deviations of position and direction, each in its worst direction, and of the sizes."""
    names = size_names(made)
    columns = np.hstack(list(errors.values())) if errors else np.zeros((6 + len(names), 1))
    position, direction = (float(np.linalg.norm(columns[rows], 2)) for rows in (slice(0, 3), slice(3, 6)))
    sizes = {name: float(np.linalg.norm(columns[6 + number])) for number, name in enumerate(names)}
    return {"position_mm": position} | ({} if made.direction is None else {"direction_rad": direction}) | sizes
