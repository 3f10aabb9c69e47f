"""Filtering the merged cloud in the window, and taking it back."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.errors import InputError
from measureapp.project.geometry.files import read_stitched, write_cloud
from measureapp.register.clouds.filter_chain import Filter
from ui.look.look import Look
from ui.widgets.filter_form import FilterForm


@pytest.mark.parametrize(
    "wanted",
    [
        Filter("statistical", (1.5, 12)),
        Filter("radius", (3.25, 7)),
        Filter("islands", (80.0,)),
        Filter("box", (-10, 20, -30, 40, 0, 55)),
        Filter("plane", (0, -1, 0, -12.5)),
    ],
)
def test_the_form_gives_back_the_filter_it_was_given(qtbot, wanted):
    form = FilterForm(Look("light"))
    qtbot.addWidget(form)
    form.setValue(wanted)
    assert form.value() == wanted


def test_a_box_that_ends_before_it_begins_is_refused(qtbot):
    form = FilterForm(Look("light"))
    qtbot.addWidget(form)
    form.kind.setValue("box")
    form.sides[0].setValue(50)
    form.sides[1].setValue(-50)
    with pytest.raises(InputError, match="box is empty"):
        form.value()


@pytest.fixture
def clouds(application, window, measurement, tmp_path, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    stored = tmp_path / "stitched_cloud.ply"
    write_cloud(stored, measurement.stitched)
    application.session.set_measurement(measurement, {"stitched_cloud": stored})
    window.show_page("clouds")
    return window.pages["clouds"]


def settled(application, qtbot):
    qtbot.waitUntil(lambda: not application.controllers.jobs.queue.busy and not application.session.busy_with, timeout=10_000)


def test_filters_add_up_beside_the_stitched_cloud_and_are_undone_one_by_one(application, clouds, measurement, tmp_path, qtbot):
    stitched, beside = measurement.stitched, tmp_path / "filtered_cloud.ply"
    clouds.filter_button.setChecked(True)
    assert clouds.filters.isVisible() and not clouds.undo.isVisible()
    for wanted, left in ((Filter("plane", (0, 0, 1, 60.0)), 60.0), (Filter("plane", (0, 0, 1, 90.0)), 90.0)):
        clouds.filters.setValue(wanted)
        clouds.filters.button.click()
        settled(application, qtbot)
        kept = application.session.filtered
        assert kept.points_mm[:, 2].min() >= left and len(kept) == np.count_nonzero(stitched.points_mm[:, 2] >= left)
        assert kept.view_names == stitched.view_names
        assert len(read_stitched(beside)) == len(kept) and read_stitched(beside).view_names == kept.view_names
    assert clouds.stage.value() == "filtered" and ", filtered " in clouds.state.text()
    assert application.session.stitched is stitched
    clouds.undo.click()
    settled(application, qtbot)
    assert len(read_stitched(beside)) == len(application.session.filtered) == np.count_nonzero(stitched.points_mm[:, 2] >= 60)
    clouds.undo.click()
    settled(application, qtbot)
    assert application.session.filtered is None and not beside.exists()
    assert clouds.stage.value() == "merged" and not clouds.undo.isVisible()
    assert (tmp_path / "stitched_cloud.ply").exists()


def test_a_filter_that_leaves_nothing_changes_nothing_and_says_why(application, clouds, qtbot):
    clouds.filters.setValue(Filter("plane", (0, 0, 1, 5000.0)))
    clouds.filters.button.click()
    settled(application, qtbot)
    assert application.session.filtered is None
    assert "removes all points" in application.session.messages[-1].text


def test_another_stitched_cloud_forgets_the_filters_of_the_last(application, clouds, measurement, qtbot):
    clouds.filters.setValue(Filter("statistical", (1.0, 8)))
    clouds.filters.button.click()
    settled(application, qtbot)
    assert application.session.filtered is not None and application.controllers.filtering.can_undo
    application.session.set_stitched(measurement.stitched.where(np.arange(3000)))
    assert application.session.filtered is None and not application.controllers.filtering.can_undo
    assert clouds.stage.value() == "merged"


def test_residuals_of_a_filtered_cloud_can_be_shown_and_its_points_clicked(application, clouds, qtbot):
    clouds.filters.setValue(Filter("plane", (0, 0, 1, 60.0)))
    clouds.filters.button.click()
    settled(application, qtbot)
    clouds.colour_by.setValue("residual")
    qtbot.waitUntil(lambda: not clouds.is_composing, timeout=20_000)
    place = 10
    clouds.view.pointPicked.emit(0, place)
    kept = application.session.filtered
    assert clouds._point.point_mm == pytest.approx(kept.points_mm[place])
