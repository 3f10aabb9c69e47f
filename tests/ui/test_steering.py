"""Mouse and keys of the 3-D view; camera, clip box, picks, print."""

from __future__ import annotations

import gc
import weakref

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QStackedWidget, QToolTip

from ui.look.look import Look
from ui.viewport.clip_box import ClipBox
from ui.viewport.cloud_view import CloudView
from ui.viewport.colouring import plain
from ui.viewport.layers import CloudLayer, SurfaceLayer
from ui.viewport.overlay.flag import Flag
from ui.viewport.overlay.legend import Legend
from ui.viewport.point_index import index_points
from ui.viewport.prepared_surface import prepare_surface
from ui.viewport.print_picture import PrintSize
from ui.viewport.shuffled_cloud import shuffle
from ui.viewport.voxel_grid import VoxelGrid

NOTHING = Qt.KeyboardModifier.NoModifier
MIDDLE = QPoint(320, 240)


@pytest.fixture
def view(qtbot):
    made = CloudView(Look("light"))
    qtbot.addWidget(made)
    made.resize(640, 480)
    with qtbot.waitExposed(made):
        made.show()
    made.activate()
    points = np.random.default_rng(3).uniform(-10, 10, (30_000, 3)) * [3, 1, 1]
    made.set_clouds([CloudLayer(points, plain((220, 20, 30), len(points)))])
    made.screenshot()
    made.setFocus()
    yield made
    made.close_view()
    made.close()


def drag(view, end: QPoint, button=Qt.MouseButton.LeftButton, keys=NOTHING, start: QPoint = MIDDLE) -> None:
    for kind, place, one, held in (
        (QEvent.Type.MouseButtonPress, start, button, button),
        (QEvent.Type.MouseMove, start + (end - start) / 2, Qt.MouseButton.NoButton, button),
        (QEvent.Type.MouseMove, end, Qt.MouseButton.NoButton, button),
        (QEvent.Type.MouseButtonRelease, end, button, Qt.MouseButton.NoButton),
    ):
        QApplication.sendEvent(view._view, QMouseEvent(kind, QPointF(place), QPointF(place), one, held, keys))


def place_of(view, point) -> np.ndarray:
    x, y = view.stage.scene.camera.pixels(np.array([point], float))[0]
    return np.array([x, 480 - y])


def test_left_drag_turns_about_the_centre_which_stays_where_it_is(view, qtbot):
    camera = view.stage.scene.camera
    camera.centre_mm = np.array([20.0, 5.0, 0.0])
    axes, before = camera.axes.copy(), place_of(view, camera.centre_mm)
    drag(view, QPoint(400, 200))
    assert np.abs(camera.axes - axes).max() > 0.2
    assert place_of(view, camera.centre_mm) == pytest.approx(before, abs=0.01)
    qtbot.waitUntil(lambda: view.stage.is_resting, timeout=3000)


@pytest.mark.parametrize(
    ("button", "keys"), [(Qt.MouseButton.MiddleButton, NOTHING), (Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier)]
)
def test_middle_or_shift_drag_moves_what_is_under_the_mouse_with_it(view, button, keys):
    axes, before = view.stage.scene.camera.axes.copy(), place_of(view, [0, 0, 0])
    drag(view, MIDDLE + QPoint(50, -30), button, keys)
    assert place_of(view, [0, 0, 0]) - before == pytest.approx([50, -30], abs=0.1)
    assert view.stage.scene.camera.axes == pytest.approx(axes)


def test_the_wheel_keeps_what_is_under_the_cursor_and_alt_drag_fills_the_picture_with_a_box(view):
    camera, at = view.stage.scene.camera, QPointF(200, 300)
    under, _ = camera.ray(200, 179)
    scale = camera.mm_per_px
    QApplication.sendEvent(
        view._view, QWheelEvent(at, at, QPoint(), QPoint(0, 120), Qt.MouseButton.NoButton, NOTHING, Qt.ScrollPhase.NoScrollPhase, False)
    )
    assert camera.mm_per_px == pytest.approx(scale / 1.2)
    assert place_of(view, under) == pytest.approx([200, 301], abs=0.5)
    scale = camera.mm_per_px
    drag(view, QPoint(160, 120), keys=Qt.KeyboardModifier.AltModifier, start=QPoint(320, 240))
    assert camera.mm_per_px == pytest.approx(scale / 4.0, rel=0.01)


