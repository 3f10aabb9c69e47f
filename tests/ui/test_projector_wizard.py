"""The projector's wizard: fringes on the board from the virtual rig or from folders, beside calibrated cameras."""

from __future__ import annotations

import shutil
from dataclasses import replace

import pytest

from measureapp.simulate.world import PAPER_BOARD
from tests.cli.board_fringes import shared_stacks
from tests.ui.wizard_steps import PATIENCE_MS, read_folder, settle
from ui.controllers.rig_connection import truth_of
from ui.wizards.wizard import COLLECT, RESULT, SETUP

VIEWS = 4


@pytest.fixture
def wizard(calibration_page, application, rig):
    """The wizard beside cameras that were calibrated at quarter resolution, without an error for once."""
    seen = truth_of(rig.at_resolution("quarter"), PAPER_BOARD)
    application.session.set_cameras(replace(seen.cameras, projector=None))
    calibration_page.open_wizard("projector")
    opened = calibration_page.wizards["projector"]
    opened.setup.board.setValue(PAPER_BOARD)
    yield opened
    opened.close()


def test_the_projector_is_offered_as_soon_as_the_cameras_are_calibrated(calibration_page, application, calibration):
    assert not calibration_page.offers["projector"].isEnabled()
    application.session.set_cameras(calibration.cameras)
    assert calibration_page.offers["projector"].isEnabled()


def test_the_virtual_rig_projects_takes_and_finds_its_projector_and_shows_the_truth_again_after_closing(qtbot, wizard, application):
    assert wizard.setup.resolution.value() == "quarter"  # as the cameras were calibrated
    wizard.footer.primary.click()
    assert wizard.step == COLLECT
    assert wizard.collecting.cameras == ("projector", "left", "right", "upper")
    wizard.collecting.capture.take(VIEWS)
    settle(qtbot, wizard)
    assert [view.verdict for view in wizard.collecting.views] == ["pass"] * VIEWS
    assert all(0 < view.residuals_px["projector"] < 0.5 for view in wizard.collecting.views)
    assert "corners, residual" in wizard.collect.picture.caption
    assert not wizard.collect.picture.is_empty  # the board as the projector sees it
    wizard.collect.cameras.setValue("left")
    assert "corners, residual" in wizard.collect.picture.caption
    wizard._conclude()
    settle(qtbot, wizard)
    check_result(wizard)
    qtbot.waitUntil(lambda: not wizard.calibrating.is_checking, timeout=PATIENCE_MS)
    assert "The stated uncertainty can be trusted: views held back fit with" in wizard.result.held_back.text()
    wizard.close()
    wizard.begin()
    wizard.setup.resumeClicked.emit()
    qtbot.waitUntil(lambda: wizard.step == COLLECT, timeout=PATIENCE_MS)
    settle(qtbot, wizard)
    wizard._conclude()
    settle(qtbot, wizard)
    check_result(wizard)  # the rig was not connected again: the session knows whose it is
    wizard._accept()
    assert application.session.cameras.projector is not None
    assert "Projector" in [row[0] for row in application.window.pages["calibration"].table.texts()]
    assert wizard.calibrating.has_previous


def check_result(wizard):
    assert wizard.step == RESULT
    result = wizard.calibrating.result
    assert result.has_truth
    assert "mm (k = 2)" in result.verdict
    assert {row.estimate.group for row in result.rows} == {"Projector"}
    assert all(abs(row.estimate.value - row.true) < 6 * row.estimate.sigma for row in result.rows)
    assert wizard.result.truth_note.isVisible()


@pytest.mark.parametrize("folder, said", [("nothing here", "There is no folder"), ("", "There is no MANIFEST.toml in")])
def test_a_folder_without_fringes_is_refused_with_a_remedy(qtbot, wizard, tmp_path, folder, said):
    (tmp_path / "empty").mkdir()
    read_folder(qtbot, wizard, tmp_path / (folder or "empty"))
    assert said in wizard.footer.message.words.text()
    assert wizard.footer.message.words.text().count(".") >= 2
    assert wizard.step == SETUP


def test_recorded_fringes_are_read_from_their_folders(qtbot, wizard, tmp_path, tmp_path_factory):
    for manifest in shared_stacks(tmp_path_factory)[:VIEWS]:  # of the head that the wizard's cameras belong to
        shutil.copytree(manifest.parent, tmp_path / "fringes" / manifest.parent.name)
    (tmp_path / "fringes" / "position02" / "left" / "60000" / "007.png").write_bytes(b"no image")
    read_folder(qtbot, wizard, tmp_path / "fringes")
    assert "007.png" in wizard.footer.message.words.text()
    assert [view.name for view in wizard.collecting.views] == ["position00", "position01", "position03"]
    assert [view.verdict for view in wizard.collecting.views] == ["pass"] * 3
