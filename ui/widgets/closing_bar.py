"""The question whether a running job is stopped to close the window; it blocks nothing, Stop least of all."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame

from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, label, row


class ClosingBar(QFrame):
    """Asks below the header, until it is answered or the job has ended."""

    closeClicked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("card")
        self.words = label("", "strong", wrap=True)
        self.stop_and_close = Button("Stop and close", look, "stop", "primary", "Stop everything that moves, then close the window")
        self.stay = Button("Keep running", look, "", "normal", "Leave the window open")
        self.stop_and_close.clicked.connect(self.closeClicked)
        self.stay.clicked.connect(self.hide)
        layout = row(self.words, self.stay, self.stop_and_close, margin=12, spacing=8)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.hide()

    def ask(self, title: str) -> None:
        """Ask whether the job ``title`` is stopped."""
        self.words.setText(tr("{title} is still running. Closing the window stops it; everything stored so far is kept.", title=title))
        self.show()
        self.stay.setFocus()
