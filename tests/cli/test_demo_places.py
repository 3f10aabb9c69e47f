"""A demo that cannot be made, or not there: it is refused, and what was there stays as it was."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from tests.cli.refusal import refused


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["--part", "spanner"], "spanner"),
        (["--part", "spanner.step"], "spanner.step"),
        (["--viewpoints", "0"], "0 viewpoints"),
        (["--viewpoints", "-3"], "-3 viewpoints"),
        (["--viewpoints", "many"], "--viewpoints"),
        (["--resolution", "tiny"], "tiny"),
        (["--seed", "-1"], "--seed"),
    ],
)
def test_a_demo_of_something_impossible_is_refused(arguments: list[str], named: str, tmp_path: Path, capsys) -> None:
    assert named in refused(capsys, ["demo", *arguments, "--out", str(tmp_path / "out")])
    assert list(tmp_path.iterdir()) == []


def a_file(out: Path) -> None:
    out.write_text("dear reader")


def below_a_file(out: Path) -> None:
    out.parent.rmdir()
    out.parent.write_text("dear reader")


def something_else(out: Path) -> None:
    out.mkdir()
    (out / "letter.txt").write_text("dear reader")


def another_project(out: Path) -> None:
    ProjectFolder.create(out, ProjectSettings(name="another", part="gear", rig=read_rig("paper")))


def a_damaged_project(out: Path) -> None:
    another_project(out)
    (out / "project.json").write_text('{"schema_version": 1')


def not_writable(out: Path) -> None:
    if os.name != "posix" or os.geteuid() == 0:
        pytest.skip("everything can be written to")
    out.parent.chmod(0o500)


@pytest.mark.parametrize("prepared", [a_file, below_a_file, something_else, another_project, a_damaged_project, not_writable])
def test_a_demo_into_a_place_that_is_taken_leaves_it_as_it_was(prepared: Callable[[Path], None], tmp_path: Path, capsys) -> None:
    out = tmp_path / "folder" / "out"
    out.parent.mkdir()
    prepared(out)
    before = {path: path.read_bytes() if path.is_file() else None for path in tmp_path.rglob("*")}
    assert "out" in refused(capsys, ["demo", "--resolution", "quarter", "--viewpoints", "2", "--out", str(out)])
    assert {path: path.read_bytes() if path.is_file() else None for path in tmp_path.rglob("*")} == before
