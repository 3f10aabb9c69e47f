"""Empty state of a page: an icon, a sentence and one button."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QLabel, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row


class EmptyState(QWidget):
    """States what is missing and offers an action."""

    triggered = Signal()

    def __init__(self, look: Look, icon: str, heading: str, text: str, action: str, action_icon: str = "run") -> None:
        super().__init__()
        self._look, self._icon_name = look, icon
        self._icon = QLabel(alignment=Qt.AlignmentFlag.AlignCenter)
        self.heading = label(heading, "heading")
        self.heading.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.text = label(text, "soft", wrap=True)
        self.text.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.text.setFixedWidth(480)
        self.button = Button(action, look, action_icon, "primary")
        self.button.clicked.connect(self.triggered)
        self._buttons = row(0, self.button, 0)
        self.setLayout(column(0, self._icon, 8, self.heading, row(0, self.text, 0), 16, self._buttons, 0))
        look.changed.connect(self._redraw)
        self._redraw()

    def add_quiet(self, button: Button) -> None:
        """Add a secondary action."""
        self._buttons.insertWidget(2, button)

    def say(self, heading: str, text: str, *, offer: bool = True) -> None:
        """Change the text; ``offer`` shows the button."""
        self.heading.setText(translated(heading))
        self.text.setText(translated(text))
        self.button.setVisible(offer)

    def _redraw(self) -> None:
        self._icon.setPixmap(self._look.icon(self._icon_name, "faint").pixmap(QSize(64, 64)))
