"""What to inspect on a part: features cut from its points, features made from others, and toleranced dimensions."""

from __future__ import annotations

import re
from typing import Annotated, Literal, get_args

from pydantic import Field, field_validator, model_validator

from measureapp.data.alignment_program import AlignmentProgram, BestFit, alignment_entry, alignment_features
from measureapp.data.blade_section import BLADE_ANGLES, BLADE_KINDS, BLADE_PAIRS, BLADE_ZONES, BladeKind, BladeSection
from measureapp.data.length_unit import LengthUnit
from measureapp.data.model import Model
from measureapp.data.repeat import Repeat

Vector = tuple[float, float, float]
Range = tuple[float, float]
PatternIndex = re.compile(r"\{k(?:\+(\d+))?\}")

MeasuredShape = Literal["plane", "cylinder", "sphere", "cone", "surface_point"]
ConstructedShape = Literal["midpoint", "midplane", "intersection", "projection"]
SizeKind = Literal["distance", "thickness", "step", "diameter", "radius", "angle", "cone_angle"]
ZoneKind = Literal[
    "flatness",
    "straightness",
    "roundness",
    "cylindricity",
    "parallelism",
    "perpendicularity",
    "angularity",
    "position",
    "concentricity",
    "coaxiality",
    "circular_runout",
    "total_runout",
    "line_profile",
    "surface_profile",
]
DimensionKind = SizeKind | ZoneKind | BladeKind
MaterialCondition = Literal["regardless", "maximum", "least"]
Criterion = Literal["minimum-zone", "least-squares"]
PAIRS = ("distance", "thickness", "step", "angle", *BLADE_PAIRS)
ZONES: tuple[str, ...] = (*get_args(ZoneKind), *BLADE_ZONES)  # the width of a zone: never negative, ideally 0
FORMS = ("flatness", "straightness", "roundness", "cylindricity")
ONE_DATUM = ("concentricity", "coaxiality", "circular_runout", "total_runout")
PROFILES = ("line_profile", "surface_profile")


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


class MeasuredFeature(Model):
    """A shape fitted to the points around its nominal, or to the region that grows from a seed."""

    name: str = Field(min_length=1)
    shape: MeasuredShape
    point_mm: Vector | None = Field(
        default=None, description="a point of the plane or axis, the centre, or the surface point itself; may be left out with `grow`"
    )
    direction: Vector | None = Field(
        default=None, description="outward normal of planes and surface points, axis of a cylinder, of a cone towards its apex"
    )
    radius_mm: float | None = Field(default=None, gt=0)
    half_angle_deg: float | None = Field(default=None, gt=0, lt=90)
    patch_mm: float = Field(default=4.0, gt=0, description="radius of the patch a surface point is taken from")
    hole: bool = Field(default=False, description="the material lies outside: a bore or a socket")
    cut: Cut = Cut()
    grow: Grow | None = Field(default=None, description="take the points by region growing; of `cut` only x_mm, y_mm and z_mm still count")
    repeat: Repeat | None = None

    @property
    def placed(self) -> bool:
        """Whether the drawing says where the feature lies."""
        return self.point_mm is not None

    @model_validator(mode="after")
    def _has_what_its_shape_needs(self) -> MeasuredFeature:
        if self.grow is not None and self.shape == "surface_point":
            raise ValueError("a surface_point is a patch about its nominal and does not `grow`")
        if self.grow is not None and not self.placed:
            if self.direction is not None or self.radius_mm is not None or self.half_angle_deg is not None:
                raise ValueError("a nominal needs `point_mm`; leave direction and sizes out where the drawing gives no place")
            return self
        if not self.placed:
            raise ValueError(f"a {self.shape} needs `point_mm`, or `grow` with a seed")
        if self.shape != "sphere" and self.direction is None:
            raise ValueError(f"a {self.shape} needs `direction`")
        if self.direction is not None and sum(value * value for value in self.direction) < 1e-12:
            raise ValueError("`direction` has no length")
        if self.shape in ("cylinder", "sphere", "cone") and self.radius_mm is None:
            raise ValueError(f"a {self.shape} needs `radius_mm`")
        if self.shape == "cone" and self.half_angle_deg is None:
            raise ValueError("a cone needs `half_angle_deg`")
        return self


