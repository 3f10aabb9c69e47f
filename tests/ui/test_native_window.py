"""The native 3-D view in a real X window: turn, pick, change the view, resize, close. Xvfb stands in for a screen."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

TIMEOUT_S = 180
SCRIPT = Path(__file__).with_name("native_window_script.py")
MISSING = "could not load the qt platform plugin"

pytestmark = pytest.mark.slow


@pytest.mark.skipif(sys.platform != "linux", reason="an X window exists on Linux only")
@pytest.mark.skipif(shutil.which("xvfb-run") is None, reason="xvfb-run is missing; install the packages xvfb and xauth")
@pytest.mark.parametrize("ratio", ["1", "1.5"])
def test_the_native_view_turns_picks_resizes_and_closes_in_an_x_window(ratio):
    environment = {**os.environ, "QT_QPA_PLATFORM": "xcb", "MEASUREAPP_VIEWPORT": "native", "QT_SCALE_FACTOR": ratio}
    command = ["xvfb-run", "-a", "-s", "-screen 0 1920x1200x24", sys.executable, "-W", "error::RuntimeWarning", str(SCRIPT)]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=TIMEOUT_S, check=False)
    if MISSING in ended.stderr.lower():
        pytest.skip("Qt cannot open an X window; install libxcb-cursor0, libxcb-icccm4 and libxcb-keysyms1")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "all good" in ended.stdout
