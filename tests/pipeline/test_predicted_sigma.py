"""The standard deviation that the planner predicts is absolute: that of the clouds, and the true scatter of their points."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.data.mesh import Mesh
from measureapp.data.pattern_sets import DEFAULT_PATTERNS
from measureapp.data.sample_worlds import IDEAL
from measureapp.demo import DemoRequest, run_demo
from measureapp.pipeline.prediction.fringe_noise import fringe_noise, sharpness
from measureapp.pipeline.prediction.light import PartLight
from measureapp.planning.coverage.limits import FringeNoise
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh, write_mesh
from measureapp.project.rig_file import read_rig
from tests.pipeline.predicted_sigma import sigma_ratios
from tests.planning.coverage.parts import blade, casting

RIG = read_rig("paper")
LIGHT = np.array([0.02, 0.1, 0.5, 0.9, 1.15, 2.0])


def test_the_planner_assumes_the_reference_rig_where_it_is_told_nothing_else() -> None:
    made = fringe_noise(DEFAULT_PATTERNS, RIG.exposures_us, RIG)
    assert made.pitch_px == FringeNoise().pitch_px
    assert made.sigma_at(LIGHT) == pytest.approx(FringeNoise().sigma_at(LIGHT), rel=0.05)  # between few values of a curve


def test_fewer_exposures_and_darker_parts_have_more_noise_and_noise_never_ends() -> None:
    usual = fringe_noise(DEFAULT_PATTERNS, RIG.exposures_us, RIG).sigma_at(LIGHT)
    single = fringe_noise(DEFAULT_PATTERNS, RIG.exposures_us[:1], RIG).sigma_at(LIGHT)
    dark = fringe_noise(DEFAULT_PATTERNS, RIG.exposures_us, RIG, light=PartLight(white=0.3)).sigma_at(LIGHT)
    assert (single[:4] > usual[:4]).all() and np.isfinite(single).all()
    assert (dark[:4] > 1.5 * usual[:4]).all()
    assert sharpness(40.0) > sharpness(10.0) > 0.85


def test_the_predicted_standard_deviation_is_that_of_the_clouds_of_a_scan(demo: Demo) -> None:
    project = demo.project
    assert project.nominal is not None
    found = sigma_ratios(project, read_mesh(project.nominal), samples=300)
    assert 0.7 < found.assumed_over_stated < 1.4
    assert 0.8 < found.predicted_over_stated < 1.2
    assert 0.7 < found.predicted_over_scatter < 1.4


@pytest.mark.slow
@pytest.mark.parametrize(("name", "mesh", "seed"), [("casting", casting(), 11), ("blade", blade(), 12)], ids=["casting", "blade"])
def test_the_prediction_holds_for_parts_that_it_was_not_written_with(
    name: str, mesh: Mesh, seed: int, tmp_path: Path, record_property: Callable[[str, object], None]
) -> None:
    nominal = tmp_path / f"{name}.stl"
    write_mesh(nominal, mesh)
    run_demo(DemoRequest(tmp_path / "p", str(nominal), "quarter", 4, seed, conditions=IDEAL), lambda _: None, NoProgress())
    found = sigma_ratios(ProjectFolder.open(tmp_path / "p"), mesh)
    record_property("ratios", found)
    sys.stdout.write(f"\n{name}: {found}\n")
    assert 0.7 < found.assumed_over_stated < 1.4
    assert 0.7 < found.predicted_over_stated < 1.4
    assert 0.7 < found.predicted_over_scatter < 1.4
