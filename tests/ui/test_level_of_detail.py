"""What is drawn when: a first part of the points while turning, all of them in parts when still."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from ui.look.look import Look
from ui.viewport.cloud_view import CloudView
from ui.viewport.colouring import plain
from ui.viewport.frame_budget import FRAME_S, FrameBudget, LevelChoice
from ui.viewport.layers import CloudLayer
from ui.viewport.point_size import HOLES, LEAST_PX, MOST_PX, point_size_px

COUNT, BUDGET = 150_000, 40_000
SOFTWARE = "OpenGL renderer string:  llvmpipe (LLVM 15.0.6, 256 bits)"


class FixedBudget(FrameBudget):
    """Learns nothing."""

    @property
    def points(self) -> int:
        return BUDGET


@pytest.fixture
def view(qtbot):
    made = CloudView(Look("light"))
    qtbot.addWidget(made)
    made.resize(320, 240)
    with qtbot.waitExposed(made):
        made.show()
    made.activate()
    made.stage.scene.budget = FixedBudget(SOFTWARE)
    points = np.random.default_rng(3).uniform(-10, 10, (COUNT, 3))
    made.set_clouds([CloudLayer(points, plain((220, 20, 30), COUNT))])
    made.screenshot()
    yield made
    made.close_view()
    made.close()


def drag(widget, step: int) -> None:
    place = QPointF(160 + 10 * step, 120)
    nothing = Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(
        widget, QMouseEvent(QEvent.Type.MouseMove, place, place, Qt.MouseButton.NoButton, Qt.MouseButton.LeftButton, nothing)
    )
    widget.repaint()


def test_while_the_mouse_turns_each_frame_is_the_same_first_part_and_nothing_is_handed_to_the_graphics_again(view, qtbot):
    scene, inner = view.stage.scene, view._view
    data = [block.GetMapper().GetInput() for block in scene._blocks]
    handed = [found.GetMTime() for found in data]
    qtbot.mousePress(inner, Qt.MouseButton.LeftButton, pos=QPoint(160, 120))
    shown, pictures = [], []
    for step in range(1, 5):
        drag(inner, step)
        shown.append([bool(block.GetVisibility()) for block in scene._blocks])
        pictures.append(inner._image.copy())
    expected = int(np.searchsorted(scene._ends, BUDGET, side="right"))
    assert all(flags == [True] * expected + [False] * (len(flags) - expected) for flags in shown)
    assert scene.frame_points == scene._ends[expected - 1] <= BUDGET
    assert all(one != other for one, other in itertools.pairwise(pictures))
    assert [block.GetMapper().GetInput() for block in scene._blocks] == data
    assert [found.GetMTime() for found in data] == handed
    qtbot.mouseRelease(inner, Qt.MouseButton.LeftButton, pos=QPoint(200, 120))


def test_when_it_comes_to_rest_all_points_follow_in_parts_between_which_the_window_answers(view, qtbot):
    scene, inner, frames, others = view.stage.scene, view._view, [], []
    turn_once(view, qtbot)
    from PySide6.QtCore import QTimer

    timer = QTimer()
    timer.timeout.connect(lambda: others.append(scene.picture_points))
    draw = inner._draw

    def told(*, resized: bool) -> None:
        draw(resized=resized)
        if scene.picture_points == scene.frame_points:  # a new picture begins
            frames.clear()
        frames.append(scene.frame_points)

    inner._draw = told
    timer.start(0)
    qtbot.waitUntil(lambda: scene.picture_points == COUNT, timeout=10_000)
    timer.stop()
    assert len(frames) >= COUNT / BUDGET
    assert max(frames) <= BUDGET
    assert sum(frames) == COUNT
    assert any(BUDGET < points < COUNT for points in others)


def test_the_next_move_ends_what_was_being_drawn_and_the_next_rest_begins_anew(view, qtbot):
    scene, inner = view.stage.scene, view._view
    turn_once(view, qtbot)
    qtbot.waitUntil(lambda: view.stage.is_resting, timeout=5_000)
    inner._render()
    inner._go_on()
    assert BUDGET < scene.picture_points < COUNT and not scene.is_complete
    qtbot.mousePress(inner, Qt.MouseButton.LeftButton, pos=QPoint(160, 120))
    drag(inner, 2)
    assert scene.is_complete and scene.picture_points == 0 < scene.frame_points <= BUDGET
    inner._go_on()
    assert scene.picture_points <= BUDGET
    qtbot.mouseRelease(inner, Qt.MouseButton.LeftButton, pos=QPoint(200, 120))
    qtbot.waitUntil(lambda: scene.picture_points == COUNT, timeout=10_000)


def test_a_picture_thinner_than_the_one_seen_while_turning_is_not_shown(view, qtbot):
    scene, inner = view.stage.scene, view._view
    turn_once(view, qtbot)
    inner._render()
    seen = inner._image.copy()
    view.stage.come_to_rest()
    inner._render()
    assert scene._size_px < scene._moving_size_px()
    assert inner._image == seen
    assert view.screenshot() != seen


def turn_once(view: CloudView, qtbot) -> None:
    qtbot.mousePress(view._view, Qt.MouseButton.LeftButton, pos=QPoint(160, 120))
    drag(view._view, 1)
    qtbot.mouseRelease(view._view, Qt.MouseButton.LeftButton, pos=QPoint(170, 120))


def test_where_the_processor_draws_it_is_recognised_before_the_first_frame_and_draws_one_sample_a_pixel(qtbot):
    view = CloudView(Look("light"))
    qtbot.addWidget(view)
    view.show()
    view.activate()
    view.screenshot()
    capabilities = view._view._window.vtk.ReportCapabilities()
    assert "renderer string" in capabilities
    assert view.stage.scene.budget.software == ("llvmpipe" in capabilities or FrameBudget(capabilities).software)
    assert view._view._window.vtk.GetMultiSamples() == (0 if view.stage.scene.budget.software else 4)
    view.close_view()


def test_an_unknown_renderer_counts_as_software():
    assert FrameBudget("Display ID not set").software
    assert not FrameBudget("OpenGL renderer string:  NVIDIA GeForce RTX 3060").software


def test_the_last_frame_of_a_picture_which_has_few_points_does_not_make_points_look_dear():
    budget = FrameBudget(SOFTWARE)
    for _ in range(40):
        budget.observe(budget.points, 0.01 + 3e-7 * budget.points)
    settled = budget.points
    budget.observe(6_000, 0.01 + 3e-7 * 6_000)
    assert budget.points == settled
    budget.observe(6_000, 4 * FRAME_S)
    assert budget.points < settled


@pytest.mark.parametrize("count", [100_000, 300_000])
def test_points_of_the_size_asked_for_leave_the_share_of_holes_aimed_at(count):
    """Squares on random places of a disc; the far half of the points hides behind the near half."""
    rng = np.random.default_rng(4)
    picture, radius = (1000, 800), 350.0
    angle, reach = rng.uniform(0, 2 * np.pi, 2 * count), radius * np.sqrt(rng.uniform(0, 1, 2 * count))
    places = np.column_stack([500 + reach * np.cos(angle), 400 + reach * np.sin(angle)])
    size = point_size_px(places[:4000], picture, 2 * count)
    assert LEAST_PX < size < MOST_PX
    covered = np.zeros(picture, bool)
    for x in np.arange(-size / 2, size / 2):
        for y in np.arange(-size / 2, size / 2):
            column, row = np.round(places[:count] + np.array([x, y])).astype(int).T
            covered[column, row] = True
    columns, rows = np.meshgrid(np.arange(1000), np.arange(800), indexing="ij")
    disc = np.hypot(columns - 500, rows - 400) < radius - 5
    assert (~covered[disc]).mean() < 2 * HOLES


def test_points_grow_when_one_looks_closer_and_stay_within_limits():
    rng = np.random.default_rng(5)
    places = rng.uniform(0, 400, (4000, 2))
    sizes = [point_size_px(200 + zoom * (places - 200), (400, 400), 100_000) for zoom in (1.0, 2.0, 4.0)]
    assert sizes[0] <= sizes[1] <= sizes[2]
    assert sizes[2] > sizes[0]
    assert point_size_px(places - 1000, (400, 400), 100_000) == LEAST_PX
    assert point_size_px(places, (400, 400), 10) == MOST_PX
    assert point_size_px(np.empty((0, 2)), (400, 400), 10) == LEAST_PX


def test_the_finest_subsample_that_is_drawn_in_time_is_chosen_and_kept():
    cost_s = [0.12, 0.05, 0.03, 0.02]  # of the finest to the coarsest
    choice, chosen = LevelChoice(), []
    for _ in range(40):
        chosen.append(choice.place(4))
        choice.observe(cost_s[chosen[-1]])
    assert chosen[0] == 2 and set(chosen[-20:]) == {1}
    assert chosen.count(0) < 6
