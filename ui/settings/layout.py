"""Sizes of the window and of its parts, as the user left them."""

from __future__ import annotations

from PySide6.QtCore import QRect
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QSplitter, QWidget

from ui.settings.settings import Settings

GRIP_PX = (120, 32)  # of the title bar that must lie on a screen for the window to be moved
MAXIMIZED = 1


def remember(splitter: QSplitter, name: str, settings: Settings) -> None:
    """Give a splitter the sizes that it had last, and keep those that the user gives it.

    Sizes of another number of parts are ignored. Call it when all parts are added.
    """
    sizes = settings.numbers(f"splitter-{name}")
    if len(sizes) == splitter.count() and min(sizes, default=-1) >= 0 and sum(sizes) > 0:
        splitter.setSizes(list(sizes))
    splitter.splitterMoved.connect(lambda *_: settings.set_numbers(f"splitter-{name}", tuple(splitter.sizes())))


def remember_splitters(parent: QWidget, settings: Settings) -> None:
    """Remember the sizes of every splitter below ``parent`` that has an object name; those that are known already are left alone."""
    for splitter in parent.findChildren(QSplitter):
        if splitter.objectName() and not splitter.property("remembered"):
            splitter.setProperty("remembered", True)
            remember(splitter, splitter.objectName(), settings)


def restore_window(window: QWidget, settings: Settings) -> None:
    """Put the window where it was, as far as the present screens allow."""
    stored = settings.numbers("window")
    if len(stored) != 5 or stored[2] <= 0 or stored[3] <= 0:
        return
    screens = [screen.availableGeometry() for screen in QGuiApplication.screens()]
    window.setGeometry(fitted(QRect(*stored[:4]), screens, QRect(0, 0, window.minimumWidth(), window.minimumHeight())))
    if stored[4] == MAXIMIZED:
        window.showMaximized()


def keep_window(window: QWidget, settings: Settings) -> None:
    """Keep where the window is."""
    place = window.normalGeometry() if window.isMaximized() or window.isFullScreen() else window.geometry()
    if place.isValid():
        settings.set_numbers("window", (place.x(), place.y(), place.width(), place.height(), MAXIMIZED if window.isMaximized() else 0))


def fitted(wanted: QRect, screens: list[QRect], least: QRect) -> QRect:
    """Return a place for the window on the present screens: as wanted if it can be gripped there, else in the middle of the first."""
    if not screens:
        return wanted
    bar = QRect(wanted.x(), wanted.y(), wanted.width(), GRIP_PX[1])
    home = next((screen for screen in screens if _can_be_gripped(bar.intersected(screen))), None)
    screen = home or screens[0]
    width = max(least.width(), min(wanted.width(), screen.width()))
    height = max(least.height(), min(wanted.height(), screen.height()))
    placed = QRect(wanted.x(), wanted.y(), width, height)
    if home is None:
        placed.moveCenter(screen.center())
        placed.moveTop(max(placed.top(), screen.top()))
        placed.moveLeft(max(placed.left(), screen.left()))
    return placed


def _can_be_gripped(seen: QRect) -> bool:
    return seen.width() >= GRIP_PX[0] and seen.height() >= GRIP_PX[1] // 2
