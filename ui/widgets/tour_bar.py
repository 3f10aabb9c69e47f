"""The bar of the tour: what the page is for, and on to the next one; it covers nothing."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row

LINES = 2  # of text in the smallest window


class TourBar(QFrame):
    """One step of a tour, between the page and the strip below."""

    nextClicked = Signal()
    backClicked = Signal()
    endClicked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("tour")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.count, self.heading, self.words = label("", "caption"), label("", "heading"), label("", wrap=True)
        self.words.setMinimumHeight(LINES * self.words.fontMetrics().lineSpacing())
        self.end, self.back = Button("End the tour", look, "", "quiet"), Button("Back", look, "", "normal")
        self.next = Button("", look, "", "primary")
        self.end.clicked.connect(self.endClicked)
        self.back.clicked.connect(self.backClicked)
        self.next.clicked.connect(self.nextClicked)
        title = row(self.heading, 8, self.count, 0, spacing=0)
        layout = row(column(title, self.words, spacing=4), 16, self.end, self.back, self.next, spacing=8)
        layout.setContentsMargins(24, 12, 24, 12)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.hide()

    def say(self, count: str, heading: str, words: str, *, next_words: str, can_go_back: bool, last: bool) -> None:
        """Show one step."""
        self.count.setText(translated(count))
        self.heading.setText(translated(heading))
        self.words.setText(translated(words))
        self.next.setText(translated(next_words))
        self.next.setAccessibleName(translated(next_words))
        self.back.setVisible(can_go_back)
        self.end.setText(tr("End the tour") if count else tr("Not now"))
        self.end.setVisible(not last)
        self.show()
        self.next.setFocus()
