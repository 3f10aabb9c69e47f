"""Scan plans: immutable lists of viewpoints with patterns and exposures."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from pydantic import AfterValidator, Field, field_validator, model_validator

from measureapp.data.fringe import PatternSet
from measureapp.data.model import Model
from measureapp.data.part_pose import PartPose
from measureapp.data.pattern_sets import DEFAULT_PATTERNS, PATTERN_SETS
from measureapp.geometry.transform import RigidTransform

KEPT_GROUPS = 256  # whose viewpoints are kept
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


def _descending(exposures_us: tuple[int, ...]) -> tuple[int, ...]:
    if any(exposure <= 0 for exposure in exposures_us) or list(exposures_us) != sorted(set(exposures_us), reverse=True):
        raise ValueError("exposures must be positive and run from long to short without repeats")
    return exposures_us


Exposures = Annotated[tuple[int, ...], Field(min_length=1), AfterValidator(_descending)]
"""Exposures from long to short, in µs."""
Settle = Annotated[float, Field(ge=0, le=60)]
"""Wait after the last axis has settled, in s."""


class Viewpoint(Model):
    """Planned pose of the sensor and angle of the table."""

    id: str = Field(pattern=r"^[A-Za-z0-9_][A-Za-z0-9_.-]{0,99}$", description="also a part of file names")
    flange: FlangePose
    guide_mm: float
    table_deg: float
    exposures_us: Exposures | None = Field(default=None, description="exposure bracket of this viewpoint; none: that of the plan")
    settle_s: Settle | None = Field(default=None, description="wait before images are taken; none: that of the plan")


class StationPose(Model):
    """A pose of the robot with a place of the guide, as a group of viewpoints repeats it."""

    flange: FlangePose
    guide_mm: float = 0.0


class ViewpointGroup(Model):
    """Viewpoints by repetition: every pose at every table angle, all angles of one pose before the next.

    The viewpoints are called ``ID-POSE-ANGLE``, counted from 1, or ``ID-ANGLE`` where there is one pose.
    """

    id: str = Field(pattern=r"^[A-Za-z0-9_][A-Za-z0-9_.-]{0,79}$", description="beginning of the names of its viewpoints")
    poses: tuple[StationPose, ...] = Field(min_length=1)
    table_deg: tuple[float, ...] = Field(min_length=1)
    exposures_us: Exposures | None = None
    settle_s: Settle | None = None

    def viewpoints(self) -> tuple[Viewpoint, ...]:
        """Return the viewpoints, pose by pose."""
        return _viewpoints_of(self)


@lru_cache(maxsize=KEPT_GROUPS)
def _viewpoints_of(group: ViewpointGroup) -> tuple[Viewpoint, ...]:
    """Return the viewpoints of a group; kept, as every iteration over a plan asks for them and checking each takes long."""
    one = len(group.poses) == 1
    return tuple(
        Viewpoint(
            id=f"{group.id}-{angle:02d}" if one else f"{group.id}-{number:02d}-{angle:02d}",
            flange=pose.flange,
            guide_mm=pose.guide_mm,
            table_deg=table_deg,
            exposures_us=group.exposures_us,
            settle_s=group.settle_s,
        )
        for number, pose in enumerate(group.poses, 1)
        for angle, table_deg in enumerate(group.table_deg, 1)
    )


class ExposureBracket(Model):
    """Exposure bracket: the exposures of every pattern, from long to short."""

    exposures_us: Exposures = (100_000, 80_000, 60_000, 40_000, 20_000)


class ScanPlan(Model):
    """Viewpoints, pattern set and exposures of a scan; iterates into its viewpoints, single ones before groups, in scan order.

    Version 2 added groups, and exposures and settling times of single viewpoints, version 3 the pose of the part; plans of earlier versions are
    read as they are.
    """

    schema_version: Literal[3] = 3
    name: str
    viewpoints: tuple[Viewpoint, ...] = Field(default=(), description="single ones; iterate over the plan for all")
    groups: tuple[ViewpointGroup, ...] = ()
    patterns: PatternSet = DEFAULT_PATTERNS  # a file may name a predefined set, for a projector of 1024 × 768 px
    bracket: ExposureBracket = ExposureBracket()
    settle_s: Settle | None = Field(default=None, description="wait before images are taken; none: that of the rig")
    part_pose: PartPose | None = Field(default=None, description="how the part stands; none: in the middle, as its nominal is oriented")

    @field_validator("schema_version", mode="before")
    @classmethod
    def _migrate(cls, value: object) -> object:
        return 3 if value in (1, 2) else value  # what was added has defaults that mean what earlier versions did

    @field_validator("patterns", mode="before")
    @classmethod
    def _check_pattern_set(cls, value: object) -> object:
        if isinstance(value, str) and value not in PATTERN_SETS:
            raise ValueError(f"there is no pattern set {value!r}, only {', '.join(PATTERN_SETS)}")
        return PATTERN_SETS[value] if isinstance(value, str) else value

    @model_validator(mode="after")
    def _ids_differ(self) -> ScanPlan:
        ids = [viewpoint.id for viewpoint in self]
        if not ids:
            raise ValueError("the plan has no viewpoints")
        if len(set(ids)) != len(ids):
            twice = next(name for place, name in enumerate(ids) if name in ids[:place])
            raise ValueError(f"two viewpoints have the same id {twice!r}")
        return self

    def __iter__(self) -> Iterator[Viewpoint]:  # type: ignore[override]
        yield from self.viewpoints
        for group in self.groups:
            yield from group.viewpoints()

    def __len__(self) -> int:
        return len(self.viewpoints) + sum(len(group.poses) * len(group.table_deg) for group in self.groups)

    def __getitem__(self, place: int) -> Viewpoint:
        return tuple(self)[place]

    def extends(self, former: ScanPlan) -> bool:
        """Whether this plan takes the same images at all viewpoints of ``former``; it may have further ones."""
        own = {viewpoint.id: viewpoint for viewpoint in self}

        def same(viewpoint: Viewpoint) -> bool:
            here = own.get(viewpoint.id)
            return (
                here is not None
                and (here.flange, here.guide_mm, here.table_deg) == (viewpoint.flange, viewpoint.guide_mm, viewpoint.table_deg)
                and self.exposures_of(here) == former.exposures_of(viewpoint)
                and self.settle_of(here) == former.settle_of(viewpoint)
            )

        return self.patterns == former.patterns and all(same(viewpoint) for viewpoint in former)

    def exposures_of(self, viewpoint: Viewpoint) -> tuple[int, ...]:
        """Return the exposures of a viewpoint, from long to short, in µs."""
        return viewpoint.exposures_us or self.bracket.exposures_us

    def settle_of(self, viewpoint: Viewpoint) -> float | None:
        """Return how long to wait at a viewpoint before images are taken, in s; None: as long as the rig states."""
        return self.settle_s if viewpoint.settle_s is None else viewpoint.settle_s
