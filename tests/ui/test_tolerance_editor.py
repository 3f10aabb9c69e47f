"""Geometrical tolerances are defined and changed by clicking, with their frame drawn meanwhile."""

import pytest
from PySide6.QtCore import QPoint, Qt

from measureapp.data.control_frame import CHARACTERISTICS
from tests.ui.test_dimension_table import page, project, row_named, settled  # noqa: F401 - fixtures
from ui.pages.inspection.dimension_model import Column


def choose(box, data):
    """Choose an item as a user does, who sees only what is offered."""
    place = box.findData(data)
    assert place >= 0, data
    box.setCurrentIndex(place)


@pytest.fixture
def editor(page):  # noqa: F811
    page.side.actions.toleranceAsked.emit()
    assert page.side.tolerance.isVisible() and not page.side.table.isVisible()
    return page.side.tolerance


def test_a_new_tolerance_is_drawn_while_it_is_chosen_and_measured_when_it_is_applied(application, page, editor, qtbot):  # noqa: F811
    assert [editor.kind.itemData(place) for place in range(editor.kind.count())] == list(CHARACTERISTICS)
    assert not any(editor.kind.itemIcon(place).isNull() for place in range(editor.kind.count()))
    choose(editor.kind, "surface_profile")
    choose(editor.feature, "plate")
    choose(editor.datums[0], "ball")
    editor.width.setValue(0.08)
    editor.offset.setValue(0.01)
    choose(editor.datums[0], "")
    frame = editor.picture.frame
    assert frame.characteristic == "surface_profile" and frame.width_mm == 0.08 and frame.datums == ()
    assert editor.problem.isHidden() and editor.apply.isEnabled()
    editor.apply.click()
    assert page.side.table.isVisible() and page.side.table.current_row().name == "plate surface profile"
    settled(application, qtbot)
    row = row_named(page, "plate surface profile")
    assert row.status == "current" and row.found.measured is not None and row.found.frame == frame
    application.controllers.programming.undo()
    assert "plate surface profile" not in [one.name for one in page.side.table.rows]


def test_what_is_not_allowed_is_said_in_a_sentence_and_cannot_be_applied(page, editor):  # noqa: F811
    choose(editor.feature, "ball")
    choose(editor.kind, "flatness")
    assert "flatness is defined for a plane" in editor.problem.text() and not editor.apply.isEnabled()
    assert all(box.isHidden() for box in editor.datums)  # form has none
    choose(editor.kind, "position")
    assert "needs a datum" in editor.problem.text()
    choose(editor.datums[0], "plate")
    assert editor.picture.frame.datums == ("A",) and editor.picture.frame.diameter == "SØ"
    assert "do not fix the location" in editor.problem.text() and not editor.apply.isEnabled()
    assert editor.condition.isHidden()  # evaluated for holes and shafts only
    editor.cancel.click()
    assert page.side.table.isVisible() and len(page.side.table.rows) == 3


def test_two_features_become_a_common_datum(application, page, editor):  # noqa: F811
    choose(editor.feature, "plate")
    choose(editor.kind, "surface_profile")
    choose(editor.datums[0], "ball")
    assert editor.picture.frame.datums == ("A",)
    choose(editor.partners[0], "ball")
    assert editor.problem.text() == "Two datums are the same feature." and not editor.apply.isEnabled()
    choose(editor.partners[0], "plate")
    assert editor.picture.frame.datums == ("A-B",)
    assert "ball and plate cannot be one datum" in editor.problem.text() and not editor.apply.isEnabled()
    application.settings.set_text("language", "zh_CN")
    application.language.retranslation.finish()
    assert {box.itemText(0) for box in editor.partners} == {"单独"} and editor.partners[0].itemText(1) == "Ball"


def test_a_double_click_on_a_frame_edits_it(application, page, qtbot):  # noqa: F811
    table = page.side.table
    place = next(number for number, row in enumerate(table.shown_rows) if row.name == "flat")
    where = table.visualRect(table.shown.index(place, Column.TOLERANCE)).center()
    table.setColumnHidden(Column.TOLERANCE, False)
    where = table.visualRect(table.shown.index(place, Column.TOLERANCE)).center()
    qtbot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(where))
    qtbot.mouseDClick(table.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(where))
    editor = page.side.tolerance
    assert editor.isVisible() and editor.value().feature == "plate" and editor.width.value() == 0.1
    editor.width.setValue(0.02)
    editor.apply.click()
    settled(application, qtbot)
    row = row_named(page, "flat")
    assert row.frame.width_mm == 0.02 and row.found.upper_tolerance == 0.02 and row.status == "current"
    application.controllers.programming.undo()
    assert row_named(page, "flat").frame.width_mm == 0.1


def test_clicked_faces_become_the_feature_and_then_its_datums(application, page, editor):  # noqa: F811
    choose(editor.kind, "position")
    editor.pick.click()
    assert page.side.is_picking
    editor.feature.setCurrentIndex(-1)
    for name in ("ball", "plate"):
        application.controllers.creating.picked.emit(name)
    assert editor.value().feature == "ball" and editor.value().datums == ("plate",)
    editor.cancel.click()
    assert not page.side.is_picking
