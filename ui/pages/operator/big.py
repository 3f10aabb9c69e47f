"""Large buttons and labels for touch: a second press within half a second is ignored, and some presses must be held."""

from __future__ import annotations

from typing import Literal

from PySide6.QtCore import QElapsedTimer, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QFrame, QLabel, QLayout, QPushButton, QSizePolicy, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import ElidedLabel, column

SECOND_PRESS_MS = 500
HOLD_MS = 1000
TICK_MS = 33
ICON_PX = 28
BigRole = Literal["normal", "primary", "stop", "quiet", "key", "card"]
BigText = Literal["body", "soft", "strong", "heading", "title", "step", "value", "error", "count"]


def big_label(text: str = "", role: BigText = "body", *, wrap: bool = False) -> QLabel:
    """Return a label in one of the sizes of operator mode."""
    made = QLabel(translated(text))
    made.setProperty("op", role)
    made.setWordWrap(wrap)
    made.setTextFormat(Qt.TextFormat.PlainText)
    if wrap:
        made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
    return made


def short_label(text: str = "", role: BigText = "body") -> ElidedLabel:
    """Return a label of one line, elided where it is longer than there is room."""
    made = ElidedLabel("")
    made.setProperty("op", role)
    made.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
    made.set_words(text)
    return made


def big_card(*parts: QWidget | QLayout | int, margin: int = 24, spacing: int = 16, name: str = "operator-card") -> QFrame:
    """Return a framed panel with its parts in a column."""
    frame = QFrame()
    frame.setObjectName(name)
    frame.setLayout(column(*parts, margin=margin, spacing=spacing))
    return frame


class BigButton(QPushButton):
    """A button of at least 48 px that is pressed once where it is pressed twice by mistake."""

    pressedOnce = Signal()

    def __init__(self, text: str, look: Look, icon: str = "", role: BigRole = "normal") -> None:
        super().__init__(translated(text))
        self._look, self._icon, self._role = look, icon, role
        self._since = QElapsedTimer()
        self.setProperty("op", role)
        self.setAccessibleName(translated(text))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAutoDefault(True)  # Enter presses the button that has the focus
        self.setIconSize(QSize(ICON_PX, ICON_PX))
        self.clicked.connect(self._pass_on)
        look.changed.connect(self._redraw)
        self._redraw()

    def _pass_on(self) -> None:
        if self._since.isValid() and self._since.elapsed() < SECOND_PRESS_MS:
            return
        self._since.start()
        self.pressedOnce.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press by Enter too, once however long it is held."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if not event.isAutoRepeat():
                self.click()
            return
        super().keyPressEvent(event)

    def _redraw(self) -> None:
        if self._icon:
            colour = "accent_on" if self._role in ("primary", "stop") else "soft"
            self.setIcon(self._look.icon(self._icon, colour))


class HoldButton(BigButton):
    """A button that acts after it was held for a second; the share held so far fills it."""

    held = Signal()

    def __init__(self, text: str, look: Look, icon: str = "") -> None:
        super().__init__(text, look, icon, "normal")
        self._held = QElapsedTimer()
        self._tick = QTimer(self)
        self._tick.setInterval(TICK_MS)
        self._tick.timeout.connect(self._grow)
        self.done = False
        self.pressed.connect(self._begin)
        self.released.connect(self._end)

    @property
    def share(self) -> float:
        """Share of the time for which it must be held."""
        return min(1.0, self._held.elapsed() / HOLD_MS) if self._held.isValid() else 0.0

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Hold by the space bar or Enter."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            if not event.isAutoRepeat():
                self.setDown(True)
                self._begin()
            return
        super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """End the hold."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            if not event.isAutoRepeat():
                self.setDown(False)
                self._end()
            return
        super().keyReleaseEvent(event)

    def restore(self) -> None:
        """Wait to be held again."""
        self._end()
        self.done = False
        self.update()

    def _begin(self) -> None:
        self._held.start()
        self._tick.start()

    def _end(self) -> None:
        self._tick.stop()
        self._held.invalidate()
        self.update()

    def _grow(self) -> None:
        self.update()
        if self.share >= 1.0:
            self._tick.stop()
            self._held.invalidate()
            self.done = True
            self.held.emit()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the share that was held along the lower edge."""
        super().paintEvent(event)
        share = 1.0 if self.done else self.share
        if share > 0:
            painter = QPainter(self)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(self._look.theme.colour("verdict_pass" if self.done else "accent")))
            painter.drawRect(QRectF(8, self.height() - 10, (self.width() - 16) * share, 6))
            painter.end()
