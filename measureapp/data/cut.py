"""Which measured points belong to a feature: cut out around its nominal, or grown from a seed."""

from __future__ import annotations

from pydantic import Field, model_validator

from measureapp.data.model import Model

Vector = tuple[float, float, float]
Range = tuple[float, float]


class Cut(Model):
    """Which measured points belong to a feature, in the nominal's frame (a pattern's copies turn it with them)."""

    band_mm: float = Field(default=2.0, gt=0, description="greatest distance from the nominal surface")
    along_mm: Range | None = Field(default=None, description="from/to along the direction, counted from the nominal point")
    radial_mm: Range | None = Field(
        default=None, description="from/to distance from the line through the nominal point along the direction"
    )
    x_mm: Range | None = None
    y_mm: Range | None = None
    z_mm: Range | None = None
    edge_mm: float = Field(default=2.0, ge=0, description="distance kept from sharp edges of the nominal mesh")
    normals_within_deg: float = Field(default=35.0, gt=0, le=180)

    @model_validator(mode="after")
    def _ranges_ascend(self) -> Cut:
        for name in ("along_mm", "radial_mm", "x_mm", "y_mm", "z_mm"):
            given = getattr(self, name)
            if given is not None and given[0] >= given[1]:
                raise ValueError(f"{name} must run from the smaller to the greater value")
        return self


class Grow(Model):
    """Points found from a seed on the surface instead of around a nominal: the region that belongs to one shape."""

    seed_mm: Vector = Field(description="a place on the surface, in the nominal's frame")
    reach_mm: float = Field(default=2.0, gt=0, description="how far from the seed the surface may lie")
    noise_mm: float | None = Field(default=None, gt=0, description="standard deviation of a point; left out: from the points")
    form_mm: float = Field(default=0.02, ge=0, description="departure from the ideal shape that still belongs to it")
    turn_deg: float = Field(default=8.0, gt=0, le=45, description="how far the surface may be turned against the shape")
