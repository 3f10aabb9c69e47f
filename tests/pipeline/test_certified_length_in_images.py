"""A length of the demo's part that is stated as certified corrects the others, whose errors by images, calibration and stitching it shares."""

from __future__ import annotations

import pytest
from demo_fixture import Demo

from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.dimensions import inspect
from measureapp.pipeline.assemble import project_settings
from measureapp.pipeline.chosen_views import select_views
from measureapp.project.geometry.files import read_mesh
from measureapp.project.program_file import read_program

CERTIFIED_MM = 0.002


@pytest.mark.parametrize("off", [-0.5, 0.5])
def test_the_other_lengths_come_nearer_to_the_truth_and_their_interval_contains_it(demo: Demo, off: float) -> None:
    """The certificate is off by its standard uncertainty, to either side."""
    project = demo.project
    measurement = project.measurement()
    settings = project_settings(project, measurement.calibration, select_views(measurement.views, project.view_choices()))
    truth = {one["name"]: one["true"] for one in demo.document["true_dimensions"]}
    plain = {one.name: one for one in measurement.inspection.dimensions}
    program = read_program(project.program).model_dump(mode="json", exclude_unset=True)
    for one in program["dimensions"]:
        if one["name"] == "c":
            one |= {"nominal": truth["c"] + off * CERTIFIED_MM, "certificate": {"uncertainty_mm": CERTIFIED_MM}}
    found = inspect(measurement.stitched, InspectionProgram.model_validate(program), read_mesh(project.nominal), settings).dimensions
    corrected = {one.name: one for one in found}
    for name in ("a", "b"):
        assert corrected[name].uncertainty < 0.8 * plain[name].uncertainty
        assert abs(corrected[name].measured - truth[name]) <= corrected[name].uncertainty
    assert abs(corrected["b"].measured - truth["b"]) < abs(plain["b"].measured - truth["b"]) / 2
    assert corrected["c"].measured == plain["c"].measured
