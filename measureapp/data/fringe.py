"""Pattern sets, and the stack of fringe images taken at one viewpoint."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import tau
from typing import Literal

from pydantic import Field

from measureapp.arrays import ImageArray
from measureapp.data.model import Model
from measureapp.geometry.transform import RigidTransform


class PhaseShiftGroup(Model):
    """Equally shifted sinusoids of one pitch: image n is A + B cos(phase + shift_sign · 2πn/steps)."""

    kind: Literal["phase-shift"] = "phase-shift"
    pitch_px: float = Field(gt=2, description="period in projector pixels")
    steps: int = Field(default=4, ge=3)

    @property
    def count(self) -> int:
        """How many images the group has."""
        return self.steps


class GrayCodeGroup(Model):
    """Binary planes, most significant first, that number the periods; with ``complementary`` the last is shifted by half a period."""

    kind: Literal["gray-code"] = "gray-code"
    planes: int = Field(ge=1, description="all planes, the complementary one included")
    complementary: bool = False

    @property
    def count(self) -> int:
        """How many images the group has."""
        return self.planes


PatternGroup = PhaseShiftGroup | GrayCodeGroup


class PatternSet(Model):
    """The images projected at one viewpoint, in order; fringes stand vertical, the phase grows with the projector's column."""

    name: str
    projector_px: int = Field(gt=0, description="columns the phase runs over")
    groups: tuple[PatternGroup, ...] = Field(min_length=1)
    shift_sign: Literal[-1, 1] = -1

    @property
    def count(self) -> int:
        """How many images the set has."""
        return sum(group.count for group in self.groups)

    @property
    def pitches_px(self) -> tuple[float, ...]:
        """The pitches of the sinusoids, in order."""
        return tuple(group.pitch_px for group in self.groups if isinstance(group, PhaseShiftGroup))

    @property
    def finest_pitch_px(self) -> float:
        """The pitch whose absolute phase is the result of decoding."""
        return min(self.pitches_px)

    @property
    def phase_range_rad(self) -> float:
        """The absolute phase at the projector's right edge."""
        return tau * self.projector_px / self.finest_pitch_px


PAPER_PATTERNS = PatternSet(
    name="paper: 4 steps at 32 and 33 px",
    projector_px=1024,
    groups=(PhaseShiftGroup(pitch_px=32, steps=4), PhaseShiftGroup(pitch_px=33, steps=4)),
)


@dataclass(frozen=True, slots=True, eq=False)
class AxisReadback:
    """Where every axis said it was when the images were taken."""

    base_from_flange: RigidTransform
    guide_mm: float
    table_rad: float


@dataclass(frozen=True, slots=True, eq=False)
class FringeStack:
    """All images of one viewpoint, with what they show and where they were taken."""

    viewpoint_id: str
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # from long to short
    images: Mapping[str, ImageArray]  # camera -> (exposures, patterns, height, width), read-only uint8 or uint16
    saturation: int  # grey level from which a pixel counts as saturated
    readback: AxisReadback | None = None  # None for recorded images without a rig
