"""How deviations from the nominal are coloured: stored with the inspection program, for the window and for reports alike."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.model import Model

RampName = Literal["blue-white-red", "rainbow", "colour-blind-safe"]
Range = tuple[float, float]


class DeviationScale(Model):
    """The colour scale of deviations; it never affects a verdict."""

    tolerance_mm: Range = Field(default=(-0.1, 0.1), description="band of one colour; the fractions inside, below and above it are stated")
    range_mm: Range | None = Field(default=None, description="ends of the scale; without them it covers the band and nearly all points")
    ramp: RampName = "blue-white-red"
    steps: int = Field(default=0, ge=0, le=100, description="number of colour steps; 0: continuous")
    go_no_go: bool = Field(default=False, description="two colours only: inside the band and outside")
    swapped: bool = Field(default=False, description="colours of material missing and material in excess exchanged")

    @model_validator(mode="after")
    def _ordered(self) -> DeviationScale:
        if self.tolerance_mm[0] > self.tolerance_mm[1]:
            raise ValueError("the lower end of tolerance_mm is above the upper one")
        if self.range_mm is not None and self.range_mm[0] >= self.range_mm[1]:
            raise ValueError("the lower end of range_mm is not below the upper one")
        return self
