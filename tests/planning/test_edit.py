"""Edits of scan plans."""

from __future__ import annotations

import pytest

from measureapp.data.plan import FlangePose, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.errors import PlanError
from measureapp.planning import edit
from measureapp.planning.plan_index import PlanIndex

POSE = FlangePose(position_mm=(500.0, 0.0, 600.0), quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))
OTHER = FlangePose(position_mm=(400.0, 0.0, 600.0), quaternion_wxyz=(0.0, 1.0, 0.0, 0.0))


def single(name: str, table_deg: float = 0.0) -> Viewpoint:
    return Viewpoint(id=name, flange=POSE, guide_mm=0.0, table_deg=table_deg)


PLAN = ScanPlan(
    name="p",
    viewpoints=(single("a"), single("b"), single("c")),
    groups=(
        ViewpointGroup(id="ring", poses=(StationPose(flange=POSE),), table_deg=(0.0, 120.0, 240.0)),
        ViewpointGroup(id="walls", poses=(StationPose(flange=POSE), StationPose(flange=OTHER)), table_deg=(0.0, 90.0)),
    ),
)


def names(plan: ScanPlan) -> list[str]:
    return [viewpoint.id for viewpoint in plan]


def test_a_viewpoint_is_added_behind_another_or_as_the_last_single_one():
    assert names(edit.add(PLAN, single("new"), "a"))[:4] == ["a", "new", "b", "c"]
    assert names(edit.add(PLAN, single("new")))[:4] == ["a", "b", "c", "new"]
    assert names(edit.add(PLAN, single("new"), "ring-02"))[:4] == ["a", "b", "c", "new"]
    assert names(edit.add(None, single("new"), name="fresh")) == ["new"]
    with pytest.raises(PlanError, match="same id 'a'"):
        edit.add(PLAN, single("a"))


def test_single_viewpoints_groups_and_angles_of_a_group_are_removed():
    left = edit.remove(PLAN, ["b", "ring-02", "walls"])
    assert names(left) == ["a", "c", "ring-01", "ring-02"]
    assert left.groups[0].table_deg == (0.0, 240.0)


def test_a_pose_of_a_group_is_removed_with_all_its_viewpoints_but_not_half_of_it():
    assert edit.remove(PLAN, ["walls-02-01", "walls-02-02"]).groups[1].poses == (StationPose(flange=POSE),)
    with pytest.raises(PlanError, match=r"Group walls repeats 2 poses at 2 table angles.*Ungroup it first"):
        edit.remove(PLAN, ["walls-02-01"])


def test_the_last_viewpoint_stays():
    with pytest.raises(PlanError, match="at least one viewpoint"):
        edit.remove(PLAN, ["a", "b", "c", "ring", "walls"])


@pytest.mark.parametrize(
    ("moved", "by", "order"), [(["c"], -1, "acb"), (["a"], 5, "bca"), (["b", "c"], -1, "bca"), (["a", "b"], -3, "abc")]
)
def test_viewpoints_move_among_their_own_kind(moved, by, order):
    assert "".join(names(edit.move(PLAN, moved, by))[:3]) == order


def test_groups_move_among_groups():
    assert [group.id for group in edit.move(PLAN, ["walls"], -1).groups] == ["walls", "ring"]


def test_copies_stand_behind_their_originals_and_a_viewpoint_of_a_group_becomes_a_single_one():
    changed, made = edit.duplicate(PLAN, ["a", "ring", "walls-01-02"])
    assert made == ("a-copy", "ring-copy", "walls-01-02-copy")
    assert names(changed)[:5] == ["a", "a-copy", "b", "c", "walls-01-02-copy"]
    assert [group.id for group in changed.groups] == ["ring", "ring-copy", "walls"]
    assert changed.viewpoints[4].table_deg == 90.0
    again, made = edit.duplicate(changed, ["a"])
    assert made == ("a-copy-01",) and len(again) == len(changed) + 1


