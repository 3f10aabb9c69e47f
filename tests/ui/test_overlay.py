"""Legend, flags and scale bar: numbers, edits, layout."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPainter

from measureapp.inspection.surface.colour_scale import RAMPS
from ui.look.theme import Theme
from ui.viewport.colouring import UNKNOWN
from ui.viewport.menus import parse_number
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.flag import Flag
from ui.viewport.overlay.flag_layout import MOST_BOXES, lay_out_flags, leader_end, lines_cross
from ui.viewport.overlay.furniture import Furniture
from ui.viewport.overlay.legend import Fractions, Histogram, Legend, one_two_five, usual_range
from ui.viewport.overlay.legend_edits import dragged, reset, scaled, symmetric, with_value
from ui.viewport.overlay.legend_layout import LARGEST_FRACTION
from ui.viewport.overlay.scale_bar import bar_length_mm
from ui.viewport.overlay.style import OverlayStyle

TOLERANCE = (-0.1, 0.1)
SIZE = (900.0, 640.0)


def legend(**changes) -> Legend:
    return replace(Legend("Surface deviation", -0.5, 0.5, tolerance=TOLERANCE), **changes)


@pytest.fixture
def style(qapp) -> OverlayStyle:
    return OverlayStyle.of(Theme.load("light"))


def camera() -> CameraView:
    projection = np.diag([2 / 90.0, 2 / 64.0, 1 / 100.0, 1.0])
    return CameraView(projection, np.eye(3), *SIZE, mm_per_px=0.1)


@pytest.mark.parametrize("ramp", [name for name in RAMPS if name != "growing"])
@pytest.mark.parametrize("steps", [0, 10, 15])
def test_every_value_inside_the_tolerance_has_the_colour_of_the_band_and_no_other_value_has(ramp, steps):
    inside = legend(ramp=ramp, steps=steps).colours(np.linspace(*TOLERANCE, 21))
    assert (inside == np.rint(RAMPS[ramp].band)).all()
    outside = legend(ramp=ramp, steps=steps).colours(np.array([-0.101, 0.101, -0.4, 0.4]))
    assert not (outside == inside[0]).all(axis=1).any()


@pytest.mark.parametrize("ramp", list(RAMPS))
def test_what_has_no_value_is_grey_which_no_value_is(ramp):
    colours = legend(ramp=ramp).colours(np.array([np.nan, *np.linspace(-0.7, 0.7, 2000)]))
    assert (colours[0] == UNKNOWN).all()
    assert np.abs(colours[1:].astype(int) - UNKNOWN).max(axis=1).min() > 3


def test_beyond_the_range_colours_are_darker_than_at_its_ends_and_go_no_go_has_two():
    low, high, beyond = legend().colours(np.array([-0.5, 0.5, 0.9])).astype(int)
    assert beyond.sum() < 0.7 * high.sum() and low[2] > low[0] and high[0] > high[2]
    two = legend(go_no_go=True).colours(np.linspace(-0.4, 0.4, 50))
    assert len(np.unique(two, axis=0)) == 2
    assert (legend(swapped=True).colours(np.array([0.5])) == [low]).all()


def test_the_default_range_covers_twice_the_tolerance_and_nearly_all_values_but_not_the_extremes():
    values = np.random.default_rng(1).normal(0, 0.05, 20_000)
    values[0] = 40.0
    assert usual_range(values, (-0.02, 0.02)) == (-0.2, 0.2)
    assert usual_range(values, (-0.3, 0.1)) == (-0.6, 0.6)


def test_fractions_sum_to_one_and_the_histogram_keeps_its_counts_on_any_range():
    values = np.concatenate([np.random.default_rng(2).normal(0, 0.1, 9_000), np.full(1_000, np.nan)])
    found = Fractions.of(values, TOLERANCE, 0.2)
    assert found.inside + found.below + found.above + found.no_data == pytest.approx(1.0)
    assert found.no_data == pytest.approx(0.2 + 0.8 * 0.1)
    assert found.inside == pytest.approx(0.8 * 0.9 * 0.683, abs=0.02)
    assert Histogram.of(values).on(-1, 1, 40).sum() == pytest.approx(9_000, rel=0.01)


def test_ends_of_equal_size_stay_tied_while_one_is_dragged_or_typed():
    assert with_value(legend(), "tolerance high", 0.2).tolerance == (-0.2, 0.2)
    assert with_value(legend(tolerance=(-0.1, 0.3)), "tolerance high", 0.2).tolerance == (-0.1, 0.2)
    wider = dragged(legend(), "high", 30.0, 150.0)
    assert (wider.low, wider.high) == (-0.7, 0.7)
    assert legend().with_range(1.0, 1.0) == legend()


def test_the_wheel_goes_through_steps_of_one_two_five_and_reset_returns():
    widths = [scaled(legend(), notches).high for notches in (-2, -1, 1, 2, 3)]
    assert widths == [0.1, 0.2, 1.0, 2.0, 5.0]
    changed = symmetric(legend(low=-0.2, high=0.7, steps=10, usual=(-0.5, 0.5)))
    assert (changed.low, changed.high) == (-0.7, 0.7)
    assert (reset(changed).low, reset(changed).steps) == (-0.5, 0)


@pytest.mark.parametrize(("words", "value"), [("\u22120,25", -0.25), ("+0.1 mm", 0.1), ("1,000.5", None), ("wide", None)])
def test_typed_numbers_are_read_with_point_or_comma(words, value):
    assert parse_number(words) == value


def test_lengths_of_the_scale_bar_are_round_and_fit():
    for mm_per_px in np.geomspace(1e-4, 10, 60):
        length = bar_length_mm(mm_per_px)
        assert length == one_two_five(length) and 0.4 * 160 * mm_per_px <= length <= 160 * mm_per_px * (1 + 1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_lines_of_flags_do_not_cross_and_boxes_do_not_overlap(seed):
    rng = np.random.default_rng(seed)
    anchors = rng.uniform((100, 60), (800, 580), (16, 2))
    sizes = [(120.0, 50.0)] * 16
    places = lay_out_flags(anchors, sizes, (12, 12, 876, 616))
    assert places.collapsed == ()
    lines = [(*leader_end(box, tuple(anchors[index])), *anchors[index]) for index, box in places.boxes.items()]
    outside = [line for line in lines if 140 < line[2] < 760]  # an anchor under a column of boxes has its line from above or below
    assert not any(lines_cross(one, other) for one, other in combinations(outside, 2))
    for one, other in combinations(places.boxes.values(), 2):
        apart = one[0] + one[2] <= other[0] or other[0] + other[2] <= one[0]
        assert apart or one[1] + one[3] <= other[1] + 1e-6 or other[1] + other[3] <= one[1] + 1e-6


def test_more_flags_than_fit_are_collapsed_the_first_ones_stay_and_dragged_ones_are_where_they_were_put():
    anchors = np.random.default_rng(3).uniform(200, 600, (50, 2))
    places = lay_out_flags(anchors, [(60.0, 20.0)] * 50, (0, 0, 900, 900), {40: (450.0, 450.0)})
    assert len(places.boxes) == MOST_BOXES and len(places.collapsed) == 50 - MOST_BOXES
    assert places.boxes[40] == (420.0, 440.0, 60.0, 20.0)
    assert set(range(MOST_BOXES - 1)) < set(places.boxes)


def test_everything_is_painted_on_an_image_and_found_again_under_the_mouse(style):
    flags = tuple(
        Flag(f"f{index}", np.array([index - 4.0, 3.0, 0.0]), f"Distance {index}", "1.000 mm", verdict="fail") for index in range(9)
    )
    furniture = Furniture(legend(fractions=Fractions(0.9, 0.05, 0.03, 0.02)), flags, "Best fit", ("Clipped",))
    image = QImage(int(SIZE[0]), int(SIZE[1]), QImage.Format.Format_RGB32)
    image.fill(0xFFFFFF)
    blank = image.copy()
    painter = QPainter(image)
    furniture.paint(painter, camera(), style)
    painter.end()
    assert image != blank
    layout = furniture.legend_layout(camera(), style)
    assert layout.panel.height() <= LARGEST_FRACTION * SIZE[1] + 1
    assert furniture.legend_part_at(layout.handle_box(furniture.legend, "high").center(), camera(), style) == "high"
    assert furniture.legend_part_at(QPointF(5, 300), camera(), style) is None
    index, box = next(iter(furniture.flag_places(camera(), style).boxes.items()))
    assert furniture.flag_at(QPointF(box[0] + 5, box[1] + 5), camera(), style) == index
    assert furniture.face_at(QPointF(SIZE[0] - 52, 52), camera(), style) == "top"
    furniture.is_visible = False
    assert furniture.face_at(QPointF(SIZE[0] - 52, 52), camera(), style) == ""


def test_boxes_stay_where_they_are_while_the_camera_moves(style):
    furniture = Furniture(flags=(Flag("one", np.array([-30.0, 0, 0]), "One"), Flag("two", np.array([30.0, 9.0, 0]), "Two")))
    still = furniture.flag_places(camera(), style)
    furniture.moving = True
    turned = replace(camera(), projection=camera().projection @ np.diag([-1, 1, -1, 1.0]))
    assert furniture.flag_places(turned, style) == still
    furniture.moving = False
    assert furniture.flag_places(turned, style) != still
