"""Legend of unmeasured areas: grey with hatching, never a colour of a scale."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.look import Look
from ui.viewport.colouring import HATCH_SHADE, UNKNOWN
from ui.widgets.basic import label, row

SWATCH = (24, 14)


class HatchedSwatch(QWidget):
    """A colour sample of unmeasured areas."""

    def __init__(self) -> None:
        super().__init__()
        self.setFixedSize(*SWATCH)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw grey with hatching."""
        grey = QColor(*(int(value) for value in UNKNOWN))
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        box = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        for brush in (QBrush(grey), QBrush(grey.darker(round(100 / HATCH_SHADE)), Qt.BrushStyle.BDiagPattern)):
            painter.setBrush(brush)
            painter.drawRoundedRect(box, 3, 3)


class NotMeasuredLegend(QWidget):
    """The colour sample with a text; hidden without text."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.words = label("", "small", wrap=True)
        self.setLayout(row(HatchedSwatch(), self.words, spacing=8))
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        look.changed.connect(self.update)
        self.say("")

    def say(self, words: str) -> None:
        """Set the text."""
        self.words.setText(words)
        self.setVisible(bool(words))
