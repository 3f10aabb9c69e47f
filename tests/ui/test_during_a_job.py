"""While a job runs, what would wait for its end without a word is refused at the click, and what only reads goes on."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from tests.ui.test_dimension_table import page, project, settled, type_in  # noqa: F401 - fixtures
from ui.pages.inspection.dimension_model import Column

PATIENCE_MS = 60_000


def last(application) -> tuple[str, str, str]:
    message = application.session.messages[-1]
    return message.level, message.text, message.hint


BUSY = ("warning", "Recomputing is still running.", "Wait until it has finished, or cancel it.")


def test_documents_are_not_exported_of_results_that_a_job_may_replace(application, page, working, tmp_path, monkeypatch):  # noqa: F811
    asked: list[object] = []
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *arguments, **_: asked.append(arguments) or (str(tmp_path / "x.csv"), ""))
    application.window.show_page("report")
    report, queue = application.window.pages["report"], application.controllers.jobs.queue
    working()
    for act in (
        report.exports["csv"].click,
        report.header_button.click,
        report.open_pdf.click,
        lambda: application.controllers.documents.export("csv", tmp_path / "x.csv"),
    ):
        application.session.tell("Something else.", "")
        act()
        assert last(application) == BUSY and not queue._waiting
    assert not asked and not (tmp_path / "x.csv").exists()


def test_the_language_of_the_report_stays_while_a_job_runs(application, page, working):  # noqa: F811
    application.window.show_page("report")
    report = application.window.pages["report"]
    before = report.language.currentData()
    working()
    place = report.language.findData("zh_CN")
    report.language.setCurrentIndex(place)
    report.language.activated.emit(place)
    assert report.language.currentData() == before and last(application) == BUSY
    assert application.settings.text("report_language") == before


def test_the_pages_of_the_report_are_drawn_and_the_series_read_while_a_job_runs(application, page, working, qtbot, monkeypatch):  # noqa: F811
    monkeypatch.undo()  # of the fixture, which draws no pages
    listed: list[object] = []
    application.controllers.series.listed.connect(listed.append)
    working()
    application.window.show_page("report")
    application.controllers.documents.preview()
    application.controllers.series.find()
    report = application.window.pages["report"]
    qtbot.waitUntil(lambda: bool(report.pages) and bool(listed), timeout=PATIENCE_MS)
    assert application.session.busy_with == "Recomputing"


def test_pages_of_a_measurement_that_was_replaced_meanwhile_are_not_shown(application, page, qtbot, monkeypatch):  # noqa: F811
    shown: list[object] = []
    documents = application.controllers.documents
    documents.pagesReady.connect(shown.append)
    documents._show_pages((object(), ()))
    assert not shown
    documents._show_pages((application.session.measurement, ()))
    assert shown == [()]


def test_an_edit_during_a_job_is_refused_with_the_reason(application, page, working, qtbot):  # noqa: F811
    working()
    table = page.side.table
    before = table.texts()
    type_in(page, qtbot, "size", Column.NOMINAL, "121")
    assert last(application) == BUSY and table.texts() == before
    application.session.tell("Something else.", "")
    QTest.keyClick(table, Qt.Key.Key_Delete)
    assert last(application) == BUSY and table.texts() == before
    application.session.tell("Something else.", "")
    application.controllers.programming.save()
    assert last(application) == BUSY


def test_what_was_removed_is_said_to_come_back_by_undo_and_both_name_the_change(application, page, qtbot):  # noqa: F811
    programming, table = application.controllers.programming, page.side.table
    names = [row.name for row in table.rows]
    table.select(next(row.id for row in table.rows if row.name == "size"))
    QTest.keyClick(table, Qt.Key.Key_Delete)
    settled(application, qtbot)
    removed = "Size removed from the inspection program."
    assert last(application) == ("done", removed, "Undo (Ctrl+Z) brings it back.")
    assert page.undo.toolTip() == f"Undo: {removed}"
    QTest.keyClick(table, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    settled(application, qtbot)
    assert last(application)[1] == f"Undone: {removed}" and [row.name for row in table.rows] == names
    for keys in (
        (Qt.Key.Key_Y, Qt.KeyboardModifier.ControlModifier),
        (
            Qt.Key.Key_Z,
            Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
        ),
    ):
        QTest.keyClick(table, *keys)
        settled(application, qtbot)
        assert last(application)[1] == f"Made again: {removed}" and "size" not in [row.name for row in table.rows]
        programming.undo()
        settled(application, qtbot)
