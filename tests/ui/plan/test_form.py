"""The form of the Plan page: what is entered for the selected viewpoints and for the plan."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt

from tests.ui.plan.page_steps import enter, said, viewpoint


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


def test_names_with_markup_are_shown_as_they_are(page):
    from measureapp.planning import edit

    name = "<b>bold</b><img src=x>"
    page.planning.edit("Rename", lambda plan: edit.set_plan(plan, name=name, patterns=plan.patterns.model_copy(update={"name": name})))
    assert page.form.plan_name.text() == name
    assert all(words.textFormat() == Qt.TextFormat.PlainText for words in (page.state, page.problem))
