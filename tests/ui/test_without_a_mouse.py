"""Clouds and Inspect are used with the keys alone, read by a screen reader, and fit the smallest window."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton, QAbstractSpinBox, QComboBox, QLabel, QSizePolicy, QWidget

from ui.widgets.segments import Segments

PAGES = ("clouds", "inspection")
PATIENCE_MS = 20_000


@pytest.fixture
def filled(application, window, rig, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.set_rig(rig)
    application.session.set_measurement(measurement, {})
    return window


def focusable(page: QWidget) -> list[QWidget]:
    return [
        widget
        for widget in page.findChildren(QWidget)
        if widget.isVisible() and widget.isEnabled() and widget.focusPolicy() & Qt.FocusPolicy.TabFocus and not widget.focusProxy()
    ]


def squeezed(page) -> list[str]:
    """Return what has less room than it needs, lies beyond the page's edge, or over its neighbour."""
    found = []
    for widget in page.findChildren(QWidget):
        is_words = (
            isinstance(widget, QLabel) and not widget.wordWrap() and widget.sizePolicy().horizontalPolicy() != QSizePolicy.Policy.Ignored
        )
        if not widget.isVisible() or not (is_words or isinstance(widget, QAbstractButton | QComboBox | QAbstractSpinBox | Segments)):
            continue
        right = widget.mapTo(page, QPoint(widget.width(), 0)).x()
        if right > page.width() or widget.width() < min(widget.minimumSizeHint().width(), widget.maximumWidth()):
            found.append(f"{widget.accessibleName() or getattr(widget, 'text', str)()}: {widget.width()} px, up to {right}")
    return found


def unfolded(window, name: str):
    """Show a page with every bar below its picture."""
    window.show_page(name)
    page = window.pages[name]
    for name in ("filter_button",):
        if hasattr(page, name):
            getattr(page, name).setChecked(True)
    if hasattr(page, "program"):
        page.program.bar.show()
        page.grow.show()
    return page


def test_everything_that_can_be_reached_by_tab_has_a_name(filled):
    for name in PAGES:
        reached = focusable(unfolded(filled, name))
        assert len(reached) > 8, name
        assert [widget for widget in reached if not (widget.accessibleName() or getattr(widget, "text", lambda: "")())] == [], name


def test_tab_reaches_everything_and_comes_back(filled):
    for name in PAGES:
        page = unfolded(filled, name)
        wanted, met = set(focusable(page)), set()
        widget = page
        for _ in range(2000):
            widget = widget.nextInFocusChain()
            met.add(widget)
        assert wanted <= met, name


def test_in_the_smallest_window_nothing_is_cut_off_or_lies_over_its_neighbour(filled, qtbot):
    filled.resize(filled.minimumSize())
    for name in PAGES:
        page = unfolded(filled, name)
        for folded in (True, False):
            filled.properties.fold(folded)
            qtbot.waitUntil(lambda page=page: squeezed(page) == [], timeout=PATIENCE_MS)


def test_the_space_bar_hides_a_view_and_shows_it_again(filled, qtbot):
    filled.show_page("clouds")
    page = filled.pages["clouds"]
    page.table.selectRow(2)
    for hidden in ({"view-03"}, set()):
        qtbot.keyClick(page.table, Qt.Key.Key_Space)
        assert page.table.hidden == hidden


@pytest.mark.parametrize("name", PAGES)
def test_escape_ends_measuring_and_undo_takes_a_point_back(filled, name, qtbot):
    filled.show_page(name)
    page = filled.pages[name]
    page.setFocus()
    page.distance.button.setChecked(True)
    qtbot.waitUntil(lambda: not page.is_composing, timeout=PATIENCE_MS)
    page.view.pointPicked.emit(0, 5)
    assert page.distance.can_undo and page.undo.isVisible()
    page.undo_last()
    assert not page.distance.can_undo
    page.end_clicking()
    assert not page.distance.is_on


def test_the_picture_turns_comes_closer_and_is_picked_from_by_keys(filled, application, qtbot):
    from ui.viewport.backend import missing_graphics

    if missing_graphics():
        pytest.skip("no graphics")
    application.session.set_graphics("ready")
    filled.show_page("clouds")
    page = filled.pages["clouds"]
    qtbot.waitUntil(lambda: not page.is_composing and page.view.is_live, timeout=PATIENCE_MS)
    page.view.screenshot()
    camera = page.view.stage.scene.camera
    before, scale = camera.vtk.GetPosition(), camera.mm_per_px
    page.view.setFocus()
    qtbot.keyClick(page.view, Qt.Key.Key_Right)
    assert camera.vtk.GetPosition() != before and camera.mm_per_px == pytest.approx(scale)
    qtbot.keyClick(page.view, Qt.Key.Key_Plus)
    assert camera.mm_per_px == pytest.approx(scale / 1.25)
    page.view.screenshot()
    with qtbot.waitSignal(page.view.pointPicked):
        qtbot.keyClick(page.view, Qt.Key.Key_Return)
    qtbot.keyClick(page.view, Qt.Key.Key_Home)
    page.view.screenshot()
    assert camera.keep_framed and camera.mm_per_px > 1.1 * scale / 1.25
