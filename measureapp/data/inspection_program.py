"""Inspection programs: measured features, constructed features and toleranced dimensions."""

from __future__ import annotations

import re
from typing import Annotated, Literal, get_args

from pydantic import Field, field_validator, model_validator

from measureapp.data.alignment_program import AlignmentProgram, BestFit, alignment_entry, alignment_features
from measureapp.data.blade_section import BLADE_ANGLES, BLADE_KINDS, BLADE_PAIRS, BLADE_ZONES, BladeKind, BladeSection
from measureapp.data.cut import Cut, Grow, Range, Vector
from measureapp.data.free_form import FreeForm
from measureapp.data.length_unit import LengthUnit
from measureapp.data.material import DatumMaterial, MaterialCondition, require_ascending
from measureapp.data.model import Model
from measureapp.data.repeat import Repeat

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
Criterion = Literal["minimum-zone", "least-squares"]
PAIRS = ("distance", "thickness", "step", "angle", *BLADE_PAIRS)
ZONES: tuple[str, ...] = (*get_args(ZoneKind), *BLADE_ZONES)  # widths of tolerance zones: never negative, ideally 0
FORMS = ("flatness", "straightness", "roundness", "cylindricity")
ONE_DATUM = ("concentricity", "coaxiality", "circular_runout", "total_runout")
PROFILES = ("line_profile", "surface_profile")


class MeasuredFeature(Model):
    """A shape fitted to the points near its nominal, or to a region grown from a seed."""

    name: str = Field(min_length=1)
    shape: MeasuredShape
    point_mm: Vector | None = Field(
        default=None, description="a point of the plane or axis, the centre, or the surface point itself; optional with `grow`"
    )
    direction: Vector | None = Field(
        default=None, description="outward normal of a plane or surface point, axis of a cylinder, axis of a cone towards its apex"
    )
    radius_mm: float | None = Field(default=None, gt=0)
    half_angle_deg: float | None = Field(default=None, gt=0, lt=90)
    patch_mm: float = Field(default=4.0, gt=0, description="radius of the patch around a surface point")
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
        if self.grow is not None and self.shape == "surface_point":
            raise ValueError("`grow` does not apply to a surface_point, which is a patch around its nominal")
        if self.grow is not None and not self.placed:
            if self.direction is not None or self.radius_mm is not None or self.half_angle_deg is not None:
                raise ValueError("a nominal needs `point_mm`; remove direction and sizes of a feature without nominal position")
            return self
        if not self.placed:
            raise ValueError(f"a {self.shape} needs `point_mm`, or `grow` with a seed")
        if self.shape != "sphere" and self.direction is None:
            raise ValueError(f"a {self.shape} needs `direction`")
        if self.direction is not None and sum(value * value for value in self.direction) < 1e-12:
            raise ValueError("`direction` has length 0")
        if self.shape in ("cylinder", "sphere", "cone") and self.radius_mm is None:
            raise ValueError(f"a {self.shape} needs `radius_mm`")
        if self.shape == "cone" and self.half_angle_deg is None:
            raise ValueError("a cone needs `half_angle_deg`")
        return self


class ConstructedFeature(Model):
    """A feature constructed from others.

    The midpoint of two points, the mid-plane of two planes, the intersection of an axis or plane with a plane, or the projection of
    a point or axis onto a plane (named second).
    """

    name: str = Field(min_length=1)
    shape: ConstructedShape
    of: tuple[str, str] = Field(description="names of the two features; `{k}` and `{k+1}` stand for the numbers of the copies of a pattern")
    repeat: Repeat | None = None


class Section(Model):
    """The section plane of a line profile, in the nominal frame."""

    point_mm: Vector
    normal: Vector

    @model_validator(mode="after")
    def _has_a_normal(self) -> Section:
        if sum(value * value for value in self.normal) < 1e-12:
            raise ValueError("`normal` has length 0")
        return self


