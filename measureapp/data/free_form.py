"""Free-form surfaces: regions of the nominal mesh."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.cut import Range, Vector
from measureapp.data.model import Model
from measureapp.data.repeat import Repeat

NO_LENGTH = 1e-12


class FreeForm(Model):
    """A region of the nominal mesh: all of it, or the part within limits that faces one way; only profiles are evaluated on it.

    Limits and direction are those of the first copy, in the nominal frame.
    """

    name: str = Field(min_length=1)
    shape: Literal["free_form"]
    x_mm: Range | None = None
    y_mm: Range | None = None
    z_mm: Range | None = None
    facing: Vector | None = Field(default=None, description="only where the nominal's outward normal is near this direction")
    facing_within_deg: float = Field(default=60.0, gt=0, le=180)
    band_mm: float = Field(default=2.0, gt=0, description="greatest distance from the nominal surface")
    edge_mm: float = Field(default=2.0, ge=0, description="distance kept from sharp edges of the nominal mesh")
    normals_within_deg: float = Field(
        default=35.0, gt=0, le=180, description="greatest angle between the normals of a point and of the nominal"
    )
    repeat: Repeat | None = None

    @model_validator(mode="after")
    def _is_consistent(self) -> FreeForm:
        for name in ("x_mm", "y_mm", "z_mm"):
            given = getattr(self, name)
            if given is not None and given[0] >= given[1]:
                raise ValueError(f"{name} must run from the smaller to the greater value")
        if self.facing is not None and sum(value * value for value in self.facing) < NO_LENGTH:
            raise ValueError("`facing` has length 0: give the direction that the surface faces")
        return self
