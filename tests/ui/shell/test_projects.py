"""A project is made, copied and closed from the window; what the window showed last comes back."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog

from measureapp.project.folder import ProjectFolder, ProjectSettings
from ui.app import build


@pytest.fixture
def idle(application, qtbot):
    def wait():
        qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=30_000)
        return application.session.messages[-1]

    return wait


def test_a_project_is_made_copied_and_closed(application, window, rig, tmp_path, monkeypatch, idle):
    application.session.set_rig(rig)
    window.actions_.perform("project.new")
    dialog = window.project_menu.new_dialog
    dialog.place.setValue(tmp_path)
    dialog.name.setText("a/b")
    assert not dialog.create.isEnabled() and "cannot contain /" in dialog.problem.text()
    for refused in ("con", "n" * 300):  # what no folder on Windows, and none at all can be called
        dialog.name.setText(refused)
        assert not dialog.create.isEnabled() and "Not every system takes this name" in dialog.problem.text()
    dialog.name.setText("Housing 4711")
    dialog.part.setText("housing")
    dialog.create.click()
    assert idle().level == "done"
    assert application.session.folder == tmp_path / "Housing 4711" and application.session.part == "housing"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "Second"), ""))
    window.actions_.perform("project.copy")
    assert idle().level == "done"
    assert application.session.project_name == "Second" and ProjectFolder.open(tmp_path / "Second").settings.part == "housing"
    window.actions_.perform("project.close")
    assert application.session.folder is None and window.windowTitle() == "MeasureApp"


def test_a_template_of_a_project_is_the_start_of_another(application, window, rig, plan, tmp_path, monkeypatch, idle):
    source = ProjectFolder.create(tmp_path / "first", ProjectSettings(name="first", part="gypsum", rig=rig))
    source.save_plan(plan)
    application.controllers.project.open(source.path)
    assert idle().level == "done"
    names = iter([str(tmp_path / "Cross.mpart"), str(tmp_path / "Second")])
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (next(names), ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "Cross.mpart"), ""))
    window.actions_.perform("project.template")
    assert "The template is saved to" in idle().text
    window.actions_.perform("project.start")
    assert idle().level == "done" and application.session.folder == tmp_path / "Second"
    assert application.session.plan == plan and not ProjectFolder.open(tmp_path / "Second").stored_viewpoints()


def test_without_a_rig_a_new_project_says_what_is_missing(application, window):
    window.project_menu.new()
    dialog = window.project_menu.new_dialog
    assert "Choose one on the page Rig first." in dialog.problem.text() and not dialog.create.isEnabled()
    dialog.reject()


def test_page_theme_and_size_come_back_at_the_next_start(application, window, qtbot, qapp):
    window.show_page("clouds")
    window.actions_.perform("theme")
    assert application.look.theme.shade == "dark"
    window.resize(1400, 800)
    window.close()
    again = build(qapp)
    qtbot.addWidget(again.window)
    assert again.window.page.name == "clouds" and again.look.theme.shade == "dark"
    assert again.settings.numbers("window")[2:4] == (1400, 800)  # as far as the screen allows, which is small here
    assert again.settings.file == Path.home() / "MeasureApp" / "settings.ini"
    again.settings.set_text("theme", "light")
    assert again.look.theme.shade == "light"
    again.controllers.end(5_000)
    again.window.close()


def test_the_settings_dialog_changes_the_settings_at_once(application, window):
    window.actions_.perform("settings")
    dialog, settings = window.settings_dialog, application.settings
    dialog.theme.setValue("dark")
    assert settings.text("theme") == "dark" and application.look.theme.shade == "dark"
    application.session.set_role("operator")
    assert settings.text("role") == "operator"
    assert not window.actions_.perform("project.new") and window.project_menu.new_dialog is None
    assert application.session.messages[-1].text == "New project…: This needs the engineer's role."
    application.session.set_role("engineer")
    dialog.forget.click()
    assert dialog.forgotten.text() == "Forgotten."
    dialog.close()
