"""A project on disk: two windows, odd paths, what results were computed from, and the times for opening and storing."""

from __future__ import annotations

import json
import logging
import os
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp import __version__
from measureapp.arrays import read_only
from measureapp.cli import main
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.errors import StorageError
from measureapp.project import upkeep
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import publish
from measureapp.project.journal.entries import Entry, FileState
from measureapp.project.journal.state import STORED
from tests.project.journal.whole_project import READBACK, bare_project, copied, stack

_log = logging.getLogger(__name__)


@pytest.fixture
def project(template: ProjectFolder, tmp_path: Path) -> ProjectFolder:
    return copied(template, tmp_path / "project")


def computed(project: ProjectFolder) -> None:
    measured = project.measurement()
    assert measured is not None
    with project.lock():
        project.save_measurement(measured)


def test_a_second_window_is_told_who_holds_the_project(project: ProjectFolder) -> None:
    with project.lock():
        holder = json.loads((project.path / ".lock.json").read_text(encoding="utf-8"))
        assert holder["process"] == os.getpid() and holder["computer"] and holder["since"]
        with pytest.raises(StorageError, match=r"in use by another window or command: this program, user \w+ at .+, since 20"):
            ProjectFolder.open(project.path).lock().__enter__()
        other = holder | {"process": 1, "program": "measureapp scan", "user": "eva", "computer": "cell-2"}
        (project.path / ".lock.json").write_text(json.dumps(other), encoding="utf-8")
        with pytest.raises(StorageError, match="measureapp scan, process 1, user eva at cell-2, since"):
            ProjectFolder.open(project.path).lock().__enter__()
    assert not (project.path / ".lock.json").exists()


def test_one_window_sees_what_another_one_stores(project: ProjectFolder) -> None:
    watching = ProjectFolder.open(project.path)
    assert watching.stored_viewpoints() == ("view01", "view02")
    with project.lock():
        project.frames.store(stack("view03"))
    assert watching.stored_viewpoints() == ("view01", "view02", "view03")
    assert watching.frames.load("view03").viewpoint_id == "view03"


@pytest.mark.parametrize("name", ["Flügelrad 扇叶 № 7", "with space and 'quote' % #?", "x" * 200 + "/" + "y" * 150])
def test_a_project_works_under_odd_and_long_paths(name: str, tmp_path: Path) -> None:
    project = bare_project(tmp_path / name)
    with project.lock():
        project.frames.store(stack("view01"))
    assert ProjectFolder.open(tmp_path / name).frames.load("view01").viewpoint_id == "view01"
    assert upkeep.verify(tmp_path / name).whole


def test_a_path_that_is_too_long_is_refused_when_the_project_is_created_and_nothing_is_left(tmp_path: Path) -> None:
    place = tmp_path / ("扇" * 80) / ("叶" * 80)
    with pytest.raises(StorageError, match="too long"):
        bare_project(place)
    assert not place.exists()


def test_a_project_moved_to_a_path_that_is_too_long_is_still_read_and_verified(project: ProjectFolder, tmp_path: Path) -> None:
    place = tmp_path / ("扇" * 80) / ("叶" * 80)
    place.parent.mkdir()
    project.path.rename(place)
    again = ProjectFolder.open(place)
    assert again.frames.load("view01").viewpoint_id == "view01"
    assert upkeep.verify(place).whole
    with pytest.raises(StorageError, match="too long"), again.lock():
        pass


def test_results_name_what_they_were_computed_from(project: ProjectFolder) -> None:
    computed(project)
    document = json.loads((project.results / "measurement.json").read_text(encoding="utf-8"))
    assert set(document["inputs"]) == {"calibration", "noise", "plan", "program", "nominal", "choices", "limits", "stacks", "version"}
    assert document["inputs"]["version"] == __version__ and document["inputs"]["calibration"]
    assert set(document["inputs"]["stacks"]) == {"view01", "view02"}
    assert project.stale_results() == ()


