"""A user: clicks what is visible and enabled, counts the clicks, and takes a picture of what was seen."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from unittest.mock import patch

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QFileDialog, QWidget

from tests.ui.heartbeat import Heartbeat

FOLDER = os.environ.get("MEASUREAPP_SCREENSHOTS", "")


class User:
    """One person at one window."""

    def __init__(self, qtbot, heart: Heartbeat, name: str) -> None:
        self._qtbot, self._heart, self._name = qtbot, heart, name
        self.clicks = 0
        self.steps: list[str] = []

    def click(self, button: QAbstractButton) -> None:
        """Click a button that can be seen."""
        self.see(button)
        self.clicks += 1
        self.steps.append(f"click {button.text() or button.toolTip()}")
        with self._heart.at(self.steps[-1]):
            QTest.mouseClick(button, Qt.MouseButton.LeftButton, pos=QPoint(button.width() // 2, button.height() // 2))
            self._qtbot.wait(50)

    def choose(self, box: QComboBox, words: str) -> None:
        """Choose an entry of a list: one click opens it, one takes the entry."""
        self.see(box)
        place = box.findText(words)
        assert place >= 0, [box.itemText(number) for number in range(box.count())]
        self.clicks += 2
        self.steps.append(f"choose {words}")
        with self._heart.at(self.steps[-1]):
            box.setCurrentIndex(place)
            box.activated.emit(place)
            self._qtbot.wait(50)

    def see(self, widget: QWidget) -> None:
        """Check that a widget can be seen and used."""
        words = getattr(widget, "text", widget.objectName)()
        assert widget.isVisible(), f"{words} is not shown"
        assert widget.isEnabled(), f"{words} is disabled: {widget.toolTip()}"
        assert not widget.visibleRegion().isEmpty(), f"{words} lies outside of the window"

    def wait(self, until: Callable[[], bool], seconds: float, doing: str) -> None:
        """Wait, with the heartbeat running."""
        with self._heart.at(doing):
            self._qtbot.waitUntil(until, timeout=round(seconds * 1000))
            self._qtbot.wait(100)

    def look_at(self, widget: QWidget, name: str) -> None:
        """Keep a picture of a window, where pictures are wanted."""
        with self._heart.pause():
            if FOLDER:
                folder = Path(FOLDER) / f"journey-{self._name}"
                folder.mkdir(parents=True, exist_ok=True)
                assert widget.grab().save(str(folder / f"{len(list(folder.iterdir())):02d}-{name}.png"))

    def tell(self, words: str) -> None:
        """Keep what was clicked, and these words, beside the pictures."""
        if FOLDER:
            steps = "\n".join((f"{self.clicks} clicks", *self.steps, "", words))
            (Path(FOLDER) / f"journey-{self._name}" / "steps.txt").write_text(steps, encoding="utf-8")


@contextmanager
def answering(path: Path) -> Iterator[None]:
    """Answer file dialogs with this path."""
    with patch.multiple(
        QFileDialog,
        getOpenFileName=lambda *_, **__: (str(path), ""),
        getSaveFileName=lambda *_, **__: (str(path), ""),
        getExistingDirectory=lambda *_, **__: str(path),
    ):
        yield
