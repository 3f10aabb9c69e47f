"""Geometric elements fitted to points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from measureapp.arrays import FloatArray, read_only

Shape = Literal[
    "point", "line", "plane", "circle", "sphere", "cylinder", "cone", "torus", "slot", "edge", "surface"
]  # a surface is not fitted: it is a region of the nominal mesh; an edge is found as a line


@dataclass(frozen=True, slots=True, eq=False)
class Feature:
    """A fitted geometric element; parameters that the shape does not have are None. Lengths in mm, in one frame."""

    name: str
    shape: Shape
    point_mm: FloatArray  # (3,) of the plane or axis, nearest the centroid of the points; centre of a circle, sphere or torus
    direction: FloatArray | None = None  # (3,), unit: normal or axis; of a cone towards its apex
    radius_mm: float | None = None  # for a cone: its radius at `point_mm`
    half_angle_rad: float | None = None
    minor_radius_mm: float | None = None
    length_mm: float | None = None  # overall length of a slot; its `radius_mm` is half the width, its direction the long one
    normal: FloatArray | None = None  # (3,), unit: axis of a slot, outward normal of the face of a line
    points: int = 0
    left_out: int = 0  # rejected outliers
    rms_mm: float = 0.0
    form_error_mm: float = 0.0  # greatest minus smallest signed distance
    standard_deviations: Mapping[str, float] = field(
        default_factory=dict
    )  # keys like the fields: "radius_mm", "position_mm", "direction_rad"
    covariance: FloatArray | None = (
        None  # (6 + S, 6 + S): of point_mm, direction and S sizes (radius_mm, then half_angle_rad, minor_radius_mm or length_mm)
    )
    boundary_mm: FloatArray | None = None  # (K, 3) extent of the points used, for display
    how: str = ""  # how its points were selected, if not around its nominal

    def __post_init__(self) -> None:
        object.__setattr__(self, "point_mm", read_only(self.point_mm, np.float64, (3,)))
        if self.direction is not None:
            object.__setattr__(self, "direction", read_only(self.direction, np.float64, (3,)))
        if self.normal is not None:
            object.__setattr__(self, "normal", read_only(self.normal, np.float64, (3,)))
        if self.covariance is not None:
            rows = len(self.covariance)
            object.__setattr__(self, "covariance", read_only(self.covariance, np.float64, (rows, rows)))
