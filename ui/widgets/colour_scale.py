"""Colour scale: a colour bar with limits and name."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.look.painting import set_letters
from ui.look.wording import millimetres

WIDTH = 304


class ColourScale(QWidget):
    """Shows the colours between two values."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._colours = np.zeros((2, 3))
        self.low, self.high, self.name = 0.0, 1.0, ""
        self.setFixedHeight(40)
        self.setMinimumWidth(152)
        self.setMaximumWidth(WIDTH)
        kept = self.sizePolicy()
        kept.setRetainSizeWhenHidden(True)  # the row above the picture keeps its height
        self.setSizePolicy(kept)
        look.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Return the size at which numbers and name fit."""
        return QSize(WIDTH, 40)

    def show_scale(self, name: str, colours: np.ndarray, low: float, high: float) -> None:
        """Show this scale."""
        self.name, self._colours, self.low, self.high = name, colours, low, high
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bar and its numbers."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        bar = QRectF(0, 0, self.width(), 12)
        gradient = QLinearGradient(bar.topLeft(), bar.topRight())
        for place, colour in enumerate(self._colours):
            gradient.setColorAt(place / (len(self._colours) - 1), QColor(*(int(value) for value in colour)))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(gradient)
        painter.drawRoundedRect(bar, 4, 4)
        set_letters(painter, theme.sizes["small"])
        painter.setPen(theme.colour("soft"))
        below = QRectF(0, 16, self.width(), 20)
        digits = 3 if self.high < 1 else 2
        low, high = millimetres(self.low, digits), millimetres(self.high, digits)
        painter.drawText(below, Qt.AlignmentFlag.AlignLeft, low)
        painter.drawText(below, Qt.AlignmentFlag.AlignRight, high)
        metrics = painter.fontMetrics()
        room = self.width() - 2 * max(metrics.horizontalAdvance(low), metrics.horizontalAdvance(high)) - 16
        painter.drawText(below, Qt.AlignmentFlag.AlignHCenter, metrics.elidedText(self.name, Qt.TextElideMode.ElideRight, room))
