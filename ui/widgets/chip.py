"""A small rounded status indicator with icon and text."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel

from ui.look.look import Look


class Chip(QFrame):
    """Shows one state by text and icon colour."""

    def __init__(self, look: Look, icon: str, text: str = "") -> None:
        super().__init__()
        self.setObjectName("chip")
        self.setFixedHeight(32)
        self._look, self._icon_name, self._colour = look, icon, "soft"
        self._icon, self._text = QLabel(), QLabel(text)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 0, 12, 0)
        layout.setSpacing(8)
        layout.addWidget(self._icon)
        layout.addWidget(self._text)
        look.changed.connect(self._redraw)
        self._redraw()

    def text(self) -> str:
        """Return the text."""
        return self._text.text()

    def show_state(self, text: str, colour: str = "soft", tip: str = "") -> None:
        """Set text, icon colour and tooltip."""
        self._text.setText(text)
        self._colour = colour
        self.setToolTip(tip)
        self._redraw()

    def _redraw(self) -> None:
        self._icon.setPixmap(self._look.icon(self._icon_name, self._colour).pixmap(QSize(18, 18)))