def test_results_of_another_calibration_program_or_stack_are_recognised(project: ProjectFolder, capsys) -> None:
    computed(project)
    assert main(["process", str(project.path), "--check"]) == 0
    calibration = project.require_calibration()
    with project.lock():
        project.save_calibration(replace(calibration, provenance=replace(calibration.provenance, created="2026-11-24T10:00:00+00:00")))
        project.save_program('name = "another"\nalignment = "none"\n')
        project.frames.store(stack("view01", seed=4))
        project.frames.store(stack("view04"))
    assert set(project.stale_results()) == {
        "The results were computed with another calibration.",
        "The results were computed with another inspection program.",
        "The results were computed with other images of viewpoint view01.",
        "Viewpoint view04 is stored, but the results were computed without it.",
    }
    capsys.readouterr()
    assert main(["process", str(project.path), "--check"]) == 1
    assert "another calibration" in capsys.readouterr().out
    assert main(["verify", str(project.path), "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)["stale"]) == 4


def test_files_that_are_missing_or_cut_are_found_without_reading_any(project: ProjectFolder) -> None:
    assert project.journal.size_problems() == ()
    (project.path / "stacks" / "view01" / "left.npy").unlink()
    path = project.path / "stacks" / "view02" / "left.npy"
    path.write_bytes(path.read_bytes()[:100])
    missing, cut = project.journal.size_problems()
    assert "view01/left.npy is missing" in missing and "view02/left.npy has 100 bytes" in cut


def test_a_project_of_sixteen_gigabytes_opens_without_reading_them(tmp_path: Path) -> None:
    """The files are sparse: a disk that reads them would take a minute for their hashes."""
    project = bare_project(tmp_path / "project")
    with project.lock():
        for number in range(26):
            files = {}
            for camera in ("left", "right", "upper"):
                path = project.path / "stacks" / f"view{number:02}" / f"{camera}.npy"
                path.parent.mkdir(parents=True, exist_ok=True)
                with path.open("wb") as file:
                    file.truncate(205_000_000)
                files[publish.relative_name(project.path, path)] = FileState(205_000_000, "0" * 64)
            publish.record(project.path, Entry(STORED, files, f"view{number:02}"))
    started = time.process_time()
    opened = ProjectFolder.open(project.path)
    assert len(opened.stored_viewpoints()) == 26 and opened.journal.size_problems() == ()
    assert opened.plan() is None and opened.calibration() is None
    used_s = time.process_time() - started
    _log.warning("Opening 16 GB: %.3f s", used_s)
    assert used_s < 2.0  # of this process: also on a busy computer


@pytest.mark.slow
def test_a_viewpoint_of_605_megabytes_is_durable_in_one_and_a_half_times_the_raw_write(tmp_path: Path) -> None:
    project = bare_project(tmp_path / "project")
    rng = np.random.default_rng(1)
    cameras = ("left", "right", "upper")
    images = {name: read_only(rng.integers(0, 255, (5, 8, 1944, 2592), np.uint8)) for name in cameras}
    whole = sum(one.nbytes for one in images.values())
    ratios = []
    with project.lock():
        for attempt in range(5):
            raw_s = _raw_write(tmp_path / "raw", images)
            started = time.perf_counter()
            project.frames.store(FringeStack(f"view{attempt}", PAPER_PATTERNS, (5, 4, 3, 2, 1), images, 255, READBACK))
            stored_s = time.perf_counter() - started
            ratios.append(stored_s / raw_s)
            _log.warning("%.0f MB: raw %.2f s, durable viewpoint %.2f s, ratio %.2f", whole / 1e6, raw_s, stored_s, ratios[-1])
            project.frames.discard(f"view{attempt}")
    assert min(ratios) < 1.5


def _raw_write(folder: Path, images: dict[str, np.ndarray]) -> float:
    """Write the same bytes with nothing else, sync them, and return the seconds."""
    folder.mkdir(exist_ok=True)
    started = time.perf_counter()
    for name, pixels in images.items():
        with (folder / name).open("wb", buffering=0) as file:
            view = memoryview(pixels.reshape(-1))
            while view:
                view = view[file.write(view[: 8 * 2**20]) :]
            os.fsync(file.fileno())
    seconds = time.perf_counter() - started
    for name in images:
        (folder / name).unlink()
    return seconds
