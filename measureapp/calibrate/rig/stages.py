"""Putting the rig together stage by stage: Tsai-Lenz, the guide's line, the weighted axis."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.motions.axis_circles import LEAST_POSITIONS, axis_through_centres
from measureapp.calibrate.motions.axis_motion import estimate_turning
from measureapp.calibrate.motions.chain import groups_of, poses_of
from measureapp.calibrate.motions.hand_eye_methods import tsai_lenz
from measureapp.calibrate.motions.pose_checks import (
    check_board_size,
    check_direction,
    check_guide_unit,
    check_robot_unit,
    check_table_angles,
    check_units,
)
from measureapp.calibrate.motions.relative import motions_between
from measureapp.calibrate.poses import mean_pose
from measureapp.data.calibration import HandEye, LinearGuide, RotationAxis
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise

BOARD_POINTS = np.array(
    [[0, 0, 0], [150, 0, 0], [0, 100, 0], [150, 100, 0], [75, 50, 0]], float
)  # in place of the board where only poses matter
SAME_ANGLE_RAD = 1e-3
PAPER_GUIDE = LinearGuide(np.array([0.0, 1.0, 0.0]), 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class RigStages:
    """The rig as the stages one after the other give it."""

    hand_eye: HandEye
    guide: LinearGuide
    axis: RotationAxis  # in the guide frame
    guide_from_board: RigidTransform  # with the table at 0


def transform_axis(axis_in_camera: RotationAxis, guide_from_camera: RigidTransform) -> RotationAxis:
    """Transform an axis from the camera frame to the guide frame, with its standard deviations."""
    return RotationAxis(
        guide_from_camera.apply(axis_in_camera.point_mm),
        guide_from_camera.rotate(axis_in_camera.direction),
        guide_from_camera.to_frame,
        axis_in_camera.point_sigma_mm,
        axis_in_camera.direction_sigma_rad,
        axis_in_camera.residual_mm,
    )


def solve_stages(observations: Sequence[Observation], guide_moved: bool) -> RigStages:
    """Solve hand-eye, guide and axis one after the other from sightings of one board fixed on the table.

    Raises
    ------
    CalibrationError
        Too few robot poses at one table angle, parallel motions, a table that hardly turned, or tables in another unit or order.
    """
    angles = np.array([observation.axes.table_rad for observation in observations])
    group = groups_of(angles[:, None], SAME_ANGLE_RAD)
    still = np.flatnonzero(group == np.argmax(np.bincount(group)))
    robot = np.array([observation.axes.base_from_flange.matrix for observation in observations])
    slide = np.array([observation.axes.guide_mm for observation in observations])
    camera = poses_of([observation.pose for observation in observations])
    check_robot_unit(robot)
    check_guide_unit(robot[still], slide[still], camera[still], PAPER_GUIDE.direction)
    carried = _flanges_in_guide(robot, slide, PAPER_GUIDE)[still]
    motions, _ = motions_between(carried, camera[still])
    check_units(camera[still], motions)
    shift_mm = slide[still, None] * PAPER_GUIDE.direction
    check_direction(robot[still], camera[still], shift_mm)
    check_board_size(robot[still], camera[still], motions, shift_mm)
    x = tsai_lenz(motions)
    guide = _guide_line((robot @ x @ camera)[still], slide[still]) if guide_moved else PAPER_GUIDE
    carried = _flanges_in_guide(robot, slide, guide)
    x = tsai_lenz(motions_between(carried[still], camera[still])[0])
    boards = carried @ x @ camera
    places = np.array([mean_pose(boards[group == number]) for number in range(group.max() + 1)])
    mean_angles = np.array([angles[group == number].mean() for number in range(group.max() + 1)])
    axis = _axis(places, mean_angles)
    back = np.array([axis.turned(-angle).matrix for angle in angles]) @ boards
    return RigStages(
        HandEye(RigidTransform(orthonormalise(x), "flange", "camera"), method="Tsai-Lenz"),
        guide,
        axis,
        RigidTransform(orthonormalise(mean_pose(back)), "guide", "board"),
    )


def _flanges_in_guide(robot: FloatArray, slide: FloatArray, guide: LinearGuide) -> FloatArray:
    """Return guide_from_flange (N, 4, 4)."""
    return np.array([guide.guide_from_base(position).matrix for position in slide]) @ robot


def _guide_line(boards: FloatArray, slide: FloatArray) -> LinearGuide:
    """Fit the travel of the robot past the board; robot poses may differ between positions."""
    if np.ptp(slide) < 1.0:
        return PAPER_GUIDE
    away = slide - slide.mean()
    places = boards[:, :3, 3] - boards[:, :3, 3].mean(axis=0)
    travel = -(away @ places) / float(away @ away)
    scale = float(np.linalg.norm(travel))
    aside = places + away[:, None] * travel
    return LinearGuide(travel / scale, scale, straightness_mm=float(np.sqrt(np.mean(np.sum(aside**2, axis=1)))))


def _axis(places: FloatArray, angles: FloatArray) -> RotationAxis:
    order = np.argsort(angles)
    corners = BOARD_POINTS @ np.swapaxes(places[order][:, :3, :3], 1, 2) + places[order][:, None, :3, 3]
    turning = estimate_turning(corners)
    check_table_angles(angles[order], turning.angles_rad)
    point, direction = turning.point_mm, turning.direction
    if len(places) >= LEAST_POSITIONS:
        try:
            point, direction = axis_through_centres(corners, 2.0)
        except CalibrationError:  # board perpendicular to the axis: the motion as a whole still shows it
            point, direction = turning.point_mm, turning.direction
    return RotationAxis(point, direction * np.sign(direction @ turning.direction), "guide")
