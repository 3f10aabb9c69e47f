"""A small project with a file of every kind: that of the version before, with its journal, stacks and views of the board."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np

from measureapp.arrays import read_only
from measureapp.data.board import BoardView
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.geometry.transform import RigidTransform
from measureapp.project.atomic import write_text
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig

ARCHIVE = Path(__file__).parents[2] / "data" / "project_of_version_before.zip"
READBACK = AxisReadback(RigidTransform.from_vector([0.1, 0.2, 0.3], [400, 0, 500], "base", "flange"), 12.5, 0.25)


def stack(name: str, seed: int = 0, cameras: tuple[str, ...] = ("left", "right"), rows: int = 12) -> FringeStack:
    """Images of 16 px in ``rows`` rows, in two exposures."""
    rng = np.random.default_rng([seed, *name.encode()])
    images = {camera: read_only(rng.integers(0, 255, (2, PAPER_PATTERNS.count, rows, 16), np.uint8)) for camera in cameras}
    return FringeStack(name, PAPER_PATTERNS, (100_000, 50_000), images, 255, READBACK, approach="2026-05-04T10:00:00+00:00")


def board_view(name: str) -> BoardView:
    rng = np.random.default_rng(list(name.encode()))
    return BoardView(name, {"left": read_only(rng.integers(0, 255, (12, 16), np.uint8))}, READBACK)


def bare_project(place: Path) -> ProjectFolder:
    """A new project without any images."""
    return ProjectFolder.create(place, ProjectSettings(name="small", part="gypsum", rig=read_rig("paper")))


def whole_project(place: Path) -> ProjectFolder:
    """The golden project of the version before, taken over, with two stacks, two views of the board and reports."""
    shutil.unpack_archive(ARCHIVE, place)
    project = ProjectFolder.open(place)
    with project.lock():
        for name in ("view01", "view02"):
            project.frames.store(stack(name))
        for name in ("board01", "board02"):
            project.save_board_view(board_view(name))
        write_text(project.report_csv, "name,measured\na,180.0\n")
    return project


def copied(template: ProjectFolder, place: Path) -> ProjectFolder:
    """A copy of a project; much faster than to store everything again."""
    shutil.copytree(template.path, place)
    return ProjectFolder.open(place)


def contents_of(place: Path) -> dict[str, bytes]:
    """Every file of a folder that matters, with its bytes."""
    return {
        path.relative_to(place).as_posix(): path.read_bytes()
        for path in sorted(place.rglob("*"))
        if path.is_file() and not path.name.startswith((".lock", ".journal", "journal."))
    }
