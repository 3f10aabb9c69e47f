"""Histogram of deviations in the colours of their scale."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.look import Look
from ui.look.painting import set_letters
from ui.look.wording import millimetres

BINS = 48
SCALE_HEIGHT, NUMBERS_HEIGHT = 12, 20
TICKS, TICK_GAP = 5, 12


class Histogram(QWidget):
    """A histogram over a symmetric scale, with the colour scale below as the legend of the picture."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._colours = np.zeros((2, 3))
        self.counts = np.zeros(BINS, int)
        self.end_mm = self.limit_mm = 0.0
        self.setMinimumSize(240, 104)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self.update)

    def show_values(self, values_mm: np.ndarray, colours: np.ndarray, end_mm: float) -> None:
        """Show these values from −end to +end; values beyond are counted in the outermost bars."""
        self._colours, self.end_mm = colours, end_mm
        self.counts, _ = np.histogram(np.clip(values_mm, -end_mm, end_mm), BINS, (-end_mm, end_mm))
        self.update()

    def mark(self, limit_mm: float) -> None:
        """Mark a symmetric tolerance, if it is on the scale."""
        self.limit_mm = limit_mm
        self.update()

    def colour_at(self, share: float) -> QColor:
        """Return the colour at a position (0…1) of the scale."""
        supports = np.linspace(0.0, 1.0, len(self._colours))
        return QColor(*(int(np.interp(share, supports, self._colours[:, channel])) for channel in range(3)))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bars, the scale and its numbers."""
        if not self.counts.any():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        base = self.height() - SCALE_HEIGHT - NUMBERS_HEIGHT - 4.0
        step = self.width() / BINS
        for place, count in enumerate(self.counts):
            height = (base - 4) * count / self.counts.max()
            self._bar(painter, QRectF(place * step, base - height, step - 1, height), place)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self.colour_at((place + 0.5) / BINS))
            painter.drawRect(QRectF(place * step, base + 4, step + 0.5, SCALE_HEIGHT))
        painter.setPen(self._look.theme.colour("line"))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(0.5, base + 4.5, self.width() - 1, SCALE_HEIGHT - 1))
        self._marks(painter, base)
        self._numbers(painter)

    def _marks(self, painter: QPainter, base: float) -> None:
        if not 0 < self.limit_mm < self.end_mm:
            return
        painter.setPen(QPen(self._look.theme.colour("text"), 1.5, Qt.PenStyle.DashLine))
        for side in (-1, 1):
            x = self.width() * (1 + side * self.limit_mm / self.end_mm) / 2
            painter.drawLine(QPointF(x, 2), QPointF(x, base + 4 + SCALE_HEIGHT))

    def _bar(self, painter: QPainter, box: QRectF, place: int) -> None:
        if box.height() <= 0:
            return
        painter.setPen(self._look.theme.colour("faint"))
        painter.setBrush(self.colour_at((place + 0.5) / BINS))
        painter.drawRect(box)

    def _numbers(self, painter: QPainter) -> None:
        theme = self._look.theme
        set_letters(painter, theme.sizes["small"])
        painter.setPen(theme.colour("soft"))
        top = float(self.height() - NUMBERS_HEIGHT)
        widest = painter.fontMetrics().horizontalAdvance(millimetres(-self.end_mm, 3)) + TICK_GAP
        step = 1 if TICKS * widest <= self.width() else TICKS // 2  # in a narrow widget only the ends and the centre
        for tick in range(0, TICKS, step):
            share = tick / (TICKS - 1)
            words = millimetres(self.end_mm * (2 * share - 1), 3, signed=True)
            width = painter.fontMetrics().horizontalAdvance(words) + 2.0
            left = min(max(0.0, share * self.width() - width / 2), self.width() - width)
            painter.drawText(QRectF(QPointF(left, top), QPointF(left + width, top + NUMBERS_HEIGHT)), Qt.AlignmentFlag.AlignCenter, words)
