"""Robot poses from targets and directions, and back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from measureapp.errors import PlanError
from measureapp.planning.aim import Aim, aim_of, flange_aimed, head_pose, viewpoint_facing
from measureapp.planning.frusta import frusta, guide_from_part
from measureapp.planning.reach import limit_violations
from measureapp.planning.viewpoints import LookAt
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")
ANGLE = st.floats(-170, 170)
POINT = st.tuples(*[st.floats(-200, 200)] * 3)


@given(target=POINT, azimuth=ANGLE, elevation=st.floats(-80, 88), distance=st.floats(200, 900), roll=ANGLE, guide=st.floats(-600, 600))
def test_an_aim_is_found_again_in_the_pose_that_it_gives(target, azimuth, elevation, distance, roll, guide):
    aim = Aim(target, LookAt(azimuth, elevation, distance, roll))
    again = aim_of(flange_aimed(aim, guide, RIG), guide, RIG, target)
    assert again.target_mm == pytest.approx(target, abs=1e-5)
    assert again.look_at.distance_mm == pytest.approx(distance, abs=1e-5)
    found, wanted = (np.deg2rad([one.azimuth_deg, one.elevation_deg, one.roll_deg]) for one in (again.look_at, aim.look_at))
    assert np.exp(1j * found) == pytest.approx(np.exp(1j * wanted), abs=1e-5)


def test_a_pose_without_a_known_target_looks_at_the_point_at_the_stand_off():
    aim = Aim((10.0, -20.0, 50.0), LookAt(12.0, 40.0, RIG.standoff_mm))
    flange = flange_aimed(aim, 30.0, RIG)
    assert aim_of(flange, 30.0, RIG).target_mm == pytest.approx(aim.target_mm, abs=1e-6)
    elsewhere = aim_of(flange, 30.0, RIG, (300.0, 0.0, 0.0))  # not on the optical axis
    assert elsewhere.target_mm == pytest.approx(aim.target_mm, abs=1e-6)


def test_a_pose_that_looks_straight_down_has_an_aim():
    aim = aim_of(flange_aimed(Aim((0.0, 0.0, 0.0), LookAt(0.0, 89.9, 500.0)), 0.0, RIG), 0.0, RIG)
    assert np.isfinite([*aim.target_mm, aim.look_at.azimuth_deg, aim.look_at.roll_deg]).all()


@pytest.mark.parametrize(("look_at", "told"), [(LookAt(0, 95, 550), "elevation of 95"), (LookAt(0, 30, 0), "stand-off of 0")])
def test_an_impossible_aim_is_refused_in_words(look_at, told):
    with pytest.raises(PlanError, match=told):
        flange_aimed(Aim((0.0, 0.0, 0.0), look_at), 0.0, RIG)


@pytest.mark.parametrize("normal", [(1.0, 0.2, 0.3), (-1.0, 0.0, 0.5), (0.0, 1.0, 1.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0)])
def test_a_click_gives_a_reachable_viewpoint_that_looks_at_the_place_nearly_along_its_normal(normal):
    point, arm = np.array([60.0, -40.0, 50.0]), arm_of(RIG)
    found = viewpoint_facing(RIG, arm, "clicked", point, np.array(normal))
    assert not limit_violations(found, RIG, arm)
    part_from_head = guide_from_part(found, RIG).inverse() @ head_pose(found.flange, found.guide_mm, RIG)
    ahead = part_from_head.inverse().apply(point[None])[0]
    assert ahead == pytest.approx([0.0, 0.0, RIG.standoff_mm], abs=1e-6)
    towards = -part_from_head.rotation[:, 2]
    assert towards @ normal / np.linalg.norm(normal) > np.cos(np.deg2rad(75.0))


def test_the_underside_of_a_part_has_no_viewpoint_and_that_is_said():
    with pytest.raises(PlanError, match=r"no viewpoint that sees this place.*turn the part over"):
        viewpoint_facing(RIG, arm_of(RIG), "under", np.zeros(3), np.array([0.0, 0.0, -1.0]))


def test_frusta_enclose_the_target_of_their_viewpoint():
    point = np.array([0.0, 0.0, 40.0])
    viewpoint = viewpoint_facing(RIG, None, "a", point, np.array([-1.0, 0.0, 1.0]))
    target = guide_from_part(viewpoint, RIG).apply(point[None])[0]
    fields = frusta(viewpoint, RIG)
    assert [field.is_projector for field in fields] == [False, False, False, True]
    for field in fields:
        sides = np.cross(field.corners_mm - field.apex_mm, np.roll(field.corners_mm, -1, axis=0) - field.apex_mm)
        assert len(set(np.sign(sides @ (target - field.apex_mm)))) == 1
