"""A demo that was begun or finished is continued."""

from __future__ import annotations

from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.acquire.events import RunEnded, RunStarted, ViewpointStored
from measureapp.data.sample_worlds import IDEAL
from measureapp.demo import DemoRequest, run_demo
from measureapp.errors import InputError
from measureapp.pipeline.events import CalibrationReady, Event, InspectionReady, StitchReady, ViewReady
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder


@pytest.fixture
def copy(demo: Demo, tmp_path: Path) -> Path:
    """The finished demo; its images are the same files, so that writing one anew shows."""
    return linked_copy(demo.folder, tmp_path / "project")


def images(folder: Path) -> dict[Path, tuple[int, int]]:
    """Which file lies at each place, and when it was written."""
    found = [path for kind in ("npy", "png") for path in folder.rglob(f"*.{kind}")]
    return {path: (path.stat().st_ino, path.stat().st_mtime_ns) for path in found}


@pytest.mark.slow
def test_no_image_is_taken_twice_and_the_results_are_the_same(demo: Demo, copy: Path) -> None:
    before, events = images(copy), list[Event]()
    project = ProjectFolder.open(copy)
    with project.lock():
        project.frames.discard("view05")  # as if a power cut had come before it was stored
    outcome = run_demo(DemoRequest(copy, "gypsum", "quarter", 6, seed=1, conditions=IDEAL), events.append, NoProgress())
    retaken = {path.parent.name for path, file in images(copy).items() if before[path] != file}
    assert retaken == {"view05"}
    assert images(copy).keys() == before.keys()

    started = next(event for event in events if isinstance(event, RunStarted))
    assert started.viewpoint_ids == ("view05",)
    assert [event.viewpoint_id for event in events if isinstance(event, ViewpointStored)] == ["view05"]
    order = [type(event) for event in events if isinstance(event, (CalibrationReady, RunStarted, RunEnded, StitchReady, InspectionReady))]
    assert order == [CalibrationReady, RunStarted, RunEnded, StitchReady, InspectionReady]
    assert sorted(event.view.viewpoint_id for event in events if isinstance(event, ViewReady)) == [f"view0{n}" for n in range(1, 7)]
    again = {dimension["name"]: dimension["measured"] for dimension in outcome.document["dimensions"]}
    for dimension in demo.document["dimensions"]:  # one view has other noise; the others are the same
        assert again[dimension["name"]] == pytest.approx(dimension["measured"], abs=dimension["uncertainty"])


def test_a_folder_with_another_demo_is_left_alone(demo: Demo, copy: Path) -> None:
    before = images(copy)
    with pytest.raises(InputError, match="contains another project"):
        run_demo(DemoRequest(copy, "gypsum", "quarter", 6, seed=2, conditions=IDEAL), lambda _: None, NoProgress())
    assert images(copy) == before
    assert (copy / "results" / "measurement.json").exists()
