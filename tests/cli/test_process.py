"""What `process` says; that it measures the same as the demo is proved in tests/pipeline."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from demo_fixture import Demo

from measureapp.cli import main
from measureapp.data.decode_limits import DecodeLimits
from measureapp.pipeline.events import CalibrationReady, ViewFailed
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.run import Outcome
from measureapp.project.folder import ProjectFolder
from measureapp.project.fringes.decode_limits_file import read_decode_limits
from measureapp.project.inputs import changes, current_inputs


@pytest.fixture
def processed(demo: Demo, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make `process` give what is stored, with one view less and no inspection."""
    measurement = demo.project.measurement()
    assert measurement is not None

    def process_project(project, on_event, progress, *, language) -> Outcome:
        on_event(ViewFailed("view04", "no phase occurs in two cameras."))
        progress.report(1, 1)
        return Outcome(replace(measurement, inspection=None), {"dimensions": []}, {})

    monkeypatch.setattr("measureapp.pipeline.run.process_project", process_project)


def test_what_limits_a_calibration_that_was_solved_now_is_said(demo: Demo, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    measurement = demo.project.measurement()
    assert measurement is not None
    displaced = "The marks of the board are displaced by 0.027 mm (rms)."

    def process_project(project, on_event, progress, *, language) -> Outcome:
        on_event(CalibrationReady(measurement.calibration, (displaced,)))
        return Outcome(replace(measurement, inspection=None), {"dimensions": []}, {})

    monkeypatch.setattr("measureapp.pipeline.run.process_project", process_project)
    assert main(["process", str(demo.folder), "--json"]) == 0
    assert capsys.readouterr().err == f"Calibration: {displaced}\n"


def test_a_view_without_points_is_reported_with_the_answer(processed: None, demo: Demo, capsys) -> None:
    assert main(["process", str(demo.folder), "--json"]) == 0
    said = capsys.readouterr()
    assert json.loads(said.out) == {"dimensions": []}
    assert said.err == "view04: no phase occurs in two cameras.\n"


def test_the_report_is_written_in_the_chosen_language(demo: Demo, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    measurement, languages = demo.project.measurement(), []
    assert measurement is not None

    def finish(_project, _on_event, _progress, _watch=None, language="") -> Outcome:
        languages.append(language)
        return Outcome(replace(measurement, inspection=None), {"dimensions": []}, {})

    monkeypatch.setattr("measureapp.pipeline.run.process_project", finish)
    for options in ([], ["--language", "zh_CN"], ["--language", "zh_CN", "--profile"]):
        assert main(["process", str(demo.folder), *options]) == 0
    assert languages == ["en", "zh_CN", "zh_CN"]
    assert main(["process", str(demo.folder), "--language", "klingon"]) == 2
    assert main(["process", str(demo.folder), str(demo.folder), "--language", "zh_CN"]) == 2  # several take no option
    assert len(languages) == 3 and "en, zh_CN" in capsys.readouterr().err


def test_a_part_without_program_has_points_and_no_dimensions(processed: None, demo: Demo, capsys) -> None:
    assert main(["process", str(demo.folder)]) == 0
    said = capsys.readouterr().out
    assert said.startswith("gypsum: ")
    assert said.endswith("The project has no inspection program.\n")


def test_limits_of_the_pixels_are_stored_and_hold_from_then_on(processed: None, demo: Demo, tmp_path) -> None:
    made = ProjectFolder.create(tmp_path / "faint", demo.project.settings)
    assert main(["process", str(made.path), "--min-modulation", "20"]) == 0
    assert main(["process", str(made.path), "--max-phase-sigma", "0.1"]) == 0
    settings = decode_settings_of(ProjectFolder.open(made.path))
    assert settings.faint_modulation_grey(255) == settings.min_modulation_grey(255) == 20
    assert settings.max_sigma_rad == 0.1


def test_results_of_other_limits_are_named(demo: Demo) -> None:
    now = current_inputs(demo.project.journal.contents())
    assert changes(now, now | {"limits": "another"}) == ("The results were computed with other limits of the pixels.",)


@pytest.mark.parametrize(("option", "value"), [("--min-modulation", "-1"), ("--max-phase-sigma", "0"), ("--min-modulation", "nan")])
def test_limits_that_are_none_are_refused_and_nothing_is_stored(processed: None, demo: Demo, tmp_path, capsys, option, value) -> None:
    made = ProjectFolder.create(tmp_path / "faint", demo.project.settings)
    assert main(["process", str(made.path), option, value]) == 2
    assert option in capsys.readouterr().err
    assert read_decode_limits(made.path) == DecodeLimits()
