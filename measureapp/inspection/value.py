"""What a dimension is before it is judged: a value, how sure it is and how it was taken."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.inspection.features.found import Found
from measureapp.inspection.settings import InspectionSettings

AXES = ("cylinder", "cone", "line")
CENTRES = ("point", "sphere", "circle", "torus")


@dataclass(frozen=True, slots=True)
class Value:
    """A value in mm (angles: degrees), the standard uncertainty of its random part, and filter and criterion in words."""

    value: float
    sigma: float
    how: str = ""
    bonus: float = 0.0  # by how much the tolerance is wider; `sigma` is then that of the value less the bonus


def feature_of(found: Found) -> Feature:
    """Return the feature. Raises InspectionError with the reason why it was not found."""
    if found.feature is None:
        raise InspectionError(found.reason)
    return found.feature


def nominal_of(found: Found) -> Feature:
    """Return where the drawing has the feature. Raises InspectionError where the drawing does not say."""
    if found.nominal is None:
        raise InspectionError(f"{found.name} has no place in the drawing")
    return found.nominal


def direction_of(feature: Feature) -> FloatArray:
    """Return the normal or axis. Raises InspectionError for a feature that has none."""
    if feature.direction is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no direction")
    return feature.direction


def placement_of(found: Found, settings: InspectionSettings) -> float:
    """Return the standard uncertainty in mm of where the views of a feature lie."""
    return float(settings.uncertainty.placement_mm / max(found.views, 1.0) ** 0.5)
