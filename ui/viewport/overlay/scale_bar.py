"""Scale bar of a parallel projection, of a round length."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from ui.look.wording import quantity
from ui.viewport.overlay.camera_view import CameraView
from ui.viewport.overlay.legend import one_two_five
from ui.viewport.overlay.style import OverlayStyle, use_letters

LONGEST_PX, BOTTOM_PX, FOOT_PX, GAP_PX = 160.0, 18.0, 5.0, 12.0


def bar_length_mm(mm_per_px: float, longest_px: float = LONGEST_PX) -> float:
    """Return the largest length of 1, 2 or 5 times a power of ten that is not longer than this on the picture.

    >>> bar_length_mm(0.5), bar_length_mm(0.02)
    (50.0, 2.0)
    """
    longest = mm_per_px * longest_px
    rounded = one_two_five(longest)
    if rounded <= longest * (1 + 1e-9):
        return rounded
    shorter = (round(rounded * part, 12) for part in (0.5, 0.4, 0.2))
    return next(length for length in shorter if one_two_five(length) == length)


def paint_scale_bar(painter: QPainter, camera: CameraView, style: OverlayStyle, free_px: float) -> None:
    """Draw the scale bar at the bottom, left of ``free_px``; in perspective there is none, because no length is true."""
    if not camera.mm_per_px:
        return
    length = bar_length_mm(camera.mm_per_px, LONGEST_PX * style.scale)
    width = length / camera.mm_per_px
    middle = min(camera.width / 2.0, free_px - width / 2 - GAP_PX * style.scale)
    bottom, foot = camera.height - BOTTOM_PX * style.scale, FOOT_PX * style.scale
    left, right = QPointF(middle - width / 2, bottom), QPointF(middle + width / 2, bottom)
    painter.save()
    for colour, thick in ((style.surface, 4.0), (style.text, 1.6)):
        painter.setPen(QPen(colour, thick * style.scale, Qt.PenStyle.SolidLine, Qt.PenCapStyle.SquareCap))
        painter.drawLine(left, right)
        for end in (left, right):
            painter.drawLine(end - QPointF(0, foot), end)
    use_letters(painter, style)
    painter.setPen(style.text)
    words = quantity(length, "mm", 0 if length >= 1 else 3 if length < 0.01 else 2 if length < 0.1 else 1)
    painter.drawText(
        QRectF(middle - 80 * style.scale, bottom - 24 * style.scale, 160 * style.scale, 18 * style.scale),
        Qt.AlignmentFlag.AlignCenter,
        words,
    )
    painter.restore()
