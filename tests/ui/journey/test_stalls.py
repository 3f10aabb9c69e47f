"""Nothing that a user does on the pages stalls the window; alone on the machine, since stalls are measured."""

from __future__ import annotations

import pytest

from measureapp.calibrate.kinds.table import KINDS
from measureapp.progress import NoProgress
from ui.controllers.startup import import_all

PATIENCE_MS = 60_000


def _settle(application, qtbot) -> None:
    qtbot.wait(60)
    qtbot.waitUntil(lambda: not any(runner.queue.busy for runner in application.controllers.runners), timeout=PATIENCE_MS)
    qtbot.wait(60)


@pytest.mark.slow
@pytest.mark.timed
def test_pages_open_without_a_stall(application, filled, heartbeat, qtbot):
    import_all(NoProgress())  # in the background of the program's first seconds
    filled.make_pages()
    qtbot.waitUntil(lambda: len(filled.pages.made) == len(filled.pages))
    qtbot.wait(100)
    heartbeat.stalls.clear()
    for turn in ("first", "second"):
        for name in filled.pages:
            with heartbeat.at(f"{turn} opening of {name}"):
                filled.show_page(name)
                _settle(application, qtbot)
    heartbeat.check()


@pytest.mark.slow
@pytest.mark.timed
def test_wizards_open_without_a_stall(application, calibration_page, heartbeat, qtbot):
    for name in KINDS:
        with heartbeat.at(f"wizard {name}"):
            calibration_page.open_wizard(name)
            _settle(application, qtbot)
        with heartbeat.at(f"closing wizard {name}"):
            calibration_page.wizards[name].close()
            qtbot.wait(60)
    heartbeat.check()


@pytest.mark.slow
@pytest.mark.timed
def test_a_theme_switch_does_not_stall(application, filled, heartbeat, qtbot):
    for name in filled.pages:
        filled.show_page(name)
        _settle(application, qtbot)
    heartbeat.stalls.clear()
    for shade in ("dark", "light", "dark"):
        with heartbeat.at(f"theme {shade}"):
            application.look.set_shade(shade)
            _settle(application, qtbot)
    heartbeat.check()
