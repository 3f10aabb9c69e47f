"""Dimensions of an inspection program: toleranced values of features."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, get_args

from pydantic import Field, model_validator

from measureapp.data.blade_section import BLADE_ANGLES, BLADE_KINDS, BLADE_PAIRS, BLADE_ZONES, BladeKind
from measureapp.data.cut import Range, Vector
from measureapp.data.feature_program import PatternIndex, substitute_index
from measureapp.data.length_certificate import LengthCertificate
from measureapp.data.material import DatumMaterial, MaterialCondition, require_ascending
from measureapp.data.model import Model
from measureapp.data.tolerance_text import parse_tolerance

SizeKind = Literal["distance", "thickness", "step", "diameter", "radius", "angle", "cone_angle", "slot_width", "slot_length"]
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
SAME = 1e-9  # mm or degrees
LIMITS = ("lower_tolerance", "upper_tolerance")
SIGNED = "step"  # the only size with a sign
__all__ = ["BLADE_KINDS", "FORMS", "PAIRS", "PROFILES", "ZONES", "Criterion", "DimensionKind", "DimensionProgram", "Section"]


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
    nominal_linked: bool = Field(default=False, description="the nominal is that of the nominal features, and follows their changes")
    lower_tolerance: float = -0.1
    upper_tolerance: float = 0.1
    tolerance: str | None = Field(
        default=None,
        description="the tolerance in one text, in place of the two limits: ±0.1, +0.1/-0.05, max 0.05, H7, 2768-m; empty: no verdict",
    )
    alignment: str | None = Field(default=None, description="one of the further `alignments`; none: that of the program")
    group: str = Field(default="", description="heading under which tables list it")
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
    certificate: LengthCertificate | None = Field(
        default=None, description="the nominal is certified: all other lengths are corrected by what this one is off"
    )
    count: int | None = Field(default=None, ge=2, description="number of copies that `{k}` runs over, cyclically")
    statistic: Literal["mean", "min", "max"] = "mean"

    @model_validator(mode="before")
    @classmethod
    def _limits_of_its_text(cls, values: Any) -> Any:
        """Set the limits that follow from `tolerance`; limits stated beside it must agree."""
        if not isinstance(values, Mapping) or values.get("tolerance") is None:
            return values
        if not isinstance(values["tolerance"], str):
            raise ValueError('`tolerance` is a text, such as "±0.05", "+0.1/-0.05", "max 0.05" or "H7"')
        kind, nominal = values.get("kind"), values.get("nominal", 0.0)
        if not isinstance(kind, str) or isinstance(nominal, bool) or not isinstance(nominal, int | float):
            return values
        parsed = parse_tolerance(values["tolerance"], kind=kind, nominal=float(nominal), is_zone=kind in ZONES)
        if parsed is None:
            return {name: value for name, value in values.items() if name not in LIMITS}
        limits = (parsed.lower if kind not in ZONES else values.get(LIMITS[0], -0.1), parsed.upper)
        for name, limit in zip(LIMITS, limits, strict=True):
            if isinstance(stated := values.get(name, limit), int | float) and abs(stated - limit) > SAME:
                raise ValueError(
                    f"`tolerance` {values['tolerance']} gives {name} = {limit:g}, but {stated:g} is stated: remove one of them"
                )
        return {**values, **dict(zip(LIMITS, limits, strict=True))}

    @model_validator(mode="after")
    def _is_consistent(self) -> DimensionProgram:
        pair = self.kind in PAIRS
        if len(self.features) != (2 if pair else 1):
            raise ValueError(f"kind {self.kind!r} needs {'two features' if pair else 'one feature'}")
        if pair and any(first == second for first, second in self.feature_sets):
            raise ValueError(f"kind {self.kind!r} needs two different features, {self.features[0]!r} is named twice")
        if self.lower_tolerance > self.upper_tolerance:
            raise ValueError("lower_tolerance is greater than upper_tolerance")
        if self.count is None and any(PatternIndex.search(name) for name in (*self.features, *self.datums)):
            raise ValueError("`{k}` needs `count`, the number of copies")
        if self.kind not in ZONES and "nominal" not in self.model_fields_set:
            raise ValueError(f"kind {self.kind!r} needs `nominal`")
        if self.kind in get_args(SizeKind) and self.kind != SIGNED and self.nominal < 0:
            raise ValueError(f"`nominal` of a {self.kind} cannot be negative: only a {SIGNED} has a sign")
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
    def _is_a_length_if_certified(self) -> DimensionProgram:
        if self.certificate is None:
            return self
        if not self.is_single_length:
            raise ValueError("a `certificate` belongs to one length, such as a distance or a diameter: remove it here")
        if self.nominal <= 0:
            raise ValueError("`nominal` must be the certified length, above 0 mm")
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
    def is_single_length(self) -> bool:
        """Whether it is one length, which can be certified: a size in mm, not of a pattern."""
        return self.kind in get_args(SizeKind) and self.unit == "mm" and self.count is None

    @property
    def is_toleranced(self) -> bool:
        """Whether a tolerance is stated, so that there is a verdict."""
        return self.tolerance is None or bool(self.tolerance.strip())

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
