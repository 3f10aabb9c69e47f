"""What becomes of raw images after a scan: kept, compressed, or dropped by choice, by a job that can be ended anywhere."""

from __future__ import annotations

import json
import threading
from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.cli import main
from measureapp.data.storage_rules import StorageRules
from measureapp.pipeline import raw_keeping
from measureapp.pipeline.kept_views import views_without_images
from measureapp.pipeline.raw_keeping import apply_raw_policy, pending_raw
from measureapp.progress import Cancelled, NoProgress
from measureapp.project import raw_images, upkeep
from measureapp.project.folder import ProjectFolder


@pytest.fixture
def project(demo: Demo, tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.open(linked_copy(demo.folder, tmp_path / "p"))


@pytest.fixture
def three(project: ProjectFolder) -> ProjectFolder:
    """The project with three of its viewpoints: compressing one takes a second."""
    with project.lock():
        for name in project.stored_viewpoints()[3:]:
            project.frames.discard(name)
    return ProjectFolder.open(project.path)


def wants(project: ProjectFolder, raw: str) -> ProjectFolder:
    with project.lock():
        project.save_storage_rules(StorageRules(raw=raw))
    return ProjectFolder.open(project.path)


def states(project: ProjectFolder) -> set[str]:
    return {one.state for one in raw_images.list_raw(project.journal)}


class CancelsAtSecond:
    """Cancels when the second viewpoint begins."""

    def report(self, done: float, total: float, note: str = "") -> None:
        if done == 1 and total > 1:
            raise Cancelled

    def check(self) -> None: ...


def test_images_are_kept_unless_somebody_decides_otherwise(project: ProjectFolder) -> None:
    assert project.storage_rules().raw == "keep"
    assert not apply_raw_policy(project, NoProgress()).done
    assert states(project) == {"raw"}


def test_compression_that_was_ended_is_continued_and_nothing_is_damaged(three: ProjectFolder) -> None:
    project = wants(three, "compress")
    with pytest.raises(Cancelled):
        apply_raw_policy(project, CancelsAtSecond())
    assert states(ProjectFolder.open(project.path)) == {"raw", "compressed"}
    project = ProjectFolder.open(project.path)
    left = apply_raw_policy(project, NoProgress())
    assert len(left.done) == 2 and left.freed_bytes > 0 and "compressed" in left.sentence
    assert upkeep.verify(project.path).whole
    assert not pending_raw(ProjectFolder.open(project.path))


def test_dropped_images_are_known_to_verify_and_their_clouds_survive_processing(project: ProjectFolder, capsys) -> None:
    project = wants(project, "drop")
    views = {path.name: path.read_bytes() for path in (project.results / "clouds").iterdir()}
    done = apply_raw_policy(project, NoProgress())
    assert len(done.done) == 6 and "dropped" in done.sentence
    assert not list((project.path / "stacks").rglob("*.npy"))
    found = upkeep.verify(project.path)
    assert found.whole and len(found.removed) == 6
    assert main(["verify", str(project.path)]) == 0
    assert "removed on purpose" in capsys.readouterr().out
    kept = views_without_images(ProjectFolder.open(project.path))
    assert {f"{name}.ply" for name in kept} == set(views)


def test_images_without_a_cloud_are_never_dropped(project: ProjectFolder) -> None:
    project = wants(project, "drop")
    with project.lock():
        project.frames.discard("view01")
    assert "view01" not in pending_raw(project)
    stale = ProjectFolder.open(project.path)
    results = stale.journal.contents()
    assert results is not None
    assert set(pending_raw(stale)) < set(results.viewpoints) | {"view01"}


def test_a_scan_that_begins_meanwhile_waits_for_one_viewpoint_only(project: ProjectFolder) -> None:
    begun, go = threading.Event(), threading.Event()

    def hold() -> None:
        with ProjectFolder.open(project.path).lock(yields=True):
            begun.set()
            go.wait(10.0)

    holder = threading.Thread(target=hold)
    holder.start()
    begun.wait(10.0)
    threading.Timer(0.2, go.set).start()
    with project.lock():  # would be refused if the holder did not yield
        assert go.is_set()
    holder.join()


def test_the_policy_is_set_by_the_command_and_applied_on_request(three: ProjectFolder, capsys) -> None:
    assert main(["raw", str(three.path), "--policy", "compress", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["policy"] == "compress" and {one["state"] for one in document["viewpoints"]} == {"raw"}
    assert main(["raw", str(three.path), "--apply", "--json"]) == 0
    assert {one["state"] for one in json.loads(capsys.readouterr().out)["viewpoints"]} == {"compressed"}
    assert raw_keeping.apply_raw_policy(ProjectFolder.open(three.path), NoProgress()).sentence == ""
