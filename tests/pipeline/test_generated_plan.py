"""A generated plan on the virtual rig: what was predicted is what is measured."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.pipeline.closed_loop.coverage import measure_coverage
from measureapp.pipeline.run import ScanRequest, scan_into_project
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.generate import GeneratorSettings, generate_plan
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.robot_file import arm_of


@pytest.mark.slow
def test_a_scan_of_a_generated_plan_measures_what_was_predicted(demo: Demo, tmp_path: Path) -> None:
    """The virtual rig at a quarter of its resolution, calibrated by the demo; its poses, lenses and part differ from the nominal ones."""
    donor = demo.project
    assert donor.program is not None and donor.nominal is not None
    rig, nominal = donor.rig(), read_mesh(donor.nominal)
    from measureapp.planning.coverage.extent import standing

    cell = Feasibility.checked(rig, arm_of(rig), nominal.seen_from(standing(nominal)))
    made = generate_plan(nominal, cell, GeneratorSettings(samples=2000, candidates=1000))
    project = ProjectFolder.create(tmp_path / "p", donor.settings.model_copy(update={"name": "generated"}))
    project.save_inspection(donor.program, donor.nominal)
    project.save_calibration(donor.require_calibration(), donor.rig_uncertainty())
    scan_into_project(ScanRequest(made.plan, rig, project.path, resume=True), lambda _: None, NoProgress())
    measurement = project.measurement()
    assert measurement is not None
    coverage = measure_coverage(measurement, made.plan, nominal, rig, NoProgress(), samples=2000)
    predicted = seen_by(coverage.viewpoints, coverage.samples, rig, coverage.scene)
    seen, areas = predicted.seen, coverage.samples.areas_mm2
    by_view = float((coverage.by_view[seen]).mean())
    together = float(areas[seen.any(axis=0) & coverage.measured].sum() / areas[seen.any(axis=0)].sum())
    stated, found = coverage.share(seen.any(axis=0)), coverage.share(coverage.measured)
    clouds = {view.viewpoint_id: view.cloud for view in measurement.views}
    ratios = [
        float(np.median(clouds[one.id].sigma_mm) / np.nanmedian(row))
        for one, row in zip(coverage.viewpoints, predicted.sigma_mm, strict=True)
    ]
    sys.stdout.write(
        f"\n{len(made.plan)} viewpoints: {stated:.1%} of the surface predicted, {found:.1%} measured; of what was predicted {together:.2%} is "
        f"measured, view by view {by_view:.2%}; measured over predicted standard deviation {min(ratios):.2f} to {max(ratios):.2f}\n"
    )
    assert len(coverage.viewpoints) == len(made.plan)
    assert together > 0.97
    assert by_view > 0.93
    assert found > stated - 0.02
