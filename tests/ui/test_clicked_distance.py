"""Measuring by clicking: two points, a distance with its uncertainty, and taking it back."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from measureapp.inspection.point_distance import point_distance
from ui.look.look import Look
from ui.pages.clicked_distance import FIRST, SECOND, ClickedPoint, DistanceTool
from ui.pages.clouds.cloud_picture import CloudPicture
from ui.pages.picked_point import PickedPoint


@pytest.fixture
def tool(qtbot):
    made = DistanceTool(Look("light"))
    qtbot.addWidget(made.button)
    return made


def point(x: float, view: str = "view-01") -> ClickedPoint:
    return ClickedPoint(np.array([x, 0.0, 0.0]), 0.01, view)


def test_two_clicks_make_a_distance_and_undo_takes_back_one_step_at_a_time(tool):
    told = []
    tool.changed.connect(lambda: told.append(tool.hint))
    tool.button.setChecked(True)
    tool.click(point(0.0))
    tool.click(point(30.0, "view-02"))
    tool.click(point(5.0))
    assert told == [FIRST, SECOND, FIRST, SECOND]
    (one,) = tool.distances
    assert (one.length_mm, one.uncertainty_mm) == point_distance(np.array([[0, 0, 0], [30.0, 0, 0]]), (0.01, 0.01), same_view=False)
    assert tool.labels(Look("light").theme)[0].text.startswith("30.000 ± 0.0")
    tool.undo()
    assert tool.hint == FIRST and len(tool.distances) == 1 and tool.can_undo
    tool.undo()
    assert not tool.distances and not tool.can_undo


def test_the_properties_say_what_the_distance_is_and_where_its_ends_come_from(tool):
    tool.button.setChecked(True)
    tool.click(point(0.0))
    tool.click(point(-12.5, "view-03"))
    shown = tool.properties()
    rows = dict(row for group in shown.groups for row in group.rows)
    assert rows["Distance"].startswith("12.500") and rows["x"].startswith("\u221212.500")
    assert "single points" in shown.note
    assert [dict(group.rows)["View"] for group in shown.groups[1:]] == ["view-01", "view-03"]


def test_putting_the_tool_away_forgets_the_point_that_waits_and_keeps_the_distances(tool):
    tool.button.setChecked(True)
    for x in (0.0, 1.0, 2.0):
        tool.click(point(x))
    tool.button.setChecked(False)
    assert tool.hint == "" and len(tool.distances) == 1
    tool.button.setChecked(True)
    assert tool.hint == FIRST


def test_on_the_clouds_page_clicks_measure_while_the_tool_is_on_and_undo_takes_that_back_first(application, window, measurement):
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    page = window.pages["clouds"]
    assert not page.undo.isVisible()
    page.distance.button.setChecked(True)
    assert page.hint.text() == FIRST
    page.view.pointPicked.emit(0, 10)
    page.view.pointPicked.emit(0, 200)
    places = measurement.stitched.points_mm[[10, 200]]
    assert page.distance.distances[0].length_mm == pytest.approx(np.linalg.norm(places[1] - places[0]))
    assert page.properties.title == "Distance"
    assert [label.text for label in page.view._labels] == [page.distance.distances[0].words]
    assert page.undo.isVisible() and "distance" in page.undo.toolTip()
    page.undo.click()
    assert not page.distance.distances and page.view._labels == () and page.view._lines == ()
    page.view.pointPicked.emit(0, 10)
    application.session.set_stitched(replace(measurement.stitched))
    assert not page.distance.can_undo


def test_on_the_inspection_page_a_click_shows_view_and_position_in_the_nominal_and_measures_on_the_points(
    application, window, measurement, qtbot
):
    application.session.set_measurement(measurement, {})
    window.show_page("inspection")
    page = window.pages["inspection"]
    page.shape.setValue("points")
    page.view.pointPicked.emit(0, 10)
    assert page.properties.title == "Point"
    qtbot.waitUntil(lambda: len(page.view._labels) == 1 and len(page.view._flags) == 1)  # the point, and the dimension selected
    page.shape.setValue("surface")
    page.distance.button.setChecked(True)
    assert page.shape.value() == "points"
    page.view.pointPicked.emit(0, 10)
    page.view.pointPicked.emit(0, 200)
    assert len(page.distance.distances) == 1 and page.undo.isVisible()


@pytest.mark.parametrize(("stage", "known"), [("before", False), ("after", True), ("merged", True), ("filtered", True)])
def test_points_of_every_cloud_that_was_stitched_bring_the_errors_of_its_views(stage, known):
    errors = object()
    session = SimpleNamespace(stitched=SimpleNamespace(view_names=("v0", "v1"), errors=errors), scale_ppm=5.0)
    point = PickedPoint("v1", np.zeros(3), 0.01, 0.5, None, 2)
    clicked = CloudPicture(SimpleNamespace(), session, ()).clicked(stage, point)
    assert (clicked.number, clicked.errors) == ((1, errors) if known else (None, None))
    assert clicked.scale_ppm == 5.0


def test_a_distance_is_as_uncertain_as_the_lengths_of_the_rig(tool):
    tool.button.setChecked(True)
    for scale_ppm in (0.0, 100.0):
        tool.click(point(0.0))
        tool.click(point(500.0))
        tool.click(replace(point(0.0), scale_ppm=scale_ppm))
        tool.click(point(500.0))
    exact, by_board = tool.distances[0].uncertainty_mm, tool.distances[-1].uncertainty_mm
    assert by_board**2 - exact**2 == pytest.approx((2 * 100e-6 * 500) ** 2)
