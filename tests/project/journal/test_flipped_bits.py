"""Flipped bits anywhere in a project: found by `verify` with file and viewpoint, and never used silently."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.errors import MeasureError
from measureapp.project import upkeep
from measureapp.project.checks import viewpoint_of
from measureapp.project.folder import ProjectFolder
from tests.project.journal.whole_project import copied

NOT_DATA = (".lock", ".journal.lock", "journal.sqlite-wal", "journal.sqlite-shm")


def flip(path: Path, rng: np.random.Generator) -> None:
    content = bytearray(path.read_bytes())
    content[int(rng.integers(len(content)))] ^= 1 << int(rng.integers(8))
    path.write_bytes(content)


def use_everything(project: Path) -> None:
    """What processing, stitching and reporting read."""
    opened = ProjectFolder.open(project)
    opened.plan(), opened.board_views(), opened.noise(), opened.view_choices(), opened.rig_uncertainty(), opened.measurement()
    opened.program_text(has_nominal=opened.nominal is not None)
    for viewpoint in opened.stored_viewpoints():
        opened.frames.load(viewpoint)


def found_of(template: ProjectFolder, place: Path, count: int, seed: int) -> None:
    project = copied(template, place).path
    use_everything(project)
    rng = np.random.default_rng(seed)
    files = sorted(path for path in project.rglob("*") if path.is_file() and path.name not in NOT_DATA)
    silent = []
    for number in range(count):
        path = files[number % len(files)]
        before = path.read_bytes()
        flip(path, rng)
        name = path.relative_to(project).as_posix()
        damage = upkeep.verify(project).damage
        file = "journal.sqlite" if name.startswith("journal.") else name
        assert [(one.file, one.viewpoint) for one in damage] == [(file, viewpoint_of(name))], name
        assert path.name in damage[0].problem
        try:
            use_everything(project)
        except MeasureError as error:
            assert str(error)
        else:
            silent.append(name)
        path.write_bytes(before)
    read_again = (
        "report/",
        "calibration/sessions/",
        "calibration/history.jsonl",
        "journal.",
    )  # written by this program, or read on their own
    assert not [name for name in silent if not name.startswith(read_again)]
    assert upkeep.verify(project).whole


def test_sixty_flipped_bits_are_found_with_file_and_viewpoint_and_what_is_damaged_is_not_used(
    template: ProjectFolder, tmp_path: Path
) -> None:
    found_of(template, tmp_path / "project", 60, seed=1)


@pytest.mark.slow
def test_a_thousand_flipped_bits_are_found(template: ProjectFolder, tmp_path: Path) -> None:
    found_of(template, tmp_path / "project", 1000, seed=2)


def test_a_file_that_is_missing_cut_or_exchanged_is_named(template: ProjectFolder, tmp_path: Path) -> None:
    project = copied(template, tmp_path / "project").path
    (project / "results" / "clouds" / "view02.ply").unlink()
    left, right = project / "stacks" / "view01" / "left.npy", project / "stacks" / "view01" / "right.npy"
    content = left.read_bytes()
    left.write_bytes(right.read_bytes())
    right.write_bytes(content[:-100])
    (project / "notes.txt").write_text("of the operator")
    found = upkeep.verify(project)
    assert {(one.file, one.viewpoint) for one in found.damage} == {
        ("results/clouds/view02.ply", "view02"),
        ("stacks/view01/left.npy", "view01"),
        ("stacks/view01/right.npy", "view01"),
    }
    assert found.unknown == ("notes.txt",)
