"""A question within a window, so that nothing else is blocked while it waits for its answer."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QHBoxLayout, QPushButton, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.widgets.basic import Button, card, column, label


class QuestionBar(QWidget):
    """Asks one question at a time; a new one replaces the one before, which counts as not answered."""

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._look = look
        self.words = label("", "body", wrap=True)
        self.buttons: dict[str, QPushButton] = {}
        self._answers = QHBoxLayout()
        self._answers.setSpacing(8)
        self.setLayout(column(card(self.words, self._answers)))
        self.hide()

    def ask(self, words: str, answers: Mapping[str, Callable[[], object]], back: str = "Cancel") -> None:
        """Show a question with its answers, each by what it does; ``back`` leaves everything as it is."""
        self.withdraw()
        self.words.setText(translated(words))
        self._answers.addStretch(1)
        for text, act in (*answers.items(), (back, lambda: None)):
            button = Button(text, self._look)
            button.clicked.connect(self.withdraw)
            button.clicked.connect(act)
            self.buttons[text] = button
            self._answers.addWidget(button)
        self.show()
        self.buttons[back].setFocus()

    @Slot()
    def withdraw(self) -> None:
        """Take the question away without an answer."""
        self.hide()
        self.buttons = {}
        while self._answers.count():
            item = self._answers.takeAt(0)
            if item.widget() is not None:
                item.widget().deleteLater()
