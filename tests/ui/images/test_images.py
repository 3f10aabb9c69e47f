"""Maps show the arrays they are made of, a profile is the array along its line, and all of it is opened from the page Clouds."""

from __future__ import annotations

import threading
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from measureapp.data.phase import PhaseMap, PixelState
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.exposures import decode_by_rules
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from tests.fringe_project import CAMERAS, EXPOSURES_US, HEIGHT, WIDTH, fringe_project, shiny_stack, valid_in_each
from tests.ui.cut_texts import cut_texts
from tests.ui.heartbeat import Heartbeat
from ui.images.frame_bar import FrameBar
from ui.images.layers import KINDS, Layer, frame_layer, layer_of, legend_words
from ui.images.map_view import MapView
from ui.images.profile import profile
from ui.images.profile_panel import ProfilePanel
from ui.look.look import Look

PATIENCE_MS = 30_000
LARGE = (972, 1296)


def phase_map(shape=(40, 60)) -> PhaseMap:
    """A map with one column of every state."""
    rng = np.random.default_rng(5)
    state = np.zeros(shape, np.uint8)
    state[:, : len(PixelState)] = np.arange(len(PixelState))
    exposure = rng.integers(-1, 3, shape).astype(np.int8)
    phase = np.where(state == 0, rng.uniform(0, 200, shape), 0).astype(np.float32)
    sigma = np.where(state == 0, rng.uniform(0.01, 0.1, shape), 0).astype(np.float32)
    modulation = rng.integers(0, 100, shape).astype(np.uint8)
    grey = modulation.astype(np.uint16)
    return PhaseMap(
        "left", "view01", phase, sigma, modulation, grey, state, exposure, 16.0, 1024, exposures_us=(80_000.0, 20_000.0, 5_000.0)
    )


@pytest.fixture
def look(qapp):
    return Look("light")


@pytest.fixture
def view(qtbot, look):
    made = MapView(look)
    qtbot.addWidget(made)
    made.resize(700, 500)
    made.show()
    return made


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "fringes"])
def test_a_layer_has_the_values_of_the_map_and_none_where_it_has_none(kind):
    found = phase_map()
    layer, valid = layer_of(found, kind), found.state == 0
    truth = {
        "phase": np.where(valid, found.phase_rad, np.nan),
        "wrapped": np.where(valid, np.mod(found.phase_rad.astype(float), 2 * np.pi), np.nan),
        "modulation": np.where(found.modulation > 0, found.modulation, np.nan),
        "sigma": np.where(valid, found.sigma_rad, np.nan),
        "exposure": np.where(found.exposure_index >= 0, found.exposure_index, np.nan),
        "state": found.state,
    }[kind]
    assert np.allclose(layer.values, truth, atol=2e-5, equal_nan=True)
    low, high = layer.span
    assert np.isfinite([low, high]).all() and low < high


def test_the_words_of_a_pixel_are_its_value_with_unit(look):
    found = phase_map()
    assert layer_of(found, "phase").words_at(7, 30).replace("\u00a0", " ") == f"{found.phase_rad[7, 30]:.3f} rad"
    assert layer_of(found, "phase").words_at(0, PixelState.SHADOW) == "–"
    assert layer_of(found, "state").words_at(0, PixelState.SHADOW) == "Shadow"
    row, column = np.argwhere(found.exposure_index == 1)[0]
    assert layer_of(found, "exposure").words_at(row, column).replace("\u00a0", " ") == "20 ms"


def test_shares_in_the_legend_are_those_of_the_map(look):
    found = phase_map()
    layer = layer_of(found, "state")
    assert sum(one.share for one in layer.categories) == pytest.approx(1.0)
    assert layer.categories[PixelState.SATURATED].share == pytest.approx(1 / 60)
    assert "Saturated" in legend_words(layer)


def test_a_map_draws_its_array_with_scale_and_unit(view):
    layer = layer_of(phase_map(), "phase")
    view.show_layer(layer)
    image, scale = view._items["image"], view._items["scale"]
    assert np.array_equal(image.image, layer.values, equal_nan=True)
    assert tuple(image.getLevels()) == pytest.approx(layer.span)
    assert scale.is_shown and scale.words == "Absolute phase [rad]"
    view.show_layer(layer_of(phase_map(), "state"))
    assert not scale.is_shown
    view.show_layer(layer)
    assert scale.is_shown and tuple(image.getLevels()) == pytest.approx(layer.span)


