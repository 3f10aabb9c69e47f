"""The 3-D view draws off-screen."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from ui.look.look import Look
from ui.viewport import colouring
from ui.viewport.backend import choose_backend
from ui.viewport.cloud_view import PREPARING, CloudView
from ui.viewport.frame_budget import FRAME_S, FrameBudget
from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer
from ui.viewport.shuffled_cloud import LIGHT, shuffle

RED = (220, 20, 30)


class FixedBudget(FrameBudget):
    """Learns nothing."""

    def __init__(self, points: int) -> None:
        super().__init__()
        self.fixed = points

    @property
    def points(self) -> int:
        return self.fixed


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
    qtbot.waitUntil(lambda: view.stage.is_resting, timeout=2000)


def test_a_new_cloud_is_framed_until_the_user_moves_the_camera(view):
    view.activate()
    view.set_clouds([block()])
    view.set_clouds([CloudLayer(block().points_mm + 500.0, block().colours)])
    assert reddish(pixels(view))[100:140, 140:180].mean() > 0.9


def test_looking_closer_fills_the_picture_with_what_is_named_without_turning(view):
    view.activate()
    view.set_clouds([block()])
    pixels(view)
    direction = view.stage.scene.camera.vtk.GetDirectionOfProjection()
    corner = np.array([[10.0, 10, 10], [-200, 10, 10]])
    view.look_at(corner)
    pixels(view)
    places = view.stage.scene.camera.pixels(corner)
    assert (places > 0).all() and (places < view.stage.scene.renderer.GetSize()).all()
    assert np.ptp(places[:, 0]) > 0.5 * 320
    assert view.stage.scene.camera.vtk.GetDirectionOfProjection() == pytest.approx(direction)
    view.reset_camera()
    assert reddish(pixels(view))[100:140, 140:180].mean() > 0.9


def test_any_first_part_of_a_shuffled_cloud_stands_for_all_of_it_and_knows_where_its_points_come_from():
    layers = [block(60_000), CloudLayer(block(40_000).points_mm + np.array([100.0, 0, 0]), colouring.plain((0, 0, 255), 40_000))]
    cloud = shuffle(layers)
    parts = cloud.blocks()
    assert [part.start for part in parts] == [0, *(part.stop for part in parts[:-1])]
    assert parts[-1].stop == len(cloud) == 100_000
    share = np.mean(cloud.points_mm[parts[0], 0] > 50)
    assert abs(share - 0.4) < 5 * np.sqrt(0.4 * 0.6 / 10_000)
    for place in (0, 777, 99_999):
        layer, inside = cloud.origin(place)
        assert np.allclose(cloud.points_mm[place], layers[layer].points_mm[inside], atol=1e-5)
    assert cloud.points_mm.dtype == np.float32 and cloud.colours.dtype == np.uint8


def test_points_are_shaded_by_their_normals_but_what_was_not_measured_keeps_its_colour():
    normals = np.array([LIGHT, -LIGHT, np.cross(LIGHT, [0, 0, 1])])
    lit = shuffle([CloudLayer(np.zeros((3, 3)), colouring.plain((200, 200, 200), 3), normals)])
    grey = {int(lit.order[place]): int(lit.colours[place, 0]) for place in range(3)}
    assert grey[0] > grey[1] > grey[2] > 60
    unknown = shuffle([CloudLayer(np.zeros((3, 3)), np.tile(colouring.UNKNOWN, (3, 1)), normals)])
    assert (unknown.colours == colouring.UNKNOWN).all()


def test_the_budget_settles_where_a_frame_takes_its_time_whatever_it_costs_without_points():
    budget = FrameBudget("OpenGL renderer string:  llvmpipe (LLVM 15.0.6, 256 bits)")
    assert budget.software
    for _ in range(60):
        budget.observe(budget.points, 0.03 + 3e-7 * budget.points)
    assert 0.03 + 3e-7 * budget.points == pytest.approx(FRAME_S, rel=0.03)
    assert not FrameBudget("OpenGL renderer string:  NVIDIA GeForce RTX 3060").software


def test_a_cloud_drawn_in_parts_is_the_same_picture_as_one_drawn_at_once(view):
    view.activate()
    layer = block(150_000)
    view.set_clouds([CloudLayer(layer.points_mm * [3, 1, 1], layer.colours)])
    view.set_labels([Label("label", np.zeros(3))])
    scene = view.stage.scene
    scene.budget = FixedBudget(10**9)
    view._view.refresh()
    whole = pixels(view)
    scene.budget = FixedBudget(1)
    view._view.refresh()
    view._view._render()
    assert not scene.is_complete
    assert (pixels(view) == whole).all()
    assert scene.is_complete


def test_while_the_camera_moves_a_frame_has_only_what_its_time_allows(view):
    view.activate()
    view.set_clouds([block(150_000)])
    scene = view.stage.scene
    scene.budget = FixedBudget(50_000)
    scene.set_moving(True)
    view._view.refresh()
    view._view._render()
    assert scene.is_complete and 40_000 < scene.frame_points <= 50_000
    scene.set_moving(False)
    pixels(view)
    assert scene._drawn == len(scene._blocks)


def test_what_was_not_measured_is_hatched_on_points_and_surfaces(view):
    view.activate()
    corners = np.array([[0, 0, 0], [10, 0, 0], [10, 0, 10], [0, 0, 10]], float)
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    levels = []
    for colour in (colouring.UNKNOWN, colouring.UNKNOWN + 8):
        view.set_surface(SurfaceLayer(corners, triangles, np.tile(colour, (4, 1)).astype(np.uint8)))
        levels.append(pixels(view)[110:130, 150:170].mean(axis=2).std())
    assert levels[0] > 10 > 2 > levels[1]  # grey levels, on a face in half shade


@pytest.mark.parametrize(("largest", "end"), [(0.012, 0.02), (0.0049, 0.005), (0.3, 0.5)])
def test_the_end_of_a_scale_is_a_round_number(largest, end):
    assert colouring.upper_end(np.full(100, largest)) == pytest.approx(end)
