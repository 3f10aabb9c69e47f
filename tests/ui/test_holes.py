"""Images and holes: a view is explained beside the work, and a click tells why a pixel has no point."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from measureapp.data.cloud import PointCloud
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import CalibrationError
from measureapp.pipeline import why as pipeline_why
from measureapp.pipeline.why import ExplainedView
from measureapp.reconstruct.reconstruct import Reconstruction
from ui.images.map_view import MapView
from ui.look.look import Look
from ui.pages.clouds.holes_dialog import ASK

HEIGHT, WIDTH = 48, 64
CAMERAS = ("left", "right")


def explained_view(name: str = "view-02") -> ExplainedView:
    """A view whose left camera has a dark stripe, one pixel that is saturated, and one that another camera contradicts."""
    state, fate = np.zeros((HEIGHT, WIDTH), np.uint8), np.zeros((HEIGHT, WIDTH), np.uint8)
    state[:, :16], state[5, 40] = PixelState.SHADOW, PixelState.SATURATED
    fate[state != 0] = PointState.NO_PHASE
    fate[20, 30] = PointState.CONTRADICTED
    grey = np.full((HEIGHT, WIDTH), 90, np.uint16)
    exposure = np.where(state == PixelState.SATURATED, -1, np.arange(WIDTH) % 2).astype(np.int8)
    sigma = np.where(state == 0, 0.02, 0).astype(np.float32)
    phase = np.full((HEIGHT, WIDTH), 12.0, np.float32)
    maps = {
        camera: PhaseMap(camera, name, phase, sigma, grey // 2, grey, state, exposure, 16.0, 1024, snr_at_one_rad=0.7) for camera in CAMERAS
    }
    rows, columns = np.nonzero(fate == PointState.VALID)
    count = len(rows)
    pixels = np.stack([rows, columns], axis=1).astype(np.int32)
    cloud = PointCloud(
        np.zeros((count, 3)), np.tile([0.0, 0, -1], (count, 1)), np.full(count, 0.012), np.full(count, 0.5), pixels,
        np.full(count, 3), "camera", name,
    )  # fmt: skip
    other = np.where(fate == PointState.VALID, PointState.SEEN_BY_ANOTHER, fate).astype(np.uint8)
    return ExplainedView(name, (80_000, 20_000), maps, Reconstruction(cloud, (), {}, {"left": fate, "right": other}), CAMERAS)


@pytest.fixture
def clouds(application, window, measurement, monkeypatch, tmp_path):
    """The Clouds page with a project on disk whose views explain themselves at once."""
    (tmp_path / "project.json").write_text("{}", encoding="utf-8")
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    monkeypatch.setattr("measureapp.project.folder.ProjectFolder.open", lambda path: path)
    monkeypatch.setattr(pipeline_why, "explain_view", lambda _project, name, _progress: explained_view(name))
    application.session.open_project("demo-gypsum", "gypsum", tmp_path)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    return window.pages["clouds"]


def click(qtbot, picture, place):
    viewport = picture.plot.viewport()
    qtbot.mouseClick(viewport, Qt.MouseButton.LeftButton, pos=viewport.mapFrom(picture, place))


def settled(qtbot, page):
    qtbot.waitUntil(lambda: not page.controllers.explaining.queue.busy and not page.dialog.picture.is_empty, timeout=10_000)
    return page.dialog


def test_the_selected_view_is_explained_with_the_shares_of_all_reasons(qtbot, clouds):
    clouds.table.selectRow(1)
    assert clouds.properties.action == "Images and holes"
    clouds.window().properties.actionClicked.emit()
    dialog = settled(qtbot, clouds)
    assert not dialog.isModal()
    assert "view-02" in dialog.title.text()
    assert dialog.kind.value() == "reasons"
    shares = {name: text.replace("\u00a0", " ") for name, text in dialog.table.texts()}
    assert shares == {"Point measured": "74.9 %", "Shadow": "25.0 %", "Saturated": "< 0.1 %", "Contradicted": "< 0.1 %"}
    assert "left 74.9" in dialog.state.text()
    assert not dialog.progress.isVisible() and not dialog.again.isVisible()


def test_a_click_on_a_pixel_shows_stage_reason_and_numbers(qtbot, clouds):
    clouds.holes.click()
    dialog = settled(qtbot, clouds)
    assert dialog.answer.text() == ASK
    place = dialog.picture.place_of(20, 30).toPoint()
    click(qtbot, dialog.picture, place)
    assert dialog.place.text() == "Row 20, column 30"
    assert dialog.stage.text() == "Lost in matching: contradicted"
    assert "Another camera sees a projector line" in dialog.answer.text()
    assert "at least 10" in dialog.figures.text()
    QTest.keyClick(dialog.picture, Qt.Key.Key_Right)
    assert dialog.place.text() == "Row 20, column 31"
    assert dialog.stage.text() == "Point measured"
    assert "Point σ 0.012 mm" in dialog.figures.text().replace("\u00a0", " ")


def test_the_values_of_the_chosen_pixel_are_one_click_away(qtbot, clouds, monkeypatch):
    asked = []
    clouds.holes.click()
    dialog = settled(qtbot, clouds)
    monkeypatch.setattr(
        clouds.images_dialog, "load", lambda: asked.append((clouds.images_dialog.viewpoint_id, clouds.images_dialog._wanted))
    )
    click(qtbot, dialog.picture, dialog.picture.place_of(20, 30).toPoint())
    dialog.values.click()
    assert asked == [("view-01", ("left", (20, 30)))]
    assert clouds.images_dialog.isVisible()
    clouds.images_dialog.close()


def test_a_reason_in_the_list_shows_a_pixel_that_has_it(qtbot, clouds):
    clouds.holes.click()
    dialog = settled(qtbot, clouds)
    names = [text[0] for text in dialog.table.texts()]
    dialog.table.cellClicked.emit(names.index("Saturated"), 0)
    assert dialog.picture.cursor_pixel == (5, 40)
    assert dialog.stage.text() == "Lost in decoding: saturated"


def test_colours_and_cameras_can_be_changed(qtbot, clouds):
    clouds.holes.click()
    dialog = settled(qtbot, clouds)
    for kind, rows in (("exposure", ["80 ms", "20 ms", "None"]), ("snr", None), ("grey", None), ("reasons", None)):
        dialog.kind.setValue(kind)
        settled(qtbot, clouds)
        assert rows is None or [text[0] for text in dialog.table.texts()] == rows
    dialog.cameras.setValue("right")
    settled(qtbot, clouds)
    assert "Measured by another camera" in [text[0] for text in dialog.table.texts()]
    assert dialog.answer.text() == ASK


def test_a_picked_point_leads_to_its_pixel_in_its_camera(qtbot, clouds, calibration):
    clouds._asked = ("view-03", 1, (7, 50))
    clouds.window().properties.actionClicked.emit()
    dialog = settled(qtbot, clouds)
    assert dialog.viewpoint_id == "view-03"
    assert dialog.cameras.value() == calibration.cameras.names[1] == "right"
    assert dialog.picture.cursor_pixel == (7, 50)
    assert dialog.stage.text() == "Measured by another camera"


def test_a_view_that_cannot_be_explained_says_why_and_can_be_tried_again(qtbot, clouds, monkeypatch):
    def refuse(*_arguments: object) -> ExplainedView:
        raise CalibrationError("The project has no calibration.", "Calibrate first.")

    with monkeypatch.context() as failing:
        failing.setattr(pipeline_why, "explain_view", refuse)
        clouds.holes.click()
        qtbot.waitUntil(clouds.dialog.again.isVisible, timeout=10_000)
    assert clouds.dialog.answer.text() == "The project has no calibration. Calibrate first."
    assert not clouds.dialog.kind.isEnabled()
    clouds.dialog.again.click()
    assert settled(qtbot, clouds).kind.isEnabled()


def test_explaining_can_be_cancelled(qtbot, clouds, monkeypatch):
    def slow(_project: object, _name: str, progress) -> ExplainedView:
        while True:
            progress.report(0.3, 1.0, "decoding left")
            QTest.qSleep(5)

    monkeypatch.setattr(pipeline_why, "explain_view", slow)
    clouds.holes.click()
    dialog = clouds.dialog
    qtbot.waitUntil(lambda: dialog.note.text() == "Decoding left", timeout=10_000)
    assert dialog.progress.isVisible() and dialog.cancel.isVisible()
    dialog.cancel.click()
    qtbot.waitUntil(dialog.again.isVisible, timeout=10_000)
    assert dialog.stage.text() == "Cancelled"
    assert not dialog.progress.isVisible()


def test_another_view_replaces_the_one_that_is_being_explained(qtbot, clouds, monkeypatch):
    def of_name(_project: object, name: str, progress) -> ExplainedView:
        while name == "view-01":
            progress.report(0.3, 1.0, "decoding left")
            QTest.qSleep(5)
        return explained_view(name)

    monkeypatch.setattr(pipeline_why, "explain_view", of_name)
    clouds.dialog.open_view("view-01")
    qtbot.waitUntil(lambda: clouds.dialog.note.text() == "Decoding left", timeout=10_000)
    clouds.dialog.open_view("view-02")
    dialog = settled(qtbot, clouds)
    assert dialog._explanation.view.viewpoint_id == "view-02"
    assert dialog.stage.text() != "Cancelled" and not dialog.again.isVisible()


def test_a_project_that_is_not_on_disk_offers_no_images(application, window, measurement):
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    page = window.pages["clouds"]
    assert not page.holes.isVisible()
    assert page.properties.action == ""


@pytest.fixture
def picture(qtbot):
    made = MapView(Look("light"))
    qtbot.addWidget(made)
    made.resize(400, 300)
    made.show()
    made.show_pixels(np.zeros((HEIGHT, WIDTH, 3), np.uint8))
    qtbot.wait(30)
    return made


def test_the_picture_finds_the_pixel_under_the_mouse_at_every_size(qtbot, picture):
    for zoom in (1.0, 0.6, 0.3):
        picture.plot.getViewBox().scaleBy((zoom, zoom))
        for pixel in ((0, 0), (20, 30), (47, 63)):
            picture.choose(pixel)
            place = picture.place_of(*pixel)
            assert picture.rect().contains(place.toPoint())
            assert picture.pixel_at(place) == pixel
    picture.show_all()
    qtbot.wait(10)
    assert picture.pixel_at(QPointF(-20, 150)) is None


def test_dragging_the_picture_moves_it_and_chooses_nothing(qtbot, picture):
    picture.plot.getViewBox().scaleBy((0.25, 0.25))
    qtbot.wait(10)
    viewport = picture.plot.viewport()
    before = picture.pixel_at(QPointF(200, 150))
    with qtbot.assertNotEmitted(picture.pixelChosen):
        qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=QPoint(200, 150))
        for x in range(195, 155, -5):
            QApplication.sendEvent(viewport, moved(viewport, QPoint(x, 150)))
        qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=QPoint(160, 150))
    after = picture.pixel_at(QPointF(160, 150))
    assert after is not None and before is not None
    assert abs(after[1] - before[1]) <= 1 and after[0] == before[0]
    assert picture.pixel_at(QPointF(200, 150)) != before


def moved(widget, place):
    left = Qt.MouseButton.LeftButton
    return QMouseEvent(
        QEvent.Type.MouseMove, QPointF(place), QPointF(widget.mapToGlobal(place)), left, left, Qt.KeyboardModifier.NoModifier
    )
