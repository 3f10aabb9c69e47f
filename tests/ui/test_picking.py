"""A click on a point tells where it comes from; the camera shows everything as large as it fits."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from ui.look.look import Look
from ui.pages.picked_point import merged_point, point_properties, view_point
from ui.viewport.cloud_view import CloudView
from ui.viewport.colouring import plain
from ui.viewport.layers import CloudLayer

RED = (220, 20, 30)


@pytest.fixture
def view(qtbot):
    made = CloudView(Look("light"))
    qtbot.addWidget(made)
    made.resize(320, 240)
    made.show()
    made.activate()
    yield made
    made.close_view()
    made.close()


def reddish(view: CloudView) -> np.ndarray:
    image = view.screenshot()
    raw = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    picture = raw[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)
    return picture[:, :, 0] - picture[:, :, 1] > 90


@pytest.mark.parametrize("sizes", [(30, 3, 3), (3, 30, 3), (3, 3, 30), (20, 20, 1)])
def test_a_part_of_any_shape_fills_the_picture_and_is_not_cut(view, sizes):
    points = np.random.default_rng(1).uniform(-1, 1, (20_000, 3)) * sizes
    view.set_clouds([CloudLayer(points, plain(RED, len(points)))])
    red = reddish(view)
    rows, columns = np.flatnonzero(red.any(axis=1)), np.flatnonzero(red.any(axis=0))
    assert rows[0] > 4 and rows[-1] < 235 and columns[0] > 4 and columns[-1] < 315
    assert max((rows[-1] - rows[0]) / 240, (columns[-1] - columns[0]) / 320) > 0.75
    assert abs((rows[0] + rows[-1]) / 2 - 120) < 12
    assert abs((columns[0] + columns[-1]) / 2 - 160) < 12


def test_a_click_picks_the_foremost_point_and_its_layer(view, qtbot):
    front = CloudLayer(np.array([[-10.0, -11.0, 8.5]]), plain(RED, 1))
    behind = CloudLayer(np.array([[10.0, 11.0, -8.5], [0.0, 0.0, 60.0]]), plain(RED, 2))
    view.set_clouds([behind, front])
    view.screenshot()
    x, y = _pixel_of(view, front.points_mm[0])
    with qtbot.waitSignal(view.pointPicked) as told:
        qtbot.mouseClick(view._view, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(240 - 1 - y)))
    assert told.args == [1, 0]
    assert view.stage.scene.camera.keep_framed


def test_a_click_beside_the_part_picks_nothing(view, qtbot):
    view.set_clouds([CloudLayer(np.zeros((1, 3)), plain(RED, 1))])
    view.screenshot()
    with qtbot.assertNotEmitted(view.pointPicked, wait=50):
        qtbot.mouseClick(view._view, Qt.MouseButton.LeftButton, pos=QPoint(8, 8))


def _pixel_of(view: CloudView, point: np.ndarray) -> tuple[float, float]:
    x, y = view.stage.scene.camera.pixels(point[None])[0]
    return float(x), float(y)


def test_a_point_of_a_view_shows_its_sigma_and_that_its_pixel_is_not_known(measurement):
    view = measurement.views[2]
    cloud = view.cloud.seen_from(view.part_from_camera)
    point = view_point(view.viewpoint_id, cloud, 5)
    rows = dict(row for group in point_properties(point).groups for row in group.rows)
    assert rows["View"] == view.viewpoint_id
    assert rows["Pixel (row, column)"] == "–"
    assert rows["Standard deviation σ"].replace("\u00a0", " ") == "0.020 mm"
    assert rows["Measured by"] == "2 cameras"


def test_a_merged_point_is_traced_back_to_the_view_that_weighs_most_even_when_others_are_hidden(measurement):
    stitched = measurement.stitched
    point = merged_point(stitched, int(np.flatnonzero(stitched.view == 3)[7]), measurement.views)
    row = np.flatnonzero(stitched.view == 3)[7]
    assert point.viewpoint_id == stitched.placements[3].viewpoint_id
    np.testing.assert_allclose(point.position_mm, stitched.points_mm[row])
    cloud = measurement.views[3].cloud.seen_from(stitched.placements[3].part_from_camera)
    nearest = np.linalg.norm(cloud.points_mm - stitched.points_mm[row], axis=1).min()
    assert point.nearest_mm == pytest.approx(nearest, abs=1e-9)


def test_picking_on_the_clouds_page_unfolds_the_properties_and_labels_the_point(application, window, measurement):
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    assert window.properties.folded
    window.pages["clouds"].view.pointPicked.emit(0, 10)
    assert not window.properties.folded
    assert window.properties.shown.title == "Point"
    label = window.pages["clouds"].view._labels[0]
    assert label.text.startswith(measurement.stitched.placements[int(measurement.stitched.view[10])].viewpoint_id)
    window.pages["clouds"].stage.setValue("after")
    assert window.pages["clouds"].view._labels == ()
