"""Maximum and least material conditions of what is toleranced and of its datums (ISO 2692)."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.cut import Range
from measureapp.data.model import Model

MaterialCondition = Literal["regardless", "maximum", "least"]


class DatumMaterial(Model):
    """A datum that is taken at its maximum or least material: by what its size departs from that the part may shift in it."""

    datum: str = Field(min_length=1, description="one of the dimension's datums, a hole or shaft")
    condition: Literal["maximum", "least"]
    size_limits_mm: Range = Field(
        description="limits of its diameter; where it has a position or orientation tolerance of its own at the same condition, "
        "with the limit at this material widened by that: the virtual size"
    )

    @model_validator(mode="after")
    def _runs_upwards(self) -> DatumMaterial:
        ascending("size_limits_mm", self.size_limits_mm)
        return self


def ascending(name: str, limits: Range) -> None:
    """Raise ValueError for limits of a diameter that do not run upwards."""
    if limits[0] >= limits[1]:
        raise ValueError(f"{name} must run from the smaller to the greater diameter")
