"""U before the scan is U after it: predicted for a plan, stated by a scan whose world differs from the prediction's."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.length_certificate import LengthCertificate
from measureapp.errors import PlanError
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.prediction.improvements import Trial, advise, answer_for
from measureapp.pipeline.prediction.light import PartLight
from measureapp.pipeline.prediction.setup import setup_of_project
from measureapp.pipeline.prediction.uncertainty import Job, evaluate, predict_uncertainty, predict_views
from measureapp.pipeline.prediction.views import PredictedScene
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.program_file import parse_program
from tests.pipeline.predicted_rig import box, nominal_rig, plan_for

BOUND = 0.3  # of U after the scan
SIZE_MM = (90.0, 70.0, 50.0)
PROGRAM = """
schema_version = 1
name = "box"
alignment = "best-fit"
[[features]]
name = "x+"
shape = "plane"
point_mm = [45, 0, 25]
direction = [1, 0, 0]
cut = { edge_mm = 3 }
[[features]]
name = "x-"
shape = "plane"
point_mm = [-45, 0, 25]
direction = [-1, 0, 0]
cut = { edge_mm = 3 }
[[features]]
name = "y+"
shape = "plane"
point_mm = [0, 35, 25]
direction = [0, 1, 0]
cut = { edge_mm = 3 }
[[features]]
name = "y-"
shape = "plane"
point_mm = [0, -35, 25]
direction = [0, -1, 0]
cut = { edge_mm = 3 }
[[dimensions]]
name = "length"
kind = "distance"
features = ["x+", "x-"]
nominal = 90
[[dimensions]]
name = "width"
kind = "distance"
features = ["y+", "y-"]
nominal = 70
"""


def dimension(name: str, uncertainty: float, budget: dict[str, float]) -> Dimension:
    return Dimension(name, 10.0, 10.0, uncertainty, -0.1, 0.1, Verdict.PASS, budget=budget)


def test_the_predicted_uncertainty_is_that_of_a_scan_of_another_part_elsewhere_in_other_light() -> None:
    rig = nominal_rig()
    plan, job = plan_for(rig.description, 4), Job(parse_program(PROGRAM), box(SIZE_MM))
    placed = PredictedScene.of(rig, NominalSurface(job.nominal))
    predicted = predict_uncertainty(plan, placed, job)
    assert {one.name: one.uncertainty is not None for one in predicted.dimensions} == {"length": True, "width": True}

    program = job.program
    standard = program.dimensions[1].model_copy(update={"nominal": 70.05, "certificate": LengthCertificate(uncertainty_mm=0.001)})
    certified = evaluate(
        predicted.views, placed, replace(job, program=program.model_copy(update={"dimensions": (program.dimensions[0], standard)}))
    )
    gained = certified.uncertainty("length")
    assert gained is not None and gained < 0.9 * (
        predicted.uncertainty("length") or 0.0
    )  # stated before it is used, whatever the part is like

    part = NominalSurface(box((90.06, 69.95, 50.04)))
    moved = RigidTransform.from_parts(rotation_about([0, 0, 1], 0.1), [3.0, -2.0, 0.0], "part", "part") @ placed.part_from_nominal
    scene = replace(placed, surface=part, part_from_nominal=moved, light=PartLight(white=0.8, ambient=0.05), seed=7)
    stated = evaluate(predict_views(plan, scene, NoProgress()), scene, job)
    for name, value in (("length", 90.06), ("width", 69.95)):
        before, after = predicted.uncertainty(name), stated.uncertainty(name)
        assert before is not None and after is not None
        assert before == pytest.approx(after, rel=BOUND)
        found = next(one for one in stated.dimensions if one.name == name)
        assert found.measured == pytest.approx(value, abs=1.5 * after)


def test_a_plan_that_sees_nothing_is_refused_in_words() -> None:
    rig = nominal_rig()
    plan, job = plan_for(rig.description, 2), Job(parse_program(PROGRAM), box(SIZE_MM))
    away = RigidTransform.from_parts(np.eye(3), [0.0, 0.0, 5000.0], "part", "nominal")
    with pytest.raises(PlanError, match="No viewpoint of the plan"):
        predict_uncertainty(plan, PredictedScene.of(rig, NominalSurface(job.nominal), away), job)


def test_what_halves_an_uncertainty_is_named_with_its_time() -> None:
    one = dimension("a", 0.02, {"noise": 0.0199, "calibration": 0.001})
    trials = [Trial("repeating view01", 10.0, None, {"a": 0.015}), Trial("all exposures 2 times as long", 30.0, None, {"a": 0.009})]
    assert answer_for(one, trials) == ("a: Most for its time: all exposures 2 times as long, U = 0.0090 mm instead of 0.0200, for 30 s.")
    assert answer_for(one, trials[:1]).startswith("a: none of the changes tried halves U. Most for its time: repeating view01")


def test_an_uncertainty_of_the_calibration_is_not_promised_to_shrink() -> None:
    one = dimension("a", 0.02, {"noise": 0.008, "calibration": 0.0183})
    sentence = answer_for(one, [Trial("repeating view01", 10.0, None, {"a": 0.0199})])
    assert sentence == "a: no viewpoint or exposure can halve U; the calibration alone gives 92% of it."


def test_a_gain_within_the_noise_of_the_prediction_is_none() -> None:
    one = dimension("a", 0.02, {"noise": 0.0199, "form": 0.002})
    sentence = answer_for(one, [Trial("repeating view01", 10.0, None, {"a": 0.0198})])
    assert sentence == "a: none of the changes tried reduces U; its largest contribution is noise, 99%."


@pytest.mark.slow
def test_a_scan_of_the_virtual_rig_states_the_predicted_uncertainty(demo: Demo, record_property: Callable[[str, object], None]) -> None:
    """Plan and calibration are known before the scan; the part is taken to stand upright in the middle, as bright as is assumed."""
    setup = setup_of_project(demo.project, NoProgress())
    before = PredictedScene.of(setup.scene.rig, setup.scene.surface)
    predicted = predict_uncertainty(setup.plan, before, setup.job)
    stated = demo.document["dimensions"]
    ratios = {one["name"]: (predicted.uncertainty(one["name"]) or 0.0) / one["uncertainty"] for one in stated}
    record_property("U predicted over U stated", ratios)
    assert all(1 - BOUND <= ratio <= 1 + BOUND for ratio in ratios.values()), ratios


def test_a_project_without_a_plan_has_no_prediction(tmp_path: Path) -> None:
    from measureapp.project.folder import ProjectSettings
    from measureapp.project.rig_file import read_rig

    project = ProjectFolder.create(tmp_path / "p", ProjectSettings(name="p", part="p", rig=read_rig("paper")))
    with pytest.raises(PlanError, match="no scan plan"):
        setup_of_project(project, NoProgress())


@pytest.mark.slow
def test_changes_of_a_plan_are_tried_and_stated_with_their_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("measureapp.pipeline.prediction.improvements.MOST_TRIED", 1)
    rig = nominal_rig()
    plan, job = plan_for(rig.description, 3), Job(parse_program(PROGRAM), box(SIZE_MM))
    scene = PredictedScene.of(rig, NominalSurface(job.nominal), light=PartLight(white=0.3))
    advice = advise(plan, scene, job, predict_uncertainty(plan, scene, job), NoProgress())
    again, new, longer = advice.trials
    assert again.change.startswith("repeating view") and new.change.startswith("adding a viewpoint at table")
    assert longer.change == "all exposures 2 times as long" and longer.viewpoint is None
    assert again.viewpoint is not None and again.viewpoint.id not in {one.id for one in plan}
    images_s = plan.patterns.count * sum(plan.bracket.exposures_us) * 1e-6
    assert again.seconds > images_s and longer.seconds > 2 * images_s  # three viewpoints, each exposure once more
    assert advice.sentences and all(sentence.split(":")[0] in ("length", "width") for sentence in advice.sentences)
