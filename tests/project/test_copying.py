"""A copy of a project is a whole project of its own; what cannot be copied is refused in words, and nothing half-copied stays."""

from __future__ import annotations

import tomllib

import pytest

from measureapp.data.rig import RigDescription
from measureapp.errors import InputError, StorageError
from measureapp.progress import Cancelled
from measureapp.project import copying
from measureapp.project.copying import copy_project
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.upkeep import verify
from measureapp.resources import resource


@pytest.fixture
def project(tmp_path):
    rig = RigDescription.model_validate(tomllib.loads(resource("rigs/paper.toml").read_text(encoding="utf-8")))
    made = ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=rig))
    with made.lock():
        made.save_program('name = "a program"\n')
    return made


def test_a_copy_is_a_whole_project_with_the_name_of_its_folder(project, tmp_path):
    copied = copy_project(project.path, tmp_path / "second part")
    assert copied.name == "second part" and ProjectFolder.open(project.path).name == "part"
    assert copied.program_text(has_nominal=False) == project.program_text(has_nominal=False)
    assert verify(copied.path).whole
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part", "second part"]


def test_a_project_on_a_disk_that_cannot_be_written_to_can_be_copied(project, tmp_path, monkeypatch):
    def refuse():
        raise StorageError("Read-only.", "Copy it.")

    monkeypatch.setattr(copying.os, "access", lambda _path, _mode: False)
    monkeypatch.setattr(ProjectFolder, "lock", lambda _self: refuse())
    monkeypatch.setattr(copying, "accept_changes", lambda _path, _names: None)  # locks the copy
    assert copy_project(project.path, tmp_path / "second").name == "second"


def test_a_folder_that_holds_something_or_lies_in_the_project_is_refused(project, tmp_path):
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "a.txt").write_text("x", encoding="utf-8")
    with pytest.raises(InputError, match="not an empty folder"):
        copy_project(project.path, tmp_path / "full")
    with pytest.raises(InputError, match="inside the project"):
        copy_project(project.path, project.path / "copy")


def test_a_copy_that_is_cancelled_leaves_nothing_behind(project, tmp_path):
    class Impatient:
        def report(self, _done, _total, _note=""):
            raise Cancelled

        def check(self):
            return

    with pytest.raises(Cancelled):
        copy_project(project.path, tmp_path / "second", Impatient())
    assert [path.name for path in tmp_path.iterdir()] == ["part"]


def test_a_disk_that_is_too_small_is_known_before_the_copy(project, tmp_path, monkeypatch):
    monkeypatch.setattr(copying.shutil, "disk_usage", lambda _folder: type("Usage", (), {"free": 10})())
    with pytest.raises(StorageError, match=r"needs 0\.0 GB"):
        copy_project(project.path, tmp_path / "second")
