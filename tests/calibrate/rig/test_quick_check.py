"""A calibration that no longer holds is found with a few views, and the right link is named."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.poses import apply_changes
from measureapp.calibrate.rig.quick_check import quick_check
from measureapp.data.calibration import HandEye, LinearGuide, RigCalibration, RotationAxis
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise

STATES = [
    (-25, 30, 0, -120.0, 0),
    (20, 55, 20, 110.0, 25),
    (0, 45, -30, 0.0, -35),
    (10, 65, 35, 60.0, 50),
    (-12, 50, 10, -60.0, -20),
    (5, 40, 0, 0, 10),
]


@pytest.fixture
def calibration(rig):
    return RigCalibration(rig.head, HandEye(rig.flange_from_camera), rig.guide, rig.axis)


@pytest.fixture
def views(rig, simulate, generator):
    """Six views with corner noise and a robot that is as good as its repeatability; every axis moves in them."""
    result = []
    for number, (azimuth, elevation, roll, guide_mm, table_deg) in enumerate(STATES):
        pose = rig.base_from_flange(azimuth, elevation, 550, roll, guide_mm)
        read = AxisReadback(pose, float(guide_mm), float(np.deg2rad(table_deg)))
        error = generator.normal(size=6) * [*[2e-5] * 3, *[0.02] * 3]
        corners = simulate.corners(rig.head, rig.board, rig.camera_from_board(read, error), 0.05, generator)
        result.append(Observation(f"check{number}", read, board_pose(corners, rig.head, rig.board, 0.05)))
    return result


def test_a_calibration_that_holds_is_good(rig, calibration, views):
    found = quick_check(views, calibration, rig.board)
    assert found.good
    assert found.suspect == ""
    assert max(view.deviation_mm for view in found.views) < 0.15
    assert "the calibration holds" in found.sentence
    assert not found.not_tested


def knocked(transform, change):
    return RigidTransform(orthonormalise(apply_changes(transform.matrix, np.array(change))), transform.to_frame, transform.from_frame)


def test_a_knocked_head_points_at_hand_eye(rig, calibration, views):
    off = replace(calibration, hand_eye=HandEye(knocked(rig.flange_from_camera, [0.004, 0, 0.003, 1.0, -1.0, 0.5])))
    found = quick_check(views, off, rig.board)
    assert not found.good
    assert found.suspect == "hand-eye or robot"
    assert "mm (view" in found.sentence


def test_a_moved_table_points_at_the_axis(rig, calibration, views):
    axis = RotationAxis(rig.axis.point_mm + np.array([2.0, 1.5, 0]), rig.axis.direction + np.array([0.002, 0, 0]), "guide")
    found = quick_check(views, replace(calibration, axis=axis), rig.board)
    assert not found.good
    assert found.suspect == "axis"


def test_a_guide_with_another_scale_points_at_the_guide(rig, calibration, views):
    guide = LinearGuide(rig.guide.direction + np.array([0.01, 0, 0.005]), rig.guide.scale * 1.01)
    found = quick_check(views, replace(calibration, guide=guide), rig.board)
    assert not found.good
    assert found.suspect == "guide"


def test_cameras_that_moved_are_named_first(rig, simulate, calibration, views, generator):
    head = rig.head
    right = replace(
        head.cameras["right"], reference_from_camera=knocked(head.cameras["right"].reference_from_camera, [0.002, 0.001, 0, 0, 0.3, 0])
    )
    off = replace(calibration, cameras=replace(head, cameras={**head.cameras, "right": right}))
    seen = []
    for one in views:
        corners = simulate.corners(head, rig.board, rig.camera_from_board(one.readback), 0.05, generator)
        seen.append(replace(one, board=board_pose(corners, off.cameras, rig.board, 0.05)))
    found = quick_check(seen, off, rig.board)
    assert not found.good
    assert found.suspect == "cameras"


def test_one_view_whose_board_moved_is_named(rig, calibration, views):
    views[4] = replace(
        views[4], board=replace(views[4].board, camera_from_board=knocked(views[4].board.camera_from_board, [0, 0, 0, 2.0, 0, 0]))
    )
    found = quick_check(views, calibration, rig.board)
    assert not found.good
    assert found.suspect == "one view"
    assert "view check4" in found.sentence


def test_links_whose_axis_stood_still_are_said_to_be_untested(rig, calibration, views):
    still = [replace(one, readback=replace(one.readback, guide_mm=0.0, table_rad=0.0)) for one in views]
    assert set(quick_check(still, calibration, rig.board).not_tested) == {"guide", "axis"}


def test_two_views_are_too_few(rig, calibration, views):
    with pytest.raises(CalibrationError, match="do not check"):
        quick_check(views[:2], calibration, rig.board)
