"""The footer of a wizard: the last message, the running task, and the buttons."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QLabel, QProgressBar, QPushButton, QWidget

from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.wording import sentence_case, with_hint
from ui.widgets.basic import Button, column, label, row
from ui.widgets.job_strip import LEVEL_ICONS

WAITING = "Evaluating the result…"


class MessageLine(QFrame):
    """One message with its icon: what happened and what to do about it; empty at first."""

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
        self.show_message("")

    def show_message(self, text: str, hint: str = "", level: str = "info") -> None:
        """Show a message; an empty text clears the line."""
        self._level = level
        self.words.setText(with_hint(text, hint))
        self._redraw()

    def _redraw(self) -> None:
        self._icon.setVisible(bool(self.words.text()))
        self._icon.setPixmap(self._look.icon(*LEVEL_ICONS[self._level]).pixmap(QSize(20, 20)))


class Footer(QWidget):
    """One filled button, up to two quiet ones, progress with Stop, and one message."""

    def __init__(self, look: Look, resting: QWidget) -> None:
        """``resting`` takes the focus from a button that disappears."""
        super().__init__()
        self._resting = resting
        self.message = MessageLine(look)
        self.note, self.bar = label("", "small"), QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedWidth(240)
        self.stop = Button("Stop", look, "cancel", tip="Stop after this view; what was collected is kept")
        self.third, self.second = Button("", look), Button("", look)
        self.primary = Button("", look, role="primary")
        self.help = Button("Help", look, "help", "quiet", "What this wizard does (F1)")
        self.missing = label("", "soft")
        self.words: tuple[str, str, str] = ("", "", "")
        self._running = QWidget()
        self._running.setLayout(row(column(0, self.note, self.bar, 0, spacing=4), self.stop, spacing=12))
        layout = row(self.message, self._running, self.missing, self.third, self.second, self.primary, spacing=12)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.setMinimumHeight(48)

    def show_message(self, text: str, hint: str = "", level: str = "info") -> None:
        """Show a message with its remedy."""
        self.message.show_message(text, hint, level)

    def offer(self, primary: str, second: str, third: str, missing: str = "") -> None:
        """Offer these buttons; empty words: not offered. ``missing`` is what the filled one waits for."""
        self.words = (primary, second, third)
        self.missing.setText(translated(missing))
        self.missing.setVisible(bool(missing))
        for button, words in zip((self.primary, self.second, self.third), self.words, strict=True):
            usable = bool(words) and not (missing and button is self.primary)
            self._keep_focus(button, usable)
            button.setText(translated(words))
            button.setVisible(bool(words))
            button.setEnabled(usable)

    def _keep_focus(self, button: QPushButton, usable: bool) -> None:
        """Qt would give the focus to whatever comes next, the help for one."""
        if button.hasFocus() and not usable:
            self._resting.setFocus()

    def show_running(self, collecting: bool, evaluating: bool) -> None:
        """Show that views are taken or read, or that the result is being evaluated."""
        self._running.setVisible(collecting or evaluating)
        self.stop.setVisible(collecting)
        if evaluating:
            self.note.setText(translated(WAITING))
        if not (collecting or evaluating):
            self.bar.setValue(0)
            self.note.setText("")

    def show_progress(self, fraction: float, note: str) -> None:
        """Show how far it is."""
        self.bar.setValue(round(1000 * fraction))
        self.note.setText(translated(sentence_case(note)))
