"""Growing features by clicking on the Inspect page."""

from __future__ import annotations

import tomllib
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication

from measureapp.data.inspection_program import InspectionProgram


@pytest.fixture
def measurement(measurement):
    """The ball stands on a plate, so that a region has an end."""
    ball, rng = measurement.stitched, np.random.default_rng(4)
    plate = np.column_stack([rng.uniform(-120, 120, (6000, 2)), np.full(6000, -5.0)])
    arrays = {
        "points_mm": np.vstack([ball.points_mm, plate]),
        "normals": np.vstack([ball.normals, np.tile([0.0, 0, 1], (6000, 1))]),
        "sigma_mm": np.full(12_000, 0.01),
        "grey": np.full(12_000, 0.5),
        "view": np.arange(12_000) % 6,
    }
    return replace(measurement, stitched=replace(ball, **arrays))


@pytest.fixture
def page(application, window, measurement, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.set_measurement(measurement, {})
    window.show_page("inspection")
    return window.pages["inspection"]


def settled(application, qtbot):
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=20_000)


def test_a_click_grows_the_ball_and_its_lines_can_be_copied_and_undone(application, page, measurement, qtbot):
    page.grow.button.setChecked(True)
    assert page.grow.isVisible() and page.shape.value() == "points"
    page.grow.shape.setValue("sphere")
    lines = len(page.view._lines)
    page.view.pointPicked.emit(0, 100)
    settled(application, qtbot)
    grown = page.grow.last
    assert grown is not None, application.session.messages[-1].text
    place = measurement.inspection.alignment.nominal_from_part.apply(measurement.stitched.points_mm[[100]])[0]
    assert grown.feature.shape == "sphere" and grown.feature.radius_mm == pytest.approx(60.0, abs=1e-3)
    assert grown.seed_mm == pytest.approx(tuple(place))
    assert len(page.view._lines) == lines + 1 and "sphere 1   radius 60.000 mm" in [one.text for one in page.view._labels]
    page.act()
    copied = tomllib.loads(QGuiApplication.clipboard().text())
    program = InspectionProgram.model_validate({"name": "p", "alignment": "none", **copied})
    assert program.features[0].grow.seed_mm == pytest.approx(grown.seed_mm, abs=1e-3)
    page.undo.click()
    assert page.grow.last is None and not page.undo.isVisible()
    qtbot.waitUntil(lambda: len(page.view._lines) == lines)


def test_where_no_such_shape_is_nothing_grows_and_the_reason_is_shown(application, page, qtbot):
    page.grow.button.setChecked(True)
    page.grow.shape.setValue("cone")
    page.view.pointPicked.emit(0, 100)
    settled(application, qtbot)
    assert page.grow.last is None
    assert application.session.messages[-1].level == "error" and application.session.messages[-1].hint


def test_measuring_and_growing_are_never_on_at_once_and_new_clouds_forget(application, page, measurement, qtbot):
    page.distance.button.setChecked(True)
    page.grow.button.setChecked(True)
    assert not page.distance.is_on
    page.grow.shape.setValue("sphere")
    page.view.pointPicked.emit(0, 7)
    settled(application, qtbot)
    assert page.grow.last is not None
    page.distance.button.setChecked(True)
    assert not page.grow.is_on
    application.session.set_stitched(measurement.stitched.where(np.arange(3000)))
    assert page.grow.last is None
