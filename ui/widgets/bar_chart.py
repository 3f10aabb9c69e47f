"""Horizontal bar chart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.look import Look
from ui.look.wording import millimetres

LINE, USUAL_LINE, TALLEST_LINE, BAR, NAME_WIDTH, VALUE_WIDTH = 20, 26, 48, 12, 264, 96


@dataclass(frozen=True)
class Bar:
    """One bar, in mm."""

    name: str
    value_mm: float
    strong: bool = False


class BarChart(QWidget):
    """A bar chart of lengths."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.bars: tuple[Bar, ...] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self.update)

    def show_bars(self, bars: Sequence[Bar]) -> None:
        """Show these bars."""
        self.bars = tuple(bars)
        self.setMinimumHeight(LINE * len(self.bars))
        self.setMaximumHeight(TALLEST_LINE * len(self.bars))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bars to a common scale."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        longest = max((bar.value_mm for bar in self.bars), default=0.0) or 1.0
        room = max(40, self.width() - NAME_WIDTH - VALUE_WIDTH)
        line = self.height() / max(1, len(self.bars))
        thickness = BAR * line / USUAL_LINE
        for place, bar in enumerate(self.bars):
            top = place * line
            font = painter.font()
            font.setBold(bar.strong)
            painter.setFont(font)
            painter.setPen(theme.colour("text" if bar.strong else "soft"))
            painter.drawText(QRectF(0, top, NAME_WIDTH - 16, line), Qt.AlignmentFlag.AlignVCenter, bar.name)
            length = room * bar.value_mm / longest
            painter.setPen(theme.colour("text"))
            painter.drawText(
                QRectF(NAME_WIDTH + length + 8, top, VALUE_WIDTH, line), Qt.AlignmentFlag.AlignVCenter, millimetres(bar.value_mm)
            )
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme.colour("accent" if bar.strong else "faint"))
            painter.drawRoundedRect(QRectF(NAME_WIDTH, top + (line - thickness) / 2, max(2.0, length), thickness), 3, 3)
