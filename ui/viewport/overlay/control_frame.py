"""Feature control frame of a geometrical tolerance (ISO 1101): symbol, width of the zone with modifiers, datums."""

from __future__ import annotations

import math
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen, QTransform

from ui.viewport.overlay.style import OverlayStyle, use_letters

FRAME_LETTERS_PX, CELL_PX, CELL_PADDING_PX, GAP_PX = 12.0, 20.0, 5.0, 4.0
SYMBOL_INSET = 0.22  # of the cell's height
Segment = tuple[float, float, float, float]
LINES: dict[str, tuple[Segment, ...]] = {  # in a unit square, y downwards
    "straightness": ((0.0, 0.5, 1.0, 0.5),),
    "flatness": ((0.3, 0.2, 1.0, 0.2), (1.0, 0.2, 0.7, 0.8), (0.7, 0.8, 0.0, 0.8), (0.0, 0.8, 0.3, 0.2)),
    "cylindricity": ((0.0, 0.95, 0.25, 0.05), (0.75, 0.95, 1.0, 0.05)),
    "parallelism": ((0.1, 1.0, 0.5, 0.0), (0.5, 1.0, 0.9, 0.0)),
    "perpendicularity": ((0.5, 0.0, 0.5, 1.0), (0.0, 1.0, 1.0, 1.0)),
    "angularity": ((1.0, 0.1, 0.0, 1.0), (0.0, 1.0, 1.0, 1.0)),
    "position": ((0.5, 0.0, 0.5, 1.0), (0.0, 0.5, 1.0, 0.5)),
    "circular_runout": ((0.15, 1.0, 0.85, 0.0), (0.85, 0.0, 0.47, 0.2), (0.85, 0.0, 0.8, 0.42)),
    "total_runout": (
        *((0.0, 1.0, 0.45, 0.1), (0.45, 0.1, 0.18, 0.3), (0.45, 0.1, 0.46, 0.48)),
        *((0.5, 1.0, 0.95, 0.1), (0.95, 0.1, 0.68, 0.3), (0.95, 0.1, 0.96, 0.48), (0.0, 1.0, 0.5, 1.0)),
    ),
    "surface_profile": ((0.0, 0.75, 1.0, 0.75),),
}
CIRCLES: dict[str, tuple[float, ...]] = {  # radii
    "roundness": (0.45,),
    "cylindricity": (0.3,),
    "position": (0.34,),
    "concentricity": (0.48, 0.24),
    "coaxiality": (0.48, 0.24),
}
ARCS = ("line_profile", "surface_profile")
CHARACTERISTICS = frozenset(LINES) | frozenset(CIRCLES) | frozenset(ARCS)


@dataclass(frozen=True)
class ControlFrame:
    """What the cells of a frame state; ``characteristic`` is one of `CHARACTERISTICS`."""

    characteristic: str
    width: float  # of the zone, in mm
    zone: str  # width with its modifiers, such as "Ø 0.100 Ⓜ"
    datums: tuple[str, ...] = ()  # letters with their modifiers, in their order

    def words(self) -> tuple[str, ...]:
        """Return the texts of the cells behind the symbol."""
        return (self.zone, *self.datums)


def frame_size(frame: ControlFrame, style: OverlayStyle) -> QSizeF:
    """Return the size of a frame, with the gap below it."""
    return QSizeF(sum(_widths(frame, style)), (CELL_PX + GAP_PX) * style.scale)


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
            painter.setPen(QPen(colour, 1.4 * style.scale))
            painter.drawPath(symbol_path(frame.characteristic, cell.adjusted(inset, inset, -inset, -inset)))
        else:
            use_letters(painter, style, FRAME_LETTERS_PX)
            painter.drawText(cell, Qt.AlignmentFlag.AlignCenter, frame.words()[place - 1])
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
        path.moveTo(0.0, 0.75)
        path.arcTo(QRectF(0.0, 0.25, 1.0, 1.0), 180.0, -180.0)
    return QTransform(area.width(), 0.0, 0.0, area.height(), area.left(), area.top()).map(path)


def _widths(frame: ControlFrame, style: OverlayStyle) -> list[float]:
    """Return the widths of the cells; whole pixels keep the lines sharp."""
    texts = [style.measure(one, FRAME_LETTERS_PX).width() + 2 * CELL_PADDING_PX * style.scale for one in frame.words()]
    return [CELL_PX * style.scale, *(float(math.ceil(max(one, CELL_PX * style.scale))) for one in texts)]
