"""The pictures of the README, taken anew from a measured project: see CONTRIBUTING."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.ui.wizard_steps import settle
from ui.wizards.wizard import RESULT

FOLDER, PROJECT = (os.environ.get(name, "") for name in ("MEASUREAPP_SCREENSHOTS", "MEASUREAPP_README_PROJECT"))
WINDOW, DIALOG, WIZARD = (1600, 1000), (1240, 680), (1340, 740)
PATIENCE_MS = 300_000
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not (FOLDER and PROJECT), reason="set MEASUREAPP_SCREENSHOTS and MEASUREAPP_README_PROJECT"),
]


def keep(widget, name: str) -> None:
    folder = Path(FOLDER)
    folder.mkdir(parents=True, exist_ok=True)
    assert widget.grab().save(str(folder / f"{name}.png"))


@pytest.fixture
def settled(application, qtbot):
    def wait() -> None:
        qtbot.wait(500)
        qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
        qtbot.wait(1500)

    return wait


def test_pages_of_the_measured_project(application, window, settled):
    window.resize(*WINDOW)
    application.controllers.startup.begin()
    settled()
    application.controllers.project.open(Path(PROJECT))
    settled()
    for name, picture in (("clouds", "clouds"), ("inspection", "inspect")):
        window.show_page(name)
        window.properties.fold(True)
        settled()
        window.pages[name].view.reset_camera()
        settled()
        keep(window, picture)
    clouds = window.pages["clouds"]
    window.show_page("clouds")
    clouds.holes.click()
    settled()
    clouds.dialog.resize(*DIALOG)
    clouds.dialog.kind.setValue("reasons")
    settled()
    keep(clouds.dialog, "holes")
    clouds.dialog.close()


def test_result_of_a_camera_calibration(calibration_page, qtbot, settled):
    calibration_page.open_wizard("cameras")
    wizard = calibration_page.wizards["cameras"]
    wizard.resize(*WIZARD)
    while wizard.step != RESULT:  # sets up, collects what the guidance asks for, sees the result
        wizard.footer.primary.click()
        settle(qtbot, wizard)
    qtbot.waitUntil(lambda: not wizard.calibrating.is_checking, timeout=PATIENCE_MS)
    settled()
    keep(wizard, "wizard_result")
    wizard.close()
