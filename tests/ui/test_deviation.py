"""Deviations from the drawing: computed beside the window, shown with a legend."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from ui.charts.deviation_histogram import BINS, DeviationHistogram
from ui.controllers import comparison as comparisons
from ui.look.look import Look
from ui.pages.inspection.deviation_card import DeviationCard
from ui.pages.inspection.deviation_display import NOT_COMPARED, DeviationDisplay, usual_legend
from ui.pages.inspection.part_picture import SHAPE_TIPS
from ui.pages.inspection.section_bar import CutPlane, cut_lines
from ui.pages.layers import deviation_layers, deviation_surface, vertex_normals
from ui.session import Comparison
from ui.viewport.colouring import UNKNOWN
from ui.viewport.overlay.legend import Legend


@pytest.fixture
def compared(measurement, tmp_path, monkeypatch) -> Comparison:
    """The measured ball (radius 60 mm, noise free) against a drawing of 59.9 mm, of which the lower half was not measured."""
    import trimesh

    from measureapp.project import folder as folders
    from measureapp.project.geometry import files
    from measureapp.project.journal.state import Journal

    ball = trimesh.creation.icosphere(subdivisions=4, radius=59.9)
    nominal = Mesh(np.asarray(ball.vertices) + np.array([0, 0, 60.0]), ball.faces, "nominal")
    (tmp_path / "project.json").write_text("{}")
    project = SimpleNamespace(nominal=tmp_path / "nominal.stl", program=None, results=tmp_path / "results", journal=Journal(tmp_path))
    monkeypatch.setattr(folders.ProjectFolder, "open", lambda _path: project)
    monkeypatch.setattr(files, "read_mesh", lambda _path, _frame: nominal)
    normals = np.random.default_rng(5).normal(size=(80_000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    normals = normals[normals[:, 2] > 0]
    count, stitched = len(normals), measurement.stitched
    half = type(stitched)(
        normals * 60.0 + [0, 0, 60.0], normals, np.full(count, 0.01), np.full(count, 0.5), np.zeros(count, int), stitched.placements
    )
    job = SimpleNamespace(report=lambda *_: None, check=lambda: None)
    found = comparisons.compare_cloud(half, measurement.inspection.alignment, tmp_path, job)
    assert found is not None
    return found


def test_points_outside_the_nominal_deviate_by_their_distance_and_what_no_point_lies_near_is_not_measured(compared):
    assert compared.deviation.mean_mm == pytest.approx(0.1, abs=0.06)  # facets of the drawing lie up to 0.05 mm inside its ball
    assert (compared.deviation.distances_mm > 0).all()
    assert np.mean(compared.unmeasured_mm[:, 2] < 60.0) > 0.9
    assert compared.deviation.unmeasured_share == pytest.approx(0.5, abs=0.1)


def test_places_not_measured_are_grey_and_never_a_colour_of_the_scale(compared):
    points, missing = deviation_layers(compared, np.zeros_like(compared.deviation.points_mm), usual_legend(compared))
    assert (missing.colours == UNKNOWN).all()
    assert points.to_read and missing.to_read
    assert not (np.abs(points.colours.astype(int) - UNKNOWN).max(axis=1) == 0).any()
    surface = deviation_surface(compared, usual_legend(compared))
    assert np.mean((surface.colours == UNKNOWN).all(axis=1)) == pytest.approx(0.5, abs=0.1)


@pytest.fixture
def card(qtbot, compared):
    """The card with the display that it shows."""
    display = DeviationDisplay()
    made = DeviationCard(Look("light"), display)
    qtbot.addWidget(made)
    made.show_comparison(compared)
    display.show_comparison(compared)
    return made


def test_the_card_sums_up_the_deviations_in_words(card, compared):
    assert "rms" in card.words.text() and "mm" in card.words.text()
    assert "Maximum" in card.extremes.text() or "maximum" in card.extremes.text()
    assert card.unmeasured.words.text().startswith("Not measured: ")
    assert card.histogram.counts.sum() == len(compared.stitched)


def test_the_tolerance_band_of_the_card_is_that_of_the_legend_and_its_shares_are_those_of_the_core(card, compared):
    display, statistics = card._display, compared.statistics
    assert display.legend.tolerance == statistics.tolerance_mm and display.shares()[0] == statistics.inside
    limit = round(float(np.percentile(np.abs(compared.deviation.distances_mm), 80)), 3)
    card.tolerance.setValue(limit)
    share = 100 * np.mean(np.abs(compared.deviation.distances_mm) <= limit)
    assert display.legend.tolerance == (-limit, limit)
    assert card.bands.text().replace("\u00a0", " ").startswith(f"{share:.1f} % within")
    assert display.legend.fractions.inside == pytest.approx(share / 100)
    display.take_legend(display.legend.with_tolerance(-0.2, 0.2))
    assert card.tolerance.value() == 0.2


def test_the_legend_says_whether_colours_are_smoothed_and_keeps_what_was_set_when_the_part_is_compared_again(card, compared):
    display = card._display
    assert display.legend.note == "Mean of the points nearby"
    card.on.setValue("points")
    assert display.legend.note.startswith("Smoothed, radius ")
    card.smooth.setChecked(False)
    assert display.legend.note == "Each point"
    display.take_legend(display.legend.with_range(-0.5, 0.5))
    display.show_comparison(compared)
    assert (display.legend.low, display.legend.high) == (-0.5, 0.5)
    display.forget()
    display.show_comparison(compared)
    assert (display.legend.low, display.legend.high) == compared.statistics.range_mm


def test_the_histogram_counts_what_lies_beyond_its_scale_in_the_outermost_bars_in_the_colours_of_the_legend(qtbot):
    histogram = DeviationHistogram(Look("light"))
    qtbot.addWidget(histogram)
    histogram.show()
    histogram.show_values(np.array([-9.0, -0.001, 0.001, 0.002, 7.0, 8.0]), Legend("Deviation", -0.05, 0.05))
    assert (histogram.counts[0], histogram.counts[-1], histogram.counts.sum(), len(histogram.counts)) == (1, 2, 6, BINS)
    histogram.resize(480, 160)
    qtbot.waitUntil(lambda: histogram.plot is not None)
    picture = histogram.grab().toImage()
    colours = [picture.pixelColor(x, y) for x in range(picture.width()) for y in range(picture.height())]
    assert any(colour.blue() - colour.red() > 80 for colour in colours)
    assert any(colour.red() - colour.blue() > 80 for colour in colours)


def test_the_inspection_page_shows_deviations_once_they_are_known_and_forgets_them_with_the_project(
    application, window, measurement, compared, qtbot
):
    session, page = application.session, window.pages["inspection"]
    window.show_page("inspection")
    session.set_measurement(measurement, {})
    assert page.shape.value() == "surface"
    assert not page.side.deviation.isVisible()
    session.set_comparison(compared)
    assert page.shape.value() == "deviation"
    page.side.list.setValue("deviation")
    assert page.side.deviation.isVisible()
    qtbot.waitUntil(lambda: page.view._surface is not None and page.view.legend is not None, timeout=10_000)
    page.side.deviation.on.setValue("points")
    qtbot.waitUntil(lambda: len(page.view._clouds) == 2, timeout=10_000)
    session.open_project("other", "gear", None)
    assert session.comparison is None and page.side.list.value() == "dimensions"
    assert page.shape.value() == "surface"


def test_normals_of_a_dense_surface_point_away_from_a_ball():
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=3, radius=10.0)
    vertices = np.asarray(ball.vertices)
    normals = vertex_normals(vertices, np.asarray(ball.faces))
    assert np.einsum("nd,nd->n", normals, vertices / 10.0).min() > 0.999


def test_a_cut_through_the_ball_draws_its_circle_with_the_deviations_on_the_measured_half(compared):
    lines, words = cut_lines(compared, CutPlane("x", 0.0))
    nominal, *whiskers = lines
    assert np.linalg.norm(np.vstack(nominal.lines) - [0, 0, 60.0], axis=1) == pytest.approx(59.9, abs=0.1)
    assert whiskers and all(one[0][2] > 58.0 for layer in whiskers for one in layer.lines)
    assert words.startswith("Deviations × ")
    assert cut_lines(compared, CutPlane("z", 500.0))[1] == "No intersection"
    assert cut_lines(compared, CutPlane("z", 10.0))[1] == "Not measured"


def test_the_inspection_page_cuts_where_the_bar_says_and_labels_all_dimensions(qtbot, application, window, measurement, compared):
    application.session.set_measurement(measurement, {})
    window.show_page("inspection")
    page = window.pages["inspection"]
    assert not page.cut.button.isEnabled()
    assert page.shape.button("deviation").toolTip() == page.side.list.button("deviation").toolTip() == NOT_COMPARED
    application.session.set_stitched(compared.stitched)
    application.session.set_comparison(compared)
    assert page.shape.button("deviation").toolTip() == SHAPE_TIPS["deviation"] and not page.side.list.button("deviation").toolTip()
    qtbot.waitUntil(lambda: bool(page.view._lines))
    before = len(page.view._lines)
    for place_mm in (-20.0, 5.0, 0.0):  # each is cut on a thread; the last wish is what is shown in the end
        page.cut.setValue(CutPlane("x", place_mm))
    qtbot.waitUntil(lambda: page.cut.words.words.startswith("Deviations") and not page.cutting._is_cutting, timeout=20_000)
    qtbot.waitUntil(lambda: len(page.view._lines) > before)
    assert page.cut.value() == CutPlane("x", 0.0)
    page.cut.button.setChecked(False)
    qtbot.waitUntil(lambda: len(page.view._lines) == before)
    page.labels.setChecked(True)
    labelled = {"a": "pass", "b": "fail", "c": "not proven"}  # d has no features
    qtbot.waitUntil(lambda: {flag.title: flag.verdict for flag in page.view._flags if flag.verdict} == labelled)


def test_residuals_of_single_points_are_signed_before_merging_and_rms_on_the_merged_cloud(application, window, measurement, qtbot):
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    page = window.pages["clouds"]
    page.colour_by.setValue("residual")
    qtbot.waitUntil(lambda: not page.is_composing and not page._stale, timeout=20_000)
    assert (page.view.legend.low, page.view.legend.quantity) == (0.0, "Residual (rms)")
    page.stage.setValue("before")
    qtbot.waitUntil(lambda: not page.is_composing and not page._stale, timeout=20_000)
    assert page.view.legend.low == -page.view.legend.high and page.view.legend.quantity == "Residual"
    view, placement = measurement.views[1], measurement.stitched.placements[1]
    cloud = page.picture.placed.get(view, placement, fine=False)
    near, kept = page.picture.residuals.of(cloud, measurement.stitched), page.picture.residuals.of(cloud, measurement.stitched)
    assert near is kept and np.nanmax(np.abs(near)) < 0.2  # both lie on one ball; chords between neighbours sag this much
    assert len(page.view._clouds) == len(measurement.views)