@pytest.mark.parametrize("pixel", [(0, 0), (39, 59), (20, 31)])
def test_the_pixel_under_the_cursor_is_the_one_that_is_drawn_there(qtbot, view, pixel):
    view.show_layer(layer_of(phase_map(), "phase"))
    qtbot.wait(30)
    assert view.pixel_at(view.place_of(*pixel)) == pixel


def test_saturated_pixels_of_a_stored_image_are_red(view):
    image = np.full((20, 30), 100, np.uint8)
    image[4, 5] = 255
    view.show_layer(frame_layer(image), 255)
    drawn = view._items["image"].image
    assert tuple(drawn[0, 0]) == (100, 100, 100)
    assert tuple(drawn[4, 5]) == (209, 73, 91)


@pytest.mark.parametrize("colour", [(12, 90, 200), (240, 128, 7)])
def test_a_picture_is_drawn_in_its_colours_from_the_first_time_on(qtbot, view, colour):
    pixels = np.empty((30, 40, 3), np.uint8)
    pixels[:] = colour
    for _ in range(2):
        view.show_pixels(pixels)
        qtbot.wait(30)
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


@pytest.mark.parametrize("ends", [((0, 0), (39, 59)), ((5, 50), (5, 2)), ((30, 7), (3, 7)), ((4, 4), (4, 4))])
def test_a_profile_is_the_array_along_its_line(ends):
    layers = {"a": np.random.default_rng(1).normal(size=(40, 60)), "b": np.arange(2400.0).reshape(40, 60)}
    found = profile(ends, layers)
    assert (found.rows[0], found.columns[0]) == ends[0] and (found.rows[-1], found.columns[-1]) == ends[1]
    for name, layer in layers.items():
        assert np.array_equal(found.values[name], [layer[row, column] for row, column in zip(found.rows, found.columns, strict=True)])
    length = np.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1])
    assert found.distance_px[-1] == pytest.approx(length)
    steps = np.hypot(np.diff(found.rows), np.diff(found.columns))
    assert (steps <= np.sqrt(2) + 1e-9).all()


