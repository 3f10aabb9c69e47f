"""Robot poses as a person states them: a target, and from which side, elevation and distance the head looks at it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.reach import limit_violations
from measureapp.planning.viewpoints import ELEVATION_STEP_DEG, LookAt, guide_from_head, viewpoint_looking_at

STEEPEST_DEG = 89.9  # straight down, azimuth and roll are one rotation
FLATTEST_DEG = 5.0  # a head that looks along the table's surface sees nothing of it
OBLIQUE_DEG = 75.0  # largest angle between the viewing direction and a surface that is to be seen
ON_AXIS_MM = 1e-3
TURN_ASIDE_DEG = (0.0, 12.0, -12.0, 24.0, -24.0)  # azimuths tried, nearest first
Point = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Aim:
    """Where the head looks, relative to the table's top centre with the axes of the guide, and from where."""

    target_mm: Point  # x away from the robot, y along the guide, z up
    look_at: LookAt


def head_pose(flange: FlangePose, guide_mm: float, rig: RigDescription) -> RigidTransform:
    """Return ``guide_from_head`` of a robot pose with the guide at ``guide_mm``."""
    guide_from_base = RigidTransform.from_parts(np.eye(3), [0.0, guide_mm, 0.0], "guide", "base")
    return guide_from_base @ flange.transform() @ rig.flange_from_head.transform("flange", "head")


def aim_of(flange: FlangePose, guide_mm: float, rig: RigDescription, known_target_mm: Point | None = None) -> Aim:
    """Return the aim of a robot pose.

    Parameters
    ----------
    known_target_mm : kept as the target if it lies on the optical axis in front of the head; otherwise the target is the point at the
        rig's stand-off on that axis
    """
    pose = head_pose(flange, guide_mm, rig)
    forward, head = pose.rotation[:, 2], pose.translation_mm
    distance_mm = rig.standoff_mm
    if known_target_mm is not None:
        to_target = np.add(known_target_mm, rig.table.centre_in_guide_mm) - head
        along = float(to_target @ forward)
        if along > 0 and np.linalg.norm(to_target - along * forward) < ON_AXIS_MM:
            distance_mm = along
    x, y, z = (float(value) for value in head + distance_mm * forward - np.array(rig.table.centre_in_guide_mm))
    elevation_deg = float(np.clip(np.rad2deg(np.arcsin(np.clip(-forward[2], -1.0, 1.0))), -STEEPEST_DEG, STEEPEST_DEG))
    azimuth_deg = float(np.rad2deg(np.arctan2(forward[1], forward[0]))) if abs(elevation_deg) < STEEPEST_DEG else 0.0
    level = guide_from_head(np.zeros(3), LookAt(azimuth_deg, elevation_deg, distance_mm)).rotation
    turned = level.T @ pose.rotation
    roll_deg = float(np.rad2deg(np.arctan2(turned[1, 0], turned[0, 0])))
    return Aim((x, y, z), LookAt(azimuth_deg, elevation_deg, distance_mm, roll_deg))


def flange_aimed(aim: Aim, guide_mm: float, rig: RigDescription) -> FlangePose:
    """Return the robot pose with this aim. Raises PlanError for an aim that no head can have."""
    look_at = aim.look_at
    if not -STEEPEST_DEG <= look_at.elevation_deg <= STEEPEST_DEG:
        raise PlanError(f"An elevation of {look_at.elevation_deg:g}° is impossible.", f"Choose {-STEEPEST_DEG:g}…{STEEPEST_DEG:g}°.")
    if look_at.distance_mm <= 0:
        raise PlanError(f"A stand-off of {look_at.distance_mm:g} mm is impossible.", "Choose a distance above 0.")
    target = np.add(aim.target_mm, rig.table.centre_in_guide_mm)
    return viewpoint_looking_at(rig, "aimed", target, look_at, guide_mm=guide_mm).flange


