"""Candidate robot poses: the head at elevations, distances and rolls around the part, within reach of the robot."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import ceil

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.coverage.extent import Extent
from measureapp.planning.coverage.head import Head
from measureapp.planning.reach import limit_violations
from measureapp.planning.viewpoints import LookAt, viewpoint_looking_at

ELEVATIONS_DEG = (25.0, 50.0, 70.0, 5.0, 38.0, 62.0, 15.0, 78.0)
ROLLS_DEG = (0.0, 90.0, 180.0)
AZIMUTHS_DEG = (0.0, 30.0, -30.0, 60.0, -60.0)  # of the robot around the table, where it does not reach from the front
SIDES_MM = (0.0, 150.0, -150.0)  # of the flange beside the robot's base, which the guide compensates
FIELD_SHARE = 0.8  # of the field of view that neighbouring targets are apart
TANGENT_SHARE = 0.6  # of the part's radius: targets beside the axis, to view walls along the tangent
LEAST_TANGENT_MM = 15.0


@dataclass(frozen=True, slots=True)
class Aim:
    """Where the head is relative to the table's axis, whatever the azimuth: the table can turn any into any other."""

    elevation_deg: float
    distance_mm: float
    roll_deg: float
    forward_mm: float  # of the target from the axis, away from the robot
    height_mm: float  # of the target above the table


@dataclass(frozen=True, slots=True)
class Station:
    """A robot pose, with the place of the guide at which it aims at the table's axis; the guide can slide it sideways from there."""

    flange: FlangePose
    guide_mm: float
    azimuth_deg: float  # of the robot around the table
    aim: Aim


def aims(extent: Extent, head: Head) -> Iterator[Aim]:
    """Yield aims that together cover the enclosing cylinder, the most useful first."""
    step = 2.0 * FIELD_SHARE * head.field_radius_mm
    bands = max(1, ceil((extent.high_mm - extent.low_mm) / step))
    heights = [extent.low_mm + (extent.high_mm - extent.low_mm) * (band + 0.5) / bands for band in range(bands)]
    outside = max(0.0, extent.radius_mm - FIELD_SHARE * head.field_radius_mm)
    forwards = (0.0,) if outside == 0.0 else (-outside, 0.0, outside)
    near, far = head.depth_mm
    closer, farther = head.standoff_mm - (head.standoff_mm - near) / 2.0, head.standoff_mm + (far - head.standoff_mm) / 2.0
    for distance, roll, elevation in product((head.standoff_mm, closer, farther), ROLLS_DEG, ELEVATIONS_DEG):
        for forward, height in product(forwards, heights):
            yield Aim(elevation, distance, roll, forward, height)


def slides_mm(extent: Extent, head: Head) -> tuple[float, ...]:
    """Return the offsets of the guide that view the part beside its axis."""
    offset = max(TANGENT_SHARE * extent.radius_mm, extent.radius_mm - FIELD_SHARE * head.field_radius_mm)
    return (0.0, offset, -offset) if offset > LEAST_TANGENT_MM else (0.0,)


def reachable_station(aim: Aim, rig: RigDescription, arm: ArmModel | None) -> Station | None:
    """Return the first pose of the robot from which the head aims so; None if none is within its limits."""
    for azimuth, side in product(AZIMUTHS_DEG, SIDES_MM):
        station = place_station(aim, rig, azimuth, side)
        if not limit_violations(_viewpoint(station), rig, arm):
            return station
    return None


def place_station(aim: Aim, rig: RigDescription, azimuth_deg: float, side_mm: float) -> Station:
    """Return the station at an azimuth around the table, with the flange ``side_mm`` beside the robot's base; reach is not checked."""
    azimuth = np.deg2rad(azimuth_deg)
    away = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    target: FloatArray = np.array(rig.table.centre_in_guide_mm) + aim.forward_mm * away + [0.0, 0.0, aim.height_mm]
    look_at = LookAt(azimuth_deg, aim.elevation_deg, aim.distance_mm, aim.roll_deg)
    still = viewpoint_looking_at(rig, "station", target, look_at)
    guide_mm = round(still.flange.position_mm[1] - side_mm, 1)
    placed = viewpoint_looking_at(rig, "station", target, look_at, guide_mm=guide_mm)
    return Station(rounded(placed.flange), guide_mm, azimuth_deg, aim)


def rounded(pose: FlangePose) -> FlangePose:
    """Return a pose with µm and 1e-7 in the quaternion, as plans are read by people; no robot resolves more."""
    x, y, z = (round(value, 3) + 0.0 for value in pose.position_mm)
    qw, qx, qy, qz = (round(value, 7) + 0.0 for value in pose.quaternion_wxyz)
    return FlangePose(position_mm=(x, y, z), quaternion_wxyz=(qw, qx, qy, qz))


def _viewpoint(station: Station) -> Viewpoint:
    return Viewpoint(id="station", flange=station.flange, guide_mm=station.guide_mm, table_deg=0.0)
