"""Gauges of quantities relative to their required values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.painting import set_letters

LINE, BAR = 36, 6


@dataclass(frozen=True)
class Level:
    """One gauge: name, fraction of the required value (1: sufficient), and the figure as text ("12 of 15")."""

    name: str
    share: float
    figure: str

    @property
    def enough(self) -> bool:
        """Whether the required value is reached."""
        return self.share >= 1.0


class Gauges(QWidget):
    """Draws gauges in a column; colour and icon mark those that are sufficient."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.levels: tuple[Level, ...] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        look.changed.connect(self.update)

    def show_levels(self, levels: Sequence[Level]) -> None:
        """Show these gauges."""
        self.levels = tuple(levels)
        self.setFixedHeight(LINE * len(self.levels))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw name, figure, bar and icon of every gauge."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        set_letters(painter, theme.sizes["small"])
        for place, level in enumerate(self.levels):
            top, right = place * LINE, self.width() - 28
            painter.setPen(theme.colour("text"))
            words = QRectF(0, top + 2, right, 18)
            painter.drawText(words, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, translated(level.name))
            painter.setPen(theme.colour("soft"))
            painter.drawText(words, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, level.figure)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.colour("sunken"))
            bar = QRectF(0, top + 22, right, BAR)
            painter.drawRoundedRect(bar, BAR / 2, BAR / 2)
            painter.setBrush(theme.colour("verdict_pass" if level.enough else "verdict_not_proven"))
            filled = max(BAR, right * min(1.0, level.share)) if level.share > 0 else 0.0
            painter.drawRoundedRect(QRectF(0, top + 22, filled, BAR), BAR / 2, BAR / 2)
            if level.enough:
                self._look.icon("pass", "verdict_pass").paint(painter, QRectF(right + 6, top + 15, 20, 20).toRect())
