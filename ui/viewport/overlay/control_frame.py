"""Feature control frame of a geometrical tolerance (ISO 1101): symbol, width of the zone with modifiers, datums."""

from __future__ import annotations

import math
import re

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QTransform

from measureapp.data.control_frame import ControlFrame
from measureapp.data.frame_symbols import ARC_RADIUS, ARC_Y, ARCS, CIRCLES, LINES
from ui.viewport.overlay.style import OverlayStyle, use_letters

FRAME_LETTERS_PX, CELL_PX, CELL_PADDING_PX, GAP_PX = 12.0, 20.0, 5.0, 4.0
CIRCLE_PX, CIRCLED_LETTERS_PX = 14.0, 10.0
CIRCLED = {"\u24c2": "M", "\u24c1": "L"}  # ISO 2692
SYMBOL_INSET = 0.2  # of the cell's height


def frame_width(frame: ControlFrame, style: OverlayStyle) -> float:
    """Return the width of a frame."""
    return sum(_widths(frame, style))


def frame_size(frame: ControlFrame, style: OverlayStyle) -> QSizeF:
    """Return the size of a frame, with the gap below it."""
    return QSizeF(frame_width(frame, style), (CELL_PX + GAP_PX) * style.scale)


def paint_frame(painter: QPainter, frame: ControlFrame, corner: QPointF, style: OverlayStyle, colour: QColor) -> None:
    """Draw a frame with its top left corner at ``corner``."""
    left, height = corner.x(), CELL_PX * style.scale
    painter.save()
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for place, width in enumerate(_widths(frame, style)):
        cell = QRectF(left, corner.y(), width, height)
        painter.setPen(QPen(colour, style.scale))
        painter.drawRect(cell)
        if place == 0:
            inset = SYMBOL_INSET * height
            painter.setPen(QPen(colour, 1.2 * style.scale))
            painter.drawPath(symbol_path(frame.characteristic, cell.adjusted(inset, inset, -inset, -inset)))
        else:
            _paint_words(painter, frame.words()[place - 1], cell, style, colour)
        left += width
    painter.restore()


def symbol_path(characteristic: str, area: QRectF) -> QPainterPath:
    """Return the outline of a symbol; fonts have not all of them, so they are drawn."""
    path = QPainterPath()
    for x0, y0, x1, y1 in LINES.get(characteristic, ()):
        path.moveTo(x0, y0)
        path.lineTo(x1, y1)
    for radius in CIRCLES.get(characteristic, ()):
        path.addEllipse(QPointF(0.5, 0.5), radius, radius)
    if characteristic in ARCS:
        path.moveTo(0.5 - ARC_RADIUS, ARC_Y)
        path.arcTo(QRectF(0.5 - ARC_RADIUS, ARC_Y - ARC_RADIUS, 2 * ARC_RADIUS, 2 * ARC_RADIUS), 180.0, -180.0)
    return QTransform(area.width(), 0.0, 0.0, area.height(), area.left(), area.top()).map(path)


def _runs(words: str, style: OverlayStyle) -> list[tuple[str, float]]:
    """Return a text in runs, and their widths; a letter in a circle, which few fonts have, is a run of its own."""
    runs = [run for run in re.split(f"([{''.join(CIRCLED)}])", words) if run]
    return [(run, CIRCLE_PX * style.scale if run in CIRCLED else style.measure(run, FRAME_LETTERS_PX).width()) for run in runs]


def _paint_words(painter: QPainter, words: str, cell: QRectF, style: OverlayStyle, colour: QColor) -> None:
    runs = _runs(words, style)
    left = cell.center().x() - sum(width for _, width in runs) / 2
    for run, width in runs:
        area = QRectF(left, cell.top(), width, cell.height())
        if run in CIRCLED:
            painter.setPen(QPen(colour, style.scale))
            painter.drawEllipse(area.center(), width / 2, width / 2)
        use_letters(painter, style, CIRCLED_LETTERS_PX if run in CIRCLED else FRAME_LETTERS_PX)
        painter.drawText(area.adjusted(-1, 0, 1, 0), Qt.AlignmentFlag.AlignCenter, CIRCLED.get(run, run))
        left += width


def _widths(frame: ControlFrame, style: OverlayStyle) -> list[float]:
    """Return the widths of the cells; whole pixels keep the lines sharp."""
    texts = [sum(width for _, width in _runs(one, style)) + 2 * CELL_PADDING_PX * style.scale for one in frame.words()]
    return [CELL_PX * style.scale, *(float(math.ceil(max(one, CELL_PX * style.scale))) for one in texts)]
