"""The whole way in a real X window with the native VTK widget, on a screen in memory."""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from PySide6.QtGui import QImage

ROOT = Path(__file__).resolve().parents[3]
LEAST_COLOURS = 200
LIBRARIES = ("libxcb-cursor.so.0", "libxcb-icccm.so.4", "libxcb-keysyms.so.1")
PACKAGES = "libxcb-cursor0, libxcb-icccm4, libxcb-keysyms1"


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("Xvfb") is None, reason="install Xvfb (Debian: apt-get install xvfb) for a screen in memory"),
    pytest.mark.skipif(not all(map(_loads, LIBRARIES)), reason=f"install what Qt needs for X windows: {PACKAGES}"),
]


@pytest.fixture
def display():
    """The name of a screen in memory."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
        pass_fds=(writing,),
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    with os.fdopen(reading) as said:
        number = said.readline().strip()
    yield f":{number}"
    server.terminate()
    server.wait(10)


def test_the_journey_in_an_x_window_with_the_native_view(display, tmp_path):
    environment = {**os.environ, "QT_QPA_PLATFORM": "xcb", "MEASUREAPP_VIEWPORT": "native", "DISPLAY": display, "HOME": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-m", "tests.ui.journey.in_x_window", str(tmp_path)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        env={**environment, "PYTHONPATH": str(ROOT)},
        timeout=3000,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "platform xcb, native True" in done.stdout
    for name in ("clouds", "inspection"):
        assert len(set(picture(tmp_path / f"{name}.png"))) > LEAST_COLOURS, f"{name} shows no picture"
    complete = {name: picture(tmp_path / f"{name}.png") for name in ("clouds", "inspection")}
    for name, other in (("clouds", "inspection"), ("inspection", "clouds")):
        soon = picture(tmp_path / f"{name}_soon.png")
        assert unlike(soon, complete[name]) < 0.2 * unlike(complete[other], complete[name]), f"{name} shows another page's picture at first"


def picture(file: Path) -> list[int]:
    """Return colours in the middle of the 3-D view."""
    image = QImage(str(file))
    return [image.pixel(x, y) for x in range(120, 560, 3) for y in range(240, 620, 3)]


def unlike(one: list[int], other: list[int]) -> int:
    """Return how many colours differ."""
    return sum(first != second for first, second in zip(one, other, strict=True))
