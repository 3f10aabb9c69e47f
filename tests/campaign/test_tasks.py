"""The tasks of workers compute what one computer computes, and say what is wrong."""

from __future__ import annotations

import pickle
import time

import pytest
from demo_fixture import linked_copy
from found_boards import found_once
from without_pictures import without_surface_and_pictures

from measureapp.calibrate.sightings import BoardDetectionError
from measureapp.campaign import tasks
from measureapp.campaign.campaign_file import process_jobs
from measureapp.campaign.tasks import SCRATCH, complete, compute_view, do_alone, prepare, views_to_compute
from measureapp.errors import MeasureError
from measureapp.pipeline.events import ViewFailed
from measureapp.project.folder import ProjectFolder


@pytest.fixture(scope="module", autouse=True)
def _boards_are_found_once():
    with found_once():
        yield


@pytest.fixture
def project(demo, tmp_path):
    return linked_copy(demo.folder, tmp_path / "project")


def test_views_computed_one_by_one_give_the_same_numbers_to_the_last_bit(demo, project):
    (job,) = process_jobs([project])
    calibration = pickle.loads(pickle.dumps(prepare(project)))
    views = {name: compute_view(project, name, calibration) for name in views_to_compute(project)}
    with without_surface_and_pictures():
        finished = complete(job, calibration, views, time.time())
    assert finished.passed
    assert not (project / SCRATCH).exists()
    expected = {one["name"]: (one["measured"], one["uncertainty"]) for one in demo.document["dimensions"]}
    assert {one["name"]: (one["measured"], one["uncertainty"]) for one in finished.document["dimensions"]} == expected
    assert not ProjectFolder.open(project).stale_results()


def test_a_cloud_that_was_damaged_on_the_storage_is_refused(project):
    (job,) = process_jobs([project])
    opened = ProjectFolder.open(project)
    calibration, (first, *others) = opened.calibration(), views_to_compute(project)
    stored = compute_view(project, first, calibration)
    stored.path.write_bytes(stored.path.read_bytes()[:-1])
    views = {first: stored, **{name: ViewFailed(name, "not computed in this test") for name in others}}
    with pytest.raises(MeasureError, match="is damaged"):
        complete(job, calibration, views, time.time())


def test_errors_of_special_kinds_travel_as_plain_ones(project, monkeypatch):
    def fail(*_):
        raise BoardDetectionError("No board.", "Show it.", "hidden")

    monkeypatch.setattr(tasks, "calibrate_stored", fail)
    with pytest.raises(MeasureError) as found:
        prepare(project)
    again = pickle.loads(pickle.dumps(found.value))
    assert (again.message, again.hint) == ("No board.", "Show it.")


def test_a_job_that_cannot_be_done_is_an_answer(tmp_path):
    (job,) = process_jobs([tmp_path / "nothing"])
    finished = do_alone(job)
    assert not finished.passed
    assert finished.problem
