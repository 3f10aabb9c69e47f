"""Axes of the part's frame in the lower left corner."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.style import OverlayStyle, use_letters

LENGTH_PX, CORNER_PX, LETTER_PX = 34.0, 52.0, 11.0
AXES = (("x", QColor(200, 60, 70)), ("y", QColor(60, 150, 70)), ("z", QColor(60, 110, 200)))


def paint_triad(painter: QPainter, camera: CameraView, style: OverlayStyle, frame: str = "") -> None:
    """Draw the axes with their letters, the nearest one last; ``frame``: name of the frame, beside them."""
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    origin = QPointF(CORNER_PX * style.scale, camera.height - CORNER_PX * style.scale)
    use_letters(painter, style, LETTER_PX, bold=True)
    directions = camera.rotation @ np.eye(3)  # columns: the axes as right, up, towards the viewer
    for place in np.argsort(directions[2]):
        letter, colour = AXES[place]
        right, up = (float(value) * LENGTH_PX * style.scale for value in directions[:2, place])
        end = origin + QPointF(right, -up)
        painter.setPen(QPen(colour, 2.2 * style.scale, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        painter.drawLine(origin, end)
        away = QPointF(right, -up) * (1.0 + LETTER_PX * style.scale / max(np.hypot(right, up), 12.0 * style.scale))
        box = QRectF(0, 0, 16 * style.scale, 16 * style.scale)
        box.moveCenter(origin + away)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, letter)
    if frame:
        use_letters(painter, style, LETTER_PX)
        painter.setPen(style.soft)
        painter.drawText(QPointF(8 * style.scale, camera.height - 8 * style.scale), frame)
    painter.restore()
