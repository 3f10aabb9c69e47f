"""Strokes that widgets which draw themselves have in common."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath
from PySide6.QtWidgets import QWidget

from ui.look.theme import Theme

LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft


def picture_painter(widget: QWidget, theme: Theme) -> QPainter:
    """Return a painter for a picture in a widget: on a sunken ground, and clipped to its rounded corners."""
    painter = QPainter(widget)
    painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
    frame = QPainterPath()
    frame.addRoundedRect(QRectF(widget.rect()), theme.sizes["corner"], theme.sizes["corner"])
    painter.setClipPath(frame)
    painter.fillRect(widget.rect(), theme.colour("sunken"))
    return painter


def set_letters(painter: QPainter, size_px: int, *, bold: bool = False) -> None:
    """Write in this size from here on."""
    font = painter.font()
    font.setPixelSize(size_px)
    font.setBold(bold)
    painter.setFont(font)


def write_elided(painter: QPainter, box: QRectF, words: str, alignment: Qt.AlignmentFlag = LEFT) -> None:
    """Write one line into a box; what does not fit ends in an ellipsis."""
    elided = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, int(box.width()))
    painter.drawText(box, alignment, elided)
