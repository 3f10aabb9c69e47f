"""What `process` says; that it measures the same as the demo is proved in tests/pipeline."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from demo_fixture import Demo

from measureapp.cli import main
from measureapp.pipeline import Outcome
from measureapp.pipeline.events import ViewFailed


@pytest.fixture
def processed(demo: Demo, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make `process` give what is stored, with one view less and no inspection."""
    measurement = demo.project.measurement()
    assert measurement is not None

    def process_project(project, on_event, progress) -> Outcome:
        on_event(ViewFailed("view04", "no phase occurs in two cameras."))
        progress.report(1, 1)
        return Outcome(replace(measurement, inspection=None), {"dimensions": []}, {})

    monkeypatch.setattr("measureapp.pipeline.process_project", process_project)


def test_a_view_without_points_is_reported_with_the_answer(processed: None, demo: Demo, capsys) -> None:
    assert main(["process", str(demo.folder), "--json"]) == 0
    said = capsys.readouterr()
    assert json.loads(said.out) == {"dimensions": []}
    assert said.err == "view04: no phase occurs in two cameras.\n"


def test_a_part_without_program_has_points_and_no_dimensions(processed: None, demo: Demo, capsys) -> None:
    assert main(["process", str(demo.folder)]) == 0
    said = capsys.readouterr().out
    assert said.startswith("gypsum: ")
    assert said.endswith("The project has no inspection program.\n")
