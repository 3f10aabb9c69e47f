"""Keep-out boxes hold at viewpoints and on the straight ways between them."""

from __future__ import annotations

import pytest

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import KeepOutBox, MotionRules, RigDescription
from measureapp.errors import PlanError
from measureapp.planning.keep_out import check_keep_out
from measureapp.project.rig_file import read_rig


def at(name: str, x_mm: float, guide_mm: float = 0.0) -> Viewpoint:
    return Viewpoint(
        id=name, flange=FlangePose(position_mm=(x_mm, 0.0, 500.0), quaternion_wxyz=(1, 0, 0, 0)), guide_mm=guide_mm, table_deg=0.0
    )


@pytest.fixture
def rig() -> RigDescription:
    box = KeepOutBox(name="cabinet", low_mm=(500.0, -300.0, 300.0), high_mm=(600.0, 300.0, 700.0))
    return read_rig("paper").model_copy(update={"motion": MotionRules(keep_out=(box,))})


def test_a_viewpoint_inside_a_box_is_named(rig: RigDescription) -> None:
    with pytest.raises(PlanError, match="inside in cabinet"):
        check_keep_out([at("inside", 550.0)], rig)


def test_a_camera_in_the_box_counts_although_the_flange_is_outside(rig: RigDescription) -> None:
    with pytest.raises(PlanError, match="near in cabinet"):
        check_keep_out([at("near", 400.0)], rig)  # the right camera is 175 mm further


def test_the_guide_carries_the_head_past_the_box(rig: RigDescription) -> None:
    check_keep_out([at("beside", 550.0, guide_mm=600.0)], rig)


def test_a_way_through_a_box_is_named_although_both_ends_are_free(rig: RigDescription) -> None:
    with pytest.raises(PlanError, match="the way from this to that through cabinet"):
        check_keep_out([at("this", 250.0), at("that", 850.0)], rig)


def test_a_plan_that_stays_outside_passes(rig: RigDescription) -> None:
    check_keep_out([at("a", 250.0), at("b", 300.0)], rig)
    check_keep_out([at("inside", 550.0)], read_rig("paper"))


def test_a_box_without_volume_is_refused() -> None:
    with pytest.raises(ValueError, match="low_mm must be below high_mm"):
        KeepOutBox(name="flat", low_mm=(0, 0, 0), high_mm=(1, 0, 1))
