"""The Plan page: table, editors, undo, background check, preview."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog

from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.planning import generate as generator
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.plan_file import read_plan, write_plan
from measureapp.resources import resource
from ui.pages.plan import preview
from ui.pages.plan.ray import first_hit
from ui.session import CellState
from ui.widgets.plan_tree_model import EXPOSURES, GUIDE, NAME, TABLE

LATER_MS = 1_000_000
SAMPLE = read_plan(resource("plans/paper_impeller.toml"))


@pytest.fixture
def page(application, window, rig, qtbot):
    """Return the page with the viewpoints `hub-01` … `hub-07` as single ones, and the group `rim`."""
    application.controllers.planning.prediction._timer.setInterval(LATER_MS)  # most tests need no check
    application.session.set_rig(rig)
    window.show_page("plan")
    hub, rim = SAMPLE.groups[2], SAMPLE.groups[0]
    shown = window.pages["plan"]
    shown.planning._push("Begin", ScanPlan(name="p", viewpoints=hub.viewpoints(), groups=(rim,)))
    yield shown
    end(application, qtbot)


def end(application, qtbot) -> None:
    """End the checks in the background."""
    application.controllers.planning.prediction.stop()
    for runner in (application.controllers.predicting, application.controllers.drawing):
        runner.queue.cancel_all()
    qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=30_000)


@pytest.fixture
def checked(page, qtbot):
    check_at_once(page)
    qtbot.waitUntil(lambda: page.planning.prediction.is_current, timeout=20_000)
    return page


@pytest.fixture
def on_impeller(page, qtbot):
    """Return the page with the impeller, whose coverage is predicted."""
    check_at_once(page)
    page.planning.part.choose(resource("parts/impeller/nominal.stl"))
    prediction = page.planning.prediction
    qtbot.waitUntil(lambda: prediction.is_current and prediction.now.coverage is not None, timeout=60_000)
    return page


def check_at_once(page) -> None:
    page.planning.prediction._timer.setInterval(0)
    page.planning.prediction.predict(page.planning.plan)


def names(page) -> list[str]:
    return [] if page.planning.plan is None else [viewpoint.id for viewpoint in page.planning.plan]


def enter(fields, *numbers) -> None:
    for line, number in zip(fields.lines, numbers, strict=True):
        line.setText(str(number))
    fields.lines[-1].editingFinished.emit()


def viewpoint(page, name: str) -> Viewpoint:
    return next(one for one in page.planning.plan if one.id == name)


def said(page) -> str:
    return page.session.messages[-1].text if page.session.messages else ""


# editors


def test_the_form_shows_the_selected_viewpoint_and_an_entry_changes_it(page):
    page.tree.select(("hub-02",))
    form = page.form
    assert form.direction.value() == pytest.approx((0.0, 60.0, 180.0), abs=0.01)
    enter(form.direction, 10, 45, 180)
    aim = page.aims.aim(viewpoint(page, "hub-02"))
    assert (aim.look_at.azimuth_deg, aim.look_at.elevation_deg) == pytest.approx((10.0, 45.0))
    assert form.position.value() == pytest.approx(viewpoint(page, "hub-02").flange.position_mm)
    page.planning.undo()
    assert form.direction.value() == pytest.approx((0.0, 60.0, 180.0), abs=0.01)


def test_a_target_that_was_entered_stays_the_target_when_the_stand_off_changes(page):
    page.tree.select(("hub-02",))
    enter(page.form.target, 20, 5, 60)
    enter(page.form.distance, 620)
    assert page.form.target.value() == pytest.approx((20.0, 5.0, 60.0), abs=1e-6)
    assert page.form.distance.value() == pytest.approx((620.0,))


def test_fields_keep_all_digits_of_what_was_not_edited(page):
    page.tree.select(("hub-02",))
    before = viewpoint(page, "hub-02").flange
    enter(page.form.position, *(f"{value:.2f}" for value in before.position_mm))
    assert viewpoint(page, "hub-02").flange == before and page.planning.stack.count() == 1


def test_a_robot_pose_is_entered_and_its_quaternion_scaled_to_one(page):
    page.tree.select(("hub-03",))
    page.form.section.setValue("pose")
    enter(page.form.quaternion, 0, 2, 0, 0)
    assert viewpoint(page, "hub-03").flange.quaternion_wxyz == (0.0, 1.0, 0.0, 0.0)
    enter(page.form.quaternion, 0, 0, 0, 0)
    assert "quaternion" in said(page)
    assert page.form.quaternion.value() == (0.0, 1.0, 0.0, 0.0)


def test_what_is_no_number_changes_nothing_and_is_marked(page):
    page.tree.select(("hub-02",))
    for text in ("", "abc", "1e999", "nan", "--3"):
        enter(page.form.guide, text)
        assert page.planning.stack.count() == 1
        assert bool(page.form.guide.lines[0].property("invalid")) == bool(text)


def test_guide_table_exposures_and_wait_are_set_for_all_selected(page):
    page.tree.select(("hub-01", "hub-04"))
    assert not page.form.target.isEnabled() and "2 rows" in page.form.note.text()
    enter(page.form.guide, 33)
    page.form.exposures.line.setText("50, 10")
    page.form.exposures.line.editingFinished.emit()
    page.form.settle.line.setText("1,5")
    page.form.settle.line.editingFinished.emit()
    assert page.form.settle.line.property("invalid")
    page.form.settle.line.setText("1.5")
    page.form.settle.line.editingFinished.emit()
    chosen, other = viewpoint(page, "hub-04"), viewpoint(page, "hub-02")
    assert (chosen.guide_mm, chosen.exposures_us, chosen.settle_s) == (33.0, (50_000, 10_000), 1.5)
    assert (other.guide_mm, other.exposures_us, other.settle_s) == (0.0, None, None)
    page.form.exposures.line.setText("")
    page.form.exposures.line.editingFinished.emit()
    assert viewpoint(page, "hub-04").exposures_us is None


def test_exposures_that_do_not_descend_are_refused_and_shown_as_before(page):
    page.tree.select(("hub-01",))
    page.form.exposures.line.setText("10, 20")
    page.form.exposures.line.editingFinished.emit()
    assert "long to short" in said(page)
    assert page.form.exposures.line.text() == "" and viewpoint(page, "hub-01").exposures_us is None


def test_the_plan_as_a_whole_is_edited(page):
    page.form.section.setValue("plan")
    page.form.plan_name.setText("new name")
    page.form.plan_name.editingFinished.emit()
    page.form.patterns.setCurrentIndex(page.form.patterns.findData("paper"))
    page.form.patterns.activated.emit(page.form.patterns.currentIndex())
    page.form.plan_exposures.line.setText("90, 30")
    page.form.plan_exposures.line.editingFinished.emit()
    plan = page.planning.plan
    assert (plan.name, plan.patterns.count, plan.bracket.exposures_us) == ("new name", 8, (90_000, 30_000))
    page.form.plan_exposures.line.setText("")
    page.form.plan_exposures.line.editingFinished.emit()
    assert page.planning.plan.bracket.exposures_us == (90_000, 30_000) and said(page)


# the table


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


# checks in the background


def test_what_cannot_be_scanned_is_marked_with_its_sentence(checked, qtbot):
    assert "nothing prevents the scan" in checked.state.text() and not checked.problem.isVisible()
    checked.tree.select(("hub-03",))
    enter(checked.form.guide, 900)
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert "1 problem" in checked.state.text()
    assert "hub-03: Guide at 900.0 mm is outside" in checked.problem.text()
    rows = checked.tree.rows
    assert rows._state(rows.find("hub-03")).sign == "fail" and rows._state(rows.find("hub-02")).sign == "pass"
    assert checked.properties.groups[0].heading == "Prevents the scan"
    checked.planning.undo()
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert not checked.problem.isVisible()


def test_only_the_newest_of_many_edits_is_checked(checked, qtbot):
    checked.tree.select(("hub-03",))
    for value in range(30):
        enter(checked.form.guide, value)
    qtbot.waitUntil(lambda: checked.planning.prediction.is_current, timeout=20_000)
    assert checked.planning.prediction.now.plan is checked.planning.plan


def test_the_coverage_is_predicted_and_drawn_on_the_part(on_impeller, application):
    page = on_impeller
    found = page.planning.prediction.now
    assert 0.5 < found.coverage.predicted < 0.8
    assert page.legend.words.text() == f"Predicted coverage {100 * found.coverage.predicted:.1f}\u00a0%"
    page.tree.select(("hub-01",))
    scenery = page._scenery()
    surfaces = {shown: preview.composer(replace(scenery, shown=shown), page.look.theme)(_Job()).surface for shown in preview.SHOWN}
    colours = {shown: {tuple(colour) for colour in surface.colours.tolist()} for shown, surface in surfaces.items()}
    assert {preview.ONCE, preview.TWICE, preview.OFTEN} <= colours["coverage"]
    assert preview.ONCE not in colours["selected"] and preview.PART["light"] in colours["part"]
    page.shown.setValue("selected")
    assert page.legend.words.text() == "" and page.legend.isVisible()


def test_the_preview_shows_frusta_and_marks_what_cannot_be_scanned_red(on_impeller, qtbot):
    page = on_impeller
    page.tree.select(("hub-01",))
    enter(page.form.guide, 900)
    qtbot.waitUntil(lambda: page.planning.prediction.is_current, timeout=20_000)
    theme = page.look.theme
    picture = preview.composer(page._scenery(), theme)(_Job())
    fail = preview.rgb(theme, "verdict_fail")
    assert fail in {layer.colour for layer in picture.lines} and preview.CAMERA_LINES in {layer.colour for layer in picture.lines}
    assert fail in {tuple(colour) for colour in picture.surface.colours.tolist()}
    assert [label.text for label in picture.labels] == ["hub-01"]


def test_a_click_on_the_part_adds_a_viewpoint_that_faces_it(on_impeller, qtbot):
    page = on_impeller
    part, before = page.planning.part.prepared, names(page)
    page.on_part.setChecked(True)
    turn = preview.guide_from_part(page._scenery())
    top, down = turn @ [0.0, 0.0, 500.0, 1.0], np.array([0.2, 0.1, -1.0])
    page.view.rayClicked.emit(top[:3], down)
    assert len(names(page)) == len(before) + 1
    new = next(name for name in names(page) if name not in before)
    assert page.tree.names() == (new,)
    point, normal = first_hit(part.corners_mm, np.eye(4), np.array([0.0, 0.0, 500.0]), down)
    assert point[2] == pytest.approx(part.mesh.vertices_mm[:, 2].max(), abs=60.0) and normal[2] > 0.5
    page.view.rayClicked.emit(top[:3], np.array([0.0, 0.0, 1.0]))  # misses the part
    page.end_clicking()
    page.view.rayClicked.emit(top[:3], down)
    assert len(names(page)) == len(before) + 1


def test_the_position_of_the_rig_is_added(page):
    assert not page.tools.here.isEnabled()
    pose = viewpoint(page, "hub-01").flange.transform()
    page.session.set_cell(CellState(connected=True, readback=AxisReadback(pose, 12.0, 0.5)))
    page.tools.here.click()
    added = viewpoint(page, page.tree.names()[0])
    assert (added.guide_mm, added.table_deg) == (12.0, pytest.approx(np.rad2deg(0.5)))
    assert added.flange.position_mm == pytest.approx(tuple(pose.translation_mm))


# files, projects and the generator


def test_a_plan_is_saved_and_opened_by_the_buttons(page, tmp_path, monkeypatch, qtbot):
    target = tmp_path / "ünï plan"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *args: (str(target), ""))
    page.save_file.click()
    saved = target.with_suffix(".toml")
    qtbot.waitUntil(saved.exists, timeout=10_000)
    assert read_plan(saved) == page.planning.plan
    write_plan(tmp_path / "other.json", SAMPLE)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *args: (str(tmp_path / "other.json"), ""))
    page.open_file.click()
    qtbot.waitUntil(lambda: page.planning.plan == SAMPLE, timeout=10_000)
    page.planning.undo()
    assert names(page)[0] == "hub-01"


def test_a_file_that_is_no_plan_is_refused_and_the_plan_stays(page, tmp_path, qtbot):
    before = page.planning.plan
    texts = ("", "rubbish", '{"schema_version": 3, "name": "x"}', '{"name": "<img src=x>", "viewpoints": []}')
    for number, text in enumerate(texts):
        bad = tmp_path / f"bad{number}.json"
        bad.write_text(text)
        page.planning.open(bad)
        qtbot.waitUntil(lambda bad=bad: bad.name in said(page), timeout=10_000)
        assert page.session.messages[-1].level == "error" and page.planning.plan is before


def test_a_plan_is_used_for_the_scan_and_stored_in_the_project(page, tmp_path, qtbot, rig):
    project = ProjectFolder.create(tmp_path / "project", ProjectSettings(name="project", part="", rig=rig))
    plan = page.planning.plan
    page.session.open_project("project", "", project.path)
    assert page.planning.plan is plan and page.use.isEnabled()
    page.use.click()
    qtbot.waitUntil(lambda: page.session.plan == plan, timeout=10_000)
    assert project.plan() == plan and list(page.session.viewpoints) == names(page)
    assert not page.use.isEnabled()


def test_the_plan_of_an_opened_project_is_shown_and_the_former_comes_back_by_undo(page, plan):
    before = page.planning.plan
    page.session.open_project("other", "", None)
    page.session.set_plan(plan)
    assert page.planning.plan == plan
    page.planning.undo()
    assert page.planning.plan == before


def test_an_empty_page_begins_with_one_viewpoint(application, window, rig, qtbot):
    application.session.set_rig(rig)
    window.show_page("plan")
    shown = window.pages["plan"]
    assert shown.is_empty
    shown.begin.click()
    assert not shown.is_empty and names(shown) == ["view01"]
    shown.planning.undo()
    assert shown.is_empty
    end(application, qtbot)


def test_a_plan_is_generated_after_its_part_is_chosen(page, monkeypatch, qtbot):
    coarse = partial(generator.GeneratorSettings, samples=300, candidates=60)  # quick, and good enough for three viewpoints
    monkeypatch.setattr(generator, "GeneratorSettings", coarse)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *args: (str(resource("parts/gypsum/nominal.stl")), ""))
    page.generate.click()
    dialog = page.dialog
    assert not dialog.start.isEnabled()
    dialog.partAsked.emit()
    qtbot.waitUntil(dialog.start.isEnabled, timeout=20_000)
    dialog.by.setValue("count")
    dialog.count.setValue(3)
    former = page.planning.plan
    dialog.start.click()
    qtbot.waitUntil(lambda: page.planning.plan is not former, timeout=90_000)
    made = page.planning.plan
    assert len(made) == 3 and (made.name, made.bracket) == (former.name, former.bracket)
    assert "3 viewpoints measure" in said(page)


def test_a_part_that_was_chosen_stays_while_other_pages_are_shown_and_a_nominal_that_is_none_is_refused(
    on_impeller, window, tmp_path, qtbot
):
    page, prepared = on_impeller, on_impeller.planning.part.prepared
    page.session.part = "gypsum"
    window.show_page("rig")
    window.show_page("plan")
    (tmp_path / "none.stl").write_text("solid")
    page.planning.part.choose(tmp_path / "none.stl")
    qtbot.waitUntil(lambda: "none.stl" in said(page), timeout=10_000)
    assert page.planning.part.prepared is prepared


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


class _Job:
    """Progress of a composer that is run in the test itself."""

    def check(self) -> None:
        """Go on."""


def test_names_with_markup_are_shown_as_they_are(page):
    from measureapp.planning import edit

    name = "<b>bold</b><img src=x>"
    page.planning.edit("Rename", lambda plan: edit.set_plan(plan, name=name, patterns=plan.patterns.model_copy(update={"name": name})))
    assert page.form.plan_name.text() == name
    assert all(words.textFormat() == Qt.TextFormat.PlainText for words in (page.state, page.problem))


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