def test_a_trembling_click_selects_and_a_double_click_sets_the_centre_of_rotation(view, qtbot):
    with qtbot.waitSignal(view.picked) as told:
        drag(view, MIDDLE + QPoint(2, 1))
    assert told.args[0].is_point and not told.args[0].adds
    with qtbot.waitSignal(view.picked) as told:
        qtbot.mouseClick(view._view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ShiftModifier, MIDDLE)
    assert told.args[0].adds
    qtbot.mouseDClick(view._view, Qt.MouseButton.LeftButton, pos=MIDDLE)
    assert view.stage.scene.camera.centre_mm is not None


def test_a_pick_names_the_measured_point_at_that_place_with_and_without_its_index(view):
    target = view.pick_at(QPointF(MIDDLE))
    view.set_index(index_points(view._cloud))
    assert view.pick_at(QPointF(MIDDLE)).index == target.index
    point = view._clouds[0].points_mm[target.index]
    assert np.linalg.norm(point - target.position_mm) < 8 * view.stage.scene.camera.mm_per_px


def test_keys_of_vtk_do_nothing_and_ours_do(view, qtbot):
    window, camera = view._view._window.vtk, view.stage.scene.camera
    qtbot.keyClick(view, Qt.Key.Key_3)
    assert not window.GetStereoRender()
    view.screenshot()
    assert camera.axes[2] == pytest.approx([-1, 0, 0])
    for key, towards in ((Qt.Key.Key_1, [0, -1, 0]), (Qt.Key.Key_5, [0, 0, 1]), (Qt.Key.Key_4, [1, 0, 0])):
        qtbot.keyClick(view, key)
        view.screenshot()
        assert camera.axes[2] == pytest.approx(towards)
    assert camera.is_parallel
    scale = camera.mm_per_px
    qtbot.keyClick(view, Qt.Key.Key_P)
    assert not camera.is_parallel and camera.mm_per_px == pytest.approx(scale)
    qtbot.keyClick(view, Qt.Key.Key_H)
    assert not view.stage.furniture.is_visible
    qtbot.keyClick(view, Qt.Key.Key_L)
    assert not view.stage.furniture.has_flags
    with qtbot.waitSignal(view.sectionAsked):
        qtbot.keyClick(view, Qt.Key.Key_C)
    axes = camera.axes.copy()
    qtbot.keyClick(view, Qt.Key.Key_F)
    view.screenshot()
    assert camera.axes == pytest.approx(axes, abs=1e-6)


def test_a_face_of_the_cube_is_shown_by_a_click(view, qtbot):
    qtbot.mouseClick(view._view, Qt.MouseButton.LeftButton, pos=QPoint(640 - 52, 30))
    view.screenshot()
    assert view.stage.scene.camera.axes[2] == pytest.approx([0, 0, 1])


def test_a_dragged_end_of_the_legend_is_announced_once_and_escape_undoes_the_gesture(view, qtbot):
    view.set_legend(Legend("Surface deviation", -0.5, 0.5, tolerance=(-0.1, 0.1)))
    view.screenshot()
    stage = view.stage
    layout = stage.furniture.legend_layout(stage.camera_view(), stage.style)
    start = layout.handle_box(view.legend, "high").center().toPoint()
    told = []
    view.legendEdited.connect(told.append)
    drag(view, start - QPoint(0, 20), start=start)
    assert len(told) == 1 and told[0].high > 0.5 and told[0].low == -told[0].high
    assert view.legend == told[0]
    edited = view.legend
    press = QMouseEvent(
        QEvent.Type.MouseButtonPress, QPointF(start), QPointF(start), Qt.MouseButton.LeftButton, Qt.MouseButton.LeftButton, NOTHING
    )
    QApplication.sendEvent(view._view, press)
    for step in (10, 20):
        place = QPointF(start + QPoint(0, step))
        move = QMouseEvent(QEvent.Type.MouseMove, place, place, Qt.MouseButton.NoButton, Qt.MouseButton.LeftButton, NOTHING)
        QApplication.sendEvent(view._view, move)
    assert stage.furniture.legend != edited
    assert view.cancel() and stage.furniture.legend == edited and len(told) == 1


