"""Every page, wizard and dialog in both themes, both languages and three sizes, as pictures."""

from __future__ import annotations

import pytest

from measureapp.calibrate.kinds.table import KINDS
from tests.ui.gallery import ON_DEMAND, every_wall

PATIENCE_MS = 60_000
pytestmark = ON_DEMAND


@every_wall
@pytest.mark.parametrize("full", [False, True], ids=["empty", "filled"])
def test_pages(application, window, request, qtbot, wall, full):
    if full:
        request.getfixturevalue("filled")
    window.resize(*wall.size)
    wall.dress(application)
    for name, page in window.pages.items():
        window.show_page(name)
        qtbot.wait(300)
        qtbot.waitUntil(lambda page=page: not getattr(page, "is_composing", False), timeout=PATIENCE_MS)
        qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
        qtbot.wait(200)
        wall.keep(window, f"{name}{'' if full else '-empty'}")


@every_wall
def test_wizards(application, calibration_page, qtbot, wall):
    wall.dress(application)
    for name in KINDS:
        calibration_page.open_wizard(name)
        wizard = calibration_page.wizards[name]
        wizard.resize(wall.size[0] - 40, wall.size[1] - 60)
        qtbot.wait(300)
        wall.keep(wizard, f"wizard-{name}")
        wizard.close()


@every_wall
def test_dialogs(application, filled, qtbot, wall):
    filled.resize(*wall.size)
    wall.dress(application)
    filled.session.tell("The rig is not connected.", "Press Connect on the page Rig, then try again.", "warning")
    for dialog in (filled.messages, filled.settings_dialog, filled.palette_, filled.shortcuts):
        dialog.begin()
        qtbot.wait(50)
        wall.keep(dialog, f"dialog-{type(dialog).__name__}")
        dialog.close()
    for name in ("rig", "inspection"):
        filled.help.show_page(name)
        qtbot.wait(50)
        wall.keep(filled.help, f"dialog-help-{name}")
    filled.help.close()
