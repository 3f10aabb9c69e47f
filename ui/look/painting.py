"""Painting helpers for custom-drawn widgets."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath
from PySide6.QtWidgets import QWidget

from ui.look.language.words import translated
from ui.look.theme import Theme

LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft


def picture_painter(widget: QWidget, theme: Theme) -> QPainter:
    """Return a painter for a picture in a widget: with a sunken background, clipped to rounded corners."""
    painter = QPainter(widget)
    painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
    frame = QPainterPath()
    frame.addRoundedRect(QRectF(widget.rect()), theme.sizes["corner"], theme.sizes["corner"])
    painter.setClipPath(frame)
    painter.fillRect(widget.rect(), theme.colour("sunken"))
    return painter


def set_letters(painter: QPainter, size_px: int, *, bold: bool = False) -> None:
    """Set the font size of subsequent text."""
    font = painter.font()
    font.setPixelSize(size_px)
    font.setBold(bold)
    painter.setFont(font)


def write_elided(painter: QPainter, box: QRectF, words: str, alignment: Qt.AlignmentFlag = LEFT) -> None:
    """Draw one line of text in a box, elided if too long."""
    elided = painter.fontMetrics().elidedText(translated(words), Qt.TextElideMode.ElideRight, int(box.width()))
    painter.drawText(box, alignment, elided)
