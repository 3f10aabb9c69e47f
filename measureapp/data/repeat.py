"""Patterns of features: on a circle, along a line, or on a grid."""

from __future__ import annotations

from pydantic import Field, model_validator

from measureapp.data.model import Model

Vector = tuple[float, float, float]
NO_LENGTH = 1e-12


class Repeat(Model):
    """Pattern of copies named `name.1`, `name.2`, …; the first is the feature itself.

    Copy k (from 0) is rotated by k·``angle_deg`` about the axis, the z axis by default, or displaced by k·``step_mm``; with ``per_row``
    the copies fill rows, each displaced by ``row_step_mm`` from the one before.
    """

    count: int = Field(ge=2, le=1000)
    angle_deg: float = 0.0
    axis_point_mm: Vector = (0.0, 0.0, 0.0)
    axis: Vector = (0.0, 0.0, 1.0)
    step_mm: Vector | None = Field(default=None, description="displacement from one copy to the next, in place of a rotation")
    per_row: int | None = Field(default=None, ge=1, description="copies in a row of a grid")
    row_step_mm: Vector | None = Field(default=None, description="displacement from one row to the next")

    @model_validator(mode="after")
    def _is_consistent(self) -> Repeat:
        if sum(value * value for value in self.axis) < NO_LENGTH:
            raise ValueError("`axis` has length 0")
        if self.step_mm is not None and self.angle_deg:
            raise ValueError("a pattern is rotated by `angle_deg` or displaced by `step_mm`: remove one of them")
        if (self.per_row is None) != (self.row_step_mm is None):
            raise ValueError("`per_row` and `row_step_mm` need each other")
        if self.per_row is not None and self.step_mm is None:
            raise ValueError("a grid needs `step_mm`, the displacement within a row")
        return self

    @property
    def is_about_z(self) -> bool:
        """Whether all copies are rotations about the z axis."""
        return self.step_mm is None and self.axis_point_mm == (0.0, 0.0, 0.0) and self.axis == (0.0, 0.0, 1.0)
