"""The list of projects opened last."""

from __future__ import annotations

from pathlib import Path

from measureapp.project.recent_projects import LARGEST, recent_projects, remember_project


def made(folder: Path) -> Path:
    folder.mkdir()
    (folder / "project.json").write_text("{}")
    return folder


def test_the_last_one_is_first_and_none_is_twice(tmp_path: Path) -> None:
    file, folders = tmp_path / "below" / "recent.json", [made(tmp_path / name) for name in "abc"]
    for folder in (*folders, folders[0]):
        remember_project(file, folder, folder.name.upper())
    assert [project.name for project in recent_projects(file)] == ["A", "C", "B"]


def test_only_so_many_are_kept(tmp_path: Path) -> None:
    for number in range(LARGEST + 3):
        remember_project(tmp_path / "recent.json", made(tmp_path / f"p{number:02d}"), str(number))
    assert len(recent_projects(tmp_path / "recent.json")) == LARGEST


def test_a_damaged_list_is_an_empty_one_and_one_that_cannot_be_written_hinders_nothing(tmp_path: Path) -> None:
    file = tmp_path / "recent.json"
    file.write_text('[{"folder": 5}]')
    assert recent_projects(file) == ()
    remember_project(file, made(tmp_path / "p"), "p")
    assert [project.name for project in recent_projects(file)] == ["p"]
    (tmp_path / "blocked").touch()
    remember_project(tmp_path / "blocked" / "recent.json", tmp_path / "p", "p")
