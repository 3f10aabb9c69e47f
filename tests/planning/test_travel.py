"""Speeds of the axes: those that a rig states, and usual ones, named as such, for the others."""

from __future__ import annotations

import pytest

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.planning.travel import AxisSpeeds, assumed_speeds, speeds_note, travel_times_s
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")
ARM = arm_of(RIG)
FLANGE = FlangePose(position_mm=(450.0, 0.0, 550.0), quaternion_wxyz=(0.0, 0.7071067811865476, 0.0, 0.7071067811865476))


def with_speeds(rig: RigDescription) -> RigDescription:
    guide = rig.guide.model_copy(update={"speed_mm_s": 50.0, "acceleration_mm_s2": 100.0})
    table = rig.table.model_copy(update={"speed_deg_s": 10.0, "acceleration_deg_s2": 20.0})
    return rig.model_copy(update={"guide": guide, "table": table})


def test_times_follow_the_speeds_that_a_rig_states() -> None:
    pair = [Viewpoint(id="a", flange=FLANGE, guide_mm=0.0, table_deg=0.0), Viewpoint(id="b", flange=FLANGE, guide_mm=100.0, table_deg=90.0)]
    slow, usual = travel_times_s(pair, with_speeds(RIG), None)[0, 1], travel_times_s(pair, RIG, None)[0, 1]
    settle_s = AxisSpeeds().settle_s
    assert slow == pytest.approx(100.0 / 50.0 + 0.5 + 90.0 / 10.0 + 0.5 + 2 * settle_s)
    assert slow > 2 * usual


def test_axes_without_stated_speeds_are_named() -> None:
    assert assumed_speeds(RIG, ARM) == ("guide", "table")
    assert "guide and table" in speeds_note(RIG, ARM)
    assert speeds_note(with_speeds(RIG), ARM) == ""
    assert assumed_speeds(with_speeds(RIG).without_speeds(), ARM) == ("robot", "guide", "table")


def test_rigs_of_the_first_version_are_read_with_usual_speeds() -> None:
    document = RIG.without_speeds().model_dump(mode="json", exclude_none=True) | {"schema_version": 1}
    old = RigDescription.model_validate(document)
    assert old.schema_version == 2 and AxisSpeeds.of(old) == AxisSpeeds()
    assert old == RIG.without_speeds()


def test_a_speed_of_the_flange_limits_an_arm_whose_joints_would_be_faster() -> None:
    turned = FLANGE.model_copy(update={"position_mm": (450.0, 100.0, 550.0)})
    pair = [Viewpoint(id="a", flange=FLANGE, guide_mm=0.0, table_deg=0.0), Viewpoint(id="b", flange=turned, guide_mm=0.0, table_deg=0.0)]
    limited = RIG.model_copy(update={"robot": RIG.robot.model_copy(update={"speed_mm_s": 10.0})})
    assert travel_times_s(pair, limited, ARM)[0, 1] > 10.0 > travel_times_s(pair, RIG, ARM)[0, 1]
