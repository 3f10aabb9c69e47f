"""The images of a view are opened from the page Clouds: all maps, values, bars, profiles."""

from __future__ import annotations

import threading
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from PySide6.QtWidgets import QPushButton

from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.exposures import decode_by_rules
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from tests.fringe_project import CAMERAS, EXPOSURES_US, HEIGHT, WIDTH, fringe_project, shiny_stack, valid_in_each
from tests.ui.cut_texts import cut_texts
from tests.ui.heartbeat import SHADES, Heartbeat, load_themes
from tests.ui.images.maps import PATIENCE_MS
from ui.images.frame_bar import FrameBar
from ui.images.layers import KINDS, layer_of


def test_the_frame_bar_names_exposure_and_image(qtbot):
    bar = FrameBar()
    qtbot.addWidget(bar)
    bar.show_stack(EXPOSURES_US, 8)
    bar.setValue((2, 5))
    assert bar.value() == (2, 5)
    assert bar.words.replace("\u00a0", " ") == "5 ms, image 6 of 8"
    bar.show_stack((1000,), 4)
    assert bar.value() == (0, 3)


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


@pytest.mark.timed
@pytest.mark.parametrize("shades", [("light",), pytest.param(SHADES, marks=pytest.mark.slow)])
def test_the_maps_do_not_stall_the_window_in_any_theme(qtbot, application, opened, shades):
    load_themes(qtbot, application.look)
    with Heartbeat() as heart:
        for shade in shades:
            application.look.set_shade(shade)
            qtbot.wait(60)
            for kind in KINDS:
                opened.kind.setValue(kind)
                qtbot.wait(30)
    heart.check()


@pytest.mark.timed
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
