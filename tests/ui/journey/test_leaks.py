"""Using the window again and again leaves nothing behind: no widget, timer, thread or VTK object."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.ui.inventory import grown, inventory

ROOT = Path(__file__).resolve().parents[3]
PATIENCE_MS = 20_000
MOST_WARM_CYCLES = 6
SCRIPT = """
import sys
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication
from shiboken6 import delete
from tests.ui.inventory import grown, inventory
from ui.app import build

application, first, last = QApplication([]), None, None
for cycle in range({cycles}):
    built = build(application)
    built.session.set_graphics("ready")
    built.window.show()
    for name in built.window.pages:
        built.window.show_page(name)
        application.processEvents()
    assert built.window.close()
    assert built.controllers.end(20_000)
    for left in (built.window, built.controllers, built.session, built.look):
        delete(left)
    del built, left
    last = inventory()
    first = last if cycle == 1 else first
print("grown:", grown(first, last))
"""


def _cycle(window, qtbot) -> None:
    for name, page in window.pages.items():
        window.show_page(name)
        qtbot.wait(10)
        qtbot.waitUntil(lambda page=page: not getattr(page, "is_composing", False), timeout=PATIENCE_MS)


@pytest.mark.parametrize("cycles", [2, pytest.param(50, marks=pytest.mark.slow)])
def test_page_cycles_leave_nothing_behind(filled, qtbot, cycles):
    _cycle(filled, qtbot)
    before = inventory()
    for _ in range(MOST_WARM_CYCLES):  # what is made when first needed is made once; a leak grows in every cycle
        _cycle(filled, qtbot)
        before, last = inventory(), before
        if not grown(last, before):
            break
    for count in range(cycles):
        if cycles > 2 and count % 10 == 0:
            filled.look.set_shade("dark" if filled.look.theme.shade == "light" else "light")
        _cycle(filled, qtbot)
    assert grown(before, inventory()) == {}


@pytest.mark.parametrize("cycles", [5, pytest.param(50, marks=pytest.mark.slow)])
def test_windows_opened_and_closed_end_with_code_0_and_leave_nothing(tmp_path, cycles):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": str(tmp_path), "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT.format(cycles=cycles)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        env=environment,
        timeout=1200,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == "grown: {}"
    assert done.stderr == ""
