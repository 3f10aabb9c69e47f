"""Pens and fills in the colours of the theme."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QPolygonF

from ui.look.theme import Theme

CHEVRONS = {"down": ((-4, -2), (0, 2), (4, -2)), "up": ((-4, 2), (0, -2), (4, 2)), "right": ((-2, -4), (2, 0), (-2, 4))}


class Ink:
    """The colours of one theme, each made once, and the few shapes that all controls consist of."""

    def __init__(self, theme: Theme) -> None:
        self.theme = theme
        self.corner = float(theme.sizes["corner"])
        self._colours = {name: QColor(value) for name, value in theme.colours.items()}

    def colour(self, token: str) -> QColor:
        """Return a colour by its token."""
        return self._colours[token]

    def box(self, painter: QPainter, rect: QRect | QRectF, fill: str, border: str, radius: float | None = None, width: float = 1.0) -> None:
        """Draw a rounded box; colours by token, empty: none."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        half = width / 2
        inner = QRectF(rect).adjusted(half, half, -half, -half) if border else QRectF(rect)
        painter.setPen(QPen(self._colours[border], width) if border else Qt.PenStyle.NoPen)
        painter.setBrush(self._colours[fill] if fill else Qt.BrushStyle.NoBrush)
        size = self.corner if radius is None else radius
        painter.drawRoundedRect(inner, size, size)
        painter.restore()

    def shape(self, painter: QPainter, path: QPainterPath, fill: str, border: str) -> None:
        """Draw any outline; colours by token, empty: none."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._colours[border], 1.0) if border else Qt.PenStyle.NoPen)
        painter.setBrush(self._colours[fill] if fill else Qt.BrushStyle.NoBrush)
        painter.drawPath(path)
        painter.restore()

    def chevron(self, painter: QPainter, rect: QRect, direction: str, token: str = "soft") -> None:
        """Draw a small arrow in the middle of ``rect``."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        pen = QPen(self._colours[token], 1.3)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        middle = QRectF(rect).center()
        painter.drawPolyline(QPolygonF([middle + QPointF(x, y) for x, y in CHEVRONS[direction]]))
        painter.restore()

    def check(self, painter: QPainter, rect: QRect, token: str = "accent_on") -> None:
        """Draw a check mark in the middle of ``rect``."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        pen = QPen(self._colours[token], 2.0)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        middle = QRectF(rect).center()
        painter.drawPolyline(QPolygonF([middle + QPointF(x, y) for x, y in ((-4, 0), (-1, 3), (4, -3))]))
        painter.restore()


def rounded_on(rect: QRectF, radius: float, *, left: bool, right: bool) -> QPainterPath:
    """Return a box that is rounded on some sides only."""
    whole, square = QPainterPath(), QPainterPath()
    whole.addRoundedRect(rect, radius, radius)
    half = rect.width() / 2
    if not left:
        square.addRect(QRectF(rect.left(), rect.top(), half, rect.height()))
    if not right:
        square.addRect(QRectF(rect.left() + half, rect.top(), half, rect.height()))
    return whole.united(square).simplified()
