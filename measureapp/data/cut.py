"""Selection of a feature's measured points: cut around the nominal, or region growing from a seed."""

from __future__ import annotations

from pydantic import Field, model_validator

from measureapp.data.model import Model

Vector = tuple[float, float, float]
Range = tuple[float, float]


class Cut(Model):
    """Limits of the points of a feature, in the nominal's frame (rotated for the copies of a pattern)."""

    band_mm: float = Field(default=2.0, gt=0, description="greatest distance from the nominal surface")
    along_mm: Range | None = Field(default=None, description="from/to along the direction, from the nominal point")
    radial_mm: Range | None = Field(
        default=None, description="from/to distance from the line through the nominal point along the direction"
    )
    x_mm: Range | None = None
    y_mm: Range | None = None
    z_mm: Range | None = None
    edge_mm: float = Field(default=2.0, ge=0, description="least distance from sharp edges of the nominal mesh")
    normals_within_deg: float = Field(default=35.0, gt=0, le=180)

    @model_validator(mode="after")
    def _ranges_ascend(self) -> Cut:
        for name in ("along_mm", "radial_mm", "x_mm", "y_mm", "z_mm"):
            given = getattr(self, name)
            if given is not None and given[0] >= given[1]:
                raise ValueError(f"{name} must run from the smaller to the greater value")
        return self


class Grow(Model):
    """Region growing: the points of one shape around a seed on the surface."""

    seed_mm: Vector = Field(description="a point on the surface, in the nominal's frame")
    reach_mm: float = Field(default=2.0, gt=0, description="greatest distance of the surface from the seed")
    noise_mm: float | None = Field(default=None, gt=0, description="standard deviation of a point; None: from the points")
    form_mm: float = Field(default=0.02, ge=0, description="form deviation that still belongs to the shape")
    turn_deg: float = Field(default=8.0, gt=0, le=45, description="greatest angle between surface and shape")
