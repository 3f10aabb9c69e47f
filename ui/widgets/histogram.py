"""Histogram of deviations on the scale of their legend, in its colours."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.look import Look
from ui.look.painting import set_letters
from ui.look.wording import millimetres
from ui.viewport.overlay.legend import Legend

BINS = 48
SCALE_HEIGHT, NUMBERS_HEIGHT = 12, 20
TICKS, TICK_GAP = 5, 12


class Histogram(QWidget):
    """Bars over the range of a legend, with its colours below and its tolerance band marked."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self._legend: Legend | None = None
        self._colours = np.zeros((BINS, 3), np.uint8)
        self.counts = np.zeros(BINS, int)
        self.setMinimumSize(240, 104)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self.update)

    def show_values(self, values_mm: np.ndarray, legend: Legend) -> None:
        """Show values (N,) on the range of a legend; those beyond it are counted in the outermost bars."""
        self._legend = legend
        edges = np.linspace(legend.low, legend.high, BINS + 1)
        self._colours = legend.colours((edges[1:] + edges[:-1]) / 2)
        self.counts, _ = np.histogram(np.clip(values_mm, legend.low, legend.high), edges)
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the bars, the scale and its numbers."""
        if self._legend is None or not self.counts.any():
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        base = self.height() - SCALE_HEIGHT - NUMBERS_HEIGHT - 4.0
        step = self.width() / BINS
        for place, count in enumerate(self.counts):
            height = (base - 4) * count / self.counts.max()
            self._bar(painter, QRectF(place * step, base - height, step - 1, height), place)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._colour(place))
            painter.drawRect(QRectF(place * step, base + 4, step + 0.5, SCALE_HEIGHT))
        painter.setPen(self._look.theme.colour("line"))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(0.5, base + 4.5, self.width() - 1, SCALE_HEIGHT - 1))
        self._marks(painter, base, self._legend)
        self._numbers(painter, self._legend)

    def _colour(self, place: int) -> QColor:
        return QColor(*(int(value) for value in self._colours[place]))

    def _marks(self, painter: QPainter, base: float, legend: Legend) -> None:
        painter.setPen(QPen(self._look.theme.colour("text"), 1.5, Qt.PenStyle.DashLine))
        for limit in legend.tolerance or ():
            if legend.low < limit < legend.high:
                x = self.width() * (limit - legend.low) / legend.span
                painter.drawLine(QPointF(x, 2), QPointF(x, base + 4 + SCALE_HEIGHT))

    def _bar(self, painter: QPainter, box: QRectF, place: int) -> None:
        if box.height() <= 0:
            return
        painter.setPen(self._look.theme.colour("faint"))
        painter.setBrush(self._colour(place))
        painter.drawRect(box)

    def _numbers(self, painter: QPainter, legend: Legend) -> None:
        theme = self._look.theme
        set_letters(painter, theme.sizes["small"])
        painter.setPen(theme.colour("soft"))
        top = float(self.height() - NUMBERS_HEIGHT)
        widest = painter.fontMetrics().horizontalAdvance(millimetres(-max(abs(legend.low), abs(legend.high)), 3)) + TICK_GAP
        step = 1 if TICKS * widest <= self.width() else TICKS // 2  # in a narrow widget only the ends and the centre
        for tick in range(0, TICKS, step):
            share = tick / (TICKS - 1)
            words = millimetres(legend.low + share * legend.span, 3, signed=True)
            width = painter.fontMetrics().horizontalAdvance(words) + 2.0
            left = min(max(0.0, share * self.width() - width / 2), self.width() - width)
            painter.drawText(QRectF(QPointF(left, top), QPointF(left + width, top + NUMBERS_HEIGHT)), Qt.AlignmentFlag.AlignCenter, words)
