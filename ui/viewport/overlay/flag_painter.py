"""Painter of flags: for the window and for printed pictures."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ui.viewport.overlay.control_frame import frame_size, paint_frame
from ui.viewport.overlay.flag import LETTERS_PX, PADDING, SIGN_WIDTH, Flag
from ui.viewport.overlay.flag_layout import Box, FlagPlaces, leader_end
from ui.viewport.overlay.style import OverlayStyle, use_letters

HIDDEN_OPACITY, DOT_PX = 0.35, 3.5  # of the line and dot of a hidden anchor: the box stays readable
LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft


def paint_flags(
    painter: QPainter,
    flags: Sequence[Flag],
    anchors_px: np.ndarray,
    places: FlagPlaces,
    style: OverlayStyle,
    hidden: Collection[int] = (),
    chosen: str = "",
) -> None:
    """Draw lines, dots and boxes; where the part hides the anchor, its line and dot are faint and the box has a dashed edge."""
    hidden = {index for index in hidden if flags[index].key != chosen}
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for index in places.collapsed:
        _paint_dot(painter, flags[index], anchors_px[index], style, index in hidden)
    for index, box in places.boxes.items():
        painter.setOpacity(HIDDEN_OPACITY if index in hidden else 1.0)
        _paint_leader(painter, flags[index], anchors_px[index], box, style)
        _paint_dot(painter, flags[index], anchors_px[index], style, index in hidden)
    painter.setOpacity(1.0)
    for index, box in places.boxes.items():
        _paint_box(painter, flags[index], box, style, flags[index].key == chosen, index in hidden)
    painter.restore()


def more_box(count: int, corner: QPointF, style: OverlayStyle) -> QRectF:
    """Return where `paint_more` draws."""
    size = style.measure(f"+{count}", 13, bold=True)
    return QRectF(corner.x(), corner.y(), size.width() + 16 * style.scale, size.height() + 8 * style.scale)


def paint_more(painter: QPainter, count: int, corner: QPointF, style: OverlayStyle) -> None:
    """Draw how many flags are not shown."""
    words, box = f"+{count}", more_box(count, corner, style)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(style.line, style.scale))
    painter.setBrush(style.panel)
    painter.drawRoundedRect(box, box.height() / 2, box.height() / 2)
    use_letters(painter, style, 13, bold=True)
    painter.setPen(style.text)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)
    painter.restore()


def _colour(flag: Flag, style: OverlayStyle) -> QColor:
    return style.verdicts.get(flag.verdict, style.soft)


def _paint_leader(painter: QPainter, flag: Flag, anchor: np.ndarray, box: Box, style: OverlayStyle) -> None:
    x, y = (float(value) for value in anchor)
    painter.setPen(QPen(style.surface, 3.0 * style.scale))  # a light edge, so that the line is visible on any colour
    start = QPointF(*leader_end(box, (x, y)))
    painter.drawLine(start, QPointF(x, y))
    painter.setPen(QPen(_colour(flag, style), 1.4 * style.scale))
    painter.drawLine(start, QPointF(x, y))


def _paint_dot(painter: QPainter, flag: Flag, anchor: np.ndarray, style: OverlayStyle, hidden: bool) -> None:
    painter.setOpacity(HIDDEN_OPACITY if hidden else 1.0)
    painter.setPen(QPen(style.surface, style.scale))
    painter.setBrush(_colour(flag, style))
    painter.drawEllipse(QPointF(float(anchor[0]), float(anchor[1])), DOT_PX * style.scale, DOT_PX * style.scale)


def _paint_box(painter: QPainter, flag: Flag, box: Box, style: OverlayStyle, chosen: bool, hidden: bool) -> None:
    colour, area, padding = _colour(flag, style), QRectF(*box), PADDING * style.scale
    edge = Qt.PenStyle.DashLine if hidden else Qt.PenStyle.SolidLine
    painter.setPen(QPen(colour, (3.0 if chosen else 1.6) * style.scale, edge))
    painter.setBrush(style.surface)
    painter.drawRoundedRect(area, 4 * style.scale, 4 * style.scale)
    inner = area.adjusted(padding, padding, -padding, -padding)
    if flag.sign:
        use_letters(painter, style, 14, bold=True)
        painter.setPen(colour)
        sign = QRectF(inner.right() - SIGN_WIDTH * style.scale, inner.top(), SIGN_WIDTH * style.scale, 16 * style.scale)
        painter.drawText(sign, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, flag.sign)
        inner.setRight(sign.left())
    top = inner.top()
    for place, line in enumerate(flag.lines()):
        bold = place == 0 and bool(flag.title)
        use_letters(painter, style, LETTERS_PX, bold=bold)
        painter.setPen(style.text if bold or line == flag.value else style.soft)
        height = style.measure(line, LETTERS_PX, bold=bold).height()
        words = painter.fontMetrics().elidedText(line, Qt.TextElideMode.ElideRight, int(inner.width()) + 1)
        painter.drawText(QRectF(inner.left(), top, inner.width(), height), LEFT, words)
        top += height
        if place == 0 and flag.frame is not None:
            paint_frame(painter, flag.frame, QPointF(inner.left(), top), style, style.text)
            top += frame_size(flag.frame, style).height()
