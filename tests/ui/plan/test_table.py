"""The table of the Plan page: cells, groups, order, undo."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import ScanPlan
from tests.ui.plan.page_steps import enter, names, said, viewpoint
from ui.session import CellState
from ui.widgets.plan_tree_model import EXPOSURES, GUIDE, NAME, TABLE


def test_cells_are_edited_in_place(page):
    rows = page.tree.rows
    index = rows.find("hub-02")
    assert rows.setData(index.siblingAtColumn(GUIDE), "12.5") and viewpoint(page, "hub-02").guide_mm == 12.5
    assert rows.setData(rows.find("hub-02").siblingAtColumn(TABLE), "\u221245,5") and viewpoint(page, "hub-02").table_deg == -45.5
    rows.setData(rows.find("hub-02").siblingAtColumn(NAME), "second")
    assert names(page)[1] == "second" and page.tree.names() == ("second",)
    rows.setData(rows.find("second").siblingAtColumn(NAME), "<b>bold</b>")
    assert "cannot be a name" in said(page) and names(page)[1] == "second"
    rows.setData(rows.find("second").siblingAtColumn(GUIDE), "wide")
    assert "'wide' is not a number" in said(page)
    assert not rows.flags(rows.find("rim").siblingAtColumn(GUIDE)) & Qt.ItemFlag.ItemIsEditable
    assert not rows.flags(rows.find("rim-01-02").siblingAtColumn(NAME)) & Qt.ItemFlag.ItemIsEditable


def test_a_viewpoint_of_a_group_changes_the_pose_that_the_group_shares(page):
    page.tree.select(("rim-02-03",))
    enter(page.form.guide, 100)
    assert [viewpoint(page, f"rim-02-{number:02d}").guide_mm for number in (1, 3, 10)] == [100.0] * 3
    assert page.tree.names() == ("rim-02-03",)


def test_the_tree_shows_groups_with_their_viewpoints(page):
    rows = page.tree.rows
    group = rows.find("rim")
    assert rows.rowCount() == 8 and rows.rowCount(group) == 20
    assert rows.data(group) == "rim (20)" and rows.data(group.siblingAtColumn(GUIDE)) == "2 poses"
    child = rows.index(12, NAME, group)
    assert rows.data(child) == "rim-02-03" and rows.parent(child) == group
    assert rows.data(child.siblingAtColumn(EXPOSURES)) == "plan's"


@pytest.mark.parametrize(
    ("button", "selected", "expected"),
    [
        ("copy", ("hub-01",), lambda before: [before[0], "hub-01-copy", *before[1:]]),
        ("remove", ("hub-01", "rim"), lambda before: before[1:7]),
        ("up", ("hub-02",), lambda before: [before[1], before[0], *before[2:]]),
        ("down", ("hub-02",), lambda before: [before[0], before[2], before[1], *before[3:]]),
        ("ungroup", ("rim",), lambda before: before),
    ],
)
def test_each_tool_edits_the_selected_rows_and_can_be_undone(page, button, selected, expected):
    before = names(page)
    page.tree.select(selected)
    getattr(page.tools, button).click()
    assert names(page) == expected(before)
    assert page.tools.undo.isEnabled() and page.tools.undo.toolTip().startswith("Undo: ")
    after = page.planning.plan
    page.tools.undo.click()
    assert names(page) == before
    page.tools.redo.click()
    assert page.planning.plan == after


@pytest.mark.parametrize("shift", [False, True], ids=["ctrl-y", "ctrl-shift-z"])
def test_both_usual_keys_redo(page, shift):
    page.tree.select(("hub-01",))
    page.tools.copy.click()
    after = page.planning.plan
    page.planning.undo()
    assert page.planning.plan != after
    control = Qt.KeyboardModifier.ControlModifier
    QTest.keyClick(page.tree, *((Qt.Key.Key_Z, control | Qt.KeyboardModifier.ShiftModifier) if shift else (Qt.Key.Key_Y, control)))
    assert page.planning.plan == after


def test_viewpoints_become_a_group_at_angles_that_are_asked_for(page):
    page.tree.select(("hub-01", "hub-02"))
    page.tools.repeat.click()
    page.tools.asking.textValueSelected.emit("0, 120, 240")
    page.tools.asking.reject()
    assert [name for name in names(page) if name.startswith("ring01")] == [
        f"ring01-{pose:02d}-{n:02d}" for pose in (1, 2) for n in (1, 2, 3)
    ]
    page.tree.select(("hub-03",))
    page.tools.repeat_at("a, b")
    assert "not a list of angles" in said(page)


def test_the_last_viewpoint_cannot_be_removed(page):
    page.tree.selectAll()
    page.tools.remove.click()
    assert "at least one viewpoint" in said(page) and len(page.planning.plan) == 27


def test_half_a_group_cannot_be_removed(page):
    page.tree.select(("rim-01-01",))
    page.tools.remove.click()
    assert "Group rim" in said(page)


def test_all_viewpoints_are_ordered_by_the_motion_of_the_axes(page, qtbot):
    mixed = [*names(page)[::3], *names(page)[1::3], *names(page)[2::3]]
    from measureapp.planning import edit

    page.planning.edit("Mix", lambda plan: edit.reorder(plan, mixed))
    page.tools.order.click()
    qtbot.waitUntil(lambda: names(page) != mixed, timeout=20_000)
    poses = [one.flange for one in page.planning.plan]
    assert sum(one != other for one, other in itertools.pairwise(poses)) == 1
    assert sorted(names(page)) == sorted(mixed)


def test_the_position_of_the_rig_is_added(page):
    assert not page.tools.here.isEnabled()
    pose = viewpoint(page, "hub-01").flange.transform()
    page.session.set_cell(CellState(connected=True, readback=AxisReadback(pose, 12.0, 0.5)))
    page.tools.here.click()
    added = viewpoint(page, page.tree.names()[0])
    assert (added.guide_mm, added.table_deg) == (12.0, pytest.approx(np.rad2deg(0.5)))
    assert added.flange.position_mm == pytest.approx(tuple(pose.translation_mm))


def test_ten_thousand_viewpoints_are_shown_and_edited(page):
    one = viewpoint(page, "hub-01")
    many = ScanPlan(name="many", viewpoints=tuple(one.model_copy(update={"id": f"v{n}", "table_deg": n * 0.01}) for n in range(10_000)))
    page.planning._push("Many", many)
    assert page.tree.rows.rowCount() == 10_000
    page.tree.select(("v9999",))
    enter(page.form.guide, 5)
    assert viewpoint(page, "v9999").guide_mm == 5.0
    page.tools.up.click()
    assert page.planning.plan.viewpoints[9998].id == "v9999"


def test_rows_of_groups_and_single_viewpoints_are_selected_from_top_to_bottom(qtbot, plan):
    from measureapp.data.plan import StationPose, ViewpointGroup
    from ui.look.look import Look
    from ui.widgets.plan_tree import PlanTree

    pose = StationPose(flange=plan.viewpoints[0].flange, guide_mm=0.0)
    ring = ViewpointGroup(id="ring", poses=(pose, pose), table_deg=(0.0, 90.0))
    alone = ViewpointGroup(id="alone", poses=(pose,), table_deg=(0.0,))
    tree = PlanTree(Look("light"))
    qtbot.addWidget(tree)
    tree.show_plan(plan.model_copy(update={"groups": (ring, alone)}), None)
    tree.expandAll()
    tree.selectAll()
    singles = tuple(viewpoint.id for viewpoint in plan.viewpoints)
    of_ring = tuple(viewpoint.id for viewpoint in ring.viewpoints())
    assert tree.names() == (*singles, "ring", *of_ring, "alone", alone.viewpoints()[0].id)
    assert len(tree.viewpoints()) == len(tree.names())
    shown = [tree.rows.data(tree.rows.find(name)) for name in ("ring", "alone")]
    assert shown == ["ring (4)", "alone"]
