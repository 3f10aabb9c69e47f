"""Live images and stored ones of a camera are shown by one view: saturation, level under the mouse, zoom that stays, overlays of a board."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtCore import QEvent, QRectF, QTimer

from tests.ui.heartbeat import Heartbeat
from tests.ui.images.maps import LARGE
from ui.images.board_view import HEAT, BoardView, Overlay
from ui.images.camera_images import CameraImages
from ui.images.camera_view import CameraView
from ui.images.live_tile import LiveTile

FAIL = (209, 73, 91)


def colour_at(view, row, column):
    return view.map.grab().toImage().pixelColor(view.map.place_of(row, column).toPoint()).getRgb()[:3]


def noise(seed, dtype=np.uint8, top=256):
    return np.random.default_rng(seed).integers(0, top, LARGE, dtype)


@pytest.mark.parametrize(("dtype", "saturation"), [(np.uint8, 255), (np.uint8, 240), (np.uint16, 4095)])
def test_saturated_pixels_are_red_and_no_others(shown, begun, look, dtype, saturation):
    pixels = np.full((20, 30), saturation // 2, dtype)
    pixels[:10] = saturation
    pixels[10, 0] = saturation - 1
    view = shown(CameraView(look))
    view.show_image(pixels, "left", saturation)
    begun(view.map)
    assert colour_at(view, 4, 5) == FAIL
    for row, column, level in ((15, 5, saturation // 2), (10, 0, saturation - 1)):
        red, green, blue = colour_at(view, row, column)
        assert red == green == blue == pytest.approx(255 * level / saturation, abs=1.5)


def test_without_a_saturation_the_brightest_pixel_is_white(shown, begun, look):
    view = shown(CameraView(look))
    pixels = np.zeros((20, 30), np.uint16)
    pixels[3:6, 3:6] = 900
    view.show_image(pixels, "left")
    begun(view.map)
    assert colour_at(view, 4, 4) == (255, 255, 255)


def test_the_level_under_the_mouse_is_that_of_the_newest_image(qtbot, shown, look):
    view = shown(CameraView(look))
    first, second = noise(1), noise(2)
    view.show_image(first, "left · 80 ms", 255)
    assert view.words.text() == "left · 80 ms"
    view.map.pointed.emit(40, 200)
    assert view.words.text() == f"Row 40, column 200: {first[40, 200]}"
    view.show_image(second, "left · 20 ms", 255)
    assert view.words.text() == f"Row 40, column 200: {second[40, 200]}"
    view.leaveEvent(QEvent(QEvent.Type.Leave))
    assert view.words.text() == "left · 20 ms" == view.caption


def test_zoom_stays_from_one_live_image_to_the_next(shown, begun, look):
    view = shown(CameraView(look))
    view.show_image(noise(1), "left", 255)
    begun(view.map)
    view.map.plot.setRange(QRectF(100, 100, 200, 150), padding=0.0)
    zoomed = view.map.plot.getViewBox().viewRect()
    view.show_image(noise(2), "left", 255)
    assert view.map.plot.getViewBox().viewRect() == zoomed
    view.map.show_all()
    assert view.map.plot.getViewBox().viewRect().contains(QRectF(0, 0, LARGE[1] - 1, LARGE[0] - 1))


def test_words_stand_where_there_is_no_image(qtbot, shown, look):
    view = shown(CameraView(look))
    view.show_image(noise(1), "left", 255)
    view.clear("There is no image of this view.")
    assert view.is_empty and view.caption == "" and view.empty.isVisible() and not view.map.isVisible()


def test_corners_coverage_and_the_wanted_position_lie_at_their_pixels(qtbot, shown, begun, look):
    view = shown(BoardView(look))
    corners, out, ghost = np.array([[30.0, 40.0], [60.0, 40.0]]), np.array([[90.0, 20.0]]), np.array([[5.0, 5], [70, 5], [70, 60]])
    coverage = np.zeros((9, 12))
    coverage[0, 11] = 4.0
    view.show_board(np.full((90, 120), 200, np.uint8), Overlay(corners, out, ghost, coverage), "view 1")
    begun(view.map)
    theme = look.theme
    assert colour_at(view, 40, 30) == theme.colour("verdict_pass").getRgb()[:3]
    assert colour_at(view, 20, 90) == theme.colour("verdict_fail").getRgb()[:3]
    plain, tinted = colour_at(view, 80, 10), colour_at(view, 5, 115)
    assert plain == (200, 200, 200)
    accent = np.array(theme.colour("accent").getRgb()[:3])
    assert np.allclose(tinted, 200 + HEAT * (accent - 200), atol=2)
    curve = next(item for item in view.map.plot.listDataItems() if isinstance(item, pg.PlotCurveItem))
    assert np.array_equal(np.column_stack(curve.getData()), [*ghost, ghost[0]])
    view.show_layers(["coverage"])
    qtbot.wait(30)
    assert colour_at(view, 40, 30) == plain
    look.set_shade("dark")  # drawn again, with what is chosen
    assert colour_at(view, 40, 30) == plain
    assert not any(isinstance(item, pg.PlotCurveItem) for item in view.map.plot.listDataItems())
    look.set_shade("light")


def test_the_axes_of_several_cameras_are_made_one_after_the_other(qtbot, shown, look):
    pictures = shown(CameraImages(look))
    pictures.show_cameras(dict.fromkeys(("left", "right", "top"), 255))
    maps = [image.map for image in pictures.images.values()]
    made, beat = [0], QTimer()
    beat.timeout.connect(lambda: made.append(sum(one.plot is not None for one in maps)))
    beat.start(0)
    for level, camera in enumerate(pictures.images):
        pictures.show_image(camera, np.full((4, 6), level, np.uint8), 10_000)
    pictures.show_image("top", np.full((4, 6), 9, np.uint8), 20_000)
    qtbot.waitUntil(lambda: made[-1] == 3)
    beat.stop()
    assert set(np.diff(made)) == {0, 1}
    assert maps[2].layer.values.max() == 9
    assert pictures.images["top"].caption.replace("\u00a0", " ") == "top · 20 ms"


@pytest.mark.timed
@pytest.mark.parametrize("themes", [False, pytest.param(True, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("dtype", "saturation"), [(np.uint8, 255), (np.uint16, 4095)])
def test_three_live_cameras_at_ten_images_per_second_do_not_stall_the_window(qtbot, shown, look, dtype, saturation, themes):
    """From the first image on: axes are made, images are replaced, one is zoomed into, the theme changes."""
    images = [noise(seed, dtype, saturation + 1) for seed in range(4)]
    with Heartbeat() as heart:
        tiles = [shown(LiveTile(look, name, saturation), 400, 420) for name in ("left", "right", "upper")]
        qtbot.wait(100)
        for turn in range(20):
            heart.place = f"image {turn}"
            for place, tile in enumerate(tiles):
                tile.show_pixels(images[(turn + place) % 4], 20_000)
            if turn == 8:
                tiles[0].image.map.plot.setRange(QRectF(100, 100, 200, 150), padding=0.0)
            if turn == 14 and themes:
                look.set_shade("dark")
            qtbot.wait(100)
        look.set_shade("light")
    heart.check()
