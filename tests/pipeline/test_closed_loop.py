"""The closed loop: coverage of a scan, holes with their causes, and proposals that gain what they promise."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.arrays import BoolArray
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.pipeline.closed_loop.causes import CAUSES, Cause, Explained, explain_holes, holes_of, shares_by_cause
from measureapp.pipeline.closed_loop.coverage import WIDE, MeasuredCoverage
from measureapp.pipeline.closed_loop.next_views import NextViewsSettings, ScanCell, extended, propose
from measureapp.pipeline.closed_loop.of_project import find_next_views
from measureapp.pipeline.run import ScanRequest, scan_into_project
from measureapp.planning.coverage.extent import standing
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.viewpoints import plan_around_part
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from tests.pipeline.predicted_rig import box, joined, nominal_rig

CHANCE = 0.9  # of a visible point, in these scans
RIG = read_rig("paper")
SETTINGS = NextViewsSettings(candidates=200, most=3)


@cache
def scene() -> tuple[PartScene, SurfaceSamples]:
    """A block with a tower beside it, and samples of both."""
    part = joined(box((60.0, 60.0, 40.0)), box((24.0, 24.0, 90.0), (42.0, 0.0, 0.0)))
    made = PartScene.of(part.seen_from(standing(part)), RIG)
    return made, sample_surface(made, 900)


def plan_of(count: int) -> ScanPlan:
    return plan_around_part(RIG, "test", radius_mm=60.0, height_mm=90.0, count=count)


def scanned(plan: ScanPlan, dead: BoolArray | None = None, required_mm: float | None = None) -> MeasuredCoverage:
    """A scan that measures each visible sample of every view with the same chance, except those that nothing measures."""
    part, samples = scene()
    viewpoints = tuple(plan)
    visible = seen_by(viewpoints, samples, RIG, part, WIDE).seen
    by_view = visible & (np.random.default_rng(5).random(visible.shape) < CHANCE) & ~(False if dead is None else dead)
    measured = by_view.any(axis=0)
    sigma = np.where(measured, 0.01, np.inf)
    return MeasuredCoverage(samples, part, viewpoints, (), measured, sigma, np.full(len(samples), 0.4), visible, by_view, required_mm)


def explained(coverage: MeasuredCoverage) -> Explained:
    camera = nominal_rig().calibration.cameras.cameras[RIG.reference]
    return explain_holes(coverage, camera.pinhole, None, NoProgress())


def test_proposals_gain_what_they_promise() -> None:
    plan = plan_of(2)
    before = scanned(plan)
    found = propose(before, explained(before), plan, ScanCell(RIG), SETTINGS)
    assert found and all(one.kind == "viewpoint" for one in found)
    promised = sum(one.share for one in found)
    part, samples = scene()
    seen = seen_by(tuple(one.viewpoint for one in found), samples, RIG, part, WIDE).seen
    rng = np.random.default_rng(9)
    gained = [before.share((seen & (rng.random(seen.shape) < CHANCE)).any(axis=0) & ~before.measured) for _ in range(20)]
    assert promised > 0.05
    # samples are few, and the chance was learnt from two views: its prior and their scatter are a few per cent
    assert promised == pytest.approx(float(np.mean(gained)), rel=0.15)
    rates = [one.area_mm2 / one.seconds for one in found]
    assert rates[0] > 0.8 * max(rates)  # exact times of moves are known after the choice


def test_an_extended_plan_keeps_its_viewpoints_and_takes_the_same_images_there() -> None:
    plan = plan_of(2)
    before = scanned(plan)
    longer = extended(plan, propose(before, explained(before), plan, ScanCell(RIG), SETTINGS))
    assert longer.extends(plan) and not plan.extends(longer)
    assert tuple(longer)[: len(plan)] == tuple(plan)
    assert len({viewpoint.id for viewpoint in longer}) == len(longer)


def test_a_complete_scan_needs_nothing_more() -> None:
    plan = plan_of(2)
    complete = replace(scanned(plan), measured=np.ones(len(scene()[1]), bool), sigma_mm=np.full(len(scene()[1]), 0.01))
    assert propose(complete, explained(complete), plan, ScanCell(RIG), SETTINGS) == ()
    assert holes_of(explained(complete), complete.samples) == ()


def test_what_no_view_sees_and_what_touches_the_table_are_told_apart() -> None:
    coverage = scanned(plan_of(2))
    found = explained(coverage)
    bottom = np.asarray(coverage.samples.normals[:, 2] < -0.9) & (coverage.samples.points_mm[:, 2] < 1.0)
    assert np.array_equal(found.of(Cause.SUPPORT), bottom)
    assert np.array_equal(found.of(Cause.UNSEEN), ~coverage.predicted & ~bottom)
    shares = shares_by_cause(found, coverage)
    assert sum(shares.values()) == pytest.approx(1.0 - coverage.share(coverage.measured))
    assert list(shares.values()) == sorted(shares.values(), reverse=True)


def test_a_required_standard_deviation_makes_noisy_points_a_hole() -> None:
    coverage = scanned(plan_of(2), required_mm=0.005)
    found = explained(coverage)
    assert not coverage.sufficient.any()
    assert np.array_equal(found.of(Cause.NOISY), coverage.measured & ~found.of(Cause.SUPPORT))


def test_points_that_were_too_dark_get_another_exposure_rather_than_another_viewpoint() -> None:
    plan = plan_of(2)
    _, samples = scene()
    top = np.asarray((samples.normals[:, 2] > 0.9) & (samples.points_mm[:, 2] > 80.0))
    coverage = scanned(plan, dead=top)
    dark = coverage.visible & top
    cause = explained(coverage).cause.copy()
    cause[top] = CAUSES.index(Cause.DARK)
    lost = Explained(cause, dark, np.zeros_like(dark))
    only_top = replace(coverage, measured=~top, sigma_mm=np.where(top, np.inf, 0.01))
    found = propose(only_top, lost, plan, ScanCell(RIG), SETTINGS)
    assert found[0].kind == "exposure" and found[0].viewpoint.id.endswith("-longer")
    original = next(one for one in plan if found[0].viewpoint.id.startswith(one.id))
    assert found[0].viewpoint.exposures_us is not None
    assert min(found[0].viewpoint.exposures_us) > plan.exposures_of(original)[0]
    assert found[0].viewpoint.flange == original.flange and found[0].viewpoint.table_deg == original.table_deg
    assert "too dark" in found[0].reason


def test_what_many_views_should_have_measured_and_did_not_is_hardly_worth_another() -> None:
    """An area that was visible in vain is given up; one of the same size that no view saw is not."""
    plan = plan_of(6)
    _, samples = scene()
    top = np.asarray((samples.normals[:, 2] > 0.9) & (samples.points_mm[:, 2] > 80.0))
    in_vain = scanned(plan, dead=top)
    failed = propose(in_vain, explained(in_vain), plan, ScanCell(RIG), SETTINGS)
    tower = samples.areas_mm2[top].sum() / samples.area_mm2
    unseen = replace(in_vain, visible=in_vain.visible & ~top)
    fresh = propose(unseen, explained(unseen), plan, ScanCell(RIG), SETTINGS)
    assert sum(one.share for one in fresh) > sum(one.share for one in failed) + 0.5 * tower


def test_the_same_viewpoint_with_another_exposure_is_no_extension() -> None:
    plan = plan_of(2)
    changed: tuple[Viewpoint, ...] = (plan[0].model_copy(update={"exposures_us": (90_000,)}), plan[1])
    assert not plan.model_copy(update={"viewpoints": changed}).extends(plan)
    stated = tuple(one.model_copy(update={"exposures_us": plan.bracket.exposures_us}) for one in plan)
    assert plan.model_copy(update={"viewpoints": stated}).extends(plan)  # the same images, said in another way


@pytest.mark.slow
def test_the_proposals_after_a_short_scan_raise_its_coverage_as_predicted(
    demo: Demo, tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    """Two viewpoints of the virtual rig, then those that are proposed; the calibration is that of the demo, of the same rig."""
    donor = demo.project
    plan = donor.plan()
    assert plan is not None and donor.program is not None
    few = plan.model_copy(update={"viewpoints": plan.viewpoints[:2]})
    project = ProjectFolder.create(tmp_path / "p", replace_name(donor.settings))
    project.save_inspection(donor.program, donor.nominal)
    project.save_calibration(donor.require_calibration(), donor.rig_uncertainty())
    scan_into_project(ScanRequest(few, donor.rig(), project.path, resume=True), lambda _: None, NoProgress())
    before = find_next_views(project, NextViewsSettings(most=3))
    assert before.proposals
    project.save_plan(before.plan)
    scan_into_project(ScanRequest(before.plan, donor.rig(), project.path, resume=True), lambda _: None, NoProgress())
    after = find_next_views(project, NextViewsSettings(most=3), from_images=False)
    gains = {"promised": before.expected - before.sufficient, "gained": after.sufficient - before.sufficient}
    record_property("share of the surface", gains)
    assert gains["promised"] > 0.02
    # the chance is learnt from two views; the wide limits of visibility let some of the borders be missed
    assert gains["gained"] == pytest.approx(gains["promised"], rel=0.25)


def replace_name(settings: ProjectSettings) -> ProjectSettings:
    return settings.model_copy(update={"name": "short scan"})
