"""A project is processed only where its memory suffices, with fewer threads where that makes it suffice."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.outcome import report_event
from measureapp.errors import InputError
from measureapp.memory import GIB
from measureapp.pipeline import memory_need as module
from measureapp.pipeline.events import Event, MemoryShort
from measureapp.pipeline.memory_need import PROGRAM_BYTES, STITCHING_BYTES, SURFACE_BYTES, Need, detection_threads, memory_need
from measureapp.pipeline.run import process_project
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.large_clouds import LARGE_BYTES
from tests.fringe_project import WIDTH, fringe_project, shiny_stack

FIXED_BYTES = PROGRAM_BYTES + SURFACE_BYTES


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    return fringe_project(tmp_path / "p", "view01", "view02")


def test_the_need_follows_views_pixels_and_lit_pixels(project: ProjectFolder, tmp_path: Path) -> None:
    two, one = memory_need(project), memory_need(fringe_project(tmp_path / "q", "view01"))
    camera = project.rig().cameras[0]
    pixels = camera.width_px * camera.height_px
    one_view = pixels * STITCHING_BYTES + LARGE_BYTES  # what is more of a cloud is on disk
    assert two.stitching - FIXED_BYTES == pytest.approx(2 * one_view, rel=0.02)
    assert one.stitching - FIXED_BYTES == pytest.approx(one_view, rel=0.02)
    assert "2 views by" in two.words and "million points" in two.words
    for name in ("view01", "view02"):
        lit = shiny_stack(name)
        darkened = {camera: np.where(np.arange(WIDTH) < WIDTH // 4, images, 7) for camera, images in lit.images.items()}
        project.frames.store(replace(lit, images=darkened))
    assert memory_need(project).stitching - FIXED_BYTES == pytest.approx(2 * (pixels * STITCHING_BYTES / 4 + LARGE_BYTES), rel=0.1)


def test_without_images_every_pixel_counts_as_lit(project: ProjectFolder) -> None:
    for path in project.path.glob("stacks/*/*.npy"):
        path.unlink()
    assert np.isclose(memory_need(project).stitching, FIXED_BYTES + 2 * (LARGE_BYTES + 2592 * 1944 * STITCHING_BYTES))


@pytest.mark.parametrize(("gib", "threads"), [(9.0, 2), (7.0, 2), (6.9, 1), (5.0, 1)])
def test_fewer_threads_where_these_fit(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], gib: float, threads: int
) -> None:
    monkeypatch.setattr(module, "memory_need", lambda _: Need(5 * GIB, 2 * GIB, 3 * GIB, 4 * GIB, "many views"))
    events = list[Event]()
    assert detection_threads(project, events.append, lambda: round(gib * GIB)) == threads
    assert events == ([] if threads == 2 else [MemoryShort(1, 2, 7.0, pytest.approx(gib))])
    for event in events:
        report_event(event)
    assert capsys.readouterr().err.count(f"7.0 GiB of memory, and {gib:.1f} GiB are available") == len(events)


def test_what_does_not_fit_is_refused_with_numbers_before_anything_is_written(
    project: ProjectFolder, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "memory_need", lambda _: Need(5 * GIB, 2 * GIB, 3 * GIB, 6 * GIB, "26 views by 3 cameras"))
    monkeypatch.setattr("measureapp.pipeline.run.detection_threads", lambda *given: detection_threads(*given, lambda: round(5.9 * GIB)))
    with pytest.raises(InputError, match=r"about 6\.0 GiB of memory \(26 views by 3 cameras\), and 5\.9 GiB are available"):
        process_project(project, lambda _: None, NoProgress())
    assert not project.results.exists()
