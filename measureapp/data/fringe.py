"""Pattern sets, and the fringe images taken at one viewpoint."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import tau
from typing import Annotated, Literal

from pydantic import Field, model_validator

from measureapp.arrays import ImageArray
from measureapp.data.conditions import Conditions
from measureapp.data.model import Model
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

Direction = Literal["vertical", "horizontal"]  # of the fringes: the phase of vertical ones increases with the projector's column


class PhaseShiftGroup(Model):
    """Phase-shifted sinusoidal fringes of one pitch: image n is A + B cos(phase + shift_sign · 2πn/steps)."""

    kind: Literal["phase-shift"] = "phase-shift"
    direction: Direction = "vertical"
    pitch_px: float = Field(gt=2, description="period in projector pixels")
    steps: int = Field(default=4, ge=3)

    @property
    def count(self) -> int:
        """Number of images."""
        return self.steps


class GrayCodeGroup(Model):
    """Gray-code planes, most significant first, that number the periods; with ``complementary`` the last is shifted by half a period."""

    kind: Literal["gray-code"] = "gray-code"
    direction: Direction = "vertical"
    planes: int = Field(ge=1, description="all planes, the complementary one included")
    complementary: bool = False

    @property
    def count(self) -> int:
        """Number of images."""
        return self.planes


PatternGroup = Annotated[PhaseShiftGroup | GrayCodeGroup, Field(discriminator="kind")]


class PatternSet(Model):
    """The images projected at one viewpoint, in order: first all groups of vertical fringes, then those of horizontal ones."""

    name: str
    projector_px: int = Field(gt=0, description="columns spanned by the phase of vertical fringes")
    projector_rows: int | None = Field(default=None, gt=0, description="rows spanned by the phase of horizontal fringes")
    groups: tuple[PatternGroup, ...] = Field(min_length=1)
    shift_sign: Literal[-1, 1] = -1

    @model_validator(mode="after")
    def _directions_follow_each_other(self) -> PatternSet:
        directions = [group.direction for group in self.groups]
        if directions != sorted(directions, reverse=True):
            raise ValueError("groups of vertical fringes must come before those of horizontal ones")
        if "horizontal" in directions and self.projector_rows is None:
            raise ValueError("horizontal fringes need projector_rows")
        return self

    @property
    def count(self) -> int:
        """Number of images."""
        return sum(group.count for group in self.groups)

    @property
    def directions(self) -> tuple[Direction, ...]:
        """Directions of the fringes, vertical first."""
        return tuple(dict.fromkeys(group.direction for group in self.groups))

    def subset(self, direction: Direction) -> tuple[PatternSet, slice]:
        """Return the groups of one direction as a set of their own, and the indices of their images.

        The set's ``projector_px`` is the extent of its phase: columns for vertical fringes, rows for horizontal ones.
        Raises ValueError when there are none.
        """
        groups = tuple(group for group in self.groups if group.direction == direction)
        first = 0 if direction == self.groups[0].direction else self.count - sum(group.count for group in groups)
        extent = self.projector_px if direction == "vertical" else self.projector_rows
        alone = PatternSet(
            name=f"{self.name} ({direction})" if len(self.directions) > 1 else self.name,
            projector_px=extent or self.projector_px,
            projector_rows=self.projector_rows,
            groups=groups,
            shift_sign=self.shift_sign,
        )
        return alone, slice(first, first + alone.count)

    @property
    def pitches_px(self) -> tuple[float, ...]:
        """Pitches of the sinusoids, in order."""
        return tuple(group.pitch_px for group in self.groups if isinstance(group, PhaseShiftGroup))

    @property
    def finest_pitch_px(self) -> float:
        """The pitch whose absolute phase is the result of decoding."""
        return min(self.pitches_px)

    @property
    def phase_range_rad(self) -> float:
        """The absolute phase at the projector's right edge."""
        return tau * self.projector_px / self.finest_pitch_px


@dataclass(frozen=True, slots=True, eq=False)
class Readback:
    """Axis positions as reported by their controllers, as far as known: a table alone has no robot."""

    base_from_flange: RigidTransform | None = None
    guide_mm: float | None = None
    table_rad: float | None = None

    def full(self) -> AxisReadback:
        """Return the read-back of a complete rig. Raises CalibrationError where an axis is missing."""
        if self.base_from_flange is None or self.guide_mm is None or self.table_rad is None:
            raise CalibrationError("The read-back of an axis is missing.", "Give robot pose, guide position and table angle.")
        return AxisReadback(self.base_from_flange, self.guide_mm, self.table_rad)

    def missing(self, needed: Iterable[str]) -> list[str]:
        """Return the axes of ``needed`` (names of the fields) whose position is not known, in words."""
        return [READBACK_WORDS[name] for name in needed if getattr(self, name) is None]


READBACK_WORDS = {"base_from_flange": "the robot's pose", "guide_mm": "the guide's position", "table_rad": "the table's angle"}


@dataclass(frozen=True, slots=True, eq=False)
class AxisReadback(Readback):
    """The positions of all axes of a rig as reported when the images were taken."""

    base_from_flange: RigidTransform
    guide_mm: float
    table_rad: float


@dataclass(frozen=True, slots=True, eq=False)
class FringeStack:
    """All fringe images of one viewpoint with their patterns, exposures and axis read-back."""

    viewpoint_id: str
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # from long to short
    images: Mapping[str, ImageArray]  # camera -> (exposures, patterns, height, width), read-only uint8 or uint16
    saturation: int  # grey level at which a pixel is saturated
    readback: AxisReadback | None = None  # None for recorded images without a rig
    conditions: Conditions | None = None  # None if not recorded
    approach: str | None = None  # the same for stacks between which robot and guide did not move; None if not recorded
