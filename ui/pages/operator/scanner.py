"""A bar-code scanner types like a keyboard, only faster: its keys are taken as one code, wherever the focus is."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent, QWindow
from PySide6.QtWidgets import QApplication, QLineEdit

FEWEST, SLOWEST_S = 4, 0.05  # characters of a code; between two of its keys
ENDS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab)
GROUP_SEPARATOR = "\x1d"
SEPARATOR_KEYS = (Qt.Key.Key_BracketRight, Qt.Key.Key_F8)  # with Ctrl, and as many scanners are set up to send GS


@dataclass
class TypedFast:
    """Keys that came one shortly after the other."""

    text: str = ""
    last_s: float = field(default=-1.0)

    def add(self, letter: str, now_s: float) -> None:
        """Add a letter; after a pause the text begins anew."""
        self.text = (self.text if now_s - self.last_s < SLOWEST_S else "") + letter
        self.last_s = now_s

    def end(self, now_s: float) -> str:
        """Return the code that Enter or Tab ends; empty where a person typed it."""
        code = self.text if now_s - self.last_s < SLOWEST_S and len(self.text) >= FEWEST else ""
        self.text = ""
        return code


class Scanner(QObject):
    """Filters the keys of a window while ``is_wanted``, and emits each scanned code.

    The letters reach the widget that has the focus as they are typed; a field gets back what it held before, once they turn out to be a
    code.
    """

    scanned = Signal(str)

    def __init__(self, is_wanted: Callable[[], bool], parent: QObject, clock: Callable[[], float] = time.monotonic) -> None:
        super().__init__(parent)
        self._is_wanted, self._clock = is_wanted, clock
        self._typed = TypedFast()
        self._before: tuple[QLineEdit, str] | None = None

    def watch(self, window: QWindow) -> None:
        """Watch the keys of a window: not those of each widget in it, through which a key passes on its way."""
        window.removeEventFilter(self)
        window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Collect letters; take the key that ends a code."""
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent) or not self._is_wanted():
            return False
        now_s, key = self._clock(), event.key()
        if key in ENDS:
            return self._end(now_s)
        separator = key in SEPARATOR_KEYS and (key == Qt.Key.Key_F8 or bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier))
        letter = GROUP_SEPARATOR if separator else event.text()
        if not letter or not (letter.isprintable() or letter == GROUP_SEPARATOR):
            return False
        self._typed.add(letter, now_s)
        if len(self._typed.text) == 1:
            focused = QApplication.focusWidget()
            self._before = (focused, focused.text()) if isinstance(focused, QLineEdit) else None
        inside = len(self._typed.text) > 1
        return letter == GROUP_SEPARATOR or (letter == " " and inside and self._before is None)  # a space would press a button

    def _end(self, now_s: float) -> bool:
        code = self._typed.end(now_s)
        if not code:
            return False
        if self._before is not None:
            self._before[0].setText(self._before[1])
        self._before = None
        self.scanned.emit(code)
        return True
