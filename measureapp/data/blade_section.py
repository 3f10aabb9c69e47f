"""Blade sections as an inspection program defines them."""

from __future__ import annotations

from typing import Literal, get_args

from pydantic import Field, model_validator

from measureapp.data.model import Model
from measureapp.data.repeat import Repeat

Vector = tuple[float, float, float]
Range = tuple[float, float]
BladeKind = Literal[
    "chord",
    "max_thickness",
    "max_thickness_place",
    "camber",
    "leading_radius",
    "trailing_radius",
    "stagger",
    "twist",
    "pitch",
    "blade_form",
    "blade_profile",
]
BLADE_KINDS: tuple[str, ...] = get_args(BladeKind)
BLADE_PAIRS = ("twist", "pitch")
BLADE_ANGLES = ("stagger", "twist", "pitch")
BLADE_ZONES = ("blade_form", "blade_profile")
NO_LENGTH = 1e-12


class BladeSection(Model):
    """The section of a blade by a plane or by a cylinder about the axis, repeated for `count` evenly spaced blades (`name.k`).

    All positions are those of the first blade in the nominal frame.
    """

    name: str = Field(min_length=1)
    shape: Literal["blade_section"]
    plane_point_mm: Vector | None = Field(default=None, description="a point of the cutting plane")
    plane_normal: Vector | None = None
    radius_mm: float | None = Field(default=None, gt=0, description="instead of a plane: radius of the cutting cylinder about the axis")
    axis_point_mm: Vector = (0.0, 0.0, 0.0)
    axis: Vector = Field(default=(0.0, 0.0, 1.0), description="axis of the blade row")
    count: int = Field(default=1, ge=1, le=1000, description="number of blades")
    leading_mm: Vector = Field(description="nominal leading edge, or where an open section begins")
    trailing_mm: Vector = Field(description="nominal trailing edge, or where an open section ends")
    open_ends: tuple[Literal["leading", "trailing"], ...] = Field(
        default=(), description="ends where the blade continues, for example into a hub"
    )
    width_mm: float = Field(default=1.0, gt=0, description="width of the strip whose points are used")
    beside_mm: float = Field(gt=0, description="greatest distance of the blade's points from the chord line")

    @model_validator(mode="after")
    def _is_consistent(self) -> BladeSection:
        by_plane = self.plane_point_mm is not None and self.plane_normal is not None
        if by_plane == (self.radius_mm is not None) or (self.plane_point_mm is None) != (self.plane_normal is None):
            raise ValueError("a blade_section needs either `plane_point_mm` and `plane_normal`, or `radius_mm`")
        for name in ("plane_normal", "axis"):
            direction = getattr(self, name)
            if direction is not None and sum(value * value for value in direction) < NO_LENGTH:
                raise ValueError(f"`{name}` has length 0")
        if sum((a - b) ** 2 for a, b in zip(self.leading_mm, self.trailing_mm, strict=True)) < NO_LENGTH:
            raise ValueError("`leading_mm` and `trailing_mm` are the same point")
        return self

    @property
    def repeat(self) -> Repeat | None:
        """The pattern of the blades; None for a single one."""
        return None if self.count == 1 else Repeat(count=self.count, angle_deg=360.0 / self.count)
