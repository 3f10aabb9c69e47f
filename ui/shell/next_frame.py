"""When a window has displayed what was changed."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QTimer, Signal, Slot
from PySide6.QtWidgets import QWidget


class NextFrame(QObject):
    """Tells that a window has drawn its next frame; at once where it is not shown."""

    drawn = Signal()

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    @Slot()
    def wait(self) -> None:
        """Ask for a frame, and tell when it is drawn."""
        if not self._window.isVisible():
            self.drawn.emit()
            return
        self._window.installEventFilter(self)
        self._window.update()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice the request of Qt that draws the frame; it is handled after this."""
        if event.type() == QEvent.Type.UpdateRequest:
            watched.removeEventFilter(self)
            QTimer.singleShot(0, self, self.drawn.emit)
        return False
