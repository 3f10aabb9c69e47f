"""Features of an inspection program: measured around their nominals, or constructed from others."""

from __future__ import annotations

import re
from typing import Literal

from pydantic import Field, model_validator

from measureapp.data.cut import Cut, Grow, Vector
from measureapp.data.model import Model
from measureapp.data.repeat import Repeat

PatternIndex = re.compile(r"\{k(?:\+(\d+))?\}")
MeasuredShape = Literal["plane", "cylinder", "sphere", "cone", "surface_point", "circle", "line", "slot", "edge"]
ConstructedShape = Literal[
    "midpoint",
    "midplane",
    "symmetry",
    "intersection",
    "projection",
    "offset",
    "point_on_axis",
    "best_fit_line",
    "best_fit_plane",
    "best_fit_circle",
    "pitch_circle",
    "common_datum",
]
CONTOURS = ("circle", "line", "slot", "edge")  # found in a slice or strip of the surface
GROWN = ("plane", "cylinder", "sphere", "cone")
ROUND = ("cylinder", "sphere", "cone", "circle")
THROUGH_POINTS = {"best_fit_line": 2, "best_fit_plane": 3, "best_fit_circle": 3, "pitch_circle": 3}  # least number of parents
PARENTS = {
    **{"midpoint": (2, 2), "midplane": (2, 2), "symmetry": (2, 2), "intersection": (2, 3), "projection": (2, 2)},
    "common_datum": (2, 2),
}
WITH_DISTANCE = ("offset", "point_on_axis")
NO_LENGTH = 1e-12


class MeasuredFeature(Model):
    """A shape fitted to the points near its nominal, or to a region grown from a seed."""

    name: str = Field(min_length=1)
    shape: MeasuredShape
    point_mm: Vector | None = Field(
        default=None,
        description="a point of the plane or axis, the centre, the middle of a line or edge, or the surface point itself; optional with `grow`",
    )
    direction: Vector | None = Field(
        default=None,
        description="outward normal of a plane or surface point, axis of a cylinder, circle or slot, axis of a cone towards its apex, "
        "direction of a line or edge",
    )
    radius_mm: float | None = Field(default=None, gt=0)
    half_angle_deg: float | None = Field(default=None, gt=0, lt=90)
    patch_mm: float = Field(default=4.0, gt=0, description="radius of the patch around a surface point")
    along: Vector | None = Field(default=None, description="slot: its long direction")
    normals: tuple[Vector, ...] = Field(
        default=(),
        max_length=2,
        description="outward normals of the faces: of a line its face, of an edge both; of a free edge its only one",
    )
    length_mm: float | None = Field(default=None, gt=0, description="length of a line or edge, overall length of a slot")
    width_mm: float | None = Field(default=None, gt=0, description="width of a slot")
    height_mm: float = Field(default=2.0, gt=0, description="circle, slot: height of the slice of the wall that is used")
    strip_mm: float = Field(default=4.0, gt=0, description="line, edge: width of the strip of the surface that is used")
    gap_mm: float = Field(default=1.5, ge=0, description="edge: distance from the edge within which points are not used")
    loss_mm: float | None = Field(
        default=None, ge=0, description="free edge: greatest width of surface that fringe window and blur remove along it"
    )
    hole: bool = Field(default=False, description="internal feature, material outside: a bore or a socket")
    cut: Cut = Cut()
    grow: Grow | None = Field(default=None, description="select the points by region growing; of `cut` only x_mm, y_mm and z_mm apply")
    repeat: Repeat | None = None

    @property
    def placed(self) -> bool:
        """Whether the feature has a nominal position."""
        return self.point_mm is not None

    @model_validator(mode="after")
    def _has_what_its_shape_needs(self) -> MeasuredFeature:
        if self.grow is not None and self.shape not in GROWN:
            words = "a surface_point, which is a patch around its nominal" if self.shape == "surface_point" else f"a {self.shape}"
            raise ValueError(f"`grow` does not apply to {words}")
        if self.grow is not None and not self.placed:
            if self.direction is not None or self.radius_mm is not None or self.half_angle_deg is not None:
                raise ValueError("a nominal needs `point_mm`; remove direction and sizes of a feature without nominal position")
            return self
        if not self.placed:
            raise ValueError(f"a {self.shape} needs `point_mm`, or `grow` with a seed")
        if self.shape != "sphere" and self.direction is None:
            raise ValueError(f"a {self.shape} needs `direction`")
        if self.direction is not None and _has_no_length(self.direction):
            raise ValueError("`direction` has length 0")
        if self.shape in ROUND and self.radius_mm is None:
            raise ValueError(f"a {self.shape} needs `radius_mm`")
        if self.shape == "cone" and self.half_angle_deg is None:
            raise ValueError("a cone needs `half_angle_deg`")
        return self

    @model_validator(mode="after")
    def _has_what_its_contour_needs(self) -> MeasuredFeature:
        direction = self.direction or (0.0, 0.0, 1.0)
        for name, vector in (("along", self.along), *(("normals", one) for one in self.normals)):
            if vector is not None and (_has_no_length(vector) or _is_parallel(vector, direction)):
                raise ValueError(f"`{name}` must not be 0 or parallel to `direction`")
        if self.shape in ("line", "edge") and (self.length_mm is None or not self.normals):
            raise ValueError(f"a {self.shape} needs `length_mm` and `normals`, the outward normals of its faces")
        if self.shape == "line" and len(self.normals) != 1:
            raise ValueError("a line lies on one face: give one of `normals`")
        if self.shape == "edge" and (len(self.normals) == 1) != (self.loss_mm is not None):
            raise ValueError(
                "an edge needs the `normals` of both faces; a free edge has one, and needs `loss_mm`: fringe window and blur end the points "
                "before the material ends"
            )
        if len(self.normals) == 2 and _is_parallel(*self.normals):
            raise ValueError("the faces of an edge must not be parallel")
        if self.shape == "slot" and (self.along is None or self.length_mm is None or self.width_mm is None):
            raise ValueError("a slot needs `along`, its long direction, `length_mm` and `width_mm`")
        if self.shape == "slot" and (self.length_mm or 0.0) <= (self.width_mm or 0.0):
            raise ValueError("a slot is longer than wide; otherwise use a circle")
        return self


