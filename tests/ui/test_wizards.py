"""The wizards: from a folder of images or from the virtual rig to an accepted calibration, and back after closing."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from measureapp.calibrate.draft.advice import Gauge
from measureapp.data.board import CheckerboardDescription
from measureapp.errors import StorageError
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.folder_lock import lock_folder
from measureapp.simulate.world import PAPER_BOARD
from tests.ui.board_pictures import BOARD, FOCAL, HEIGHT, WIDTH, record
from tests.ui.wizard_steps import PATIENCE_MS, read_folder, settle
from ui.controllers.rig_connection import truth_of
from ui.look.demo_settings import DemoSettings
from ui.widgets.gauges import Level
from ui.wizards.collect_page import gauge_words
from ui.wizards.wizard import COLLECT, RESULT, SETUP


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    return record(tmp_path_factory.mktemp("images") / "stereo")


@pytest.fixture
def wizard(calibration_page):
    calibration_page.open_wizard("cameras")
    opened = calibration_page.wizards["cameras"]
    opened.setup.board.setValue(BOARD)
    yield opened
    opened.close()


def test_a_folder_of_images_becomes_an_accepted_calibration(qtbot, wizard, recorded, application):
    read_folder(qtbot, wizard, recorded)
    assert wizard.step == COLLECT
    assert wizard.collecting.cameras == ("left", "right")
    assert [view.verdict for view in wizard.collecting.views] == ["pass"] * 8
    assert all(0 < view.residuals_px["left"] < 0.5 for view in wizard.collecting.views)
    assert len(wizard.collect.strip.thumbnails) == 8
    assert wizard.footer.words[0] == "See the result"
    wizard.footer.primary.click()
    settle(qtbot, wizard)
    assert wizard.step == RESULT
    assert "mm (k = 2)" in wizard.result.verdict.text()
    focal = wizard.result.table.texts()[0]
    assert focal[0] == "Focal length x"
    estimate, sigma = (float(text.removeprefix("± ").split("\u00a0")[0]) for text in focal[1:3])
    assert abs(estimate - FOCAL) < 5 * sigma + 1.0  # drawing the board costs some hundredths of a pixel, a few tenths of the focal length
    assert not wizard.calibrating.result.has_truth
    assert "Back to the views" in wizard.footer.words  # the check leaves the choice open
    qtbot.waitUntil(lambda: not wizard.calibrating.is_checking, timeout=PATIENCE_MS)
    assert "views held back fit with" in wizard.result.held_back.text()
    assert wizard.result.stop_check.isHidden()
    folder = wizard.collecting.collected.folder
    wizard._accept()
    assert not wizard.isVisible()
    assert application.session.cameras.names == ("left", "right")
    assert read_cameras(folder / "result" / "cameras.json").names == ("left", "right")
    calibration_page = application.window.pages["calibration"]
    assert [row[0] for row in calibration_page.table.texts()] == ["Camera left", "Camera right"]
    application.session.open_project("", "", None)  # as at the next start
    assert not calibration_page.last_one.isHidden()
    calibration_page.last_one.click()
    qtbot.waitUntil(lambda: application.session.cameras is not None, timeout=PATIENCE_MS)
    assert application.session.cameras.names == ("left", "right")


def test_the_check_with_views_held_back_can_be_stopped_and_the_result_stays(qtbot, wizard, recorded):
    read_folder(qtbot, wizard, recorded)
    wizard._conclude()
    qtbot.waitUntil(lambda: wizard.calibrating.is_checking, timeout=PATIENCE_MS)
    wizard.result.stop_check.click()
    qtbot.waitUntil(lambda: not wizard.calibrating.is_checking, timeout=PATIENCE_MS)
    assert wizard.calibrating.result is not None
    assert wizard.calibrating.result.held_back == ""
    assert wizard.result._held_back.isHidden()
    assert {"Accept", "Accept anyway"} & set(wizard.footer.words)


def test_delete_removes_a_view_and_ctrl_z_brings_it_back(qtbot, wizard, recorded):
    read_folder(qtbot, wizard, recorded)
    place = QPoint(3 * 136 + 20, 20)
    QTest.mouseClick(wizard.collect.strip.widget(), Qt.MouseButton.LeftButton, pos=place)
    chosen = wizard.collect.chosen
    assert chosen.name == "left04.png"
    assert "residual" in wizard.collect.picture.caption
    QTest.keyClick(wizard, Qt.Key.Key_Delete)
    settle(qtbot, wizard)
    assert wizard.collect.chosen.removed
    assert "8 views, 1 not used" in wizard.collect.count.text()
    assert wizard.collecting.collected.solved.of == ("01", "02", "03", "05", "06", "07", "08")
    QTest.keyClick(wizard, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    settle(qtbot, wizard)
    assert [view.verdict for view in wizard.collecting.views] == ["pass"] * 8
    control = Qt.KeyboardModifier.ControlModifier
    for key, modifiers in ((Qt.Key.Key_Y, control), (Qt.Key.Key_Z, control | Qt.KeyboardModifier.ShiftModifier)):
        QTest.keyClick(wizard, key, modifiers)
        settle(qtbot, wizard)
        assert wizard.collecting.views[3].removed
        wizard.collecting.undo()
        settle(qtbot, wizard)


def test_closing_loses_nothing_and_the_work_goes_on(qtbot, calibration_page, wizard, recorded):
    read_folder(qtbot, wizard, recorded)
    wizard.collect.choose("02")
    wizard.collect.remove_chosen()
    wizard.close()
    assert wizard.collecting.views == ()
    calibration_page.open_wizard("cameras")
    assert wizard.step == SETUP
    assert wizard.setup.kept.isVisible()
    wizard.setup.resumeClicked.emit()
    qtbot.waitUntil(lambda: wizard.step == COLLECT, timeout=PATIENCE_MS)
    settle(qtbot, wizard)
    assert [view.id for view in wizard.collecting.views if view.removed] == ["02"]
    assert len(wizard.collecting.views) == 8
    assert all(view.pictures for view in wizard.collecting.views)


def test_views_that_another_window_works_on_are_not_taken_over(qtbot, calibration_page, wizard, recorded):
    read_folder(qtbot, wizard, recorded)
    folder = wizard.collecting.collected.folder
    wizard.close()
    calibration_page.open_wizard("cameras")
    with lock_folder(folder):
        wizard.setup.resumeClicked.emit()
        qtbot.waitUntil(lambda: "another window" in wizard.footer.message.words.text(), timeout=PATIENCE_MS)
    assert wizard.step == SETUP
    wizard.setup.resumeClicked.emit()
    qtbot.waitUntil(lambda: wizard.step == COLLECT, timeout=PATIENCE_MS)
    settle(qtbot, wizard)
    with pytest.raises(StorageError, match="another window"), lock_folder(folder):
        pass


def test_what_begin_waits_for_stands_beside_it(wizard, recorded):
    wizard.setup.source.setValue("images")
    assert (wizard.footer.primary.text(), wizard.footer.primary.isEnabled()) == ("Begin", False)
    assert wizard.footer.missing.text() == "Choose a folder"
    wizard.setup.folder.setValue(recorded)
    assert wizard.footer.primary.isEnabled()
    assert not wizard.footer.missing.isVisible()


def test_the_focus_does_not_fall_on_the_help_when_its_button_goes(wizard):
    wizard.footer.primary.setFocus()
    wizard.setup.source.setValue("images")
    assert wizard.focusWidget() is wizard.steps


def test_the_arrow_keys_go_to_the_steps_that_were_reached(qtbot, wizard, recorded):
    QTest.keyClick(wizard.steps, Qt.Key.Key_Down)
    assert wizard.step == SETUP  # nothing was collected
    read_folder(qtbot, wizard, recorded)
    QTest.keyClick(wizard.steps, Qt.Key.Key_Up)
    assert wizard.step == SETUP
    QTest.keyClick(wizard.steps, Qt.Key.Key_Down)
    assert wizard.step == COLLECT


@pytest.mark.parametrize("folder, said", [("nothing here", "There is no folder"), ("", "There are no images in")])
def test_a_folder_without_images_is_refused_with_a_remedy(qtbot, wizard, tmp_path, folder, said):
    (tmp_path / "empty").mkdir()
    read_folder(qtbot, wizard, tmp_path / (folder or "empty"))
    assert said in wizard.footer.message.words.text()
    assert wizard.footer.message.words.text().count(".") >= 2  # what happened, and what to do
    assert wizard.step == SETUP
    assert wizard.collecting.kept() is None


def test_the_wrong_board_is_named_and_the_images_are_kept(qtbot, wizard, recorded):
    wizard.setup.board.setValue(CheckerboardDescription(columns=11, rows=8, square_mm=20.0))
    read_folder(qtbot, wizard, recorded)
    assert "No image shows the board" in wizard.footer.message.words.text()
    assert [view.verdict for view in wizard.collecting.views] == ["fail"] * 8
    assert "See the result" not in wizard.footer.words
    wizard.show_step(SETUP)
    wizard.setup.board.setValue(BOARD)
    read_folder(qtbot, wizard, recorded)
    assert [view.verdict for view in wizard.collecting.views] == ["pass"] * 8


def test_images_that_cannot_be_read_lead_back_to_the_choice(qtbot, wizard, tmp_path):
    (tmp_path / "left01.png").write_bytes(b"no image")
    read_folder(qtbot, wizard, tmp_path)
    assert wizard.step == COLLECT
    assert wizard.footer.words[0] == "Choose other images"
    wizard.footer.primary.click()
    assert wizard.step == SETUP


def test_an_image_of_one_camera_may_be_missing_and_a_broken_one_is_reported(qtbot, wizard, tmp_path):
    folder = record(tmp_path / "some", 5)
    (folder / "right02.png").unlink()
    (folder / "left04.png").write_bytes(b"no image")
    read_folder(qtbot, wizard, folder)
    assert "left04.png" in wizard.footer.message.words.text()
    assert [view.name for view in wizard.collecting.views] == ["left01.png", "left02.png", "left03.png", "left05.png"]
    wizard.collect.cameras.setValue("right")
    wizard.collect.choose("02")
    assert "no image of this view" in wizard.collect.picture.empty.text()


def test_sizes_of_a_board_that_contradict_each_other_cannot_begin(wizard):
    wizard.setup.board.kind.setValue("charuco")
    wizard.setup.board.lengths["marker_mm"].setValue(25.0)
    assert not wizard.footer.primary.isEnabled()
    assert wizard.footer.missing.text() == "Check the board"
    assert "do not fit" in wizard.setup.board.note.text()


def test_the_virtual_rig_takes_views_and_shows_its_truth_beside_the_result(qtbot, wizard):
    wizard.setup.board.setValue(CheckerboardDescription(columns=14, rows=11, square_mm=15.0))
    wizard.setup.source.setValue("rig")
    wizard.setup.resolution.setValue("quarter")
    wizard.footer.primary.click()
    assert wizard.step == COLLECT
    assert wizard.footer.words == (f"Take {len(wizard.collecting.capture.viewpoints_left)} views", "", "Take one view")
    wizard.collecting.capture.take(5)
    qtbot.waitUntil(wizard.footer.stop.isVisible, timeout=PATIENCE_MS)
    wizard.footer.stop.click()
    settle(qtbot, wizard)
    assert wizard.footer.message.words.text() == "Stopped. The views collected so far are kept."
    wizard.collecting.capture.take(5 - len(wizard.collecting.views))
    settle(qtbot, wizard)
    assert len(wizard.collecting.views) == 5
    assert wizard.collecting.capture.rig.cameras[0].width_px == 648
    wizard._conclude()
    settle(qtbot, wizard)
    result = wizard.calibrating.result
    assert result.has_truth
    focal = next(row for row in result.rows if row.estimate.label == "Focal length x")
    assert abs(focal.estimate.value - focal.true) < 6 * focal.estimate.sigma
    assert wizard.result.truth_note.isVisible()
    assert wizard.footer.words[0] == "Collect more"  # five views are not enough, and it says so
    taken = {view.name for view in wizard.collecting.views}
    wizard.footer.show_message("A camera does not answer.", "", "error")
    wizard.close()
    wizard.begin()
    assert wizard.footer.message.words.text() == ""  # it is over
    wizard.setup.resumeClicked.emit()
    qtbot.waitUntil(lambda: wizard.step == COLLECT, timeout=PATIENCE_MS)
    settle(qtbot, wizard)
    assert wizard.collecting.capture.rig.cameras[0].width_px == 648
    assert not taken & {viewpoint.id for viewpoint in wizard.collecting.capture.viewpoints_left}


def test_one_link_of_a_rig_is_offered_only_when_the_rig_is_calibrated(calibration_page, application, calibration):
    assert not calibration_page.offers["hand-eye"].isEnabled()
    application.session.set_calibration(calibration)
    assert all(action.isEnabled() for action in calibration_page.offers.values())


def test_one_link_is_taken_at_the_resolution_of_the_calibrated_cameras(calibration_page, application, calibration):
    application.session.set_calibration(calibration)  # of 1296 px; the rig has 2592
    calibration_page.open_wizard("hand-eye")
    wizard = calibration_page.wizards["hand-eye"]
    assert wizard.setup.resolution.value() == "half"
    application.controllers.demo.choose(DemoSettings(resolution="full"))
    wizard.close()
    wizard.begin()
    assert wizard.setup.resolution.value() == "half"
    wizard.close()


def test_an_axis_taken_with_the_rig_is_compared_with_the_one_before(qtbot, calibration_page, application, rig):
    known = truth_of(rig.at_resolution("quarter"), PAPER_BOARD)
    application.session.set_calibration(known)
    calibration_page.open_wizard("axis")
    wizard = calibration_page.wizards["axis"]
    wizard.setup.board.setValue(PAPER_BOARD)
    wizard.footer.primary.click()
    wizard.collecting.capture.take(4)
    settle(qtbot, wizard)
    wizard._conclude()
    settle(qtbot, wizard)
    assert "between views half a turn apart, by" in wizard.result.comparison.text()
    folder = wizard.collecting.collected.folder
    wizard._accept()
    stored = json.loads((folder / "result" / "axis.json").read_text())
    assert stored["provenance"]["temperature_c"] == pytest.approx(35.0, abs=0.5)
    assert stored["provenance"]["valid_days"] == rig.calibration_rules.valid_days


def test_in_a_small_window_what_is_missing_is_read_rather_than_measured(qtbot, wizard):
    wizard.show_step(COLLECT)
    levels = [Level(f"Gauge {number}", 0.1 * number, "") for number in range(8)]
    shown = []
    for height in (660, 1000):
        wizard.resize(1264, height)
        qtbot.wait(20)
        wizard.collect.guidance.show_guidance(("Tilt the board more.",), levels)
        shown.append((len(wizard.collect.guidance.gauges.levels), wizard.collect.guidance.rest.text()))
    assert shown == [(4, "and 4 more"), (7, "and 1 more")]


def test_what_is_not_enough_is_not_rounded_to_what_is():
    assert gauge_words(Gauge("Spread", 14.8, 15.0, "%", "left")) == "14\u00a0% of 15\u00a0%"
    assert gauge_words(Gauge("Spread", 15.2, 15.0, "%", "left")) == "15\u00a0%"


def test_a_wizard_does_not_open_while_the_rig_is_busy(calibration_page, application):
    application.session.set_busy("Demo: gypsum")
    calibration_page.open_wizard("cameras")
    assert calibration_page.wizards == {}
    assert "still running" in application.session.messages[-1].text
    application.session.set_busy("")


def test_images_of_two_sizes_are_reported(qtbot, wizard, tmp_path):
    folder = record(tmp_path / "sizes", 4, ("left",))
    cv2.imwrite(str(folder / "left09.png"), np.zeros((HEIGHT // 2, WIDTH // 2), np.uint8))
    read_folder(qtbot, wizard, folder)
    assert f"{WIDTH} × {HEIGHT} px are expected" in wizard.footer.message.words.text()
    assert len(wizard.collecting.views) == 4