def viewpoint_facing(
    rig: RigDescription, arm: ArmModel | None, name: str, point_mm: FloatArray, normal: FloatArray, distance_mm: float | None = None
) -> Viewpoint:
    """Return a reachable viewpoint that looks at a point of the part along its surface normal, as nearly as the rig allows.

    The table turns the point towards the robot. What is out of reach is approached by a lower or higher elevation and from the side.

    Parameters
    ----------
    point_mm, normal : (3,), on the part as it stands on the table at 0°: origin in the centre of the table's top, axes of the guide
    distance_mm : stand-off; None: that of the rig

    Raises
    ------
    PlanError
        No viewpoint from which the surface is seen at a useful angle can be reached.
    """
    outward = np.asarray(normal, float) / np.linalg.norm(normal)
    steep = float(np.rad2deg(np.arcsin(np.clip(outward[2], -1.0, 1.0))))
    heading = float(np.rad2deg(np.arctan2(outward[1], outward[0]))) if np.hypot(outward[0], outward[1]) > 1e-6 else 180.0
    wanted = float(np.clip(steep, FLATTEST_DEG, STEEPEST_DEG))
    offsets = (sign * step for step in np.arange(0.0, 80.0, ELEVATION_STEP_DEG) for sign in ((1.0,) if step == 0 else (-1.0, 1.0)))
    for elevation_deg in (wanted + offset for offset in offsets):
        if not FLATTEST_DEG <= elevation_deg <= STEEPEST_DEG:
            continue
        for azimuth_deg in TURN_ASIDE_DEG:
            turned = _Turned(point_mm, outward, _turn_to(180.0 + azimuth_deg - heading, rig))
            look_at = LookAt(azimuth_deg, elevation_deg, rig.standoff_mm if distance_mm is None else distance_mm)
            if turned.incidence_deg(look_at) <= OBLIQUE_DEG:
                found = turned.viewpoint(rig, name, look_at)
                if not limit_violations(found, rig, arm):
                    return found
    raise PlanError(
        f"{rig.name} reaches no viewpoint that sees this place of the part at less than {OBLIQUE_DEG:g}° to its surface normal.",
        "Choose another place, or turn the part over for a second set-up.",
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Turned:
    """A point of the part and its outward normal; the table turns both."""

    point_mm: FloatArray
    outward: FloatArray
    table_deg: float

    def incidence_deg(self, look_at: LookAt) -> float:
        """Return the angle between the surface normal and the direction to the head."""
        towards = -guide_from_head(np.zeros(3), look_at).rotation[:, 2]
        return float(np.rad2deg(np.arccos(np.clip((self._turn() @ self.outward) @ towards, -1.0, 1.0))))

    def viewpoint(self, rig: RigDescription, name: str, look_at: LookAt) -> Viewpoint:
        """Return the viewpoint, with the guide where the robot looks straight ahead at the point."""
        target = self._turn() @ np.asarray(self.point_mm, float) + np.array(rig.table.centre_in_guide_mm)
        aside = look_at.distance_mm * np.sin(np.deg2rad(look_at.azimuth_deg)) * np.cos(np.deg2rad(look_at.elevation_deg))
        low, high = rig.guide.limits_mm
        guide_mm = round(float(np.clip(target[1] - aside, low, high)), 1)
        return viewpoint_looking_at(rig, name, target, look_at, guide_mm=guide_mm, table_deg=self.table_deg)

    def _turn(self) -> FloatArray:
        return rotation_about([0, 0, 1], np.deg2rad(self.table_deg))


def _turn_to(angle_deg: float, rig: RigDescription) -> float:
    """Return the table angle nearest to 0 that is this one but for whole turns, within the table's limits where possible."""
    wrapped = round((angle_deg + 180.0) % 360.0 - 180.0, 3)
    low, high = rig.table.limits_deg
    return next((turned for turned in (wrapped, wrapped - 360.0, wrapped + 360.0) if low <= turned <= high), wrapped)
