"""The engineer's role: behind a PIN where one is set, and nothing of it is reachable in operator mode."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence, QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog
from shiboken6 import delete

from measureapp.project.engineer_pin import pin_file, set_pin


def test_without_a_pin_the_role_is_open_and_says_so_once(application, window):
    told = []
    application.session.messageAdded.connect(lambda message: told.append(message.text))
    for _ in range(2):
        window.header.role.setValue("operator")
        assert window.shell.is_operators
        window.shell.operator.bar.engineer.click()
        assert application.session.role == "engineer" and not window.shell.is_operators
        window.shell.operator.bar.engineer._since.invalidate()
    assert told == ["No PIN is set: anyone can leave operator mode."]
    assert window.header.role.value() == "engineer"


def test_with_a_pin_only_the_pin_leads_back(application, window, qtbot):
    set_pin(pin_file(), "2468")
    window.header.role.setValue("operator")
    screens = window.shell.operator
    screens.bar.engineer.click()
    assert screens.screens.currentWidget() is screens.pin and application.session.role == "operator"
    for key in "1111":
        screens.pin.keys[key].click()  # the same digit four times is four digits
    assert screens.pin.field.text() == "1111"
    screens.pin.keys["OK"].click()
    qtbot.waitUntil(lambda: screens.pin.problem.text() == "Wrong PIN.", timeout=10_000)
    assert application.session.role == "operator" and screens.pin.field.text() == ""
    for key in "2468":
        screens.pin.keys[key].click()
    screens.pin.keys["OK"].click()
    qtbot.waitUntil(lambda: application.session.role == "engineer", timeout=10_000)
    assert not window.shell.is_operators and screens.pin.field.text() == ""


def test_too_many_wrong_pins_say_how_long_to_wait_and_the_way_out_once(application, window, qtbot):
    set_pin(pin_file(), "2468")
    window.header.role.setValue("operator")
    screens = window.shell.operator
    screens.bar.engineer.click()
    for _ in range(4):
        screens.pin.problem.setText("")
        screens.pin.field.setText("1111")
        QTest.keyClick(screens.pin.field, Qt.Key.Key_Return)
        qtbot.waitUntil(lambda: screens.pin.problem.text() != "", timeout=10_000)
    assert screens.pin.problem.text() in ("Too many wrong attempts. Wait 1 s.", "Too many wrong attempts. Wait 2 s.")


def test_the_warning_that_no_pin_is_set_ends_when_one_is_set(application, window, qtbot):
    window.header.role.setValue("operator")
    window.shell.operator.bar.engineer.click()
    open_now = application.session.messages
    assert [message.text for message in open_now.open] == ["No PIN is set: anyone can leave operator mode."]
    application.controllers.roles.set_pin("2468")
    qtbot.waitUntil(lambda: not open_now.open, timeout=10_000)


def test_a_start_with_a_pin_begins_in_operator_mode(application, window):
    set_pin(pin_file(), "2468")
    application.controllers.roles.begin()
    assert window.shell.is_operators


def test_in_operator_mode_nothing_of_the_engineers_is_reachable(application, window, qtbot):
    reached = []
    QShortcut(QKeySequence("Ctrl+J"), window, lambda: reached.append("palette"))
    action = QAction("Open", window)
    action.setShortcut(QKeySequence("Ctrl+Shift+O"))
    action.triggered.connect(lambda: reached.append("open"))
    window.addAction(action)
    window.setAcceptDrops(True)
    dialog = QDialog(window)
    dialog.show()
    window.header.role.setValue("operator")
    assert not window.acceptDrops() and not dialog.isVisible()
    assert not window.header.isVisible() and not window.rail.isVisible() and not window.stack.isVisible()
    for keys in ("K", "J", "O"):
        QTest.keyClick(window.windowHandle(), keys, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(window.windowHandle(), "O", Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier)
    QTest.keyClick(window.windowHandle(), Qt.Key.Key_F1)
    assert not reached and not window.help.isVisible()
    window.shell.operator.bar.engineer.click()
    assert window.acceptDrops() and dialog.isVisible() and action.isEnabled()
    dialog.hide()
    window.activateWindow()
    QTest.keyClick(window.windowHandle(), "J", Qt.KeyboardModifier.ControlModifier)
    assert reached == ["palette"]
    dialog.close()
    dialog.deleteLater()


def test_a_window_of_the_engineers_that_was_closed_for_good_meanwhile_does_not_keep_him_out(application, window, qtbot):
    dialog = QDialog(window)
    dialog.show()
    window.header.role.setValue("operator")
    delete(dialog)  # as the set-up does when its PIN is stored at last
    window.shell.operator.bar.engineer.click()
    assert application.session.role == "engineer" and not window.shell.is_operators


def test_without_input_the_role_ends_but_not_while_a_job_runs(application, window, qtbot, monkeypatch):
    set_pin(pin_file(), "2468")
    roles, queue = application.controllers.roles, application.controllers.jobs.queue
    roles.set_idle_minutes(1 / 6000)  # 10 ms

    class Running:
        quiet = False

    monkeypatch.setattr(type(queue), "running", property(lambda self: Running()))
    qtbot.wait(60)
    assert application.session.role == "engineer"
    monkeypatch.setattr(type(queue), "running", property(lambda self: None))
    qtbot.waitUntil(lambda: application.session.role == "operator", timeout=5_000)
    assert not roles._idle.isActive()


def test_input_into_the_window_is_noted(application, window, monkeypatch):
    noted = []
    monkeypatch.setattr(application.controllers.roles, "note_input", lambda: noted.append(True))
    window.shell._watch.watch(window.windowHandle())
    QTest.keyClick(window.windowHandle(), "a")
    QTest.mouseClick(window.windowHandle(), Qt.MouseButton.LeftButton)
    assert len(noted) >= 2


def test_the_engineer_sets_folders_shifts_and_pin(application, window, qtbot, tmp_path):
    window.shell.set_up()
    dialog = window.shell._setup
    assert "No PIN is set" in dialog.state.text()
    dialog.programs.setValue(tmp_path / "released")
    dialog.shifts.setText("05:30, 13:30")
    dialog.pin.setText("1357")
    dialog.again.setText("1358")
    dialog.save.click()
    assert dialog.problem.text() == "The two PINs differ."
    dialog.again.setText("1357")
    dialog.save.click()
    qtbot.waitUntil(lambda: application.controllers.roles.has_pin, timeout=10_000)
    qtbot.waitUntil(lambda: QApplication.activeModalWidget() is None, timeout=10_000)
    from measureapp.project.operator_settings import operator_file, read_operator_settings

    settings = read_operator_settings(operator_file())
    assert settings.programs_folder == tmp_path / "released" and settings.shift_starts == ("05:30", "13:30")


@pytest.mark.parametrize("starts", ["25:00", "noon", ""])
def test_shifts_must_begin_at_times(application, window, starts):
    window.shell.set_up()
    dialog = window.shell._setup
    dialog.shifts.setText(starts)
    dialog.save.click()
    assert dialog.problem.text() and dialog.isVisible()
    dialog.reject()
