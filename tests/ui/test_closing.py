"""Closing the window while a thread cannot stop yet: nothing is destroyed under it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
STUBBORN_S = 1.5
SCRIPT = """
import sys, time
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
import ui.app, ui.main_window
from ui.controllers import startup

ui.main_window.CLOSING_WAIT_MS, ui.app.LAST_WAIT_MS = 100, {last_ms}

def compiles(job):
    for window in QApplication.topLevelWidgets():
        if isinstance(window, ui.main_window.MainWindow):
            QTimer.singleShot(0, window, window.close)
    time.sleep({stubborn_s})
    print("the thread came to its end", flush=True)

startup.load_rig = compiles
sys.exit(ui.app.run())
"""


@pytest.mark.parametrize(("last_ms", "ends"), [(20_000, True), (200, False)])
def test_a_thread_that_cannot_stop_is_waited_for_or_left_but_never_destroyed(tmp_path, last_ms, ends):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": str(tmp_path)}
    script = SCRIPT.format(last_ms=last_ms, stubborn_s=STUBBORN_S if ends else 600)
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, env=environment, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "Destroyed while thread" not in done.stderr
    assert ("the thread came to its end" in done.stdout) == ends
