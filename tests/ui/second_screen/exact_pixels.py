"""Run by the tests in a process of its own, since the display scaling is fixed when Qt starts: counts wrong pixels.

Prints the scaling, the number of pixels that differ on the painted surface, the number that differ in a grab of the screen, and
the number of pixels in that grab (Qt's platform without a display grabs as many pixels as the screen has in logical units).
"""

from __future__ import annotations

import sys

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QRegion

from ui.second_screen.screens import ScreenChoice, find_screen
from ui.second_screen.window import PatternWindow, read_grey


def main(width_px: int, height_px: int) -> None:
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(Qt.HighDpiScaleFactorRoundingPolicy.PassThrough)
    application = QGuiApplication([])
    screen = find_screen(application.screens(), ScreenChoice(name="beamer"))
    window = PatternWindow(screen, width_px, height_px)
    window.showFullScreen()
    application.processEvents()
    noise = np.random.default_rng(1).integers(0, 256, (height_px, width_px), np.uint8)
    checker = ((np.arange(height_px)[:, None] + np.arange(width_px)) % 2 * 255).astype(np.uint8)
    wrong = grabbed = seen = 0
    for image in (noise, checker):
        window.display(image)
        application.processEvents()
        window._store.beginPaint(QRegion())
        surface = read_grey(window._store.paintDevice())
        window._store.endPaint()
        wrong += int((surface[:height_px, :width_px] != image).sum())
        grab = read_grey(screen.grabWindow(window.winId()).toImage())[:height_px, :width_px]
        grabbed += int((grab != image[: grab.shape[0], : grab.shape[1]]).sum())
        seen += grab.size
    sys.stdout.write(f"{screen.devicePixelRatio():g} {wrong} {grabbed} {seen}\n")
    window.close()


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
