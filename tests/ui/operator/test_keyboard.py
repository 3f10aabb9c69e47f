"""Keys on the screen type serial number, order and PIN where there is no keyboard; a bar-code scanner works beside them."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QGuiApplication, QMouseEvent, QPointingDevice
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

LEAST_PX = 48


@pytest.fixture
def identify(workshop):
    workshop.screens.home.grid.buttons[0].click()
    workshop.qtbot.waitUntil(workshop.screens.identify.isVisible)
    workshop.window.activateWindow()
    workshop.screens.identify.fields["serial"].setFocus()
    return workshop.screens.identify


def press(keyboard, text: str) -> None:
    for letter in text:
        keyboard.keys[letter].click()


@cache
def finger() -> QPointingDevice:
    """Return a touch screen; it is kept, since Qt keeps it as well."""
    return QTest.createTouchDevice()


def touch(widget) -> None:
    place = QPointF(widget.rect().center())
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    event = QMouseEvent(QMouseEvent.Type.MouseButtonPress, place, widget.mapToGlobal(place), left, left, none, finger())
    QApplication.sendEvent(widget, event)


def test_a_field_touched_by_a_finger_brings_the_keys_and_a_mouse_does_not(workshop, identify):
    keyboard, field = workshop.screens.keyboard, identify.fields["order"]
    QTest.mouseClick(field, Qt.MouseButton.LeftButton)
    assert not keyboard.isVisible()
    touch(field)
    assert keyboard.isVisible()
    keyboard.hide_button.click()
    assert not keyboard.isVisible()


def test_keys_type_letters_digits_and_corrections_into_the_field(workshop, identify):
    workshop.screens.strip.keyboard.click()
    keyboard, field = workshop.screens.keyboard, identify.fields["serial"]
    assert keyboard.isVisible() and field.hasFocus()
    press(keyboard, "SN-12")
    keyboard.keys["⌫"].click()
    press(keyboard, "7")
    keyboard.keys["⇧"].click()
    assert keyboard.keys["A"].text() == "a"
    press(keyboard, "A ")
    assert field.text() == "SN-17a "
    assert identify.value().serial == "SN-17a"


def test_there_are_no_keys_where_nothing_can_be_typed(workshop, identify):
    keyboard, button = workshop.screens.keyboard, workshop.screens.strip.keyboard
    identify.next.setFocus()
    button.click()
    assert keyboard.isVisible() and identify.fields["serial"].hasFocus()
    workshop.operator.identify(identify.value())
    workshop.qtbot.waitUntil(workshop.screens.load.isVisible)
    button.click()
    assert not keyboard.isVisible()


def test_enter_goes_on_as_on_a_keyboard(workshop, identify):
    workshop.screens.strip.keyboard.click()
    keyboard = workshop.screens.keyboard
    press(keyboard, "A1")
    keyboard.keys["\r"].click()
    workshop.qtbot.waitUntil(workshop.screens.load.isVisible)


def test_fast_presses_are_no_bar_code_and_a_scanned_code_still_is_one(workshop, identify, monkeypatch):
    codes, handle = [], workshop.window.windowHandle()
    workshop.screens.scanner.scanned.connect(codes.append)
    workshop.screens.strip.keyboard.click()
    press(workshop.screens.keyboard, "GC-180")
    QTest.keyClick(handle, Qt.Key.Key_Tab)
    assert codes == []
    for letter in "GC-180|X7":
        QTest.keyClick(handle, letter)
    QTest.keyClick(handle, Qt.Key.Key_Return)
    assert codes == ["GC-180|X7"]


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_every_key_is_large_enough_and_nothing_is_pushed_out(workshop, identify, size):
    workshop.window.resize(*size)
    workshop.screens.strip.keyboard.click()
    workshop.qtbot.wait(50)
    keyboard = workshop.screens.keyboard
    keys = [*keyboard.keys.values(), keyboard.hide_button]
    assert min(min(key.width(), key.height()) for key in keys) >= LEAST_PX
    assert all(not key.visibleRegion().isEmpty() for key in keys)
    assert all(field.visibleRegion().boundingRect().height() >= LEAST_PX for field in identify.fields.values())
    assert identify.next.visibleRegion().boundingRect().height() >= LEAST_PX


def test_the_keys_hide_where_the_system_shows_its_own(workshop, identify, monkeypatch):
    system_keys = SimpleNamespace(isVisible=lambda: True)
    workshop.screens.strip.keyboard.click()
    monkeypatch.setattr(QGuiApplication, "inputMethod", lambda: system_keys)
    workshop.screens.keys._follow_system()
    assert not workshop.screens.keyboard.isVisible()
    touch(identify.fields["order"])
    assert not workshop.screens.keyboard.isVisible()
