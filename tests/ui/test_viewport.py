"""The 3-D view draws off-screen."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from ui.look.look import Look
from ui.viewport import colouring
from ui.viewport.backend import choose_backend
from ui.viewport.cloud_view import PREPARING, CloudView
from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer, shuffled_prefix

RED = (220, 20, 30)


@pytest.fixture
def view(qtbot):
    look = Look("light")
    made = CloudView(look)
    qtbot.addWidget(made)
    made.resize(320, 240)
    made.show()
    yield made
    made.close_view()
    made.close()


def pixels(view: CloudView) -> np.ndarray:
    image = view.screenshot().convertToFormat(view.screenshot().format())
    raw = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return raw[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def reddish(picture: np.ndarray) -> np.ndarray:
    return picture[:, :, 0] - picture[:, :, 1] > 90


def block(count: int = 20_000) -> CloudLayer:
    points = np.random.default_rng(3).uniform(-10, 10, (count, 3))
    return CloudLayer(points, colouring.plain(RED, count))


def test_under_the_offscreen_platform_the_off_screen_backend_is_chosen(qapp):
    assert choose_backend() == "off-screen"


def test_until_it_is_allowed_to_draw_it_says_that_it_prepares(view):
    view.set_clouds([block()])
    assert not view.is_live
    assert view.screenshot().isNull()
    assert view.findChild(type(view._placeholder)).text() == PREPARING


def test_a_cloud_appears_in_the_middle_and_the_corners_stay_empty(view):
    view.set_clouds([block()])
    view.activate()
    red = reddish(pixels(view))
    assert red[100:140, 140:180].mean() > 0.9
    assert not red[:8, :8].any()
    assert not red[-8:, -8:].any()


def test_clearing_the_cloud_leaves_the_background_alone(view):
    view.activate()
    view.set_clouds([block()])
    assert reddish(pixels(view)).any()
    view.set_clouds([])
    assert not reddish(pixels(view)).any()


def test_a_surface_lines_and_labels_are_drawn(view):
    view.activate()
    empty = pixels(view)
    corners = np.array([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]], float)
    view.set_surface(SurfaceLayer(corners, np.array([[0, 1, 2], [0, 2, 3]]), colour=RED))
    surface = pixels(view)
    assert reddish(surface).sum() > 500
    view.set_lines([LineLayer((np.array([[0, 0, 5.0], [10, 10, 5.0]]),), (0, 0, 255), 3)])
    lined = pixels(view)
    assert ((lined[:, :, 2] - lined[:, :, 0]) > 150).any()
    view.set_labels([Label("120.021 mm", np.array([5.0, 5, 5]), (0, 160, 0))])
    labelled = pixels(view)
    assert (labelled != lined).any()
    assert (empty != labelled).any()


def test_dragging_turns_the_part_and_the_wheel_zooms(view, qtbot):
    view.activate()
    layer = block(2000)
    view.set_clouds([CloudLayer(layer.points_mm * [3, 0.3, 0.3], layer.colours)])
    before = pixels(view)
    inner = view._view
    qtbot.mousePress(inner, Qt.MouseButton.LeftButton, pos=QPoint(160, 120))
    qtbot.mouseMove(inner, QPoint(220, 150))
    from PySide6.QtCore import QEvent, QPointF
    from PySide6.QtGui import QMouseEvent
    from PySide6.QtWidgets import QApplication

    move = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(240, 160),
        QPointF(240, 160),
        Qt.MouseButton.NoButton,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(inner, move)
    qtbot.mouseRelease(inner, Qt.MouseButton.LeftButton, pos=QPoint(240, 160))
    assert (pixels(view) != before).mean() > 0.01
    qtbot.waitUntil(lambda: not view._view._rest.isActive(), timeout=2000)


def test_a_new_cloud_is_framed_until_the_user_moves_the_camera(view):
    view.activate()
    view.set_clouds([block()])
    view.set_clouds([CloudLayer(block().points_mm + 500.0, block().colours)])
    assert reddish(pixels(view))[100:140, 140:180].mean() > 0.9


def test_the_part_drawn_while_moving_is_a_random_part_of_the_budgets_size():
    chosen = shuffled_prefix(1000, 100)
    assert chosen is not None
    assert len(set(chosen.tolist())) == 100
    assert abs(chosen.mean() - 500) < 100
    assert shuffled_prefix(100, 100) is None


def test_values_that_are_not_finite_are_grey_on_every_scale():
    colours = colouring.along(colouring.GROWING, np.array([0.0, 1.0, np.nan]), 0.0, 1.0)
    assert tuple(colours[2]) == tuple(colouring.UNKNOWN)
    assert tuple(colours[0]) == tuple(colouring.GROWING[0].astype(int))
    assert tuple(colours[1]) == tuple(colouring.GROWING[-1].astype(int))


@pytest.mark.parametrize(("largest", "end"), [(0.012, 0.02), (0.0049, 0.005), (0.3, 0.5)])
def test_the_end_of_a_scale_is_a_round_number(largest, end):
    assert colouring.upper_end(np.full(100, largest)) == pytest.approx(end)
