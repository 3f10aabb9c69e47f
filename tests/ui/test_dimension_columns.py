"""Columns of the table of dimensions: as wide as their texts, and what matters most is read in every window and language."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetricsF
from PySide6.QtWidgets import QStyle, QStyleOptionViewItem

from measureapp import __version__
from measureapp.inspection.programming import edits
from tests.ui.test_dimension_table import page, project, row_named, settled, type_in  # noqa: F401 - fixtures
from ui.pages.inspection.dimension_model import Column
from ui.pages.inspection.dimension_table import CELL_ROOM, LEAST_NAME_WIDTH, NAME_SHARE, STATUS_WIDTH, WIDEST_NAME, WIDEST_TOLERANCE

READ_AT_ONCE = (Column.NAME, Column.NOMINAL, Column.MEASURED, Column.UNCERTAINTY, Column.VERDICT)


def test_an_editor_that_is_opened_leaves_the_widths_of_the_columns_as_they_are(application, page, qtbot):  # noqa: F811
    table = page.side.table
    page.window().resize(1600, 900)  # room for all columns: one that is hidden is shown to be edited
    qtbot.waitUntil(lambda: not table.isColumnHidden(Column.NOMINAL))
    before = table.columnWidth(Column.NAME)
    for column in (Column.NOMINAL, Column.TOLERANCE):
        editor = type_in(page, qtbot, "half", column, "1", key=Qt.Key.Key_Escape)
        qtbot.waitUntil(lambda editor=editor: not table.is_editing)
        settled(application, qtbot)
    assert table.columnWidth(Column.NAME) == before and not table._chosen


def test_one_long_tolerance_does_not_take_the_room_of_the_other_columns(application, page, qtbot):  # noqa: F811
    table = page.side.table
    type_in(page, qtbot, "size", Column.TOLERANCE, "+0.1/-0.05")
    settled(application, qtbot)
    usual = table.columnWidth(Column.TOLERANCE)
    type_in(page, qtbot, "size", Column.TOLERANCE, "+123456.789/-98765.4321")
    settled(application, qtbot)
    widest = table.fontMetrics().horizontalAdvance(WIDEST_TOLERANCE) + CELL_ROOM
    assert usual <= table.columnWidth(Column.TOLERANCE) <= widest and not table.isColumnHidden(Column.VERDICT)
    place = next(number for number, row in enumerate(table.shown_rows) if row.name == "size")
    assert table.shown.index(place, Column.TOLERANCE).data(Qt.ItemDataRole.ToolTipRole) == table.texts()[0][2]


def test_the_tolerance_stays_in_sight_where_only_a_few_pixels_of_the_names_are_missing(application, page, qtbot):  # noqa: F811
    table = page.side.table
    type_in(page, qtbot, "half", Column.NAME, "radius of the half of the ball")
    settled(application, qtbot)
    shown = (Column.NOMINAL, Column.TOLERANCE, Column.MEASURED, Column.UNCERTAINTY, Column.VERDICT)
    names = min(table._needs[Column.NAME], WIDEST_NAME)
    room = STATUS_WIDTH + names + sum(map(table._width_for, shown))
    spare = (names - LEAST_NAME_WIDTH) // NAME_SHARE
    assert spare > 3
    for missing, is_hidden in ((0, False), (3, False), (spare + 1, True)):
        table.setFixedWidth(room - missing + table.width() - table.viewport().width())
        qtbot.waitUntil(lambda missing=missing: table.viewport().width() == room - missing)
        assert table.isColumnHidden(Column.TOLERANCE) == is_hidden, missing
        assert table.isColumnHidden(Column.DEVIATION)


@pytest.mark.parametrize("language", ["en", "zh_CN"])
@pytest.mark.parametrize("is_missed", [False, True], ids=["measured", "one-not-measured"])
def test_name_nominal_value_u_and_verdict_are_read_in_the_smallest_window(application, page, qtbot, language, is_missed):  # noqa: F811
    programming, table = application.controllers.programming, page.side.table
    page.window().resize(1280, 720)
    if is_missed:
        lost = {"name": "lost", "shape": "sphere", "point_mm": [300, 0, 0], "radius_mm": 10}
        size = {
            "name": "lost size",
            "kind": "diameter",
            "features": ["lost"],
            "nominal": 120,
            "upper_tolerance": 0.1,
            "lower_tolerance": -0.1,
        }
        programming.edit(lambda program: edits.add(edits.add(program, "feature", lost), "dimension", size), "added")
        settled(application, qtbot)
        assert row_named(page, "lost size").verdict == "not measured"
    application.settings.set_text("language", language)
    application.language.retranslation.finish()
    qtbot.wait(30)
    assert "\n".join(unread(table)) == ""


def unread(table) -> list[str]:
    """Return the cells of the columns that are read at once whose text is hidden, cut or out of sight."""
    found = []
    for place, row in enumerate(table.shown_rows):
        for column in READ_AT_ONCE:
            index = table.shown.index(place, column)
            option = QStyleOptionViewItem()
            table.initViewItemOption(option)
            option.rect = table.visualRect(index)
            table.itemDelegate().initStyleOption(option, index)
            room = table.style().subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, table).width()
            room -= 2 * (table.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, option, table) + 1)
            need = QFontMetricsF(option.font).horizontalAdvance(option.text) + 1  # Qt lays the text out in fractions of a pixel
            if table.isColumnHidden(column) or need > room or option.rect.right() > table.viewport().width():
                found.append(f"{row.name}, {column.name}: {option.text!r} has {room} of {need} px, up to {option.rect.right()}")
    return found


def test_rows_that_another_version_evaluated_are_marked_until_all_are_measured_and_saved(application, page, qtbot, project):  # noqa: F811
    programming, table, notice = application.controllers.programming, page.side.table, page.side.versions
    inspection = application.session.inspection
    older = replace(inspection, dimensions=tuple(replace(one, version="0.0.9") for one in inspection.dimensions))
    project.update_inspection(replace(application.session.measurement, inspection=older))
    application.controllers.project.open(project.path)
    settled(application, qtbot)
    assert shown_u(table) == {"size": "0.0.9", "half": "0.0.9", "flat": "0.0.9"} and notice.isHidden()  # all rows are of one version
    type_in(page, qtbot, "half", Column.NOMINAL, "60")
    settled(application, qtbot)
    assert shown_u(table) == {"size": "0.0.9*", "half": __version__, "flat": "0.0.9*"}
    assert notice.isVisibleTo(page) and "0.0.9" in notice.words.text() and unread(table) == []
    place = next(number for number, row in enumerate(table.shown_rows) if row.name == "size")
    assert "0.0.9" in table.shown.index(place, Column.UNCERTAINTY).data(Qt.ItemDataRole.ToolTipRole)
    assert not any("*" in text for texts in table.texts() for text in texts)  # what is copied are numbers
    programming.save()
    settled(application, qtbot)
    qtbot.mouseClick(notice.again, Qt.MouseButton.LeftButton)
    settled(application, qtbot)
    assert set(shown_u(table).values()) == {__version__} and notice.isHidden() and programming.is_modified
    programming.save()
    settled(application, qtbot)
    stored = project.measurement().inspection.dimensions
    assert {one.version for one in stored} == {__version__} and not programming.is_modified


def shown_u(table) -> dict[str, str]:
    """Return the version of each row, with the mark that U is shown with."""
    shown = {}
    for place, row in enumerate(table.shown_rows):
        mark = "*" if table.shown.index(place, Column.UNCERTAINTY).data().endswith("*") else ""
        shown[row.name] = row.found.version + mark
    return shown
