"""Editing a rig in the window: forms, problems, saving, and drivers from outside."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QLineEdit

from measureapp.data.rig import DriverChoice, MotionRules
from measureapp.devices.plugin_loader import load_all
from measureapp.devices.plugin_permission import fingerprint
from measureapp.project.rig_file import read_rig, write_rig
from measureapp.resources import resource, user_plugin_folder
from ui.pages.rig.rig_editor import RigEditor
from ui.widgets.field_editors import TableEditor

PATIENCE_MS = 20_000
NAMES = ("left", "right", "upper", "projector", "robot", "guide", "table")


@pytest.fixture(scope="module")
def offers():
    return load_all()


@pytest.fixture
def composed(rig):
    """The reference rig with a driver for each device."""
    drivers = dict.fromkeys(NAMES[:3], "camera_folder") | {
        "projector": "projector_second_screen",
        "robot": "robot_generic_tcp",
        "guide": "axis_modbus",
        "table": "axis_modbus",
    }
    settings = {"guide": {"drive": "toyo_xc100", "link": "bus"}, "table": {"drive": "oriental_az", "link": "bus"}}
    devices = {name: DriverChoice(driver=driver, settings=settings.get(name, {})) for name, driver in drivers.items()}
    changes = {"driver": "", "devices": devices, "links": {"bus": {"port": "COM3"}}, "motion": MotionRules(settle_s=0.5)}
    return rig.model_copy(update=changes)


@pytest.fixture
def edited(application, qtbot, offers):
    """Return a function that opens the editor of a rig."""

    def opened(rig, file=None) -> RigEditor:
        editor = RigEditor(application.look, rig, file, offers)
        qtbot.addWidget(editor)
        editor.show()
        for name in editor.sections:
            editor.show_section(name)
        return editor

    return opened


def enter(editor, section, part, field, text):
    """Type into a field of a section."""
    editor.show_section(section)
    line = editor.parts[section][part].editors[field].line
    line.setText(text)
    line.textEdited.emit(text)


def test_what_was_opened_and_looked_at_is_unchanged(edited, rig, composed):
    assert edited(rig).value() == rig
    assert edited(composed).value() == composed


def test_fields_of_every_section_can_be_changed(edited, composed):
    editor = edited(composed)
    enter(editor, "rig", "fields", "name", "My cell")
    enter(editor, "motion", "fields", "settle_s", "1.5")
    enter(editor, "left", "fields", "serial", "2200")
    driver = editor.parts["robot"]["driver"]
    driver.settings.editors["host"].line.setText("10.0.0.7")
    editor.parts["links"]["link"]._rows[0][1].editors["usb_serial"].line.setText("FT123")
    found = editor.value()
    assert (found.name, found.motion.settle_s, found.camera("left").serial) == ("My cell", 1.5, "2200")
    assert found.devices["robot"].settings == {"host": "10.0.0.7"}
    assert found.links["bus"]["usb_serial"] == "FT123"


def test_a_problem_is_stated_once_where_it_is_and_keeps_the_rig_from_being_saved(edited, composed, tmp_path):
    editor = edited(composed, tmp_path / "mine.toml")
    enter(editor, "motion", "fields", "settle_s", "soon")
    assert editor.problem_words.text() == "Motion: Settling time: Enter a number."
    assert editor.parts["motion"]["fields"]._notes["settle_s"].text() == "Enter a number."
    assert not editor.save.isEnabled()
    assert not editor.save_as.isEnabled()
    enter(editor, "motion", "fields", "settle_s", "2")
    assert editor.problem() == ""
    assert editor.save.isEnabled()


def test_a_setting_that_the_driver_refuses_is_stated_below_it(edited, composed):
    editor = edited(composed)
    settings = editor.parts["robot"]["driver"].settings
    settings.editors["port"].line.setText("0")
    settings.edited.emit()
    assert editor.problem() == "Robot: Settings, port: Must be at least 1."
    assert settings._notes["port"].text() == "Must be at least 1."


def test_a_link_that_is_not_described_is_named(edited, composed):
    editor = edited(composed.model_copy(update={"links": {}}))
    assert editor.problem() == "Linear guide: Settings, link: There is no link bus. Add it under Links."
    editor.show_section("links")
    editor.parts["links"]["link"].add.click()
    assert editor.problem() == ""
    assert editor.value().links == {"bus": {}}


def test_a_rig_with_one_driver_can_get_one_for_each_device_and_back(edited, rig):
    editor = edited(rig)
    editor.mode.setValue("devices")
    assert editor.problem() == "Camera left: Driver: Choose a driver."
    editor.show_section("left")
    box = editor.parts["left"]["driver"].box
    assert box.findData("axis_modbus") < 0
    box.setCurrentIndex(box.findData("camera_folder"))
    assert editor.problem().startswith("Camera right")
    editor.show_section("rig")
    editor.mode.setValue("whole")
    assert editor.value() == rig


def test_settings_come_back_with_the_driver_that_they_belong_to(edited, composed):
    editor = edited(composed)
    driver = editor.parts["guide"]["driver"]
    driver.settings.editors["speed"].line.setText("42")
    before = driver.box.currentIndex()
    driver.box.setCurrentIndex(driver.box.findData("axis_modbus") if before < 0 else before)
    left = editor.parts["left"]["driver"]
    left.settings.editors["files"].line.setText("*.tiff")
    left.box.setCurrentIndex(left.box.findData("virtual_rig"))
    left.box.setCurrentIndex(left.box.findData("camera_folder"))
    assert left.raw()["settings"]["files"] == "*.tiff"


def test_a_driver_that_is_not_there_keeps_its_settings_as_text(edited, composed):
    gone = DriverChoice(driver="camera_gone", settings={"depth": 3, "mode": "a"})
    editor = edited(composed.model_copy(update={"devices": {**composed.devices, "left": gone}}))
    assert isinstance(editor.parts["left"]["driver"].settings, TableEditor)
    assert "camera_gone" in editor.parts["left"]["driver"].box.currentText()
    assert editor.value().devices["left"] == gone


def test_comments_of_a_file_are_not_deleted_without_a_warning(edited, composed, tmp_path, monkeypatch):
    path = tmp_path / "mine.toml"
    write_rig(path, composed)
    path.write_text("# wired by hand\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
    editor, asked = edited(composed, path), []
    editor.saveAsked.connect(lambda rig, where: asked.append(where))
    editor.save.click()
    assert asked == []
    assert "mine.toml has comments" in editor.question.words.text()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "other"), ""))
    editor.question.buttons["Save as…"].click()
    assert asked == [tmp_path / "other.toml"]
    editor.save.click()
    editor.question.buttons["Save without comments"].click()
    assert asked[-1] == path


def opened_from_page(application, window, qtbot):
    window.show_page("rig")
    page = window.pages["rig"]
    page.editing.button.click()
    qtbot.waitUntil(lambda: page.editing.editor is not None, timeout=PATIENCE_MS)
    return page, page.editing.editor


def test_the_saved_rig_is_the_one_to_work_with(application, window, rig, qtbot, tmp_path, monkeypatch):
    application.session.set_rig(rig)
    page, editor = opened_from_page(application, window, qtbot)
    assert not editor.save.isVisible(), "a rig that comes with the program is never overwritten"
    assert not page.rigs.isEnabled()
    enter(editor, "rig", "fields", "name", "My cell")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "mine.toml"), ""))
    editor.save_as.click()
    qtbot.waitUntil(lambda: page.editing.editor is None, timeout=PATIENCE_MS)
    assert application.session.rig == read_rig(tmp_path / "mine.toml")
    assert application.session.rig.name == page.rigs.currentText() == "My cell"
    assert application.session.rig_file == tmp_path / "mine.toml"
    assert page.rigs.isEnabled()


def test_a_rig_that_cannot_be_saved_stays_open_with_the_reason(application, window, rig, qtbot, tmp_path):
    application.session.set_rig(rig)
    page, editor = opened_from_page(application, window, qtbot)
    (tmp_path / "file").write_text("", encoding="utf-8")
    editor.saveAsked.emit(editor.value(), tmp_path / "file" / "mine.toml")
    qtbot.waitUntil(lambda: "cannot be written" in editor.problem_words.text(), timeout=PATIENCE_MS)
    assert page.editing.editor is editor
    editor.reject()


def test_cancel_changes_nothing(application, window, rig, qtbot):
    application.session.set_rig(rig)
    page, editor = opened_from_page(application, window, qtbot)
    enter(editor, "rig", "fields", "name", "My cell")
    editor.cancel.click()
    editor.question.buttons["Discard changes"].click()
    assert application.session.rig is rig
    assert page.editing.editor is None
    assert page.editing.button.isEnabled()


def test_an_operator_cannot_edit_a_rig(application, window, rig, qtbot):
    application.session.set_rig(rig)
    page, _ = opened_from_page(application, window, qtbot)
    window.header.role.setValue("operator")
    assert page.editing.editor is None
    assert not page.editing.button.isVisible()


@pytest.mark.parametrize("answer", ["Allow", "Cancel"])
def test_a_driver_from_outside_is_loaded_once_a_person_has_allowed_its_fingerprint(
    application, window, rig, qtbot, tmp_path, monkeypatch, answer
):
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    folder = user_plugin_folder() / "mine"
    shutil.copytree(resource("plugin_template"), folder)
    application.session.set_rig(rig)
    _, editor = opened_from_page(application, window, qtbot)
    editor.show_section("drivers")
    row = editor.drivers_list.selected()
    assert row.folder == folder
    assert editor.drivers_list.allow.isVisible()
    question = editor.question
    editor.drivers_list.allow.click()
    qtbot.waitUntil(question.isVisible, timeout=PATIENCE_MS)
    assert str(folder) in question.words.text()
    assert fingerprint(folder) in question.words.text()
    question.buttons[answer].click()
    qtbot.waitUntil(lambda: not question.isVisible() and not application.controllers.editing.queue.busy, timeout=PATIENCE_MS)
    states = {row.folder: row.problem for row in editor.drivers_list.rows}
    assert (states[folder] == "") == (answer == "Allow")
    assert window.header.devices.text() != "1 driver failed", "a driver that waits for permission is no fault"
    editor.reject()


def test_changes_are_not_lost_by_closing_the_editor_without_a_question(edited, composed):
    editor = edited(composed)
    finished = []
    editor.finished.connect(finished.append)
    enter(editor, "rig", "fields", "name", "My cell")
    editor.close()
    assert not finished
    assert "not saved" in editor.question.words.text()
    editor.question.buttons["Keep editing"].click()
    assert editor.value().name == "My cell"
    editor.cancel.click()
    editor.question.buttons["Discard changes"].click()
    assert finished
    untouched = edited(composed)
    untouched.finished.connect(finished.append)
    untouched.close()
    assert len(finished) == 2


def test_two_links_with_one_name_are_refused(edited, composed):
    editor = edited(composed)
    editor.show_section("links")
    links = editor.parts["links"]["link"]
    links.add.click()
    name = links._rows[1][0]
    assert editor.problem() == ""
    name.setText("bus")
    name.textEdited.emit("bus")
    assert editor.problem() == "Links: Two links have the name bus."
    name.setText("")
    name.textEdited.emit("")
    assert editor.problem() == "Links: Enter a name for each link."


def test_escape_stops_a_connected_rig_and_keeps_the_editor_open(application, window, rig, qtbot):
    application.session.set_rig(rig.at_resolution("quarter"))
    page, editor = opened_from_page(application, window, qtbot)
    page.connect_button.click()
    qtbot.waitUntil(lambda: application.session.cell.connected, timeout=PATIENCE_MS)
    qtbot.keyClick(editor, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: bool(application.session.cell.stopped), timeout=PATIENCE_MS)
    assert page.editing.editor is editor
    editor.reject()


def test_a_rig_is_not_exchanged_under_a_running_job(application, window, rig, qtbot, tmp_path):
    application.session.set_rig(rig)
    _, editor = opened_from_page(application, window, qtbot)
    application.session.set_busy("Scanning")
    editor.saveAsked.emit(editor.value(), tmp_path / "mine.toml")
    assert "Scanning" in editor.problem_words.text()
    assert not (tmp_path / "mine.toml").exists()
    application.session.set_busy("")
    editor.reject()


def test_every_field_has_a_name_for_a_screen_reader(edited, composed):
    editor = edited(composed)
    for name in editor.sections:
        editor.show_section(name)
    nameless = [line.parent() for line in editor.findChildren(QLineEdit) if not line.accessibleName()]
    assert nameless == []