def test_a_saved_profile_has_the_same_numbers(tmp_path):
    layer = np.random.default_rng(1).normal(size=(40, 60)).astype(np.float32)
    layer[20, 10] = np.nan
    found = profile(((20, 0), (20, 59)), {"phase_rad": layer})
    found.save(tmp_path / "line 线.csv")
    lines = (tmp_path / "line 线.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "distance_px,row,column,phase_rad" and len(lines) == 61
    assert lines[11].endswith(",")  # no value there
    values = [float(line.rsplit(",", 1)[1]) for line in lines[1:] if not line.endswith(",")]
    assert values == pytest.approx(np.delete(layer[20], 10), rel=1e-6)


def test_the_ends_of_a_line_can_be_typed_and_stay_inside_the_image(qtbot, look):
    panel = ProfilePanel(look)
    qtbot.addWidget(panel)
    panel.fit((40, 60))
    assert panel.value() == ((20, 0), (20, 59))
    with qtbot.waitSignal(panel.lineEdited) as told:
        panel.fields[2].setValue(99)
    assert told.args[0] == ((20, 0), (39, 59)) == panel.value()
    panel.setValue(((1, 2), (3, 4)))
    assert panel.value() == ((1, 2), (3, 4))


def test_a_line_moved_by_the_mouse_tells_its_pixels(qtbot, view):
    view.show_layer(layer_of(phase_map(), "phase"))
    view.show_line(((10, 5), (30, 50)))
    qtbot.wait(30)
    told = []
    view.lineMoved.connect(told.append)
    line = view._items["line"]
    line.movePoint(line.getHandles()[1], (40, 12), coords="parent")
    assert told[-1] == ((10, 5), (12, 40))
    before = len(told)
    view.show_line(((1, 1), (2, 2)))
    assert len(told) == before  # the program's own changes are not told


def test_the_frame_bar_names_exposure_and_image(qtbot):
    bar = FrameBar()
    qtbot.addWidget(bar)
    bar.show_stack(EXPOSURES_US, 8)
    bar.setValue((2, 5))
    assert bar.value() == (2, 5)
    assert bar.words.replace("\u00a0", " ") == "5 ms, image 6 of 8"
    bar.show_stack((1000,), 4)
    assert bar.value() == (0, 3)


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


@pytest.fixture
def clouds(application, window, measurement, monkeypatch, tmp_path):
    """The page Clouds of a project on disk with the images of two of its views."""
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    project = fringe_project(tmp_path / "p", "view-01", "view-02")
    application.session.open_project("shiny", "gear", project.path)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    return window.pages["clouds"]


@pytest.fixture
def opened(qtbot, clouds):
    clouds.images.click()
    dialog = clouds.images_dialog
    qtbot.waitUntil(lambda: dialog.view is not None and not dialog.progress.isVisible(), timeout=PATIENCE_MS)
    return dialog


def test_the_selected_view_is_shown_with_all_its_maps(opened):
    stack = shiny_stack("view-01")
    maps = decode_by_rules(stack, DecodeSettings(), NoProgress())["combined"]
    assert opened.viewpoint_id == "view-01" and "view-01" in opened.title.text()
    for camera in CAMERAS:
        opened.cameras.setValue(camera)
        for kind in KINDS:
            opened.kind.setValue(kind)
            if kind == "fringes":
                assert np.array_equal(opened.map.layer.values, stack.images[camera][0, 0])
            else:
                assert np.array_equal(opened.map.layer.values, layer_of(maps[camera], kind).values, equal_nan=True)


def test_the_read_out_tells_all_values_of_a_pixel(opened):
    opened.frames.setValue((1, 3))
    opened.map.point_at(40, 200)
    said = opened.values.text().replace("\u00a0", " ")
    found = opened.view.maps["left"]
    assert opened.pixel.text() == "Row 40, column 200"
    assert f"Absolute phase: {found.phase_rad[40, 200]:.3f} rad" in said
    assert f"Grey level at 20 ms, image 4 of 8: {shiny_stack().images['left'][1, 3, 40, 200]}" in said


def test_the_bars_are_the_valid_pixels_counted_in_the_images(opened):
    counted = valid_in_each(shiny_stack("view-01"), "left").mean(axis=(1, 2))
    assert [bar.value for bar in opened.chart.bars[:3]] == pytest.approx(100 * counted)
    assert [bar.name.replace("\u00a0", " ") for bar in opened.chart.bars[:4]] == ["80 ms", "20 ms", "5 ms", "Composite"]


def test_a_profile_through_phase_and_grey_levels_is_plotted_and_saved(opened, monkeypatch, tmp_path):
    opened.kind.setValue("phase")
    opened.line.click()
    opened.panel.fields[0].setValue(10)
    ends = opened.panel.value()
    assert ends == ((10, 0), (HEIGHT // 2, WIDTH - 1))
    found, phase = opened.panel.profile, opened.view.maps["left"]
    truth = np.where(phase.valid, phase.phase_rad, np.nan)[found.rows, found.columns]
    assert np.array_equal(opened.panel.upper.curves["phase_rad"], truth.astype(float), equal_nan=True)
    assert np.array_equal(opened.panel.lower.curves["grey_80000us"], shiny_stack().images["left"][0, 0][found.rows, found.columns])
    assert opened.panel.lower.limit == 255
    monkeypatch.setattr("ui.pages.clouds.images_dialog.choose_new", lambda *_: tmp_path / "line.csv")
    opened.panel.saveAsked.emit()
    header = (tmp_path / "line.csv").read_text(encoding="utf-8").splitlines()[0]
    assert header == "distance_px,row,column,phase_rad,wrapped_rad,sigma_rad,modulation_grey,grey_80000us,grey_20000us,grey_5000us"
    monkeypatch.setattr("ui.pages.clouds.images_dialog.choose_new", lambda *_: tmp_path / "line.csv" / "below.csv")
    opened.panel.saveAsked.emit()
    assert "not saved" in opened.state.text()


@pytest.mark.parametrize("size", [(1240, 680), (0, 0)], ids=["as opened", "smallest"])
def test_the_names_of_all_maps_and_of_three_cameras_have_room(qtbot, clouds, size):
    stack = shiny_stack("view-03")
    images = {**stack.images, "upper": stack.images["right"]}
    ProjectFolder.open(clouds.session.folder).frames.store(replace(stack, images=images))
    dialog = clouds.images_dialog
    dialog.open_view("view-03")
    dialog.resize(*size)
    qtbot.waitUntil(lambda: dialog.view is not None, timeout=PATIENCE_MS)
    qtbot.wait(60)
    assert list(dialog.view.maps) == ["left", "right", "upper"]
    assert cut_texts(dialog) == []
    for segments in (dialog.kind, dialog.cameras):
        buttons = sorted(segments.findChildren(QPushButton), key=lambda each: each.x())
        for one, following in pairwise(buttons):
            assert one.width() >= one.sizeHint().width() and one.geometry().right() <= following.x()
        assert buttons[-1].geometry().right() < segments.width()


def test_a_view_without_images_is_told_in_words(qtbot, opened, clouds):
    clouds.images_dialog.open_view("view-05")
    qtbot.waitUntil(lambda: "view-05" in opened.state.text() and not opened.progress.isVisible(), timeout=PATIENCE_MS)
    assert opened.view is None and opened.again.isVisible()


def test_decoding_can_be_cancelled_and_started_again(qtbot, clouds, monkeypatch):
    going, held = threading.Event(), threading.Event()

    def slow(stack, settings, progress):
        going.set()
        while not held.is_set():
            progress.report(0, 1)
            held.wait(0.01)
        return decode_by_rules(stack, settings, progress)

    monkeypatch.setattr("measureapp.pipeline.exposures.decode_by_rules", slow)
    clouds.images.click()
    dialog = clouds.images_dialog
    qtbot.waitUntil(going.is_set, timeout=PATIENCE_MS)
    dialog.cancel.click()
    qtbot.waitUntil(lambda: not dialog.progress.isVisible(), timeout=PATIENCE_MS)
    assert dialog.state.text().startswith("Cancelled") and dialog.view is None
    held.set()
    dialog.again.click()
    qtbot.waitUntil(lambda: dialog.view is not None, timeout=PATIENCE_MS)


def test_closing_while_it_decodes_ends_the_job_and_shows_nothing(qtbot, clouds):
    clouds.images.click()
    clouds.images_dialog.close()
    qtbot.waitUntil(lambda: not clouds.controllers.imaging.queue.busy, timeout=PATIENCE_MS)
    assert not clouds.images_dialog.isVisible()


def test_another_project_takes_the_images_away(application, opened):
    application.session.open_project("other", "gear", None)
    assert opened.view is None and opened.map.layer is None and opened.values.text().startswith("Move the mouse")


def test_both_themes_and_all_maps_do_not_stall_the_window(qtbot, application, opened):
    with Heartbeat() as heart:
        for shade in ("dark", "light"):
            application.look.set_shade(shade)
            qtbot.wait(60)
            for kind in KINDS:
                opened.kind.setValue(kind)
                qtbot.wait(30)
    heart.check()


def test_a_view_of_a_large_camera_is_looked_through_without_a_stall(qtbot, application, window, measurement, monkeypatch, tmp_path):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    project = fringe_project(tmp_path / "p")
    small = shiny_stack("view-01")
    project.frames.store(replace(small, images={name: np.tile(images, (1, 1, 18, 3)) for name, images in small.images.items()}))
    application.session.open_project("shiny", "gear", project.path)
    application.session.set_measurement(measurement, {})
    window.show_page("clouds")
    decode_by_rules(small, DecodeSettings(), NoProgress())  # the kernels are loaded, as by the warm-up after the start
    qtbot.wait(300)
    page = window.pages["clouds"]
    dialog = page.images_dialog
    with Heartbeat() as heart:
        heart.place = "opening"
        page.images.click()
        qtbot.waitUntil(lambda: dialog.view is not None and not dialog.progress.isVisible(), timeout=PATIENCE_MS)
        qtbot.wait(100)
        for camera in CAMERAS:
            heart.place = f"camera {camera}"
            dialog.cameras.setValue(camera)
            qtbot.wait(60)
            for kind in KINDS:
                heart.place = f"{kind} of {camera}"
                dialog.kind.setValue(kind)
                qtbot.wait(60)
                dialog.map.point_at(500, 700)
                qtbot.wait(60)
        heart.place = "profile"
        dialog.line.click()
        qtbot.wait(60)
        for row in range(100, 120):
            dialog.panel.fields[0].setValue(row)
            qtbot.wait(30)
        heart.place = "frames"
        dialog.kind.setValue("fringes")
        for image in range(8):
            dialog.frames.setValue((1, image))
            qtbot.wait(30)
    dialog.close()
    heart.check()
