"""What stands in the cell, for collision checks: boxes and cylinders with nominal sizes."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.model import Model

Vector = tuple[float, float, float]


class NamedBox(Model):
    """A box with edges along the axes of its frame."""

    name: str
    low_mm: Vector
    high_mm: Vector

    @model_validator(mode="after")
    def _has_a_volume(self) -> NamedBox:
        if any(low >= high for low, high in zip(self.low_mm, self.high_mm, strict=True)):
            raise ValueError("low_mm must be below high_mm in x, y and z")
        return self


class Fixture(NamedBox):
    """Something that stands beside the table, in the guide frame, or on it: then the origin is its top centre, and it turns with the table."""

    shape: Literal["box", "cylinder"] = Field(default="box", description="cylinder: the upright one that just fits into the box")
    on_table: bool = False


class CellDescription(Model):
    """Floor, guide, head and fixtures."""

    floor_mm: float = Field(default=0.0, description="height of the floor in the guide frame; default: the plane on which the robot stands")
    guide_beam: NamedBox | None = Field(default=None, description="the linear guide under the robot, in the guide frame; none: no body")
    head_bodies: tuple[NamedBox, ...] = Field(default=(), description="in the head frame; none given: derived from cameras and projector")
    fixtures: tuple[Fixture, ...] = ()
    largest_part_mm: float | None = Field(
        default=None, gt=0, description="largest diameter of a part about the table's axis; none: the table's"
    )
