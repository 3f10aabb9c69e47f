"""What tests of all wizards do with them."""

from __future__ import annotations

from pathlib import Path

from pytestqt.qtbot import QtBot

from ui.wizards.wizard import CalibrationWizard

PATIENCE_MS = 240_000


def settle(qtbot: QtBot, wizard: CalibrationWizard) -> None:
    """Wait until nothing is collected, thought about or concluded any more."""
    collecting = wizard.collecting
    qtbot.waitUntil(
        lambda: not (collecting.is_collecting or collecting.solver.is_running or wizard.calibrating.is_concluding), timeout=PATIENCE_MS
    )


def read_folder(qtbot: QtBot, wizard: CalibrationWizard, folder: Path) -> None:
    """Begin with the recorded images in a folder."""
    wizard.setup.source.setValue("images")
    wizard.setup.folder.setValue(folder)
    wizard.footer.primary.click()
    settle(qtbot, wizard)
