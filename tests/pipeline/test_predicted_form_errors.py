"""Smooth errors of predicted clouds: drawn as stated, found again by registration, and taken from the last scan of the rig."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.prediction.form_errors import bend, measured_form_mm, usual_form_mm
from measureapp.pipeline.prediction.setup import with_form_errors
from measureapp.pipeline.prediction.uncertainty import Job, predict_uncertainty, predict_views
from measureapp.pipeline.prediction.views import PredictedScene
from measureapp.progress import NoProgress
from measureapp.project.program_file import parse_program
from tests.pipeline.predicted_rig import box, nominal_rig, plan_for
from tests.pipeline.test_predicted_uncertainty import PROGRAM, SIZE_MM

SIZE = 0.03  # mm, several times what the noise alone leaves


def scan_of(size_mm: float, form: Any = True) -> Any:
    """As much of a measurement as the form error is read from."""
    errors = SimpleNamespace(form=SimpleNamespace(sizes_mm=np.full(3, size_mm)) if form else None)
    return SimpleNamespace(stitched=SimpleNamespace(errors=errors))


def test_registration_finds_the_errors_that_were_drawn_and_states_them_in_u() -> None:
    rig, plan = nominal_rig(), plan_for(nominal_rig().description, 8)
    job = Job(parse_program(PROGRAM), box(SIZE_MM))
    plain, bent = (
        predict_uncertainty(plan, PredictedScene.of(one, NominalSurface(job.nominal)), job) for one in (rig, replace(rig, form_mm=SIZE))
    )
    found = measured_form_mm(SimpleNamespace(stitched=bent.stitched))  # type: ignore[arg-type]
    assert (
        found is not None and 0.4 * SIZE < found < 1.2 * SIZE
    )  # pairs share a part of each cloud, and compensate the rigid part of its error
    for name in ("length", "width"):
        before, after = plain.uncertainty(name), bent.uncertainty(name)
        assert before is not None and after is not None
        assert after**2 - before**2 > (4 * SIZE) ** 2  # stitching carries them from view to view, and enlarges them


def test_a_bent_cloud_moves_along_its_normals_by_a_smooth_field_of_the_stated_size() -> None:
    rig = nominal_rig()
    scene = PredictedScene.of(rig, NominalSurface(box(SIZE_MM)))
    moved = []
    for view in predict_views(plan_for(rig.description, 8), scene, NoProgress()):
        change = np.asarray(bend(view, SIZE).cloud.points_mm) - np.asarray(view.cloud.points_mm)
        normals = np.asarray(view.cloud.normals, float)
        along = np.einsum("ij,ij->i", change, normals)
        np.testing.assert_allclose(change, along[:, None] * normals, atol=1e-6)
        neighbours = np.linalg.norm(np.diff(np.asarray(view.cloud.points_mm), axis=0), axis=1) < 4.0
        assert neighbours.sum() > 100 and np.abs(np.diff(along))[neighbours].max() < 0.4 * SIZE
        moved.append(along)
    # a cloud spans few correlation lengths: about two independent values each
    assert np.sqrt(np.mean(np.concatenate(moved) ** 2)) == pytest.approx(SIZE, rel=0.5)
    assert not np.allclose(moved[0][:100], moved[1][:100])  # every view has its own


def test_the_size_is_stated_measured_or_usual_in_this_order_and_the_source_says_which() -> None:
    rig = nominal_rig()
    usual = with_form_errors(rig, None, None)
    assert usual.form_mm == usual_form_mm(rig.description) == pytest.approx(1.5e-5 * rig.description.standoff_mm)
    assert usual.source.endswith("as usual rigs have")
    measured = with_form_errors(rig, None, scan_of(0.004))
    assert measured.form_mm == pytest.approx(0.004) and measured.source.endswith("0.0040 mm, as the last scan shows")
    stated = with_form_errors(rig, 0.0, scan_of(0.004))
    assert stated.form_mm == 0.0 and stated.source.endswith("as stated")
    assert measured_form_mm(scan_of(0.004, form=False)) is None