class ConstructedFeature(Model):
    """A feature made from others.

    The middle of two points, the plane between two planes, where an axis or plane meets a plane, or a point or axis
    projected onto a plane (named second).
    """

    name: str = Field(min_length=1)
    shape: ConstructedShape
    of: tuple[str, str] = Field(description="names of the two features; `{k}` and `{k+1}` count the copies of a pattern")
    repeat: Repeat | None = None


class Section(Model):
    """A plane in which a line profile is taken, in the nominal's frame."""

    point_mm: Vector
    normal: Vector

    @model_validator(mode="after")
    def _has_a_normal(self) -> Section:
        if sum(value * value for value in self.normal) < 1e-12:
            raise ValueError("`normal` has no length")
        return self


class DimensionProgram(Model):
    """One toleranced value; with `count`, the mean, least or greatest over a pattern.

    Form, orientation, location, run-out and profile are widths of zones: their nominal is 0 and `upper_tolerance` is the zone's width.
    """

    name: str = Field(min_length=1)
    kind: DimensionKind
    features: tuple[str, ...] = Field(min_length=1, max_length=2)
    datums: tuple[str, ...] = Field(default=(), max_length=3, description="features that are datums A, B, C, in this order")
    nominal: float = Field(default=0.0, description="value of the drawing; left out for the width of a zone")
    lower_tolerance: float = -0.1
    upper_tolerance: float = 0.1
    criterion: Criterion = Field(default="minimum-zone", description="how form is taken (ISO 1101: minimum zone)")
    along: Vector | None = Field(default=None, description="straightness of a plane: direction of its lines")
    section: Section | None = Field(default=None, description="line profile: the plane it is taken in")
    material_condition: MaterialCondition = Field(
        default="regardless", description="position of a hole or shaft: whether its actual size widens the zone (ISO 2692)"
    )
    size_limits_mm: Range | None = Field(default=None, description="limits of the diameter that a material condition starts from")
    count: int | None = Field(default=None, ge=2, description="how many copies `{k}` runs over, cyclically")
    statistic: Literal["mean", "min", "max"] = "mean"

    @model_validator(mode="after")
    def _is_consistent(self) -> DimensionProgram:
        pair = self.kind in PAIRS
        if len(self.features) != (2 if pair else 1):
            raise ValueError(f"kind {self.kind!r} needs {'two features' if pair else 'one feature'}")
        if self.lower_tolerance > self.upper_tolerance:
            raise ValueError("lower_tolerance lies above upper_tolerance")
        if self.count is None and any(PatternIndex.search(name) for name in (*self.features, *self.datums)):
            raise ValueError("`{k}` needs `count`, the number of copies")
        if self.kind not in ZONES and "nominal" not in self.model_fields_set:
            raise ValueError(f"kind {self.kind!r} needs `nominal`")
        if self.kind in ZONES and (self.nominal != 0 or self.upper_tolerance <= 0):
            raise ValueError(f"a {self.kind} is the width of a zone: its nominal is 0, `upper_tolerance` the width allowed")
        return self

    @model_validator(mode="after")
    def _has_what_its_material_condition_needs(self) -> DimensionProgram:
        if (self.material_condition != "regardless") != (self.size_limits_mm is not None):
            raise ValueError("`material_condition` and `size_limits_mm` come together")
        if self.size_limits_mm is None:
            return self
        if self.kind != "position":
            raise ValueError("a material condition is taken of a position only, and not of datums")
        if self.size_limits_mm[0] >= self.size_limits_mm[1]:
            raise ValueError("size_limits_mm must run from the smaller to the greater diameter")
        if self.count is not None and self.statistic == "mean":
            raise ValueError('with a material condition the mean of several positions says nothing: take `statistic = "max"`')
        return self

    @model_validator(mode="after")
    def _has_the_datums_of_its_kind(self) -> DimensionProgram:
        if (self.kind in FORMS or self.kind not in ZONES) and self.datums:
            raise ValueError(f"a {self.kind} has no datums")
        if self.kind in BLADE_ZONES and self.datums:
            raise ValueError(f"a {self.kind} has no datums")
        if self.kind in ZONES and self.kind not in (*FORMS, *PROFILES, *BLADE_ZONES) and not self.datums:
            raise ValueError(f"a {self.kind} needs `datums`")
        if self.kind in ONE_DATUM and len(self.datums) > 1:
            raise ValueError(f"a {self.kind} has one datum")
        if self.kind == "line_profile" and self.section is None:
            raise ValueError("a line_profile needs `section`, the plane it is taken in")
        return self

    @property
    def limits(self) -> tuple[float, float]:
        """Lower and upper tolerance; the width of a zone ends at 0."""
        return (0.0 if self.kind in ZONES else self.lower_tolerance), self.upper_tolerance

    @property
    def unit(self) -> str:
        """The unit of the value: degrees for angles, else millimetres."""
        return "°" if self.kind in ("angle", "cone_angle", *BLADE_ANGLES) else "mm"

    @property
    def feature_sets(self) -> tuple[tuple[str, ...], ...]:
        """The features of each single value that the dimension is taken over."""
        return self._sets(self.features)

    @property
    def datum_sets(self) -> tuple[tuple[str, ...], ...]:
        """The datums of each single value."""
        return self._sets(self.datums)

    def _sets(self, names: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
        return tuple(indexed(names, k, self.count) for k in range(1, self.count + 1)) if self.count else (names,)


class InspectionProgram(Model):
    """All features and dimensions of a part, in the frame of its nominal: z up as it stands on the table."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1)
    nominal: str | None = Field(default=None, description="mesh file of the nominal, relative to the program's file")
    nominal_unit: LengthUnit = Field(default=LengthUnit.MM, description="unit of the nominal's file; the program itself is in mm")
    alignment: AlignmentProgram = Field(default=BestFit(), description="a word like best-fit, or a table with `method`")
    features: tuple[Annotated[MeasuredFeature | ConstructedFeature | BladeSection, Field(discriminator="shape")], ...] = ()
    dimensions: tuple[DimensionProgram, ...] = ()

    @field_validator("alignment", mode="before")
    @classmethod
    def _alignment_in_one_word(cls, given: object) -> object:
        return alignment_entry(given) if isinstance(given, str) else given

    @model_validator(mode="after")
    def _names_meet(self) -> InspectionProgram:
        known: set[str] = set()
        for feature in self.features:
            if isinstance(feature, ConstructedFeature):
                for needed in needed_names(feature):
                    if needed not in known:
                        raise ValueError(f"feature {feature.name!r} is made of {needed!r}, which is not defined before it")
            names = copy_names(feature.name, feature.repeat)
            if twice := known.intersection(names):
                raise ValueError(f"two features are called {sorted(twice)[0]!r}")
            known.update(names)
        blades = {name for one in self.features if isinstance(one, BladeSection) for name in copy_names(one.name, one.repeat)}
        for needed in alignment_features(self.alignment):
            if needed not in known:
                raise ValueError(f"the alignment needs feature {needed!r}, which is not defined")
        for dimension in self.dimensions:
            for needed in (name for names in (*dimension.feature_sets, *dimension.datum_sets) for name in names):
                if needed in known and (needed in blades) != (dimension.kind in BLADE_KINDS):
                    what = "is no blade_section" if needed not in blades else "is a blade_section"
                    raise ValueError(f"dimension {dimension.name!r}: {needed!r} {what}, a {dimension.kind} is not taken of it")
                if needed not in known:
                    raise ValueError(f"dimension {dimension.name!r} needs feature {needed!r}, which is not defined")
        if len({dimension.name for dimension in self.dimensions}) != len(self.dimensions):
            raise ValueError("two dimensions have the same name")
        return self


def copy_names(name: str, repeat: Repeat | None) -> tuple[str, ...]:
    """Return the names a feature or its copies have.

    >>> copy_names("flank", Repeat(count=2, angle_deg=180))
    ('flank.1', 'flank.2')
    """
    return (name,) if repeat is None else tuple(f"{name}.{k}" for k in range(1, repeat.count + 1))


def indexed(names: tuple[str, ...], k: int, count: int | None) -> tuple[str, ...]:
    """Return ``names`` with `{k}` and `{k+n}` replaced by numbers 1…count, cyclically.

    >>> indexed(("mid.{k}", "mid.{k+1}"), 7, 7)
    ('mid.7', 'mid.1')
    """

    def number(match: re.Match[str]) -> str:
        shifted = k + int(match.group(1) or 0)
        return str(shifted if count is None else (shifted - 1) % count + 1)

    return tuple(PatternIndex.sub(number, name) for name in names)


def needed_names(feature: ConstructedFeature) -> tuple[str, ...]:
    """Return the names of all features that ``feature`` and its copies are made of."""
    if feature.repeat is None:
        return feature.of
    return tuple(name for k in range(1, feature.repeat.count + 1) for name in indexed(feature.of, k, feature.repeat.count))
