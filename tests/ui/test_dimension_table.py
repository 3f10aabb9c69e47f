"""Dimensions are edited in their table; only what an edit affects is measured again, and nothing old is shown as current."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLineEdit

from measureapp.inspection.dimensions import inspect
from measureapp.inspection.programming import edits
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.program_file import parse_program
from ui.controllers.program_rows import carry_ids, changed_names
from ui.pages.inspection.dimension_model import Column
from ui.pages.inspection.program_dialog import ProgramDialog
from ui.widgets.data_table import SIGN_ROLE

PATIENCE_MS = 60_000
PROGRAM = """# by hand
name = "ball"
alignment = "none"

[[features]]
name = "ball"
shape = "sphere"
point_mm = [0, 0, 60]
radius_mm = 60

[[features]]
name = "plate"
shape = "plane"
point_mm = [140, 0, 10]
direction = [0, 0, 1]
cut = { edge_mm = 0 }

# of the drawing
[[dimensions]]
name = "size"
kind = "diameter"
features = ["ball"]
nominal = 120

[[dimensions]]
name = "half"
kind = "radius"
features = ["ball"]
nominal = 60.5

[[dimensions]]
name = "flat"
kind = "flatness"
features = ["plate"]
upper_tolerance = 0.1
"""


@pytest.fixture
def project(tmp_path, rig, measurement) -> ProjectFolder:
    """A ball of 120 mm and a plate, without noise; the radius has a wrong nominal."""
    made = ProjectFolder.create(tmp_path / "ball", ProjectSettings(name="ball", part="ball", rig=rig))
    made.save_calibration(measurement.calibration)
    made.save_program(PROGRAM)
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(100.0, 180.0), np.arange(-40.0, 40.0)))
    count, ball = len(x), measurement.stitched
    plate = {
        "points_mm": np.column_stack([x, y, np.full(count, 10.0)]),
        "normals": np.tile([0.0, 0.0, 1.0], (count, 1)),
        "sigma_mm": np.full(count, 0.01),
        "grey": np.full(count, 0.5),
        "view": np.zeros(count, int),
    }
    stitched = replace(ball, **{name: np.concatenate([getattr(ball, name), values]) for name, values in plate.items()})
    made.save_measurement(replace(measurement, stitched=stitched, inspection=inspect(stitched, parse_program(PROGRAM))))
    return made


@pytest.fixture
def page(application, window, project, qtbot, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.controllers.project.open(project.path)
    window.show_page("inspection")
    settled(application, qtbot)
    return window.pages["inspection"]


def settled(application, qtbot):
    controllers = application.controllers
    runners = (controllers.jobs, controllers.background, controllers.inspecting)
    qtbot.waitUntil(lambda: not any(one.queue.busy for one in runners) and not application.session.busy_with, timeout=PATIENCE_MS)


def row_named(page, name):
    return next(row for row in page.side.table.rows if row.name == name)


def type_in(page, qtbot, name, column, text, key=Qt.Key.Key_Return):
    """Type into a cell as a user does; return the editor."""
    table = page.side.table
    table.select(row_named(page, name).id)
    table.edit_cell(column)
    editor = next(one for one in table.findChildren(QLineEdit) if one.isVisible())
    editor.selectAll()
    qtbot.keyClicks(editor, text)
    if key is not None:
        qtbot.keyClick(editor, key)
    if key == Qt.Key.Key_Return:
        qtbot.waitUntil(lambda: not table.is_editing)
    return editor


def test_an_entry_that_is_refused_is_told_and_leaves_nothing_open(application, page, qtbot):
    type_in(page, qtbot, "half", Column.TOLERANCE, "wide")
    told = application.session.messages[-1]
    assert told.level == "error" and not application.session.messages.is_open(told)


@pytest.mark.parametrize("text", ["-120", "1e308", "nan", "120 inch", ""])
def test_a_nominal_that_no_size_has_is_refused(application, page, qtbot, text):
    editor = type_in(page, qtbot, "size", Column.NOMINAL, text or "\b", key=None)
    assert editor.property("invalid")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: not page.side.table.is_editing)
    assert row_named(page, "size").nominal == 120 and not application.controllers.programming.is_modified


def test_changes_of_the_program_outlive_a_closed_dialog(page, project):
    dialog = ProgramDialog(page.look, page.controllers.programming, page)
    dialog.show_program()
    program = dialog.text.toPlainText()
    dialog.text.setPlainText(program + "# mine")
    dialog.reject()
    dialog.show_program()
    assert dialog.text.toPlainText() == program + "# mine" and "not measured yet" in dialog.problem.text()
    dialog.text.undo()
    assert dialog.text.toPlainText() == program
    dialog.reject()
    dialog.show_program()
    assert dialog.text.toPlainText() == program and dialog.problem.isHidden()
    dialog.reject()
    dialog.deleteLater()


def test_the_worst_verdict_is_first_and_selected(page):
    assert page.side.table.current_row().name == "half" and page.side.table.current_row().verdict == "fail"
    assert page.side.table.shown_rows[0].name == "half"


def test_a_nominal_is_typed_and_its_verdict_follows_without_measuring_features_again(application, page, qtbot, project):
    size, shown = row_named(page, "size").found, []
    application.controllers.programming.changed.connect(lambda: shown.append([row_named(page, name).status for name in ("half", "size")]))
    type_in(page, qtbot, "half", Column.NOMINAL, "60")
    settled(application, qtbot)
    assert shown[0] == ["calculating", "current"]  # from the edit on, however soon the measurement ends
    half = row_named(page, "half")
    assert half.status == "current" and half.verdict != "fail" and half.found.nominal == 60
    assert row_named(page, "size").found is size  # the same result, not measured again
    assert page.side.table.current_row().name != "" and application.controllers.programming.is_modified
    assert "nominal = 60.5" in project.program_text(has_nominal=False)  # not saved yet


def test_a_row_that_is_measured_again_shows_neither_its_old_verdict_nor_its_old_value_as_valid(application, page, qtbot, monkeypatch):
    programming, table = application.controllers.programming, page.side.table
    seen = []

    def look() -> None:
        row = row_named(page, "half")
        cells = {column: table.dimensions.index(table.rows.index(row), column) for column in Column}
        measured, verdict = cells[Column.MEASURED], cells[Column.VERDICT]
        muted = measured.data(Qt.ItemDataRole.ForegroundRole)
        seen.append((row.status, verdict.data(), verdict.data(SIGN_ROLE), muted is not None, verdict.data(Qt.ItemDataRole.ToolTipRole)))

    programming.changed.connect(look)
    type_in(page, qtbot, "half", Column.NOMINAL, "60")
    settled(application, qtbot)
    assert seen[0][:4] == ("calculating", "Measuring…", "", True) and "60.0" in seen[0][4] and "Fail" in seen[0][4]
    assert seen[-1][:4] == ("current", "Not proven", "not proven", False)
    monkeypatch.setattr(programming._measuring, "measure", lambda _state, _former: None)  # cancelled, or not possible
    type_in(page, qtbot, "half", Column.NOMINAL, "60.5")
    assert seen[-1][:4] == ("stale", "Stale", "", True) and "Not proven" in seen[-1][4]
    page.side.table.select(row_named(page, "half").id)
    outdated = "dimension:half", "", ("Before the change",)
    qtbot.waitUntil(lambda: outdated in [(flag.key, flag.verdict, flag.more[-1:]) for flag in page.view._flags])
    assert [page.side.filter.buttons[name].text() for name in ("not proven", "stale")] == ["0", "1"]
    table.set_filter(frozenset({"stale"}), "")
    assert [row.name for row in table.shown_rows] == ["half"]
    table.set_filter(frozenset({"not proven"}), "")
    assert not table.shown_rows


def test_a_tolerance_is_one_text_and_what_is_none_turns_red(application, page, qtbot):
    editor = type_in(page, qtbot, "size", Column.TOLERANCE, "H", key=None)
    assert editor.property("invalid") and editor.toolTip()
    qtbot.keyClicks(editor, "7")
    assert not editor.property("invalid")
    qtbot.keyClick(editor, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: not page.side.table.is_editing)
    settled(application, qtbot)
    size = row_named(page, "size")
    assert size.limits == (0.0, 0.035) and size.source == "H7"
    texts = page.side.table.texts()
    assert texts[0][2].endswith("H7")
    type_in(page, qtbot, "flat", Column.TOLERANCE, "±0.1")
    assert row_named(page, "flat").limits == (0.0, 0.1) and application.session.messages[-1].level == "error"


def test_escape_leaves_the_value_and_no_tolerance_is_no_verdict(application, page, qtbot):
    type_in(page, qtbot, "size", Column.TOLERANCE, "±5", Qt.Key.Key_Escape)
    assert not application.controllers.programming.is_modified
    table = page.side.table
    type_in(page, qtbot, "size", Column.TOLERANCE, "\b")
    settled(application, qtbot)
    assert row_named(page, "size").verdict == "no tolerance" and table.rows[0].limits is None


def test_a_renamed_dimension_stays_selected_and_undo_brings_its_name_back(application, page, qtbot):
    chosen = row_named(page, "size").id
    type_in(page, qtbot, "size", Column.NAME, "ball size", key=Qt.Key.Key_Tab)
    settled(application, qtbot)
    assert row_named(page, "ball size").id == chosen and row_named(page, "ball size").status == "current"
    page.undo_last()
    settled(application, qtbot)
    assert row_named(page, "size").id == chosen and not application.controllers.programming.is_modified


def test_rows_are_duplicated_moved_and_deleted_by_keys_and_saved_with_their_comments(application, page, qtbot, project):
    table = page.side.table
    table.select(row_named(page, "size").id)
    table.setFocus()
    page.side.actions.duplicate()
    settled(application, qtbot)
    assert [row.name for row in table.rows] == ["size", "size 2", "half", "flat"] and table.current_row().name == "size 2"
    page.side.actions.move(1)
    settled(application, qtbot)
    assert [row.name for row in table.shown_rows] == ["size", "half", "size 2", "flat"]  # the order of the program
    table.select(row_named(page, "half").id)
    page.side.actions.remove()
    settled(application, qtbot)
    page.side.save.save.click()
    settled(application, qtbot)
    text = project.program_text(has_nominal=False)
    assert "# by hand" in text and "# of the drawing" in text
    assert [one.name for one in parse_program(text).dimensions] == ["size", "size 2", "flat"]
    assert [one.name for one in project.measurement().inspection.dimensions] == ["size", "size 2", "flat"]
    assert not page.side.save.isVisible()


def test_one_edit_applies_to_all_selected_rows(application, page, qtbot):
    table = page.side.table
    table.selectAll()
    table.dimensions.setData(table.dimensions.index(0, Column.TOLERANCE), "±0.3")
    settled(application, qtbot)
    assert row_named(page, "half").limits == (-0.1, 0.1)  # the model edits one cell
    table.selectAll()
    index = next(table.shown.index(place, Column.TOLERANCE) for place, row in enumerate(table.shown_rows) if row.name == "flat")
    assert table.commit(index, "0.2") is False  # not a tolerance of the sizes: nothing is changed
    page.side.actions.remove()
    settled(application, qtbot)
    assert table.rows == () and application.controllers.programming.stack.count() == 2


def test_filter_and_search_keep_the_selection_and_rows_are_copied_with_their_headings(page):
    table, bar = page.side.table, page.side.filter
    bar.buttons["fail"].setChecked(True)
    assert [row.name for row in table.shown_rows] == ["half"]
    bar.buttons["fail"].setChecked(False)
    bar.search.setText("diam")
    assert [row.name for row in table.shown_rows] == ["size"]
    bar.search.clear()
    table.select(row_named(page, "half").id)
    table.copy()
    lines = [line.split("\t") for line in QGuiApplication.clipboard().text().split("\n")]
    assert lines[0][:3] == ["Dimension", "Nominal", "Tolerance"] and lines[1][0] == "Half" and len(lines) == 2


def test_an_edit_that_is_not_possible_changes_nothing(application, page, qtbot):
    type_in(page, qtbot, "size", Column.NAME, "flat")
    told = application.session.messages[-1]
    assert told.level == "error" and "already" in told.text
    assert not application.controllers.programming.is_modified


def test_what_an_edit_affects_follows_from_the_program():
    program = parse_program(PROGRAM)
    renamed = parse_program(PROGRAM.replace('"half"', '"semi"'))
    moved = parse_program(PROGRAM.replace("[140, 0, 10]", "[140, 0, 10.1]"))
    assert changed_names(program, program) == set()
    assert changed_names(program, renamed) == {"semi"}
    assert changed_names(program, moved) == {"flat"}
    assert changed_names(None, program) == {"size", "half", "flat"}
    assert carry_ids(["a", "b"], [4, 2], ["b", "c", "a"]) == (2, 5, 4)


def test_a_window_with_unsaved_edits_asks_before_it_closes_and_a_project_before_another_is_opened(
    application, window, page, qtbot, project
):
    type_in(page, qtbot, "half", Column.NOMINAL, "60")
    settled(application, qtbot)
    bar = window.unsaved.bar
    assert not window.close() and bar.isVisible() and window.isVisible()
    bar.buttons["Stay here"].click()
    application.controllers.project.open(project.path)
    assert bar.isVisible() and not application.controllers.jobs.queue.busy
    bar.buttons["Save"].click()
    qtbot.waitUntil(lambda: application.session.messages[-1].text == "ball is open.", timeout=PATIENCE_MS)
    settled(application, qtbot)
    assert row_named(page, "half").nominal == 60 and not application.controllers.programming.is_modified
    type_in(page, qtbot, "half", Column.NOMINAL, "61")
    settled(application, qtbot)
    application.controllers.project.open(project.path)
    bar.buttons["Discard the edits"].click()
    qtbot.waitUntil(lambda: row_named(page, "half").nominal == 60, timeout=PATIENCE_MS)
    settled(application, qtbot)


def test_selected_features_propose_a_dimension_and_constructions_that_fit(application, page, qtbot):
    page.side.list.setValue("features")
    page.side.features.select_names(["ball", "plate"])
    bar = page.side.create
    assert bar.choice.currentText().replace("\u00a0", " ") == "Distance 50.000 mm"
    bar.accept()
    settled(application, qtbot)
    new = page.side.table.current_row()
    assert new.found.measured == pytest.approx(50.0, abs=1e-3) and new.is_linked and new.status == "current"
    page.side.list.setValue("features")
    page.side.features.select_names(["plate"])
    assert [action.text() for action in bar.menu.actions()] == ["Offset plane"]
    bar.menu.actions()[0].trigger()
    settled(application, qtbot)
    assert page.side.features.names() == ("offset plane 1",) and "offset plane 1" in [
        one.name for one in application.session.inspection.features
    ]


def test_a_construction_is_drawn_in_the_picture_before_it_is_made(application, page, qtbot):
    drawn = []
    page.view.set_lines = lambda layers: drawn.append([line for layer in layers for line in layer.lines])
    page.side.list.setValue("features")
    page.side.features.select_names(["plate"])
    menu, names = page.side.create.menu, [one.name for one in application.session.inspection.features]
    qtbot.waitUntil(lambda: bool(drawn))
    before = len(drawn[-1])
    menu.hovered.emit(menu.actions()[0])
    qtbot.waitUntil(lambda: len(drawn[-1]) > before + 5)
    assert np.allclose(np.vstack(drawn[-1][before:])[:, 2], 20.0, atol=0.01)  # dashes 10 mm above the plate
    menu.aboutToHide.emit()
    qtbot.waitUntil(lambda: len(drawn[-1]) == before)
    assert [one.name for one in application.session.inspection.features] == names and not application.controllers.programming.is_modified


def test_a_datum_letter_is_changed_in_the_list_of_features_and_every_frame_follows(page, application, qtbot):
    controller = application.controllers.programming
    square = {"name": "level", "kind": "surface_profile", "features": ["plate"], "datums": ["plate"], "upper_tolerance": 0.1}
    assert controller.edit(lambda program: edits.add(program, "dimension", square), "Added.")
    settled(application, qtbot)
    assert row_named(page, "level").frame.datums == ("A",)
    page.side.list.setValue("features")
    menu = page.side.datums.menu("plate")
    letters = menu.actions()[0].menu().actions()
    assert [one.text() for one in letters if one.isChecked()] == ["A"]
    next(one for one in letters if one.text() == "D").trigger()
    settled(application, qtbot)
    assert row_named(page, "level").frame.datums == ("D",)
    assert row_named(page, "level").found.datum_letters == ("D",)
    table = page.side.features.model()
    shown = [(table.index(place, 0).data(), table.index(place, 1).data()) for place in range(table.rowCount())]
    assert shown == [("Ball", ""), ("Plate", "D")]
    assert 'D = "plate"' in controller.text()
    controller.undo()
    assert row_named(page, "level").frame.datums == ("A",)
    menu.close()
