"""A language is changed while pages, wizards and dialogs are open: nothing that is displayed stays in the language before."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QAbstractListModel, QModelIndex
from PySide6.QtWidgets import QAbstractItemView, QDialog, QWidget

from measureapp.calibrate.draft.estimate import Estimate
from measureapp.calibrate.draft.verdict import BY_THE_ROBOT
from measureapp.calibrate.kinds.table import KINDS
from tests.ui.look.language.displayed import chart_texts, displayed_texts, painted_texts
from ui.controllers.result import Result, ValueRow
from ui.viewport.backend import missing_graphics
from ui.widgets.basic import label
from ui.widgets.data_table import Cell, DataTable, number
from ui.widgets.empty_rows import EmptyRows
from ui.widgets.segments import Segments
from ui.wizards.result_page import ResultPage

PATIENCE_MS = 60_000


@pytest.fixture
def sample(application, window, qtbot):
    """The window with the shipped sample project open, and what runs after its opening done."""
    application.session.set_graphics("failed" if missing_graphics() else "ready", "No graphics in this test.")
    application.controllers.project.open_sample("gypsum")
    qtbot.waitUntil(lambda: application.session.measurement is not None, timeout=PATIENCE_MS)
    settle(application, qtbot)
    return window


def settle(application, qtbot) -> None:
    qtbot.wait(150)
    qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
    qtbot.wait(150)


def all_texts(top: QWidget) -> list[tuple[str, str]]:
    return [*displayed_texts(top), *chart_texts(top), *painted_texts(top)]


def choices(top: QWidget, most: int) -> Iterator[Callable[[], None]]:
    """Yield what selects the first rows of each table of ``top``, one after another: each changes the properties."""
    for view in top.findChildren(QAbstractItemView):
        model = view.model()
        if model is None or isinstance(model, QAbstractListModel) or not view.isVisible():
            continue
        for row in range(min(model.rowCount(), most)):
            yield lambda view=view, row=row: view.setCurrentIndex(view.model().index(row, 0, QModelIndex()))


class Tongues:
    """Changes the language there and back, and gathers what stays English."""

    def __init__(self, speak, left) -> None:
        self._speak, self._left = speak, left
        self.found: set[str] = set()

    def listen(self, place: str, *tops: QWidget) -> None:
        self._speak("zh_CN")
        for top in tops:
            self.found |= {f"{place}: {text}" for text in self._left(all_texts(top))}
        self._speak("en")


@pytest.fixture
def tongues(speaking, english_left) -> Tongues:
    return Tongues(speaking, english_left)


@pytest.mark.parametrize("rows", [1, pytest.param(5, marks=pytest.mark.slow)])
def test_open_pages_follow_the_language(application, sample, qtbot, tongues, rows):
    for name, page in sample.pages.items():
        sample.show_page(name)
        settle(application, qtbot)
        tongues.listen(name, sample)
        for choose in choices(page, rows):
            choose()
            qtbot.wait(50)
            tongues.listen(name, page, sample.properties)
    assert "\n".join(sorted(tongues.found)) == ""


def test_open_wizards_follow_the_language(application, sample, qtbot, tongues):
    page = sample.pages["calibration"]
    for name in KINDS:
        page.open_wizard(name)
        tongues.listen(name, page.wizards[name])
        page.wizards[name].close()
    assert "\n".join(sorted(tongues.found)) == ""


def test_the_result_of_a_wizard_follows_the_language(application, qtbot, tongues):
    page = ResultPage(application.look)
    qtbot.addWidget(page)
    verdict = "Adds 0.021 mm (k = 2), at worst 0.131 mm, to a length of 300 mm in this volume: usable."
    reasons = (BY_THE_ROBOT, "About 2.0 times as many observations, as different from each other, would make it good.")
    row = ValueRow(Estimate("left.fx", 2045.3, 0.21, "px", "Camera left", "Focal length x"), 2045.1, 2044.9)
    page.show_result(
        Result(
            *(None, None, None, verdict, "not proven", reasons, (row,)),
            facts=(("Views used", "7 of 8"), ("Largest residual", "0.012 mm, 01")),
            rejected=(("01", "There are no images of the board."),),
            comparison=verdict,
            has_truth=True,
            has_previous=True,
            held_back=verdict,
        )
    )
    page.show()
    english = {text for _, text in displayed_texts(page)}
    tongues.listen("result", page)
    assert "\n".join(sorted(tongues.found)) == ""
    assert {text for _, text in displayed_texts(page)} == english


def dialogs(window) -> dict[str, Callable[[], object]]:
    """Return what opens each dialog of the window."""
    pages = window.pages
    return {
        "messages": window.messages.begin,
        "settings": window.settings_dialog.begin,
        "palette": window.palette_.begin,
        "shortcuts": window.shortcuts.begin,
        "help": window.show_help,
        "series": pages["report"].open_series,
        "repeats": pages["report"].open_repeats,
        "generate": pages["plan"].ask_generate,
        "automatic": pages["calibration"].open_automatic,
    }


def test_open_dialogs_follow_the_language(application, sample, qtbot, tongues):
    sample.session.tell("No extreme that its neighbours confirm.", "Calibrate again.", "warning")
    for name, begin in dialogs(sample).items():
        begin()
        settle(application, qtbot)
        opened = [one for one in application.window.findChildren(QDialog) if one.isVisible()]
        assert opened, name
        tongues.listen(name, *opened)
        for one in opened:
            one.close()
    assert "\n".join(sorted(tongues.found)) == ""


def test_texts_with_one_translation_become_what_they_were(application, window, qtbot):
    application.settings.set_text("language", "zh_CN")
    made = {words: label(words) for words in ("Dimensions", "Dimension", "Features", "Feature")}
    list_, heading = Segments({"d": "Dimensions", "f": "Features"}, name="List"), label("Dimension")
    for one in (*made.values(), list_, heading):
        qtbot.addWidget(one)
    assert made["Dimension"].text() == made["Dimensions"].text() == "尺寸"
    application.settings.set_text("language", "en")
    application.language.retranslation.finish()
    assert {words: one.text() for words, one in made.items()} == {words: words for words in made}
    assert [list_.button(one).text() for one in "df"] == ["Dimensions", "Features"]


def test_columns_get_the_width_of_their_words(application, qtbot):
    table = DataTable(application.look, ["Feature", "Form"], numeric=[1])
    qtbot.addWidget(table)
    table.set_rows([[Cell("bore"), number("0.1")]])
    table.show()
    english = table.columnWidth(1)
    application.settings.set_text("language", "zh_CN")
    needed = table.fontMetrics().horizontalAdvance("形状误差")
    qtbot.waitUntil(lambda: table.columnWidth(1) >= needed > english, timeout=PATIENCE_MS // 12)
    application.settings.set_text("language", "en")
    qtbot.waitUntil(lambda: table.columnWidth(1) == english, timeout=PATIENCE_MS // 12)


def test_lists_without_rows_say_how_they_are_filled(window):
    for view in (window.pages["plan"].tree, window.pages["clouds"].table):
        words = view.viewport().findChild(EmptyRows)
        assert not words.isHidden() and "yet" in words.text()
