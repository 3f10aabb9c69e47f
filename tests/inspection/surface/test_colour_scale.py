"""Colours of deviations: one scale for window, report and files."""

import numpy as np
import pytest

from measureapp.data.deviation_scale import DeviationScale
from measureapp.inspection.surface.colour_scale import BEYOND_SHADE, GO, NO_GO, RAMPS, ColourScale


def test_blue_is_below_red_above_and_the_band_has_a_colour_of_its_own():
    low, inside, high = ColourScale(-0.2, 0.2, tolerance=(-0.05, 0.05)).colours(np.array([-0.2, 0.04, 0.2]))
    assert low[2] > low[0] and high[0] > high[2]
    np.testing.assert_array_equal(inside, RAMPS["blue-white-red"].band)


def test_what_is_beyond_the_range_is_darker_than_its_end():
    end, beyond = ColourScale(-0.2, 0.2).colours(np.array([0.2, 0.21]))
    np.testing.assert_allclose(beyond, BEYOND_SHADE * end)


def test_two_colours_tell_inside_from_outside():
    made = ColourScale(-0.2, 0.2, tolerance=(-0.05, 0.1), go_no_go=True).colours(np.array([-0.06, -0.05, 0.1, 0.11]))
    np.testing.assert_array_equal(made, [NO_GO, GO, GO, NO_GO])


def test_steps_never_cross_the_band():
    scale = ColourScale(-0.2, 0.2, steps=4, tolerance=(-0.05, 0.05))
    inside, outside = scale.colours(np.array([0.049, 0.051]))
    assert (inside == RAMPS["blue-white-red"].band).all() and (outside != inside).any()
    assert len(np.unique(scale.colours(np.linspace(0.11, 0.19, 30)), axis=0)) == 1


@pytest.mark.parametrize("range_mm", [None, (-0.4, 0.3)])
def test_a_stored_scale_takes_the_usual_range_unless_it_has_its_own(range_mm):
    scale = ColourScale.of(DeviationScale(range_mm=range_mm, swapped=True), (-0.2, 0.2))
    assert (scale.low, scale.high) == (range_mm or (-0.2, 0.2))
    assert scale.colours(np.array([scale.low]))[0, 0] > scale.colours(np.array([scale.low]))[0, 2]  # red below


def test_stops_cover_the_range():
    scale = ColourScale(-0.2, 0.2, ramp="growing")
    assert scale.stops(3) == ["#26185f", "#1f968b", "#f0e442"]
