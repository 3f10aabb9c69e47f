"""Checks of whole plans, and the sample plan."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.pipeline.plan_check import PlanChecker
from measureapp.pipeline.plan_coverage import place_on_table, predict_coverage
from measureapp.planning import edit
from measureapp.planning.aim import Aim, flange_aimed
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.viewpoints import LookAt
from measureapp.progress import Cancelled, NoProgress
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.plan_file import read_plan
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

RIG = read_rig("paper")
SAMPLE = read_plan(resource("plans/paper_impeller.toml"))


@pytest.fixture(scope="module")
def impeller():
    return place_on_table(read_mesh(resource("parts/impeller/nominal.stl")))


@pytest.fixture(scope="module")
def checker(impeller):
    return PlanChecker(RIG, arm_of(RIG), PartSolid.of_points(impeller.vertices_mm))


def looking(name: str, look_at: LookAt, guide_mm: float = 0.0, target=(0.0, 0.0, 40.0)) -> Viewpoint:
    return Viewpoint(id=name, flange=flange_aimed(Aim(target, look_at), guide_mm, RIG), guide_mm=guide_mm, table_deg=0.0)


def test_the_sample_plan_has_26_measuring_angles_and_36_clouds():
    angles = {(viewpoint.flange, viewpoint.table_deg) for viewpoint in SAMPLE}
    assert (len(angles), len(SAMPLE)) == (26, 36)
    twice = [angle for angle in angles if sum((viewpoint.flange, viewpoint.table_deg) == angle for viewpoint in SAMPLE) == 2]
    assert len(twice) == 10


def test_the_sample_plan_uses_the_guide_over_hundreds_of_millimetres():
    places = [viewpoint.guide_mm for viewpoint in SAMPLE]
    assert max(places) - min(places) > 400.0


def test_the_sample_plan_can_be_driven_and_visits_each_robot_pose_once(checker):
    assert checker.check(SAMPLE).problems == ()
    poses = [viewpoint.flange for viewpoint in SAMPLE]
    visits = 1 + sum(one != other for one, other in itertools.pairwise(poses))
    assert visits == len(set(poses)) == 3


def test_the_sample_plan_measures_all_but_the_underside_and_what_is_hidden(impeller):
    coverage = predict_coverage(SAMPLE, impeller, RIG, (), NoProgress())
    downward = coverage.samples.normals[:, 2] < -0.2
    assert coverage.predicted / coverage.share(~downward) > 0.93
    assert not coverage.counts[downward & (coverage.samples.points_mm[:, 2] < 1.0)].any()
    assert sum(coverage.unmeasurable().values()) + sum(coverage.unseen().values()) + coverage.predicted == pytest.approx(1.0)
    assert max(coverage.unmeasurable(), key=coverage.unmeasurable().get) == "touches the support"
    assert coverage.twice <= coverage.predicted


def test_each_problem_names_its_viewpoint_and_its_kind(checker):
    plan = ScanPlan(
        name="bad",
        viewpoints=(
            looking("good", LookAt(0.0, 40.0, 550.0)),
            looking("guide", LookAt(0.0, 40.0, 550.0)).model_copy(update={"guide_mm": 700.0}),
            looking("far", LookAt(180.0, 40.0, 550.0)),
            looking("inside", LookAt(0.0, 40.0, 160.0)),
        ),
    )
    found = {problem.viewpoint_id: problem for problem in checker.check(plan).problems}
    assert set(found) == {"guide", "far", "inside"}
    assert found["guide"].kind == found["far"].kind == "limits" and "700.0 mm" in found["guide"].sentence
    assert found["inside"].kind == "collision" and "head" in found["inside"].sentence


def test_a_changed_plan_is_judged_as_if_it_were_new(checker):
    changed = edit.change(SAMPLE, ["rim-01-01"], guide_mm=-900.0)
    fresh = PlanChecker(RIG, arm_of(RIG), None)
    assert [problem.viewpoint_id for problem in checker.check(changed).problems if problem.kind == "limits"] == [
        problem.viewpoint_id for problem in fresh.check(changed).problems if problem.kind == "limits"
    ]
    assert checker.check(SAMPLE).problems == ()


def test_a_part_larger_than_the_table_is_a_problem_of_the_whole_plan():
    part = PartSolid.enclosing(450.0, 60.0)
    found = PlanChecker(RIG, arm_of(RIG), part).check(SAMPLE)
    assert [(problem.viewpoint_id, problem.kind) for problem in found.problems] == [("", "part")]
    assert "900 mm" in found.problems[0].sentence


def test_patterns_wider_than_the_projector_are_a_problem(checker):
    wide = SAMPLE.model_copy(update={"patterns": SAMPLE.patterns.model_copy(update={"projector_px": 1920})})
    assert any(problem.kind == "patterns" and "1920 columns" in problem.sentence for problem in checker.check(wide).problems)


def test_time_counts_images_waiting_and_moves(checker):
    plan = edit.set_plan(SAMPLE, settle_s=2.0)
    before, after = checker.check(SAMPLE), checker.check(plan)
    assert after.images_s - before.images_s == pytest.approx(2.0 * len(SAMPLE))
    assert before.images_s == pytest.approx(len(SAMPLE) * 12 * (0.3 + 5 * 0.069))
    assert before.moves_s is not None and before.time_s == before.images_s + before.moves_s > before.images_s
    assert before.bytes == 36 * 12 * 5 * 3 * 2592 * 1944


def test_a_check_is_cancelled_between_viewpoints(checker):
    class Impatient(NoProgress):
        def report(self, done: float, total: float, note: str = "") -> None:
            if note == "rim-01-03":
                raise Cancelled

    with pytest.raises(Cancelled):
        checker.check(SAMPLE, Impatient())


def test_coverage_counts_only_viewpoints_that_can_be_scanned(impeller, monkeypatch):
    monkeypatch.setattr("measureapp.pipeline.plan_coverage.SAMPLES", 500)  # a share of 0.3 to 0.02
    few = SAMPLE.model_copy(update={"groups": SAMPLE.groups[2:]})
    whole = predict_coverage(few, impeller, RIG, (), NoProgress())
    none = predict_coverage(few, impeller, RIG, {viewpoint.id for viewpoint in few}, NoProgress())
    assert whole.predicted > 0.3 and none.predicted == 0.0 and np.count_nonzero(none.counts) == 0
