"""`plan predict` prints U of every dimension with its budget, and what would halve it; what it needs is asked for in words."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import pytest

from measureapp.cli import main
from measureapp.data.dimension import Dimension, Verdict
from measureapp.pipeline.prediction.improvements import Advice, Trial
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig

MEASURED = Dimension("a", 180.0, 180.0, 0.006, -0.1, 0.1, Verdict.PASS, budget={"stitching": 0.0057, "noise": 0.002})
UNSEEN = Dimension("b", 140.0, None, None, -0.1, 0.1, Verdict.NOT_MEASURED, reason="y-: only 0 points were measured there, 30 are needed")
ADVICE = Advice((Trial("repeating view01", 10.0, None, {"a": 0.0055}),), ("a: none of the changes tried halves U.",))


@pytest.fixture
def predicted(monkeypatch: pytest.MonkeyPatch) -> None:
    """A prediction of two dimensions, whatever it is asked for."""
    views = (SimpleNamespace(viewpoint_id="view01", cloud=range(5000)),)
    result = SimpleNamespace(views=views, dimensions=(MEASURED, UNSEEN), source="calibration of yesterday")
    setup = SimpleNamespace(plan=None, scene=None, job=None)
    monkeypatch.setattr("measureapp.pipeline.prediction.setup.setup_of_project", lambda *_: setup)
    monkeypatch.setattr("measureapp.pipeline.prediction.uncertainty.predict_uncertainty", lambda *_: result)
    monkeypatch.setattr("measureapp.pipeline.prediction.improvements.advise", lambda *_: ADVICE)


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    return ProjectFolder.create(tmp_path / "p", ProjectSettings(name="p", part="box", rig=read_rig("paper")))


def test_every_dimension_is_stated_with_its_budget_or_the_reason_why_not(project, predicted, capsys) -> None:
    assert main(["plan", "predict", str(project.path)]) == 0
    said = capsys.readouterr().out
    assert "Predicted for 1 view; calibration of yesterday." in said
    assert "a: U = 0.0060 mm (k = 2): stitching 0.0057, noise 0.0020" in said
    assert "b: not measured, y-: only 0 points were measured there" in said


def test_the_json_document_has_budgets_and_on_request_the_trials(project, predicted, capsys) -> None:
    assert main(["plan", "predict", str(project.path), "--improve", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert [(one["name"], one["uncertainty"]) for one in answer["dimensions"]] == [("a", 0.006), ("b", None)]
    assert answer["dimensions"][0]["budget"] == {"stitching": 0.0057, "noise": 0.002}
    assert answer["trials"] == [{"change": "repeating view01", "seconds": 10.0, "uncertainty": {"a": 0.0055}, "viewpoint": None}]
    assert answer["advice"] == ["a: none of the changes tried halves U."]


def test_what_is_stated_of_part_and_clouds_is_what_the_prediction_starts_from(project, predicted, monkeypatch, capsys) -> None:
    asked = []
    setup = SimpleNamespace(plan=None, scene=None, job=None)

    def prepare(_project, _progress, light, form_mm):
        asked.append((light, form_mm))
        return setup

    monkeypatch.setattr("measureapp.pipeline.prediction.setup.setup_of_project", prepare)
    assert main(["plan", "predict", str(project.path)]) == 0
    assert main(["plan", "predict", str(project.path), "--brightness", "0.3", "--form-error", "0.003"]) == 0
    assert asked[0] == (None, None)
    assert asked[1][0].white == 0.3 and asked[1][1] == 0.003
    assert main(["plan", "predict", str(project.path), "--form-error", "-1"]) == 2
    capsys.readouterr()


def test_a_plan_without_a_rig_or_program_asks_for_them(tmp_path: Path, capsys) -> None:
    assert main(["plan", "predict", str(tmp_path / "plan.toml")]) == 2
    assert "--rig is missing" in capsys.readouterr().err
    assert main(["plan", "predict", str(tmp_path / "plan.toml"), "--rig", "paper"]) == 2
    assert "--program is missing" in capsys.readouterr().err


def test_a_project_has_its_own_rig(project, capsys) -> None:
    assert main(["plan", "predict", str(project.path), "--rig", "paper"]) == 2
    assert "has its own rig" in capsys.readouterr().err


def test_a_project_without_a_program_is_refused_in_words(project, capsys) -> None:
    from measureapp.planning.viewpoints import plan_around_part

    project.save_plan(plan_around_part(read_rig("paper"), "two", radius_mm=60.0, height_mm=60.0, count=2))
    assert main(["plan", "predict", str(project.path)]) == 2
    assert "has no inspection program" in capsys.readouterr().err
