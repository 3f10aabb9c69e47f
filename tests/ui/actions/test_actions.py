"""Every action is registered once, found by a few letters, and says why it cannot be used."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from ui.actions.actions import Action, Actions
from ui.actions.search import score
from ui.widgets.basic import Button


@pytest.fixture
def actions(qtbot):
    window = QWidget()
    qtbot.addWidget(window)
    return Actions(window)


def test_an_id_or_a_shortcut_is_taken_once(actions):
    actions.register(Action("a", "A", list, shortcut="Ctrl+A"), Action("page", "P", list, context="plan", shortcut="Ctrl+D", bound=False))
    for double in (
        Action("a", "B", list),
        Action("b", "B", list, shortcut="Ctrl+A"),
        Action("c", "C", list, context="clouds", shortcut="Ctrl+A"),
        Action("d", "D", list, shortcut="Ctrl+D"),
    ):
        with pytest.raises(ValueError, match=r"registered twice|same shortcut"):
            actions.register(double)
    actions.register(Action("other", "O", list, context="clouds", shortcut="Ctrl+D", bound=False))


@pytest.mark.parametrize(
    ("typed", "first"),
    [("op", "Open project…"), ("oprj", "Open project…"), ("dark", "Change the theme"), ("stop", "Stop all axes"), ("", "Open project…")],
)
def test_a_few_letters_find_the_action_that_is_meant(actions, typed, first):
    actions.register(
        Action("open", "Open project…", list, "folder"),
        Action("theme", "Change the theme", list, "dark light"),
        Action("stop", "Stop all axes", list),
        Action("copy", "Copy the top", list),
    )
    assert actions.find(typed)[0].text == first
    assert score("xyz", "Open project") is None


def test_a_word_as_typed_comes_before_its_letters_elsewhere():
    assert score("theme", "Change between light and dark", "night theme") > score("theme", "Edit the tolerance frame")


def test_what_cannot_be_used_comes_last_and_says_why(actions, qtbot):
    ran = []
    actions.register(
        Action("close", "Close project", lambda: ran.append("close"), why_not=lambda: "No project is open."),
        Action("log", "Close the log", lambda: ran.append("log")),
    )
    assert [action.id for action in actions.find("close")] == ["log", "close"]
    with qtbot.waitSignal(actions.refused) as refused:
        assert not actions.perform("close")
    assert refused.args == ["Close project", "No project is open."] and actions.perform("log") and ran == ["log"]


def test_the_palette_runs_what_was_typed_and_refuses_with_a_reason(application, window, qtbot):
    palette = window.palette_
    window.actions_.perform("palette")
    assert palette.isVisible() and len(palette.table.texts()) >= len(window.actions_.all())
    qtbot.keyClicks(palette.line, "go clou")
    assert palette.table.texts()[0][0] == "Go to Clouds"
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert not palette.isVisible() and window.page.name == "clouds"
    window.actions_.perform("palette")
    qtbot.keyClicks(palette.line, "save a copy")
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert palette.isVisible() and palette.hint.text() == "No project is open."
    palette.line.clear()
    qtbot.keyClick(palette.line, Qt.Key.Key_Down)
    assert palette.table.currentIndex().row() == 1
    qtbot.keyClicks(palette.line, "qqqq")
    assert palette.table.texts() == [] and "Nothing fits" in palette.hint.text()
    palette.reject()


def test_the_palette_lists_the_buttons_of_the_page(window, qtbot):
    window.show_page("clouds")
    button = Button("Explode", window.look, tip="Draw the parts apart")
    window.page.layout().addWidget(button)
    button.show()
    pressed = []
    button.clicked.connect(lambda: pressed.append(True))
    window.actions_.perform("palette")
    qtbot.keyClicks(window.palette_.line, "parts apart")
    assert window.palette_.table.texts()[0][:2] == ["Explode", "Clouds"]
    button.setEnabled(False)
    qtbot.keyClick(window.palette_.line, Qt.Key.Key_Return)
    assert window.palette_.hint.text() == "It cannot be used at the moment." and not pressed
    button.setEnabled(True)
    qtbot.keyClick(window.palette_.line, Qt.Key.Key_Return)
    assert pressed and not window.palette_.isVisible()


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ("language", "Settings…"),
        ("theme", "Change between light and dark"),
        ("tolerance", "Go to Inspect"),
        ("delete", "Delete the selected dimensions"),
        ("export pdf", "PDF report…"),
        ("pdf export", "PDF report…"),
        ("report", "Go to Report"),
        ("scale", "Go to Inspect"),
        ("excel", "Dimensions (XLSX)…"),
    ],
)
def test_what_people_call_things_is_found_on_every_page(window, typed, expected):
    assert expected in [action.text for action in window.actions_.find(typed)][:3]


def test_what_needs_a_selection_on_inspect_says_so(window):
    refused = []
    window.actions_.refused.connect(lambda words, reason: refused.append((words, reason)))
    window.show_page("clouds")
    window.actions_.perform("inspection.copy")
    window.show_page("inspection")
    window.actions_.perform("inspection.copy")
    window.actions_.perform("inspection.rename")
    assert refused == [
        ("Duplicate the selected dimensions", "Go to the page Inspect first."),
        ("Duplicate the selected dimensions", "Select dimensions in the table first."),
        ("Rename the selected feature…", "Select one feature in the table first."),
    ]


def test_an_export_from_the_palette_needs_a_measurement(window):
    export = window.actions_.action("report.pdf")
    assert window.actions_.reason(export) == "No part has been measured."


class WithMenu(QWidget):
    """A table with a context menu that has another one inside."""

    def __init__(self) -> None:
        super().__init__()
        self.done: list[str] = []

    def offered_menu(self) -> QMenu:
        menu = QMenu(self)
        menu.addAction("Delete the row\tDel", lambda: self.done.append("deleted"))
        menu.addAction("Restore", list).setEnabled(False)
        menu.addMenu("Datum letter").addAction("B", lambda: self.done.append("B"))
        return menu


def test_the_palette_lists_what_only_menus_have(window, qtbot):
    window.show_page("clouds")
    table = WithMenu()
    window.page.layout().addWidget(table)
    table.show()
    for typed, words in (("delete row", "Delete the row"), ("datum", "Datum letter: B")):
        window.actions_.perform("palette")
        qtbot.keyClicks(window.palette_.line, typed)
        assert window.palette_.table.texts()[0][:2] == [words, "Clouds"]
        qtbot.keyClick(window.palette_.line, Qt.Key.Key_Return)
    assert table.done == ["deleted", "B"]
    window.actions_.perform("palette")
    qtbot.keyClicks(window.palette_.line, "restore")
    qtbot.keyClick(window.palette_.line, Qt.Key.Key_Return)
    assert window.palette_.hint.text() == "It cannot be used at the moment."
    window.palette_.reject()


def test_every_shortcut_is_listed_and_every_action_has_words(window):
    window.actions_.perform("keys")
    listed = {row[0] for row in window.shortcuts.table.texts()}
    assert {"Ctrl+K", "F1", "Ctrl+N", "Ctrl+O", "?", "Esc", "Ctrl+1", "Ctrl+7"} <= listed
    here = {row[0] for row in window.shortcuts.table.texts() if row[2] == "Inspect"}
    assert {"Ctrl+Z", "Ctrl+Y", "Ctrl+S", "Ctrl+F", "F2", "Ctrl+D", "Del", "Alt+Up", "Alt+Down"} <= here
    for action in window.actions_.all():
        assert action.text and not action.text[0].islower() and not action.text.endswith(".")
        assert not action.shortcut or not QKeySequence(action.shortcut).isEmpty()
    window.shortcuts.close()


def test_the_menu_of_the_header_offers_projects_settings_and_exit(window):
    window.header.menu.aboutToShow.emit()
    words = [entry.text().partition("\t")[0] for entry in window.header.menu.actions() if not entry.isSeparator()]
    for expected in ("New project…", "Open project…", "Open recent", "Save a copy as…", "Close project", "Settings…", "Exit"):
        assert expected in words
    copy = next(entry for entry in window.header.menu.actions() if entry.text().startswith("Save a copy"))
    assert not copy.isEnabled() and copy.toolTip() == "No project is open."