class ConstructedFeature(Model):
    """A feature constructed from others.

    The midpoint of two points, the mid-plane of two planes, the plane or axis of symmetry, the intersection of an axis or plane with a
    plane, or of three planes, the projection of a point or axis onto a plane (named second), a plane offset along its normal, the point
    of an axis at a distance from a plane (named second), a line, plane or circle through points, or the common datum (ISO 5459, A-B) of
    two axes in line, two faces in one plane or two centres.
    """

    name: str = Field(min_length=1)
    shape: ConstructedShape
    of: tuple[str, ...] = Field(
        min_length=1, description="names of the features; `{k}` and `{k+1}` stand for the numbers of the copies of a pattern"
    )
    distance_mm: float | None = Field(default=None, description="of an offset or a point on an axis")
    count: int | None = Field(default=None, ge=2, le=1000, description="`{k}` of `of` runs over 1…count, all in one feature")
    repeat: Repeat | None = None

    @model_validator(mode="after")
    def _has_its_parents(self) -> ConstructedFeature:
        number = len(self.of) * (self.count or 1)
        least, most = PARENTS.get(self.shape, (THROUGH_POINTS.get(self.shape, 1), 1000))
        if self.shape in WITH_DISTANCE:
            least, most = (1, 1) if self.shape == "offset" else (2, 2)
        if not least <= number <= most:
            needed = str(least) if least == most else f"at least {least}" if most == 1000 else f"{least} to {most}"
            raise ValueError(f"a constructed {self.shape} needs {needed} features in `of`")
        if (self.shape in WITH_DISTANCE) != (self.distance_mm is not None):
            words = "needs `distance_mm`" if self.distance_mm is None else "has no `distance_mm`"
            raise ValueError(f"a constructed {self.shape} {words}")
        if self.count is not None and (self.repeat is not None or not any(PatternIndex.search(name) for name in self.of)):
            raise ValueError("`count` is the number of copies that `{k}` in `of` runs over; it excludes `repeat`")
        return self


def copy_names(name: str, repeat: Repeat | None) -> tuple[str, ...]:
    """Return the name of a feature, or the names of its copies.

    >>> copy_names("flank", Repeat(count=2, angle_deg=180))
    ('flank.1', 'flank.2')
    """
    return (name,) if repeat is None else tuple(f"{name}.{k}" for k in range(1, repeat.count + 1))


def substitute_index(names: tuple[str, ...], k: int, count: int | None) -> tuple[str, ...]:
    """Replace `{k}` and `{k+n}` in ``names`` by numbers 1…count, cyclically.

    >>> substitute_index(("mid.{k}", "mid.{k+1}"), 7, 7)
    ('mid.7', 'mid.1')
    """

    def number(match: re.Match[str]) -> str:
        shifted = k + int(match.group(1) or 0)
        return str(shifted if count is None else (shifted - 1) % count + 1)

    return tuple(PatternIndex.sub(number, name) for name in names)


def parent_sets(feature: ConstructedFeature) -> tuple[tuple[str, ...], ...]:
    """Return the names of the parents of the feature, or of each of its copies."""
    if feature.count is not None:
        return (tuple(name for k in range(1, feature.count + 1) for name in substitute_index(feature.of, k, feature.count)),)
    if feature.repeat is None:
        return (feature.of,)
    return tuple(substitute_index(feature.of, k, feature.repeat.count) for k in range(1, feature.repeat.count + 1))


def needed_names(feature: ConstructedFeature) -> tuple[str, ...]:
    """Return the names of all features that ``feature`` and its copies are constructed from."""
    return tuple(name for names in parent_sets(feature) for name in names)


def _has_no_length(vector: Vector) -> bool:
    return sum(value * value for value in vector) < NO_LENGTH


def _is_parallel(one: Vector, other: Vector) -> bool:
    """Return whether two vectors enclose less than about 0.6°."""
    product = sum(a * b for a, b in zip(one, other, strict=True)) ** 2
    return product > 0.9999 * sum(a * a for a in one) * sum(b * b for b in other)
