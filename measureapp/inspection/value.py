"""What a dimension is before it is judged: a value, how sure it is and how it was taken."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings

AXES = ("cylinder", "cone", "line")
CENTRES = ("point", "sphere", "circle", "torus")


Budget = Mapping[str, float]  # what each of the `SHARES` adds to a standard uncertainty, in the value's unit


@dataclass(frozen=True, slots=True)
class Value:
    """A value in mm (angles: degrees), where its standard uncertainty comes from, and filter and criterion in words."""

    value: float
    budget: Budget
    how: str = ""
    bonus: float = 0.0  # by how much the tolerance is wider; the uncertainty is then that of the value less the bonus

    @property
    def sigma(self) -> float:
        """The standard uncertainty: of all shares together."""
        return float(np.linalg.norm(list(self.budget.values())))


def combine_budgets(*budgets: Budget) -> Budget:
    """Return the shares of several independent contributions together."""
    shares = dict.fromkeys(share for budget in budgets for share in budget)
    return {share: float(np.linalg.norm([budget.get(share, 0.0) for budget in budgets])) for share in shares}


def scale_budget(budget: Budget, factor: float) -> Budget:
    """Return the shares of a value that is multiplied."""
    return {share: factor * sigma for share, sigma in budget.items()}


def require_feature(found: FoundFeature) -> Feature:
    """Return the feature. Raises InspectionError with the reason why it was not found."""
    if found.feature is None:
        raise InspectionError(found.reason)
    return found.feature


def require_nominal(found: FoundFeature) -> Feature:
    """Return where the drawing has the feature. Raises InspectionError where the drawing does not say."""
    if found.nominal is None:
        raise InspectionError(f"{found.name} has no place in the drawing")
    return found.nominal


def require_direction(feature: Feature) -> FloatArray:
    """Return the normal or axis. Raises InspectionError for a feature that has none."""
    if feature.direction is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no direction")
    return feature.direction


def assumed_placement_sigma(found: FoundFeature, settings: InspectionSettings) -> float:
    """Return the standard uncertainty in mm of where the views of a feature lie, where the settings have to tell; 0 where the cloud does."""
    if found.view_errors is not None:
        return 0.0
    return float(settings.uncertainty.placement_mm / max(found.views, 1.0) ** 0.5)
