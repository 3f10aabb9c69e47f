"""Alignment of the measured part to its nominal, as an inspection program states it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from measureapp.data.model import Model

Vector = tuple[float, float, float]
Range = tuple[float, float]


class NoAlignment(Model):
    """No alignment: the part frame and the nominal frame coincide."""

    method: Literal["none"] = "none"


class ByCoordinates(Model):
    """Known coordinates, such as those of a fixture: rotations about x, y and z of the nominal, in this order, then a translation."""

    method: Literal["coordinates"] = "coordinates"
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    translation_mm: Vector = Field(default=(0.0, 0.0, 0.0), description="position of the part's origin in the nominal frame")


class Region(Model):
    """An axis-aligned region in the nominal frame; an omitted limit does not restrict it."""

    x_mm: Range | None = None
    y_mm: Range | None = None
    z_mm: Range | None = None
    radial_mm: Range | None = Field(default=None, description="from/to distance from the z axis")

    @model_validator(mode="after")
    def _limits_something(self) -> Region:
        given = [extent for extent in (self.x_mm, self.y_mm, self.z_mm, self.radial_mm) if extent is not None]
        if not given:
            raise ValueError("a region needs at least one of x_mm, y_mm, z_mm, radial_mm")
        if any(low >= high for low, high in given):
            raise ValueError("the ranges of a region must run from the smaller to the greater value")
        return self


class BestFit(Model):
    """Least-squares best fit to the nominal mesh of all points, or of those of chosen features and regions alone."""

    method: Literal["best-fit"] = "best-fit"
    features: tuple[str, ...] = Field(default=(), description="only the points of these features")
    regions: tuple[Region, ...] = Field(default=(), description="only the points in these regions")
    fold: int | None = Field(default=None, ge=2, le=1000, description="order of the rotational symmetry: every angular position is tried")
    axis_point_mm: Vector = (0.0, 0.0, 0.0)
    axis: Vector = Field(default=(0.0, 0.0, 1.0), description="the axis of symmetry")

    @model_validator(mode="after")
    def _is_consistent(self) -> BestFit:
        if sum(value * value for value in self.axis) < 1e-12:
            raise ValueError("`axis` has length 0")
        if self.fold is not None and (self.features or self.regions):
            raise ValueError("`fold` uses all points: remove `features` and `regions`")
        return self


class ThreeTwoOne(Model):
    """3-2-1 alignment: a plane fixes three degrees of freedom, a line or axis two more, a point the last one."""

    method: Literal["3-2-1"] = "3-2-1"
    plane: str
    line: str
    point: str


class ReferencePoint(Model):
    """A feature constrained to its nominal position along given directions."""

    feature: str
    along: tuple[Vector, ...] = Field(
        default=(),
        max_length=3,
        description="constrained directions; default: the normal of a surface point or plane, all three of a centre",
    )

    lock: str = Field(default="", pattern="^[xyz]{0,3}$", description="constrained axes, such as xz, in place of `along`")

    @property
    def directions(self) -> tuple[Vector, ...]:
        """The stated constrained directions; empty for the default."""
        axes = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
        return self.along or tuple(axes[letter] for letter in self.lock)

    @model_validator(mode="after")
    def _directions_have_length(self) -> ReferencePoint:
        if self.along and self.lock:
            raise ValueError("a reference point has `along` or `lock`: remove one of them")
        if len(set(self.lock)) < len(self.lock):
            raise ValueError("`lock` names an axis twice")
        if any(sum(value * value for value in direction) < 1e-12 for direction in self.along):
            raise ValueError("a direction of `along` has length 0")
        return self


class ReferencePoints(Model):
    """Reference point system (RPS): all constraints at once, by least squares where they are redundant."""

    method: Literal["rps"] = "rps"
    points: tuple[ReferencePoint, ...] = Field(min_length=3)


class DatumAlignment(Model):
    """Datum alignment: A, B and C onto their nominals in order of precedence; each constrains only what the earlier ones leave free."""

    method: Literal["datums"] = "datums"
    datums: tuple[str, ...] = Field(min_length=1, max_length=3)


AlignmentProgram = Annotated[
    NoAlignment | ByCoordinates | BestFit | ThreeTwoOne | ReferencePoints | DatumAlignment, Field(discriminator="method")
]
FORMS = "best-fit, none, local:FEATURE,…, cyclic:COUNT, 3-2-1:PLANE,LINE,POINT, rps:POINT,POINT,POINT,… or datums:A,B,C"


def alignment_features(alignment: AlignmentProgram) -> tuple[str, ...]:
    """Return the names of the features an alignment uses."""
    if isinstance(alignment, BestFit):
        return alignment.features
    if isinstance(alignment, ThreeTwoOne):
        return (alignment.plane, alignment.line, alignment.point)
    if isinstance(alignment, ReferencePoints):
        return tuple(point.feature for point in alignment.points)
    return alignment.datums if isinstance(alignment, DatumAlignment) else ()


def alignment_entry(words: str) -> dict[str, object]:
    """Parse the short form of an alignment, such as `best-fit`, into the entry of a program; its values are not checked yet.

    Raises
    ------
    ValueError
        The text has none of the forms in `FORMS`.

    >>> alignment_entry("cyclic:7")
    {'method': 'best-fit', 'fold': 7}
    """
    method, _, rest = words.partition(":")
    names = [name.strip() for name in rest.split(",") if name.strip()]
    if method in ("best-fit", "none") and not rest:
        return {"method": method}
    if method == "cyclic" and rest.strip().isdigit():
        return {"method": "best-fit", "fold": int(rest)}
    if method == "local" and names:
        return {"method": "best-fit", "features": names}
    if method == "3-2-1" and len(names) == 3:
        return {"method": method, "plane": names[0], "line": names[1], "point": names[2]}
    if method == "rps" and names:
        return {"method": method, "points": [{"feature": name} for name in names]}
    if method == "datums" and names:
        return {"method": method, "datums": names}
    raise ValueError(f"{words!r} is not an alignment: give {FORMS}")
