"""Maximum and least material conditions of toleranced features and their datums (ISO 2692)."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.cut import Range
from measureapp.data.model import Model

MaterialCondition = Literal["regardless", "maximum", "least"]


class DatumMaterial(Model):
    """A datum at maximum or least material condition: the departure of its actual size from it allows a datum shift."""

    datum: str = Field(min_length=1, description="one of the dimension's datums, a hole or shaft")
    condition: Literal["maximum", "least"]
    size_limits_mm: Range = Field(
        description="limits of its diameter; if the datum has a position or orientation tolerance at the same condition, "
        "widen the limit at this condition by that tolerance (virtual size)"
    )

    @model_validator(mode="after")
    def _runs_upwards(self) -> DatumMaterial:
        require_ascending("size_limits_mm", self.size_limits_mm)
        return self


def require_ascending(name: str, limits: Range) -> None:
    """Raise ValueError unless the limits of a diameter are in ascending order."""
    if limits[0] >= limits[1]:
        raise ValueError(f"{name} must run from the smaller to the greater diameter")
