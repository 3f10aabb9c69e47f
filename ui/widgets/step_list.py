"""The steps of a wizard, one under the other, each with its state."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.look import Look
from ui.look.painting import set_letters, write_elided

StepState = Literal["waiting", "now", "done", "problem"]
WIDTH, LINE, DOT = 184, 72, 28
WORDS: dict[StepState, str] = {"waiting": "Waiting", "now": "Now", "done": "Done", "problem": "Look here"}


@dataclass(frozen=True)
class Step:
    """One step: what it is called, how far it is, and a few words about that."""

    name: str
    state: StepState = "waiting"
    note: str = ""


class StepList(QWidget):
    """Draws the steps; a click on a step that was reached, or an arrow key, requests it."""

    stepClicked = Signal(int)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.steps: tuple[Step, ...] = ()
        self.current = 0
        self._by_keys = False  # whether the focus came by the keyboard
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setFixedWidth(WIDTH)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Expanding)
        look.changed.connect(self.update)

    def show_steps(self, steps: Sequence[Step], current: int) -> None:
        """Draw these steps; ``current`` is the one shown."""
        self.steps, self.current = tuple(steps), current
        self.update()

    def words(self) -> list[str]:
        """Return the note or state of every step."""
        return [step.note or WORDS[step.state] for step in self.steps]

    def sizeHint(self) -> QSize:
        """Return the room all steps need."""
        return QSize(WIDTH, LINE * max(1, len(self.steps)))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Ask for the step under the mouse."""
        self._ask_for(int(event.position().y() // LINE))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Ask for the step before or after."""
        step = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(Qt.Key(event.key()))
        if step is None:
            super().keyPressEvent(event)
        else:
            self._ask_for(self.current + step)

    def _ask_for(self, place: int) -> None:
        if 0 <= place < len(self.steps) and self.steps[place].state != "waiting":
            self.stepClicked.emit(place)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the focus to those who work by keyboard."""
        self._by_keys = event.reason() in (Qt.FocusReason.TabFocusReason, Qt.FocusReason.BacktabFocusReason)
        super().focusInEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw every step with its number or its sign, joined by a line."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for place, step in enumerate(self.steps):
            top = place * LINE
            if place == self.current:
                marked = self.hasFocus() and self._by_keys
                painter.setPen(QPen(theme.colour("accent"), 2) if marked else Qt.PenStyle.NoPen)
                painter.setBrush(theme.colour("accent_soft"))
                painter.drawRoundedRect(QRectF(1, top + 5, self.width() - 2, LINE - 10), 6, 6)
            if place + 1 < len(self.steps):
                painter.setPen(theme.colour("line"))
                painter.drawLine(8 + DOT // 2, top + LINE // 2 + DOT // 2 + 4, 8 + DOT // 2, top + LINE + LINE // 2 - DOT // 2 - 4)
            self._draw_sign(painter, QRectF(8, top + (LINE - DOT) / 2, DOT, DOT), place, step)
            self._write(painter, QRectF(48, top + 14, self.width() - 56, 22), step.name, "text", theme.sizes["body"], bold=True)
            self._write(painter, QRectF(48, top + 36, self.width() - 56, 20), step.note or WORDS[step.state], "soft", theme.sizes["small"])

    def _draw_sign(self, painter: QPainter, box: QRectF, place: int, step: Step) -> None:
        theme = self._look.theme
        filled = {"done": "verdict_pass", "now": "accent", "problem": "verdict_not_proven"}.get(step.state)
        painter.setPen(theme.colour(filled or "faint"))
        painter.setBrush(theme.colour(filled) if filled else QColor(0, 0, 0, 0))
        painter.drawEllipse(box.adjusted(1, 1, -1, -1))
        if step.state in ("done", "problem"):
            sign = box.adjusted(6, 6, -6, -6).toRect()
            self._look.icon("pass" if step.state == "done" else "not proven", "accent_on").paint(painter, sign)
            return
        set_letters(painter, theme.sizes["small"], bold=True)
        painter.setPen(theme.colour("accent_on" if filled else "soft"))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(place + 1))

    def _write(self, painter: QPainter, box: QRectF, words: str, colour: str, size: int, *, bold: bool = False) -> None:
        set_letters(painter, size, bold=bold)
        painter.setPen(self._look.theme.colour(colour))
        write_elided(painter, box, words)
