"""Planning of viewpoints around a part on the table, from the nominal rig."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.pattern_sets import DEFAULT_NAME, make_pattern_sets
from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.reach import limit_violations

RINGS_DEG = ((0.0, 32.0), (8.0, 62.0), (-8.0, 47.0))  # azimuth and elevation, in the order in which they are added
RING_SHARES = {1: (1.0,), 2: (0.6, 0.4), 3: (0.4, 0.25, 0.35)}  # walls need more viewpoints than tops
FIELD_RADIUS_MM = 140.0  # half the smaller side of the common field of view of the reference rig
ELEVATION_STEP_DEG = 2.0
MOST_VIEWPOINTS = 500
LEAST_TARGET_MM = 55.0  # above the table, so that the calibration board on its stand is visible as well


@dataclass(frozen=True, slots=True)
class LookAt:
    """Pose of the head relative to its target: azimuth, elevation, distance, and roll about the optical axis."""

    azimuth_deg: float  # 0: from the robot's side; counter-clockwise positive seen from above
    elevation_deg: float  # above the table's plane
    distance_mm: float
    roll_deg: float = 0.0


def guide_from_head(target_mm: FloatArray, look_at: LookAt) -> RigidTransform:
    """Return the pose of the head aimed at ``target_mm`` (3,) in the guide frame, its x axis level before the roll."""
    azimuth, elevation = np.deg2rad([look_at.azimuth_deg, look_at.elevation_deg])
    outward = np.array([-np.cos(elevation) * np.cos(azimuth), -np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    forward = -outward
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    level = np.column_stack([right, np.cross(forward, right), forward])
    rotation = level @ Rotation.from_euler("z", look_at.roll_deg, degrees=True).as_matrix()
    return RigidTransform.from_parts(rotation, np.asarray(target_mm) + look_at.distance_mm * outward, "guide", "head")


def viewpoint_looking_at(
    rig: RigDescription, name: str, target_mm: FloatArray, look_at: LookAt, *, guide_mm: float = 0.0, table_deg: float = 0.0
) -> Viewpoint:
    """Return the viewpoint whose head is aimed at ``target_mm`` (guide frame) with the guide at ``guide_mm``."""
    base_from_guide = RigidTransform.from_parts(np.eye(3), [0.0, -guide_mm, 0.0], "base", "guide")
    head_from_flange = rig.flange_from_head.transform("flange", "head").inverse()
    base_from_flange = base_from_guide @ guide_from_head(target_mm, look_at) @ head_from_flange
    return Viewpoint(id=name, flange=FlangePose.of(base_from_flange), guide_mm=guide_mm, table_deg=table_deg)


def plan_around_part(
    rig: RigDescription,
    name: str,
    *,
    radius_mm: float,
    height_mm: float,
    count: int,
    patterns: str = DEFAULT_NAME,
    arm: ArmModel | None = None,
) -> ScanPlan:
    """Plan ``count`` viewpoints in rings around a part in the centre of the table.

    A ring is one station of the robot: between its viewpoints only the table turns, and the robot approaches it once. Its pose error
    is then common to all views of the ring: their relative poses are as accurate as the table, and stitching can estimate the error
    from overlapping surfaces, which independent errors of every view would not allow (decision 11).

    Parameters
    ----------
    rig : nominal description
    name : of the plan
    radius_mm, height_mm : of the enclosing cylinder of the part about the table's axis
    count : number of viewpoints, 1 to `MOST_VIEWPOINTS`
    patterns : name of a predefined pattern set
    arm : of the rig's robot, whose joint limits are then kept; None: its reach only

    Raises
    ------
    PlanError
        ``count`` is out of range, there is no such pattern set, or a viewpoint cannot be reached at any elevation.
    """
    if not 1 <= count <= MOST_VIEWPOINTS:
        raise PlanError(f"{count} viewpoints were requested.", f"Request 1 to {MOST_VIEWPOINTS}.")
    sets = make_pattern_sets(rig.projector.width_px, rig.projector.height_px)
    if patterns not in sets:
        raise PlanError(f"There is no pattern set {patterns!r}.", f"Choose one of {', '.join(sets)}.")
    rings = 1 if count < 5 else 2 if count < 16 else 3
    heights = _target_heights(height_mm)
    places = [
        (ring, heights[index % len(heights)], _wrap(360.0 * (index + ring / rings) / share))
        for ring, share in enumerate(_shares(count, rings))
        for index in range(share)
    ]
    viewpoints = [
        _reachable(rig, arm, f"view{number:02d}", _target(rig, radius_mm, height, RINGS_DEG[ring][0]), *RINGS_DEG[ring], table_deg)
        for number, (ring, height, table_deg) in enumerate(sorted(places), start=1)
    ]
    return ScanPlan(name=name, viewpoints=tuple(viewpoints), patterns=sets[patterns])


def _shares(count: int, rings: int) -> list[int]:
    """Distribute ``count`` viewpoints over the rings by `RING_SHARES`; the rounding remainder goes to the first ring."""
    others = [round(count * share) for share in RING_SHARES[rings][1:]]
    return [count - sum(others), *others]


def _target_heights(height_mm: float) -> list[float]:
    bands = max(1, ceil(height_mm / (2 * FIELD_RADIUS_MM)))
    return [max(LEAST_TARGET_MM, height_mm * (band + 0.5) / bands) for band in range(bands)]


def _target(rig: RigDescription, radius_mm: float, height_mm: float, azimuth_deg: float) -> FloatArray:
    """Return the target in the guide frame; for a part wider than the field of view it is on the near wall."""
    centre = np.array(rig.table.centre_in_guide_mm)
    azimuth = np.deg2rad(azimuth_deg)
    towards_head = np.array([-np.cos(azimuth), -np.sin(azimuth), 0.0])
    return centre + max(0.0, radius_mm - FIELD_RADIUS_MM - 20.0) * towards_head + [0.0, 0.0, height_mm]


def _reachable(
    rig: RigDescription, arm: ArmModel | None, name: str, target_mm: FloatArray, azimuth_deg: float, elevation_deg: float, table_deg: float
) -> Viewpoint:
    """Return the reachable viewpoint nearest to the wanted elevation."""
    for offset in np.arange(0.0, 40.0, ELEVATION_STEP_DEG):
        for sign in (-1.0, 1.0):
            look_at = LookAt(azimuth_deg, elevation_deg + sign * offset, rig.standoff_mm)
            guide_mm = -look_at.distance_mm * np.sin(np.deg2rad(azimuth_deg)) * np.cos(np.deg2rad(look_at.elevation_deg))
            candidate = viewpoint_looking_at(rig, name, target_mm, look_at, guide_mm=round(float(guide_mm), 1), table_deg=table_deg)
            if not limit_violations(candidate, rig, arm):
                return candidate
    raise PlanError(
        f"{rig.name} cannot reach a viewpoint of this part at or near an elevation of {elevation_deg:.0f}°.", "Write a plan for this part."
    )


def _wrap(angle_deg: float) -> float:
    """Wrap an angle to −180…180°, which keeps the travel of the table short."""
    return round((angle_deg + 180.0) % 360.0 - 180.0, 3)
