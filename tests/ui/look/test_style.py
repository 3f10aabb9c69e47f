"""Controls are drawn by the window's style: in the colours of the theme, by name and role, and anew in each theme."""

from __future__ import annotations

import time

import pytest
from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication, QFrame, QLineEdit, QProgressBar, QPushButton, QSpinBox, QTableWidget, QTableWidgetItem

from ui.look.look import Look
from ui.look.style.roles import BUTTONS, FRAMES, TEXTS
from ui.look.theme import Theme
from ui.widgets.basic import Button, label
from ui.widgets.segments import Segments

SHADES = ("light", "dark")


@pytest.fixture
def look(qapp) -> Look:
    made = Look("light")
    made.apply_theme()
    return made


def shown(qtbot, widget, width=200, height=60):
    qtbot.addWidget(widget)
    widget.resize(width, height)
    widget.show()
    return widget


def colour_at(widget, x, y) -> str:
    return widget.grab().toImage().pixelColor(x, y).name().upper()


def test_every_look_names_tokens_of_the_theme():
    theme = Theme.load("light")
    for frame in FRAMES.values():
        assert {frame.fill, frame.border} - {""} <= theme.colours.keys()
    for button in BUTTONS.values():
        fills = {button.fill, button.hover_fill, button.pressed_fill, button.checked_fill, button.text, button.checked_text}
        assert (fills | {button.border, button.hover_border, button.focus_border}) - {""} <= theme.colours.keys()
    assert {text.size for text in TEXTS.values()} <= theme.sizes.keys()


@pytest.mark.parametrize("name", ["card", "sunken", "header"])
def test_a_frame_has_the_ground_that_its_name_asks_for_in_both_themes(qtbot, look, name):
    frame = QFrame()
    frame.setObjectName(name)
    shown(qtbot, frame)
    for shade in SHADES:
        look.set_shade(shade)
        assert colour_at(frame, 100, 30) == look.theme.colours[FRAMES[name].fill].upper()


@pytest.mark.parametrize("role", TEXTS)
def test_a_label_is_written_as_its_role_asks(qtbot, look, role):
    made = shown(qtbot, label("0.012 mm", role))
    assert made.font().pixelSize() == look.theme.sizes[TEXTS[role].size]
    assert made.foregroundRole() == TEXTS[role].colour


def test_the_filled_button_is_the_only_filled_one(qtbot, look):
    for role, fill in (("primary", "accent"), ("stop", "verdict_fail")):
        made = shown(qtbot, Button("Start", look, "", role))
        assert colour_at(made, 4, made.height() // 2) == look.theme.colours[fill].upper()
        assert made.sizeHint().height() == 40
    quiet = shown(qtbot, Button("Start", look, "", "quiet"))
    assert colour_at(quiet, 4, quiet.height() // 2) == look.theme.colours["window"].upper()
    assert quiet.sizeHint().height() == 32


def test_a_choice_that_cannot_be_changed_is_still_seen(qtbot, look):
    segments = shown(qtbot, Segments({"one": "One", "two": "Two"}))
    segments.setEnabled(False)
    grounds = [colour_at(segments.button(name), 6, 8) for name in ("one", "two")]
    assert grounds[0] != grounds[1]


def test_a_button_is_as_wide_as_its_words(qtbot, look):
    short, long = QPushButton("Go"), QPushButton("Go on with the measurement")
    for one in (short, long):
        shown(qtbot, one)
        assert one.sizeHint().width() >= one.fontMetrics().horizontalAdvance(one.text()) + 2 * BUTTONS["normal"].padding_px


def test_an_invalid_editor_has_a_red_border_until_it_is_valid(qtbot, look):
    editor = shown(qtbot, QLineEdit("x"), 200, 32)
    editor.clearFocus()
    for invalid in (True, False):
        editor.setProperty("invalid", invalid)
        editor.style().unpolish(editor)
        editor.style().polish(editor)
        assert (colour_at(editor, 100, 0) == look.theme.colours["verdict_fail"].upper()) == invalid


def test_editors_and_spin_boxes_have_the_height_of_a_control(qtbot, look):
    for editor in (QLineEdit(), QSpinBox()):
        shown(qtbot, editor)
        assert editor.sizeHint().height() == look.theme.sizes["control"]


def test_a_selected_row_keeps_the_colour_of_its_text(qtbot, look):
    table = QTableWidget(1, 1)
    table.setItem(0, 0, QTableWidgetItem(""))
    with qtbot.waitExposed(table):
        shown(qtbot, table, 200, 120)

    def is_tinted() -> None:
        table.selectRow(0)
        cell = table.visualItemRect(table.item(0, 0)).center() + table.viewport().pos()
        assert table.item(0, 0).isSelected()
        assert colour_at(table, cell.x(), cell.y()) == look.theme.colours["accent_soft"].upper()

    qtbot.waitUntil(is_tinted, timeout=30_000)  # rows are laid out and painted when Qt comes to it


def test_a_progress_bar_is_filled_as_far_as_it_is(qtbot, look):
    bar = QProgressBar()
    bar.setRange(0, 100)
    bar.setValue(50)
    shown(qtbot, bar, 200, 6)
    assert colour_at(bar, 50, 3) == look.theme.colours["accent"].upper()
    assert colour_at(bar, 150, 3) == look.theme.colours["sunken"].upper()


def test_an_icon_follows_the_theme_without_being_set_again(qtbot, look):
    icon = look.icon("pass", "text")
    drawn = [icon.pixmap(QSize(24, 24)).toImage()]
    look.set_shade("dark")
    drawn.append(icon.pixmap(QSize(24, 24)).toImage())
    assert look.icon("pass", "text") is icon

    def brightest(image):
        return max(image.pixelColor(x, y).lightness() for x in range(24) for y in range(24) if image.pixelColor(x, y).alpha() > 250)

    assert brightest(drawn[1]) > brightest(drawn[0]) + 100


def test_every_icon_of_the_set_can_be_drawn(look):
    from ui.look.icons import NAMES

    for name in NAMES:
        image = look.icon(name).pixmap(QSize(20, 20)).toImage()
        assert any(image.pixelColor(x, y).alpha() > 0 for x in range(20) for y in range(20)), name


@pytest.mark.timed
def test_the_theme_of_two_thousand_widgets_changes_in_a_tenth_of_a_second(qtbot, look):
    parent = QFrame()
    for number in range(2000):
        label(f"{number}", "soft").setParent(parent)
    shown(qtbot, parent)
    spent = []
    for shade in ("dark", "light") * 3:
        begin = time.perf_counter()
        look.set_shade(shade)
        spent.append(time.perf_counter() - begin)
    assert min(spent) < 0.1


def test_no_style_sheet_is_set_on_the_application(qapp, look):
    application = QApplication.instance()
    assert isinstance(application, QApplication) and application.styleSheet() == ""
