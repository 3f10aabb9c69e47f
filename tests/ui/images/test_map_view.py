"""Maps show the arrays they are made of, pixel by pixel."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from tests.ui.heartbeat import Heartbeat
from tests.ui.images.maps import LARGE, phase_map
from ui.images.layers import Layer, frame_layer, layer_of


def test_a_map_draws_its_array_with_scale_and_unit(view, begun):
    layer = layer_of(phase_map(), "phase")
    view.show_layer(layer)
    begun(view)
    image, scale = view._items["image"], view._items["scale"]
    assert np.array_equal(image.image, layer.values, equal_nan=True)
    assert tuple(image.getLevels()) == pytest.approx(layer.span)
    assert scale.is_shown and scale.words == "Absolute phase [rad]"
    view.show_layer(layer_of(phase_map(), "state"))
    assert not scale.is_shown
    view.show_layer(layer)
    assert scale.is_shown and tuple(image.getLevels()) == pytest.approx(layer.span)


@pytest.mark.parametrize("pixel", [(0, 0), (39, 59), (20, 31)])
def test_the_pixel_under_the_cursor_is_the_one_that_is_drawn_there(view, begun, pixel):
    view.show_layer(layer_of(phase_map(), "phase"))
    begun(view)
    assert view.pixel_at(view.place_of(*pixel)) == pixel


def test_saturated_pixels_of_a_stored_image_are_red(view, begun):
    image = np.full((20, 30), 100, np.uint8)
    image[4, 5] = 255
    view.show_layer(frame_layer(image), 255)
    begun(view)
    item = view._items["image"]
    assert tuple(item.lut[item.image[0, 0]]) == (100, 100, 100)
    assert tuple(item.lut[item.image[4, 5]]) == (209, 73, 91)


@pytest.mark.parametrize("colour", [(12, 90, 200), (240, 128, 7)])
def test_a_picture_is_drawn_in_its_colours_from_the_first_time_on(view, begun, colour):
    pixels = np.empty((30, 40, 3), np.uint8)
    pixels[:] = colour
    for _ in range(2):
        view.show_pixels(pixels)
        begun(view)
        drawn = view.grab().toImage().pixelColor(view.place_of(15, 20).toPoint())
        assert drawn.getRgb()[:3] == colour


def test_a_map_without_any_value_is_shown_empty(view):
    view.show_layer(Layer("Absolute phase", "rad", np.full((10, 12), np.nan, np.float32), 3))
    assert not view.grab().isNull()
    view.clear()
    assert view.pixel_at(view.rect().center().toPointF()) is None


def test_arrow_keys_move_the_cursor_and_stop_at_the_edge(qtbot, view):
    view.show_layer(layer_of(phase_map(), "phase"))
    told = []
    view.pointed.connect(lambda row, column: told.append((row, column)))
    for key, modifier in ((Qt.Key.Key_Right, Qt.KeyboardModifier.NoModifier), (Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)):
        QTest.keyClick(view, key, modifier)
    assert told == [(20, 31), (10, 31)]
    for _ in range(3):
        QTest.keyClick(view, Qt.Key.Key_Up, Qt.KeyboardModifier.ShiftModifier)
    assert told[-1] == (0, 31)


@pytest.mark.timed
def test_showing_maps_of_a_large_camera_does_not_stall_the_window(qtbot, view):
    layers = [layer_of(phase_map(LARGE), kind) for kind in ("phase", "sigma", "state")]
    frame = np.random.default_rng(1).integers(0, 256, LARGE, np.uint8)
    view.show_layer(layers[0])
    qtbot.wait(50)
    with Heartbeat() as heart:
        for layer in layers:
            view.show_layer(layer)
            qtbot.wait(60)
        view.show_layer(frame_layer(frame), 255)
        qtbot.wait(60)
    heart.check()