class DimensionProgram(Model):
    """One toleranced value; with `count`, the mean, minimum or maximum over a pattern.

    Form, orientation, location, run-out and profile are widths of tolerance zones: nominal 0, `upper_tolerance` is the width allowed.
    """

    name: str = Field(min_length=1)
    kind: DimensionKind
    features: tuple[str, ...] = Field(min_length=1, max_length=2)
    datums: tuple[str, ...] = Field(default=(), max_length=3, description="features used as datums A, B, C, in this order")
    nominal: float = Field(default=0.0, description="nominal value; omitted for the width of a zone")
    lower_tolerance: float = -0.1
    upper_tolerance: float = 0.1
    criterion: Criterion = Field(default="minimum-zone", description="how form is evaluated (ISO 1101: minimum zone)")
    along: Vector | None = Field(default=None, description="straightness of a plane: direction of its lines")
    section: Section | None = Field(default=None, description="line profile: its section plane")
    zone_offset_mm: float = Field(
        default=0.0,
        description="profile: offset of the zone's middle from the nominal, out of the material (ISO 1660, UZ)",
    )
    material_condition: MaterialCondition = Field(
        default="regardless", description="position of a hole or shaft: whether its actual size widens the zone (ISO 2692)"
    )
    size_limits_mm: Range | None = Field(default=None, description="limits of the diameter for a material condition")
    datum_material: tuple[DatumMaterial, ...] = Field(
        default=(), description="position of an axis or centre: datums at a material condition, which allow a datum shift (ISO 2692)"
    )
    count: int | None = Field(default=None, ge=2, description="number of copies that `{k}` runs over, cyclically")
    statistic: Literal["mean", "min", "max"] = "mean"

    @model_validator(mode="after")
    def _is_consistent(self) -> DimensionProgram:
        pair = self.kind in PAIRS
        if len(self.features) != (2 if pair else 1):
            raise ValueError(f"kind {self.kind!r} needs {'two features' if pair else 'one feature'}")
        if self.lower_tolerance > self.upper_tolerance:
            raise ValueError("lower_tolerance is greater than upper_tolerance")
        if self.count is None and any(PatternIndex.search(name) for name in (*self.features, *self.datums)):
            raise ValueError("`{k}` needs `count`, the number of copies")
        if self.kind not in ZONES and "nominal" not in self.model_fields_set:
            raise ValueError(f"kind {self.kind!r} needs `nominal`")
        if self.kind in ZONES and (self.nominal != 0 or self.upper_tolerance <= 0):
            raise ValueError(f"a {self.kind} is the width of a tolerance zone: its nominal is 0, `upper_tolerance` the width allowed")
        return self

    @model_validator(mode="after")
    def _has_what_its_material_condition_needs(self) -> DimensionProgram:
        if (self.material_condition != "regardless") != (self.size_limits_mm is not None):
            raise ValueError("`material_condition` and `size_limits_mm` need each other")
        conditions = [limits for limits in (self.size_limits_mm, *(one.size_limits_mm for one in self.datum_material)) if limits]
        if not conditions:
            return self
        if self.kind != "position":
            raise ValueError("a material condition applies to a position only: remove it, or use kind = position")
        if self.size_limits_mm is not None:
            require_ascending("size_limits_mm", self.size_limits_mm)
        if self.count is not None and self.statistic == "mean":
            raise ValueError('with a material condition the mean of several positions is meaningless: use `statistic = "max"`')
        return self

    @model_validator(mode="after")
    def _has_the_datums_of_its_materials(self) -> DimensionProgram:
        named = [one.datum for one in self.datum_material]
        for name in named:
            if name not in self.datums:
                raise ValueError(f"`datum_material` names {name!r}, which is not one of the `datums`: use a name of that list")
            if named.count(name) > 1:
                raise ValueError(f"`datum_material` names {name!r} twice: remove one of them")
        return self

    @model_validator(mode="after")
    def _has_what_its_zone_needs(self) -> DimensionProgram:
        if self.zone_offset_mm and self.kind not in PROFILES:
            raise ValueError("`zone_offset_mm` applies to a line_profile or surface_profile only: remove it")
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
            raise ValueError("a line_profile needs `section`, its section plane")
        return self

    @property
    def limits(self) -> tuple[float, float]:
        """Lower and upper tolerance; the lower limit of a zone's width is 0."""
        return (0.0 if self.kind in ZONES else self.lower_tolerance), self.upper_tolerance

    @property
    def unit(self) -> str:
        """The unit of the value: degrees for angles, else millimetres."""
        return "°" if self.kind in ("angle", "cone_angle", *BLADE_ANGLES) else "mm"

    @property
    def feature_sets(self) -> tuple[tuple[str, ...], ...]:
        """The features of each single value of the dimension."""
        return self._sets(self.features)

    @property
    def datum_sets(self) -> tuple[tuple[str, ...], ...]:
        """The datums of each single value."""
        return self._sets(self.datums)

    def _sets(self, names: tuple[str, ...]) -> tuple[tuple[str, ...], ...]:
        return tuple(substitute_index(names, k, self.count) for k in range(1, self.count + 1)) if self.count else (names,)


