"""One sentence with its sign: what happened and what to do about it."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QLabel

from ui.look.look import Look
from ui.widgets.basic import label, row
from ui.widgets.job_strip import LEVEL_ICONS


class MessageLine(QFrame):
    """Stays empty until something is to be said."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look, self._level = look, "info"
        self._icon, self.words = QLabel(), label("", "body", wrap=True)
        self._icon.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout = row(self._icon, self.words, spacing=8)
        layout.setStretch(1, 1)
        self.setLayout(layout)
        look.changed.connect(self._redraw)
        self.say("")

    def say(self, text: str, hint: str = "", level: str = "info") -> None:
        """Say something; an empty text clears the line."""
        self._level = level
        self.words.setText(f"{text} {hint}".strip())
        self._redraw()

    def _redraw(self) -> None:
        self._icon.setVisible(bool(self.words.text()))
        self._icon.setPixmap(self._look.icon(*LEVEL_ICONS[self._level]).pixmap(QSize(20, 20)))
