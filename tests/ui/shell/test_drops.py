"""What is dropped on the window is named before it is let go; during a job it is refused in words."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from measureapp.resources import resource
from ui.shell.drops import DropActions, meaning, toml_kind


@pytest.fixture
def done():
    return []


@pytest.fixture
def actions(done):
    def noted(name):
        return lambda path: done.append((name, path.name))

    names = ("open_project", "inspect", "set_nominal", "set_program", "open_plan", "open_rig")
    return DropActions(**{name: noted(name) for name in names}, is_engineer=lambda: True, running=lambda: "", is_measured=lambda: True)


def dropped(path, actions, done):
    found = meaning([path], actions)
    if found.act is not None:
        found.act()
    return found.words, (done.pop()[0] if done else None)


def test_each_kind_of_file_goes_where_it_belongs(tmp_path, actions, done):
    project = tmp_path / "part"
    project.mkdir()
    assert dropped(project, actions, done) == ("part is not a MeasureApp project.", None)
    (project / "project.json").write_text("{}", encoding="utf-8")
    assert dropped(project, actions, done)[1] == "open_project"
    assert dropped(tmp_path / "scan.PLY", actions, done)[1] == "inspect"
    assert dropped(tmp_path / "part.step", actions, done)[1] == "set_nominal"
    assert dropped(tmp_path / "part.stl", actions, done)[1] == "set_nominal"
    without = replace(actions, is_measured=lambda: False)
    assert dropped(tmp_path / "part.stl", without, done)[1] == "inspect"
    assert dropped(tmp_path / "part.step", without, done) == ("A STEP file is a nominal. Open a measured project first.", None)
    assert "cannot use" in dropped(tmp_path / "film.mp4", actions, done)[0]


def test_documents_are_told_apart_by_what_they_hold(tmp_path, actions, done):
    assert toml_kind(resource("rigs/paper.toml")) == "rig"
    programs = sorted(resource("parts").glob("*/program*.toml"))
    assert programs and all(toml_kind(program) == "program" for program in programs)
    plans = sorted(resource("plans").glob("*.toml"))
    assert plans and all(toml_kind(plan) == "plan" for plan in plans)
    torn = tmp_path / "torn.toml"
    torn.write_bytes(b"\xff[[[")
    assert toml_kind(torn) == "" and toml_kind(tmp_path / "gone.toml") == ""
    assert dropped(programs[0], actions, done)[1] == "set_program"


def test_nothing_is_taken_during_a_job(tmp_path, actions):
    found = meaning([tmp_path / "scan.ply"], replace(actions, running=lambda: "Demo: gypsum"))
    assert found.act is None and found.words.startswith("Demo: gypsum is still running.")
    assert meaning([tmp_path, tmp_path], actions).act is None
    assert meaning([tmp_path / "scan.ply"], replace(actions, is_engineer=lambda: False)).words == "This needs the engineer's role."


def test_an_outline_says_what_will_happen_while_a_file_hangs_over_the_window(application, window, tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(window.drops, "_actions", replace(window.drops._actions, inspect=asked.append))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(tmp_path / "scan.ply"))])
    both = Qt.DropAction.CopyAction
    QApplication.sendEvent(window, QDragEnterEvent(QPoint(300, 300), both, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier))
    assert window.drops.outline.isVisible() and window.drops.outline.words == "scan.ply is inspected"
    assert not window.grab().isNull()
    QApplication.sendEvent(window, QDropEvent(QPointF(300, 300), both, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier))
    assert not window.drops.outline.isVisible() and asked == [tmp_path / "scan.ply"]
