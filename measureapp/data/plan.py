"""Scan plans: immutable lists of viewpoints with patterns and exposures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import Field, field_validator

from measureapp.data.fringe import PatternSet
from measureapp.data.model import Model
from measureapp.data.pattern_sets import DEFAULT_PATTERNS, PATTERN_SETS
from measureapp.geometry.transform import RigidTransform

Motion = Literal["robot", "table", "guide", "passes", "stations"]
"""What moves between the views of a calibration; "passes" are further ones along the guide, "stations" the robot poses of a scan plan."""


class FlangePose(Model):
    """Target pose of the robot: base_from_flange as position and unit quaternion (w, x, y, z)."""

    position_mm: tuple[float, float, float]
    quaternion_wxyz: tuple[float, float, float, float]

    @field_validator("quaternion_wxyz")
    @classmethod
    def _is_unit(cls, value: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
        if abs(float(np.linalg.norm(value)) - 1.0) > 1e-4:
            raise ValueError("the quaternion (w, x, y, z) must have length 1")
        return value

    @classmethod
    def of(cls, base_from_flange: RigidTransform) -> FlangePose:
        """Build from a transform."""
        x, y, z = (float(value) for value in base_from_flange.translation_mm)
        qw, qx, qy, qz = (float(value) for value in base_from_flange.quaternion_wxyz)
        return cls(position_mm=(x, y, z), quaternion_wxyz=(qw, qx, qy, qz))

    def transform(self) -> RigidTransform:
        """Return base_from_flange."""
        return RigidTransform.from_quaternion(self.quaternion_wxyz, self.position_mm, "base", "flange")


class Viewpoint(Model):
    """Planned pose of the sensor and angle of the table."""

    id: str = Field(pattern=r"^[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}$", description="also a part of file names")
    flange: FlangePose
    guide_mm: float
    table_deg: float


class ExposureBracket(Model):
    """Exposure bracket: the exposures of every pattern, from long to short."""

    exposures_us: tuple[int, ...] = Field(default=(100_000, 80_000, 60_000, 40_000, 20_000), min_length=1)

    @field_validator("exposures_us")
    @classmethod
    def _descends(cls, value: tuple[int, ...]) -> tuple[int, ...]:
        if any(exposure <= 0 for exposure in value) or list(value) != sorted(set(value), reverse=True):
            raise ValueError("exposures must be positive and run from long to short without repeats")
        return value


class ScanPlan(Model):
    """Viewpoints, pattern set and exposures of a scan."""

    schema_version: Literal[1] = 1
    name: str
    viewpoints: tuple[Viewpoint, ...] = Field(min_length=1)
    patterns: PatternSet = DEFAULT_PATTERNS  # a file may name a predefined set, for a projector of 1024 × 768 px
    bracket: ExposureBracket = ExposureBracket()

    @field_validator("patterns", mode="before")
    @classmethod
    def _check_pattern_set(cls, value: object) -> object:
        if isinstance(value, str) and value not in PATTERN_SETS:
            raise ValueError(f"there is no pattern set {value!r}, only {', '.join(PATTERN_SETS)}")
        return PATTERN_SETS[value] if isinstance(value, str) else value

    @field_validator("viewpoints")
    @classmethod
    def _ids_differ(cls, value: tuple[Viewpoint, ...]) -> tuple[Viewpoint, ...]:
        if len({viewpoint.id for viewpoint in value}) != len(value):
            raise ValueError("two viewpoints have the same id")
        return value

    def __iter__(self) -> Iterator[Viewpoint]:  # type: ignore[override]
        return iter(self.viewpoints)

    def __len__(self) -> int:
        return len(self.viewpoints)
