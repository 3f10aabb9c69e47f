"""A camera image with overlays: detected corners, coverage, and the wanted next position of the board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.painting import picture_painter, set_letters, write_elided

DOT_PX = 3.0
HEAT = 0.35  # opacity of covered cells


@dataclass(frozen=True, eq=False)
class Overlay:
    """Overlays of an image, in its pixels."""

    corners_px: np.ndarray | None = None  # (N, 2)
    left_out_px: np.ndarray | None = None  # (M, 2), corners rejected by the calibration
    ghost_px: np.ndarray | None = None  # (K, 2), outline of the wanted next position of the board
    coverage: np.ndarray | None = None  # (rows, columns) number of corners in each cell


class BoardPicture(QWidget):
    """Shows one image fitted to the widget, with overlays and a caption."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look, self._image, self._size = look, QImage(), QSize()
        self.overlay, self.caption, self.empty_words = Overlay(), "", ""
        self.shown: frozenset[str] = frozenset({"corners", "coverage", "ghost"})
        self.setMinimumSize(320, 200)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self.update)

    @property
    def is_empty(self) -> bool:
        """Whether there is no image."""
        return self._image.isNull()

    def show_image(self, image: QImage, size_px: tuple[int, int], overlay: Overlay, caption: str) -> None:
        """Show an image, possibly a subsampled one of an original of ``size_px`` (width, height); overlays are in original pixels."""
        self._image, self._size, self.overlay, self.caption = image, QSize(*size_px), overlay, caption
        self.update()

    def clear(self, words: str) -> None:
        """Show a text instead of an image."""
        self._image, self._size, self.overlay, self.caption, self.empty_words = QImage(), QSize(), Overlay(), "", words
        self.update()

    def show_layers(self, names: Sequence[str]) -> None:
        """Choose the overlays: ``corners``, ``coverage`` and ``ghost``."""
        self.shown = frozenset(names)
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw image, coverage, ghost and corners."""
        theme = self._look.theme
        painter = picture_painter(self, theme)
        set_letters(painter, theme.sizes["small"])
        if self.is_empty:
            painter.setPen(theme.colour("soft"))
            painter.drawText(
                self.rect().adjusted(32, 0, -32, 0), Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap, translated(self.empty_words)
            )
            return
        fitted = QSizeF(self._size).scaled(QSizeF(self.size()), Qt.AspectRatioMode.KeepAspectRatio)
        target = QRectF(QPointF(), fitted)
        target.moveCenter(QRectF(self.rect()).center())
        painter.drawImage(target, self._image)
        painter.save()
        painter.setClipRect(target)
        painter.translate(target.topLeft())
        scale = fitted.width() / max(1, self._size.width())
        if "coverage" in self.shown and self.overlay.coverage is not None:
            self._draw_coverage(painter, fitted, self.overlay.coverage)
        if "ghost" in self.shown and self.overlay.ghost_px is not None:
            self._draw_ghost(painter, self.overlay.ghost_px, scale)
        if "corners" in self.shown:
            self._draw_corners(painter, self.overlay.corners_px, scale, theme.colour("verdict_pass"))
            self._draw_corners(painter, self.overlay.left_out_px, scale, theme.colour("verdict_fail"))
        painter.restore()
        self._draw_caption(painter)

    def _draw_coverage(self, painter: QPainter, size: QSizeF, coverage: np.ndarray) -> None:
        """Tint the covered cells."""
        rows, columns = coverage.shape
        most = max(1.0, float(coverage.max()))
        painter.setPen(Qt.PenStyle.NoPen)
        for row in range(rows):
            for column in range(columns):
                if coverage[row, column] > 0:
                    shade = QColor(self._look.theme.colour("accent"))
                    shade.setAlphaF(HEAT * (0.3 + 0.7 * float(coverage[row, column]) / most))
                    painter.setBrush(shade)
                    cell = QSizeF(size.width() / columns, size.height() / rows)
                    painter.drawRect(QRectF(column * cell.width(), row * cell.height(), cell.width(), cell.height()).adjusted(1, 1, -1, -1))

    def _draw_ghost(self, painter: QPainter, outline: np.ndarray, scale: float) -> None:
        shape = QPolygonF([QPointF(float(x), float(y)) * scale for x, y in outline])
        fill = QColor(255, 255, 255, 40)
        for colour, width, style in ((QColor(0, 0, 0, 160), 5.0, Qt.PenStyle.SolidLine), (QColor("#EDAE49"), 2.5, Qt.PenStyle.DashLine)):
            painter.setPen(QPen(colour, width, style))
            painter.setBrush(fill)
            painter.drawPolygon(shape)
            fill = QColor(0, 0, 0, 0)

    def _draw_corners(self, painter: QPainter, corners: np.ndarray | None, scale: float, colour: QColor) -> None:
        if corners is None:
            return
        painter.setPen(QPen(QColor(0, 0, 0, 150), 1.0))
        painter.setBrush(colour)
        for x, y in corners:
            painter.drawEllipse(QPointF((float(x) + 0.5) * scale, (float(y) + 0.5) * scale), DOT_PX, DOT_PX)

    def _draw_caption(self, painter: QPainter) -> None:
        if not self.caption:
            return
        strip = QRectF(0, self.height() - 28, self.width(), 28)
        painter.fillRect(strip, QColor(0, 0, 0, 190))
        painter.setPen(Qt.GlobalColor.white)
        write_elided(painter, strip.adjusted(12, 0, -12, 0), self.caption)
