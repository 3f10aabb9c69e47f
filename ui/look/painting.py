"""Painting helpers for custom-drawn widgets."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter

from ui.look.language.words import translated

LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft


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
