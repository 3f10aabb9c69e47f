"""The window shows every pixel as it is, at any display scaling, on the screen that was named."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from contracts.drivers.projector_second_screen import screens
from PySide6.QtGui import QGuiApplication, QRegion, QScreen

from measureapp.errors import DeviceError, InputError
from ui.second_screen.screens import ScreenChoice, check_size, describe, find_screen, native_size_px
from ui.second_screen.window import PatternWindow, read_grey

ROOT = Path(__file__).resolve().parents[3]


def count_wrong_pixels(scaling: str, size: tuple[int, int], screen: tuple[int, int] | None = None) -> subprocess.CompletedProcess[str]:
    with screens(main=(640, 480), beamer=screen or size):
        environment = os.environ | {"QT_SCALE_FACTOR": scaling, "PYTHONPATH": str(ROOT)}
        environment.pop("QT_ENABLE_HIGHDPI_SCALING", None)
        script = [sys.executable, str(Path(__file__).with_name("exact_pixels.py")), *map(str, size)]
        return subprocess.run(script, env=environment, cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)


SIZES = ((912, 1140), (1280, 720))
USUAL = (("1.0", SIZES[0]), ("1.25", SIZES[1]), ("1.5", SIZES[0]), ("2.0", SIZES[1]))  # each is a program of its own
OTHERS = [pytest.param(scaling, size, marks=pytest.mark.slow) for scaling, used in USUAL for size in SIZES if size != used]


@pytest.mark.parametrize(("scaling", "size"), [*USUAL, *OTHERS])
def test_every_pixel_arrives_as_it_is_at_any_scaling(scaling: str, size: tuple[int, int]) -> None:
    done = count_wrong_pixels(scaling, size)
    assert done.returncode == 0, done.stderr
    ratio, wrong, grabbed, seen = done.stdout.split()
    assert float(ratio) == float(scaling)
    assert (wrong, grabbed) == ("0", "0")
    assert int(seen) >= 2 * size[0] * size[1] / float(scaling) ** 2 - 2 * sum(size)


def test_a_scaling_that_would_drop_a_row_is_refused() -> None:
    done = count_wrong_pixels("1.75", (912, 1140))
    assert done.returncode != 0
    assert "cannot show the patterns pixel by pixel at a scaling of 1.75" in done.stderr


@pytest.mark.parametrize("scaling", [pytest.param("1.0", marks=pytest.mark.slow), "1.5"])
def test_a_screen_of_another_size_is_refused(scaling: str) -> None:
    done = count_wrong_pixels(scaling, (912, 1140), screen=(1280, 720))
    assert "The screen beamer has 1280 × 720 px, and the patterns have 912 × 1140 px." in done.stderr


@pytest.fixture
def screen(qapp: QGuiApplication) -> QScreen:
    return qapp.primaryScreen()


@pytest.fixture
def window(screen: QScreen) -> Iterator[PatternWindow]:
    made = PatternWindow(screen, *native_size_px(screen))
    made.showFullScreen()
    QGuiApplication.processEvents()
    yield made
    made.close()
    made.destroy()
    made.deleteLater()


def shown(window: PatternWindow) -> np.ndarray:
    window._store.beginPaint(QRegion())
    grey = read_grey(window._store.paintDevice())
    window._store.endPaint()
    return grey


def test_all_256_grey_levels_are_different_and_right(window: PatternWindow, screen: QScreen) -> None:
    width, height = native_size_px(screen)
    ramp = np.broadcast_to((np.arange(width) % 256).astype(np.uint8), (height, width))
    window.display(ramp)
    assert np.array_equal(shown(window), ramp)


def test_the_window_is_dark_before_the_first_image(window: PatternWindow) -> None:
    assert not shown(window).any()


def test_an_image_is_painted_again_when_it_was_covered(window: PatternWindow, screen: QScreen) -> None:
    width, height = native_size_px(screen)
    window.display(np.full((height, width), 90, np.uint8))
    window.hide()
    window.showFullScreen()
    QGuiApplication.processEvents()
    assert np.all(shown(window) == 90)


def test_a_screen_is_found_by_its_name_only(screen: QScreen) -> None:
    assert find_screen([screen], ScreenChoice(name=screen.name())) is screen
    with pytest.raises(DeviceError, match=r"No screen has model 'DLP' \(connected: "):
        find_screen([screen], ScreenChoice(model="DLP"))
    with pytest.raises(InputError, match="2 screens have any name"):
        find_screen([screen, screen], ScreenChoice())


def test_a_screen_states_its_mode_in_pixels(screen: QScreen) -> None:
    width, height = native_size_px(screen)
    found = describe(screen)
    assert (found["width_px"], found["height_px"], found["refresh_hz"]) == (width, height, 60.0)
    check_size(screen, width, height)
    with pytest.raises(InputError, match=f"has {width} × {height} px, and the patterns have {width + 2} × {height} px"):
        check_size(screen, width + 2, height)