def test_viewpoints_become_a_group_and_a_group_becomes_viewpoints():
    grouped = edit.repeat(PLAN, ["a", "c"], [0.0, 45.0], "pair")
    assert names(grouped)[-4:] == ["pair-01-01", "pair-01-02", "pair-02-01", "pair-02-02"] and names(grouped)[0] == "b"
    assert names(edit.ungroup(grouped, "pair-02-01"))[:5] == ["b", "pair-01-01", "pair-01-02", "pair-02-01", "pair-02-02"]
    with pytest.raises(PlanError, match="single viewpoint"):
        edit.ungroup(PLAN, "a")
    with pytest.raises(PlanError, match="Only single viewpoints"):
        edit.repeat(PLAN, ["ring-01"], [0.0], "pair")


def test_a_change_in_a_group_is_one_of_the_pose_or_the_angle_that_its_viewpoints_share():
    changed = edit.change(PLAN, ["walls-02-01"], flange=POSE, guide_mm=250.0, table_deg=15.0)
    assert changed.groups[1].poses == (StationPose(flange=POSE), StationPose(flange=POSE, guide_mm=250.0))
    assert changed.groups[1].table_deg == (15.0, 90.0)
    with pytest.raises(PlanError, match="several viewpoints"):
        edit.change(PLAN, ["walls"], guide_mm=1.0)


def test_several_viewpoints_are_changed_together():
    changed = edit.change(PLAN, ["a", "c", "ring-01"], guide_mm=100.0)
    assert [viewpoint.guide_mm for viewpoint in changed][:4] == [100.0, 0.0, 100.0, 100.0]
    exposed = edit.set_exposures(PLAN, ["a", "walls-01-01"], (50_000, 10_000))
    assert exposed.viewpoints[0].exposures_us == exposed.groups[1].exposures_us == (50_000, 10_000)
    assert edit.set_exposures(exposed, ["a", "walls"], None) == PLAN
    assert edit.set_settle(PLAN, ["ring"], 2.0).groups[0].settle_s == 2.0


def test_bad_values_are_refused_in_words_and_nothing_changes():
    for change, told in (
        (lambda: edit.set_exposures(PLAN, ["a"], (10, 20)), "long to short"),
        (lambda: edit.set_settle(PLAN, ["a"], -1.0), "settle_s"),
        (lambda: edit.rename(PLAN, "a", "b"), "b is taken"),
        (lambda: edit.rename(PLAN, "a", "<b>a</b>"), "'<b>a</b>' cannot be a name"),
        (lambda: edit.rename(PLAN, "ring-01", "x"), "named after its group ring"),
        (lambda: edit.move(PLAN, ["zz"], 1), "no viewpoint or group 'zz'"),
        (lambda: edit.make_viewpoint("a b", POSE, 0.0, 0.0), "'a b' cannot be a name"),
    ):
        with pytest.raises(PlanError, match=told):
            change()


def test_an_order_names_every_viewpoint_once():
    wanted = list(reversed(names(PLAN)))
    ordered = edit.reorder(PLAN, wanted)
    assert names(ordered) == wanted and not ordered.groups
    for order, told in ((wanted[1:], "walls-02-02 is missing"), ([*wanted, "x"], "x is not in"), ([*wanted, "a"], "a is given twice")):
        with pytest.raises(PlanError, match=told):
            edit.reorder(PLAN, order)


def test_free_names_count_on():
    index = PlanIndex(PLAN)
    assert [index.free_name(name) for name in ("new", "a", "ring-01", "walls-01-01")] == ["new", "a-01", "ring-04", "walls-01-03"]
    assert index.take_name("view01") == "view01" and index.take_name("view01") == "view02"


def test_viewpoints_of_a_group_are_made_once_and_follow_its_changes():
    group = ViewpointGroup(id="ring", poses=(StationPose(flange=POSE),), table_deg=(0.0, 90.0))
    moved = group.model_copy(update={"table_deg": (10.0, 20.0)})
    assert group.viewpoints() is group.viewpoints()
    assert [viewpoint.table_deg for viewpoint in moved.viewpoints()] == [10.0, 20.0]
    assert [viewpoint.table_deg for viewpoint in group.viewpoints()] == [0.0, 90.0]
