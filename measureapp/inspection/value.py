"""Value of a dimension before the conformance decision: number, uncertainty budget, and method."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings

AXES = ("cylinder", "cone", "line")
CENTRES = ("point", "sphere", "circle", "torus", "slot")


Budget = Mapping[str, float]  # standard uncertainty by each of the `CONTRIBUTIONS`, in the value's unit


@dataclass(frozen=True, slots=True)
class Value:
    """A value in mm (angles: degrees), its uncertainty budget, and filter and criterion in words."""

    value: float
    budget: Budget
    how: str = ""
    warning: str = field(default="", kw_only=True)  # what limits the use of the value, in one sentence
    doubt: str = field(default="", kw_only=True)  # why the value proves nothing, in one sentence
    bonus: float = 0.0  # bonus tolerance; the uncertainty is then that of the value less the bonus

    @property
    def sigma(self) -> float:
        """The combined standard uncertainty."""
        return float(np.linalg.norm(list(self.budget.values())))


def combine_budgets(*budgets: Budget) -> Budget:
    """Combine independent budgets: root sum of squares of each contribution."""
    names = dict.fromkeys(name for budget in budgets for name in budget)
    return {name: float(np.linalg.norm([budget.get(name, 0.0) for budget in budgets])) for name in names}


def scale_budget(budget: Budget, factor: float) -> Budget:
    """Return the budget of a value multiplied by ``factor``."""
    return {name: factor * sigma for name, sigma in budget.items()}


def require_feature(found: FoundFeature) -> Feature:
    """Return the fitted feature. Raises InspectionError with the reason why it was not found."""
    if found.feature is None:
        raise InspectionError(found.reason)
    return found.feature


def require_nominal(found: FoundFeature) -> Feature:
    """Return the nominal feature. Raises InspectionError where the program defines none."""
    if found.nominal is None:
        raise InspectionError(f"{found.name} has no nominal position")
    return found.nominal


def require_direction(feature: Feature) -> FloatArray:
    """Return the normal or axis. Raises InspectionError for a feature without one."""
    if feature.direction is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no direction")
    return feature.direction


def assumed_placement_sigma(found: FoundFeature, settings: InspectionSettings) -> float:
    """Return the assumed standard uncertainty (mm) of the position of a feature's views; 0 if the cloud has an error model."""
    if found.view_errors is not None:
        return 0.0
    return float(settings.uncertainty.placement_mm / max(found.views, 1.0) ** 0.5)
