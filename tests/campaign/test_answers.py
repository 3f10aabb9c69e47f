"""A campaign that was ended early goes on where it stopped."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from demo_fixture import linked_copy

from measureapp.campaign import answers
from measureapp.campaign.answers import Answers
from measureapp.campaign.campaign_file import process_jobs
from measureapp.campaign.jobs import DemoJob, Finished
from measureapp.demo import DemoRequest
from measureapp.project.folder import ProjectFolder


def test_answers_are_known_again_until_program_or_settings_change(tmp_path, monkeypatch):
    job = DemoJob("gypsum-good-1", DemoRequest(tmp_path / "gypsum-good-1", seed=1))
    stored = Answers(tmp_path)
    assert stored.of([job]) == {}
    stored.keep(Finished(job.name, job.folder, True, {"value": np.float64(1.5), "none": float("nan")}, seconds=3.0))
    (known,) = Answers(tmp_path).of([job]).values()
    assert (known.passed, known.document, known.seconds) == (True, {"value": 1.5, "none": None}, 3.0)
    assert Answers(tmp_path).of([replace(job, request=replace(job.request, viewpoints=4))]) == {}
    monkeypatch.setattr(answers, "fingerprint", lambda: "another program")
    assert Answers(tmp_path).of([job]) == {}


def test_jobs_without_a_result_are_done_again(tmp_path):
    failed = DemoJob("gear-bad-1", DemoRequest(tmp_path / "gear-bad-1"))
    stored = Answers(tmp_path)
    stored.of([failed])
    stored.keep(Finished.failed(failed, OSError("no space")))
    assert Answers(tmp_path).of([failed]) == {}


def test_a_project_is_known_until_what_it_was_computed_from_changes(demo, tmp_path):
    folder = linked_copy(demo.folder, tmp_path / "project")
    (job,) = process_jobs([folder])
    stored = Answers(tmp_path)
    stored.of([job])
    stored.keep(Finished(job.name, folder, True))
    assert Answers(tmp_path).of([job])
    project, changed = ProjectFolder.open(folder), tmp_path / "changed.toml"
    changed.write_text(project.program.read_text(encoding="utf-8").replace("180", "181"), encoding="utf-8")
    project.save_inspection(changed, project.nominal)
    assert Answers(tmp_path).of([job]) == {}