def test_a_dragged_flag_is_pinned_and_a_click_on_it_chooses_it(view, qtbot):
    view.set_flags([Flag("one", np.array([-20.0, 0, 0]), "One", "1.000 mm", verdict="pass")])
    stage = view.stage
    left, top, width, height = stage.furniture.flag_places(stage.camera_view(), stage.style).boxes[0]
    grip = QPoint(round(left + 8), round(top + 8))
    with qtbot.waitSignal(view.flagChosen) as told:
        qtbot.mouseClick(view._view, Qt.MouseButton.LeftButton, pos=grip)
    assert told.args == ["one"]
    with qtbot.waitSignal(view.flagMoved) as told:
        drag(view, grip + QPoint(100, 60), start=grip)
    x, y = told.args[1]
    assert (x * 640, y * 480) == pytest.approx((left + width / 2 + 100, top + height / 2 + 60), abs=1.5)
    assert stage.furniture.flag_places(stage.camera_view(), stage.style).boxes[0][0] == pytest.approx(left + 100, abs=1.5)


def test_the_number_of_flags_without_room_names_each_of_them_under_the_mouse_and_by_a_click(view, monkeypatch):
    shown = []
    monkeypatch.setattr(QToolTip, "showText", lambda _place, words, _widget: shown.append(words))
    names = [f"Distance {place}" for place in range(40)]
    view.set_flags([Flag(name, np.array([0.1 * place, 0, 0]), name, "1.000 mm", verdict="fail") for place, name in enumerate(names)])
    stage, (width, height) = view.stage, (640, 480)
    camera, style = stage.camera_view(), stage.style
    collapsed = [names[index] for index in stage.furniture.flag_places(camera, style).collapsed]
    assert collapsed and len(collapsed) < len(names)
    places = [QPointF(x, y) for x in range(0, width, 4) for y in range(0, height, 4)]
    on_it = [place for place in places if stage.furniture.collapsed_at(place, camera, style)]
    assert on_it and len(on_it) < len(places) / 20
    point_at(view, on_it[len(on_it) // 2])
    lines = view._view.toolTip().splitlines()
    assert [line.split("  ")[1] for line in lines] == collapsed and all(line.endswith("1.000 mm") for line in lines)
    QTest.mouseClick(view._view, Qt.MouseButton.LeftButton, pos=on_it[len(on_it) // 2].toPoint())
    assert shown == [view._view.toolTip()]
    point_at(view, QPointF(5, 5))
    assert view._view.toolTip() == ""


def point_at(view, place: QPointF) -> None:
    none = Qt.MouseButton.NoButton
    QApplication.sendEvent(view._view, QMouseEvent(QEvent.Type.MouseMove, place, place, none, none, NOTHING))


def test_what_is_clipped_is_neither_drawn_nor_selectable_and_the_picture_says_so(view):
    pick = view.pick_at(QPointF(MIDDLE))
    assert pick.is_point
    bounds = np.array(view.stage.scene.bounds_mm()).reshape(3, 2)
    clip = ClipBox.around(bounds.T).with_face(5, 0.0)
    view.set_clip(clip)
    assert view.stage.furniture.notices == ("Clipped",)
    view.screenshot()
    below = view.pick_at(QPointF(MIDDLE))
    assert view._clouds[0].points_mm[below.index][2] <= 0.0 < view._clouds[0].points_mm[pick.index][2]
    assert clip.with_face(5, -50.0).high_mm[2] > clip.low_mm[2]
    view.set_clip(ClipBox(clip.low_mm, clip.high_mm, is_on=False))
    assert view.stage.furniture.notices == () and view.clip is not None


@pytest.mark.parametrize("background", ["white", "transparent"])
def test_a_printed_picture_has_the_resolution_of_print_and_the_window_is_as_before(view, background):
    before = view.screenshot()
    printed = view.print_picture(PrintSize(60.0, 300.0, background))
    assert printed.width() == 709 and printed.height() == round(709 * 480 / 640)
    assert printed.pixelColor(2, 2).alpha() == (255 if background == "white" else 0)
    assert printed.pixelColor(354, 266).alpha() == 255
    assert printed.dotsPerMeterX() == 11811
    assert view.screenshot() == before


def test_several_views_share_one_render_window_that_is_closed_with_the_last(qtbot):
    stack = QStackedWidget()
    qtbot.addWidget(stack)
    views = [CloudView(Look("light")) for _ in range(3)]
    for index, view in enumerate(views):
        stack.addWidget(view)
        layer = CloudLayer(np.random.default_rng(index).normal(size=(500, 3)), plain((200, 40 * index, 30), 500))
        view.set_clouds([layer])
    stack.show()
    for view in views:
        view.activate()
        stack.setCurrentWidget(view)
    windows = {id(view._view._window) for view in views}
    assert len(windows) == 1
    first = views[0].screenshot()
    for _ in range(3):
        for view in views:
            view.screenshot()
    assert views[0].screenshot() == first
    window = views[0]._view._window
    for view in views[:2]:
        view.close_view()
    assert window.parent() is stack
    views[2].close_view()
    assert window.parent() is None


def test_the_grid_finds_the_nearest_point_and_its_subsamples_are_even():
    rng = np.random.default_rng(5)
    points = rng.normal(size=(60_000, 3))
    points = (40 * points / np.linalg.norm(points, axis=1)[:, None]).astype(np.float32)
    grid = VoxelGrid.of(points, 2.0)
    for place in points[:20] + rng.normal(0, 0.5, (20, 3)):
        index, distance = grid.nearest(place)
        assert distance == pytest.approx(np.linalg.norm(points - place, axis=1).min(), abs=1e-4)
        assert np.linalg.norm(points[index] - place) == pytest.approx(distance, abs=1e-4)
    assert grid.nearest(np.array([500.0, 0, 0]))[1] == pytest.approx(np.linalg.norm(points - [500, 0, 0], axis=1).min(), abs=1e-3)
    levels = index_points(shuffle([CloudLayer(points, plain((9, 9, 9), len(points)))])).levels
    assert levels and all(len(points) / len(level.points_mm) >= 4 for level in levels)


def test_a_large_surface_is_drawn_in_parts_with_a_coarse_copy_and_sharp_edges_stay_sharp():
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=6, radius=50.0)
    made = prepare_surface(SurfaceLayer(ball.vertices, ball.faces))
    assert sum(len(part.triangles) for part in made.parts) == len(ball.faces) and len(made.parts) > 1
    assert 5_000 < len(made.proxy.triangles) <= 50_000
    assert np.linalg.norm(made.proxy.vertices_mm, axis=1) == pytest.approx(50.0, abs=0.3)
    box = trimesh.creation.box()
    part = prepare_surface(SurfaceLayer(box.vertices, box.faces)).parts[0]
    used = part.normals[np.unique(part.triangles)]
    assert np.sort(np.abs(used), axis=1) == pytest.approx(np.tile([0, 0, 1], (len(used), 1)), abs=1e-6)


def test_fifty_changes_of_the_view_leave_no_widgets_timers_actors_or_scenes_behind(qtbot):
    stack = QStackedWidget()
    qtbot.addWidget(stack)
    stack.resize(300, 260)
    views = [CloudView(Look("light")) for _ in range(2)]
    layer = CloudLayer(np.random.default_rng(1).normal(size=(300, 3)), plain((200, 40, 30), 300))
    for view in views:
        stack.addWidget(view)
    stack.show()
    counts = []
    for cycle in range(50):
        view = views[cycle % 2]
        stack.setCurrentWidget(view)
        view.activate()
        view.set_clouds([layer])
        view.set_index(index_points(view._cloud))
        view.repaint()
        view._view.repaint()
        actors = [view.stage.scene.renderer.GetActors().GetNumberOfItems() for view in views if view.stage]
        counts.append((len(QApplication.allWidgets()), len(stack.findChildren(QTimer)), *actors))
    assert counts[-1] == counts[10] and counts[-1][-1] == 1
    scenes = [weakref.ref(view.stage.scene) for view in views]
    for view in views:
        view.close_view()
        view._view = view.stage = None
    qtbot.wait(1)
    gc.collect()
    assert [scene() for scene in scenes] == [None, None]