class InspectionProgram(Model):
    """All features and dimensions of a part, in the nominal frame: z up as on the table."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1)
    nominal: str | None = Field(default=None, description="mesh file of the nominal, relative to the program's file")
    nominal_unit: LengthUnit = Field(default=LengthUnit.MM, description="unit of the nominal file; the program itself is in mm")
    alignment: AlignmentProgram = Field(default=BestFit(), description="a short form such as best-fit, or a table with `method`")
    features: tuple[Annotated[MeasuredFeature | ConstructedFeature | FreeForm | BladeSection, Field(discriminator="shape")], ...] = ()
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
                        raise ValueError(f"feature {feature.name!r} is constructed from {needed!r}, which is not defined before it")
            names = copy_names(feature.name, feature.repeat)
            if twice := known.intersection(names):
                raise ValueError(f"two features have the name {sorted(twice)[0]!r}")
            known.update(names)
        for needed in alignment_features(self.alignment):
            if needed not in known:
                raise ValueError(f"the alignment needs feature {needed!r}, which is not defined")
        for dimension in self.dimensions:
            for needed in (name for names in (*dimension.feature_sets, *dimension.datum_sets) for name in names):
                if needed not in known:
                    raise ValueError(f"dimension {dimension.name!r} needs feature {needed!r}, which is not defined")
        if len({dimension.name for dimension in self.dimensions}) != len(self.dimensions):
            raise ValueError("two dimensions have the same name")
        return self

    @model_validator(mode="after")
    def _features_suit_their_dimensions(self) -> InspectionProgram:
        blades, free = self._names_of(BladeSection), self._names_of(FreeForm)
        for dimension in self.dimensions:
            features = {name for names in dimension.feature_sets for name in names}
            datums = {name for names in dimension.datum_sets for name in names}
            for needed in sorted(features | datums):
                if (needed in blades) != (dimension.kind in BLADE_KINDS):
                    what = "is not a blade_section" if needed not in blades else "is a blade_section"
                    raise ValueError(f"dimension {dimension.name!r}: {needed!r} {what}; a {dimension.kind} cannot be evaluated on it")
            if (dimension.kind not in PROFILES and features & free) or datums & free:
                needed = sorted((features | datums) & free)[0]
                raise ValueError(
                    f"dimension {dimension.name!r}: {needed!r} is a free_form, which allows only a surface_profile or line_profile"
                )
        for one in self.features:
            if isinstance(one, ConstructedFeature) and (unfit := free.intersection(needed_names(one))):
                raise ValueError(f"feature {one.name!r} is constructed from {min(unfit)!r}, a free_form: use a plane, an axis or a centre")
        if unfit := free.intersection(alignment_features(self.alignment)):
            raise ValueError(f"the alignment uses {min(unfit)!r}, a free_form: use another feature, or a region of the best fit")
        return self

    def _names_of(self, kind: type[BladeSection] | type[FreeForm]) -> set[str]:
        return {name for one in self.features if isinstance(one, kind) for name in copy_names(one.name, one.repeat)}


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


def needed_names(feature: ConstructedFeature) -> tuple[str, ...]:
    """Return the names of all features that ``feature`` and its copies are constructed from."""
    if feature.repeat is None:
        return feature.of
    return tuple(name for k in range(1, feature.repeat.count + 1) for name in substitute_index(feature.of, k, feature.repeat.count))
