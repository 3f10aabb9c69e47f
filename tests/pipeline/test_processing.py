"""Clouds are computed behind a scan, which waits for storing alone, also where computing is slow or stuck."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from measureapp.acquire.tasks.stack import ExposureTaken
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.errors import DecodeError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline import processing
from measureapp.pipeline.events import Event, ViewFailed, ViewReady
from measureapp.pipeline.processing import MOST_MAPS, Processing
from measureapp.pipeline.watch import Stopwatch
from measureapp.pipeline.worker import NICE
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from tests.fringe.conftest import images_of, ramp, stack_of

LIMIT_S = 60.0
EXPOSURES_US = (40_000, 20_000)
HERE = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0)


class Computing:
    """Stands in for `compute_cloud`: remembers what it got, and does what a test wants."""

    def __init__(self) -> None:
        self.got: dict[str, tuple[bool, bool]] = {}  # whether maps, and whether images, by viewpoint
        self.do: Callable[[str], None] = lambda _: None

    def __call__(self, stack: FringeStack, calibration: Any, progress: Any, rectifier: Any, maps: Any, *_: Any) -> Any:
        self.do(stack.viewpoint_id)
        self.got[stack.viewpoint_id] = (maps is not None, bool(stack.images))
        return SimpleView(stack.viewpoint_id)


class SimpleView(SimpleNamespace):
    def __init__(self, viewpoint_id: str) -> None:
        super().__init__(viewpoint_id=viewpoint_id, quality=SimpleNamespace(accepted=False))


@pytest.fixture
def computing(monkeypatch: pytest.MonkeyPatch) -> Computing:
    made = Computing()
    genuine = processing.replace
    monkeypatch.setattr(processing, "compute_cloud", made)
    monkeypatch.setattr(processing, "Rectifier", lambda _: object())
    monkeypatch.setattr(processing, "stored_view", lambda _, view, *__: view)
    monkeypatch.setattr(processing, "replace", lambda value, **new: value if isinstance(value, SimpleView) else genuine(value, **new))
    return made


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.create(tmp_path / "project", ProjectSettings(name="p", part="p", rig=read_rig("paper")))


@pytest.fixture
def stack() -> FringeStack:
    plain = stack_of(images_of(ramp(), PAPER_PATTERNS, EXPOSURES_US), exposures_us=EXPOSURES_US)
    return replace(plain, readback=HERE)


@pytest.fixture
def events() -> list[Event]:
    return []


@pytest.fixture
def sink(project: ProjectFolder, computing: Computing, events: list[Event]) -> Iterator[Processing]:
    with Processing(project, SimpleNamespace(cameras=None), events.append, Stopwatch()) as made:  # type: ignore[arg-type]
        yield made


def take(sink: Processing, stack: FringeStack, name: str) -> None:
    """Take a viewpoint as a scan does."""
    for level in range(len(stack.exposures_us)):
        images = {camera: taken[level] for camera, taken in stack.images.items()}
        sink.exposure_taken(ExposureTaken(name, stack.patterns, stack.exposures_us, level, images, stack.saturation))
    sink.store(replace(stack, viewpoint_id=name))


def of(events: list[Event], kind: type) -> list[str]:
    return [event.view.viewpoint_id if isinstance(event, ViewReady) else event.viewpoint_id for event in events if isinstance(event, kind)]


def test_a_cloud_is_computed_from_the_maps_of_live_decoding_without_the_images(sink, stack, computing, events, project) -> None:
    take(sink, stack, "v0")
    sink.finish(NoProgress())
    assert computing.got == {"v0": (True, False)}
    assert (of(events, ViewReady), list(sink.views)) == (["v0"], ["v0"])
    assert project.stored_viewpoints() == ("v0",)


def test_viewpoints_are_stored_while_computing_is_stuck_and_computed_from_the_disk_later(sink, stack, computing, project) -> None:
    free = threading.Event()
    computing.do = lambda _: free.wait(LIMIT_S)
    names = [f"v{number}" for number in range(MOST_MAPS + 4)]
    for name in names:
        take(sink, stack, name)  # returns, although nothing is computed
    assert project.stored_viewpoints() == tuple(names)
    assert not sink.views
    free.set()
    sink.finish(NoProgress())
    assert list(sink.views) == names
    assert [computing.got[name][0] for name in names] == [True] * MOST_MAPS + [False] * 4
    assert all(computing.got[name][1] for name in names[MOST_MAPS:])


def test_a_cloud_that_never_ends_is_reported_and_the_others_are_computed(sink, stack, computing, events, monkeypatch) -> None:
    monkeypatch.setattr(processing, "STUCK_S", 0.3)
    free = threading.Event()

    def do(name: str) -> None:
        if name == "v1":
            free.wait(LIMIT_S)

    computing.do = do
    for name in ("v0", "v1", "v2"):
        take(sink, stack, name)
    sink.finish(NoProgress())
    free.set()
    assert of(events, ViewFailed) == ["v1"]
    assert [event.reason for event in events if isinstance(event, ViewFailed)] == [
        "Its processing did not end. Its images are stored: process the project again."
    ]
    assert {"v0", "v2"} <= set(sink.views)


def test_a_viewpoint_without_points_is_reported_and_a_bug_is_raised_after_everything_is_stored(
    sink, stack, computing, events, project
) -> None:
    def do(name: str) -> None:
        if name == "v0":
            raise DecodeError("nothing to see.", "Add light.")
        if name == "v1":
            raise ZeroDivisionError("a bug")

    computing.do = do
    for name in ("v0", "v1", "v2"):
        take(sink, stack, name)
    with pytest.raises(ZeroDivisionError):
        sink.finish(NoProgress())
    assert of(events, ViewFailed) == ["v0"]
    assert project.stored_viewpoints() == ("v0", "v1", "v2")


def test_images_that_cannot_be_stored_are_decoded_and_computed_when_they_are(sink, stack, computing, project, monkeypatch) -> None:
    genuine, calls = type(project.frames).store, []

    def store(self: Any, stack: FringeStack) -> None:
        calls.append(1)
        if len(calls) == 1:
            raise StorageError("The disk is full.", "Free some space.")
        genuine(self, stack)

    monkeypatch.setattr(type(project.frames), "store", store)
    with pytest.raises(StorageError):
        take(sink, stack, "v0")
    assert not computing.got
    sink.store(replace(stack, viewpoint_id="v0"))
    sink.finish(NoProgress())
    assert computing.got == {"v0": (True, False)}


def test_the_cloud_of_a_viewpoint_taken_again_is_that_of_its_new_images(sink, stack, computing, events) -> None:
    take(sink, stack, "v0")
    take(sink, stack, "v0")
    sink.finish(NoProgress())
    assert of(events, ViewReady) == ["v0", "v0"]
    assert list(sink.views) == ["v0"]


def test_earlier_images_are_computed_behind_the_scan_too(sink, stack, computing, project, events) -> None:
    project.frames.store(replace(stack, viewpoint_id="early"))
    sink.compute_stored("early")
    take(sink, stack, "v0")
    sink.finish(NoProgress())
    assert computing.got == {"early": (False, True), "v0": (True, False)}


def test_what_was_decoded_and_dropped_leaves_nothing_behind(sink, stack, computing, project) -> None:
    images = {camera: taken[0] for camera, taken in stack.images.items()}
    sink.exposure_taken(ExposureTaken("v0", stack.patterns, stack.exposures_us, 0, images, stack.saturation))
    sink.drop("v0")
    sink.finish(NoProgress())
    assert (computing.got, project.stored_viewpoints()) == ({}, ())


@pytest.mark.skipif(sys.platform != "linux", reason="priorities of threads are known to Linux only")
def test_computing_gives_way_to_taking_images(sink, stack, computing) -> None:
    here, found = os.getpriority(os.PRIO_PROCESS, 0), []
    computing.do = lambda _: found.append(os.getpriority(os.PRIO_PROCESS, 0))
    take(sink, stack, "v0")
    sink.finish(NoProgress())
    assert found == [min(19, here + NICE)]
    assert os.getpriority(os.PRIO_PROCESS, 0) == here
