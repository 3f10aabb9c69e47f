"""A seeded monkey: random clicks, keys, wheel turns, drags and sizes on what is visible, with jobs that end at once."""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QDesktopServices, QKeyEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QFileDialog, QMenu, QWidget

from measureapp.errors import MeasureError
from measureapp.progress import Cancelled
from ui.workers.job import Job

KEYS = (
    *(getattr(Qt.Key, f"Key_{name}") for name in ("Tab", "Backtab", "Return", "Space", "Escape", "Delete", "Up", "Down", "Left", "Right")),
    *(getattr(Qt.Key, f"Key_{name}") for name in ("Home", "End", "PageUp", "PageDown", "F2", "Backspace", "A", "M", "3", "P", "0", "9")),
    *(getattr(Qt.Key, f"Key_{name}") for name in ("Minus", "Comma", "Period")),
)
COMBINATIONS = tuple((Qt.Key(key), Qt.KeyboardModifier.ControlModifier) for key in (Qt.Key.Key_Z, Qt.Key.Key_Y, Qt.Key.Key_D, Qt.Key.Key_K))
SIZES = ((1280, 720), (1400, 800), (1600, 900), (1920, 1080))
KINDS = ("click",) * 12 + ("double", "right", "key", "key", "key", "type", "wheel", "wheel", "drag", "combination", "size")
STUCK_MS = 300


class Monkey:
    """Sends random events to one window and its dialogs; equal seeds send equal events."""

    def __init__(self, window: QWidget, seed: int, spared: tuple[str, ...] = ()) -> None:
        self.window, self.random, self.spared = window, random.Random(seed), spared
        self.sent = list[str]()

    def play(self, home: str, events: int) -> None:
        """Send events; every twentieth returns to the page ``home`` of the window."""
        keeper = QTimer()
        keeper.setInterval(STUCK_MS)
        keeper.timeout.connect(_dismiss)
        keeper.start()
        stay_open = StayOpen()
        self.window.installEventFilter(stay_open)
        try:
            for count in range(events):
                if count % 20 == 0:
                    self.window.show_page(home)
                self._send(self.random.choice(KINDS))
                QApplication.processEvents()
        finally:
            self.window.removeEventFilter(stay_open)
            keeper.stop()
            keeper.deleteLater()
            _dismiss()

    def _send(self, kind: str) -> None:
        targets = [widget for widget in _visible(self.window) if not self._is_spared(widget)]
        widget = self.random.choice(targets)
        place = QPoint(self.random.randrange(max(1, widget.width())), self.random.randrange(max(1, widget.height())))
        self.sent.append(f"{kind} {type(widget).__name__} {widget.objectName()} {place.x()},{place.y()}")
        getattr(self, f"_{kind}")(widget, place)

    def _is_spared(self, widget: QWidget) -> bool:
        return any(
            name in self.spared for name in (widget.objectName(), getattr(widget, "text", lambda: "")() if _has_text(widget) else "")
        )

    def _click(self, widget: QWidget, place: QPoint) -> None:
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, pos=place)

    def _double(self, widget: QWidget, place: QPoint) -> None:
        QTest.mouseDClick(widget, Qt.MouseButton.LeftButton, pos=place)

    def _right(self, widget: QWidget, place: QPoint) -> None:
        QTest.mouseClick(widget, Qt.MouseButton.RightButton, pos=place)

    def _key(self, widget: QWidget, place: QPoint) -> None:
        QTest.keyClick(QApplication.focusWidget() or widget, self.random.choice(KEYS))

    def _combination(self, widget: QWidget, place: QPoint) -> None:
        QTest.keyClick(QApplication.focusWidget() or widget, *self.random.choice(COMBINATIONS))

    def _type(self, widget: QWidget, place: QPoint) -> None:
        target = QApplication.focusWidget() or widget
        for letter in self.random.choice(
            ("12.5", "-1", "ab", "1e9", "0", "Ø ä 叶", "../x")
        ):  # QTest.keyClicks aborts with other than Latin
            for kind in (QEvent.Type.KeyPress, QEvent.Type.KeyRelease):
                QApplication.sendEvent(target, QKeyEvent(kind, 0, Qt.KeyboardModifier.NoModifier, letter))

    def _wheel(self, widget: QWidget, place: QPoint) -> None:
        turn = QPoint(0, self.random.choice((-120, 120, -360)))
        at, none = QPointF(place), Qt.KeyboardModifier.NoModifier
        event = QWheelEvent(at, widget.mapToGlobal(at), QPoint(), turn, Qt.MouseButton.NoButton, none, Qt.ScrollPhase.NoScrollPhase, False)
        QApplication.sendEvent(widget, event)

    def _drag(self, widget: QWidget, place: QPoint) -> None:
        QTest.mousePress(widget, Qt.MouseButton.LeftButton, pos=place)
        for _ in range(3):
            QTest.mouseMove(widget, QPoint(self.random.randrange(max(1, widget.width())), self.random.randrange(max(1, widget.height()))))
        QTest.mouseRelease(widget, Qt.MouseButton.LeftButton, pos=place)

    def _size(self, widget: QWidget, place: QPoint) -> None:
        self.window.resize(*self.random.choice(SIZES))


