"""Every page and wizard in both themes and three sizes, as pictures in the folder that MEASUREAPP_SCREENSHOTS names."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from measureapp.calibrate.kinds.table import KINDS

FOLDER = os.environ.get("MEASUREAPP_SCREENSHOTS", "")
SIZES = ((1280, 720), (1600, 900), (1920, 1080))
SHADES = ("light", "dark")
PATIENCE_MS = 60_000
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not FOLDER, reason="set MEASUREAPP_SCREENSHOTS to the folder that shall receive the pictures"),
]


def _keep(widget, name: str, shade: str, size: tuple[int, int]) -> None:
    folder = Path(FOLDER)
    folder.mkdir(parents=True, exist_ok=True)
    assert widget.grab().save(str(folder / f"{name}-{size[0]}x{size[1]}-{shade}.png"))


@pytest.mark.parametrize("shade", SHADES)
@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
@pytest.mark.parametrize("full", [False, True], ids=["empty", "filled"])
def test_pages(application, window, request, qtbot, shade, size, full):
    if full:
        request.getfixturevalue("filled")
    window.resize(*size)
    application.look.set_shade(shade)
    for name, page in window.pages.items():
        window.show_page(name)
        qtbot.wait(300)
        qtbot.waitUntil(lambda page=page: not getattr(page, "is_composing", False), timeout=PATIENCE_MS)
        qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
        qtbot.wait(200)
        _keep(window, f"{name}{'' if full else '-empty'}", shade, size)


@pytest.mark.parametrize("shade", SHADES)
@pytest.mark.parametrize("size", SIZES, ids=lambda size: f"{size[0]}x{size[1]}")
def test_wizards(application, calibration_page, qtbot, shade, size):
    application.look.set_shade(shade)
    for name in KINDS:
        calibration_page.open_wizard(name)
        wizard = calibration_page.wizards[name]
        wizard.resize(size[0] - 40, size[1] - 60)
        qtbot.wait(300)
        _keep(wizard, f"wizard-{name}", shade, size)
        wizard.close()
