"""Where to look at the calibration board from, so that one automatic run determines the whole rig."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.planning.reach import obstacles
from measureapp.planning.viewpoints import Gaze, viewpoint_looking_at

BOARD_ABOVE_TABLE_MM = 90.0  # centre of a board on its stand, tilted 45° towards the robot
BOARD_ELEVATION_DEG = 45.0
POSES = 26
STATION_ANGLES_DEG = (-50.0, -25.0, 0.0, 25.0, 50.0)
CHECK_ANGLES_DEG = (-12.0, 0.0, 12.0, 0.0)


def calibration_viewpoints(rig: RigDescription, plan: ScanPlan | None = None) -> tuple[Viewpoint, ...]:
    """Return the viewpoints of an automatic rig calibration: `pose…` for cameras and hand-eye, `axis…`, `guide…`, `station…`.

    The tilts and rolls of the poses follow Tsai and Lenz (IEEE Trans. Robotics and Automation 5(3), 1989): large
    rotations about axes that are not parallel. From the stations of ``plan`` the board is seen at several table angles:
    a part seems swollen by twice the robot's error towards the table unless that error is known where the scan is made.
    Places the rig cannot reach are left out.
    """
    centre = np.array(rig.table.centre_in_guide_mm) + np.array([0.0, 0.0, BOARD_ABOVE_TABLE_MM])
    candidates = (*_poses(rig, centre), *_axis(rig, centre), *_guide(rig, centre), *_stations(plan))
    return tuple(viewpoint for viewpoint in candidates if not obstacles(viewpoint, rig))


def check_viewpoints(rig: RigDescription) -> tuple[Viewpoint, ...]:
    """Return a few poses of the calibration, the table turned a little, which differ in every axis: each link of the chain is tested."""
    poses = [viewpoint for viewpoint in calibration_viewpoints(rig) if viewpoint.id.startswith("pose")]
    spread = [poses[round(step * (len(poses) - 1) / (len(CHECK_ANGLES_DEG) - 1))] for step in range(len(CHECK_ANGLES_DEG))]
    return tuple(viewpoint.model_copy(update={"table_deg": angle}) for viewpoint, angle in zip(spread, CHECK_ANGLES_DEG, strict=True))


def _poses(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """Tilts to all sides, three rolls, three distances, and targets beside the board that carry it to the image's borders."""
    views = []
    azimuths = (-30.0, -12.0, 12.0, 30.0, 0.0)
    elevations = (BOARD_ELEVATION_DEG - 18.0, BOARD_ELEVATION_DEG + 2.0, BOARD_ELEVATION_DEG + 22.0)
    rolls = (-35.0, 0.0, 35.0, 15.0)
    distances = (rig.standoff_mm + 15.0, rig.standoff_mm + 50.0, rig.standoff_mm + 90.0)
    sides = np.array([[0, 0, 0], [0, 26, 0], [0, -26, 0], [10, 0, 20], [-10, 0, -20]], float)
    for number in range(POSES):
        gaze = Gaze(
            azimuths[number % 5],
            elevations[(number // 5) % 3] + (6.0 if number % 2 else 0.0),
            distances[(number * 2) % 3],
            rolls[(number * 3 + number // 5) % 4],
        )
        target = centre + sides[(number * 2 + number // 5) % 5]
        guide_mm = round(float(-0.7 * gaze.distance_mm * np.sin(np.deg2rad(gaze.azimuth_deg))), 1)
        views.append(viewpoint_looking_at(rig, f"pose{number + 1:02d}", target, gaze, guide_mm=guide_mm))
    return views


def _axis(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """One pose of the robot, the table turned as far as the board stays in sight to both sides."""
    gaze = Gaze(0.0, BOARD_ELEVATION_DEG + 10.0, rig.standoff_mm + 60.0)
    angles = np.arange(-60.0, 60.1, 20.0)
    return [
        viewpoint_looking_at(rig, f"axis{index + 1:02d}", centre, gaze, table_deg=round(float(angle), 3))
        for index, angle in enumerate(angles)
    ]


def _guide(rig: RigDescription, centre: FloatArray) -> list[Viewpoint]:
    """One pose of the robot, slid along the guide as far as the board stays in sight."""
    gaze = Gaze(0.0, BOARD_ELEVATION_DEG + 5.0, rig.standoff_mm + 80.0)
    still = viewpoint_looking_at(rig, "still", centre, gaze)
    slides = np.arange(-60.0, 60.1, 20.0)
    return [
        Viewpoint(id=f"guide{index + 1:02d}", flange=still.flange, guide_mm=float(slide), table_deg=0.0)
        for index, slide in enumerate(slides)
    ]


def _stations(plan: ScanPlan | None) -> list[Viewpoint]:
    """The board from every place at which the plan lets the robot stand, the table turned to both sides."""
    places = {} if plan is None else {(viewpoint.flange, viewpoint.guide_mm): None for viewpoint in plan}
    return [
        Viewpoint(id=f"station{number + 1:02d}-{turn + 1}", flange=flange, guide_mm=guide_mm, table_deg=angle)
        for turn, angle in enumerate(STATION_ANGLES_DEG)  # outer loop: the robot comes to every station several times
        for number, (flange, guide_mm) in enumerate(places)
    ]