class StayOpen(QObject):
    """Ignores that the window is closed: the menu and the palette offer Exit, after which there is nothing to click at."""

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:  # noqa: N802 - of Qt
        """Take the event that closes the window."""
        if event.type() != QEvent.Type.Close:
            return False
        event.ignore()
        return True


@contextmanager
def harmless(seed: int) -> Iterator[None]:
    """Let every job that is shown end at once, cancelled or failed; no file dialog opens, no document leaves the program."""
    chance, run = random.Random(seed), Job.run

    def ended(job: Job) -> None:
        if job.quiet:
            run(job)
            return
        problem = Cancelled() if chance.random() < 0.5 else MeasureError(f"{job.title} was refused by the monkey.", "Go on.")

        def refuse(_: Job) -> None:
            raise problem

        job._work = refuse
        run(job)

    with (
        patch.object(Job, "run", ended),
        patch.object(QFileDialog, "getOpenFileName", return_value=("", "")),
        patch.object(QFileDialog, "getOpenFileNames", return_value=([], "")),
        patch.object(QFileDialog, "getSaveFileName", return_value=("", "")),
        patch.object(QFileDialog, "getExistingDirectory", return_value=""),
        patch.object(QDesktopServices, "openUrl", return_value=True),
    ):
        yield


def _visible(window: QWidget) -> list[QWidget]:
    """Return the visible, enabled widgets of what accepts input: a menu, a modal dialog, or the window and its dialogs."""
    popup, modal = QApplication.activePopupWidget(), QApplication.activeModalWidget()
    roots = [popup] if popup is not None else [modal] if modal is not None else [window, *_dialogs()]
    return [widget for root in roots for widget in _seen(root)] or roots


def _seen(widget: QWidget) -> Iterator[QWidget]:
    """Yield a widget and those in it, parents first; what is hidden, disabled or covered has nothing in it that is not."""
    if widget.isVisible() and widget.isEnabled() and not widget.visibleRegion().isEmpty():
        yield widget
        for child in widget.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly):
            yield from _seen(child)


def _dialogs() -> list[QWidget]:
    return [widget for widget in QApplication.topLevelWidgets() if isinstance(widget, QDialog) and widget.isVisible()]


def _has_text(widget: QWidget) -> bool:
    return callable(getattr(widget, "text", None))


def _dismiss() -> None:
    """Close the menu or dialog that waits for an answer."""
    QTimer.singleShot(0, lambda: None)  # wakes a nested event loop
    popup, modal = QApplication.activePopupWidget(), QApplication.activeModalWidget()
    if isinstance(popup, QMenu) or popup is not None:
        popup.close()
    elif isinstance(modal, QDialog):
        modal.reject()
    elif modal is not None:
        QApplication.postEvent(modal, QEvent(QEvent.Type.Close))
