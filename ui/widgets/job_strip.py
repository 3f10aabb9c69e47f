"""The status strip: running job, remaining time, last message."""

from __future__ import annotations

import time

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QProgressBar, QSizePolicy, QWidget

from ui.look.look import Look
from ui.look.wording import duration
from ui.widgets.basic import Button, column, label, row

LEVEL_ICONS = {"info": ("info", "soft"), "done": ("pass", "verdict_pass"), "warning": ("warning", "verdict_not_proven")}
LEVEL_ICONS["error"] = ("error", "verdict_fail")
SETTLED_SHARE = 0.03
SETTLED_S = 2.0


class JobStrip(QFrame):
    """Running job with progress, remaining time and Cancel; the last message with its hint."""

    cancelClicked = Signal()
    messagesClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("strip")
        self.setFixedHeight(look.theme.sizes["strip"])
        self._look, self._level, self._started, self.words = look, "info", 0.0, ""
        self.title, self.note, self.time_left = label("", "strong"), label("", "small"), label("", "small")
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.cancel = Button("Cancel", look, "cancel", "normal", "Stop at the next safe point")
        self.cancel.clicked.connect(self._on_cancel)
        self._job = self._job_area()
        self._icon = QLabel()
        self.message = Button("", look, "", "message", "Show all messages")
        self.message.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.message.clicked.connect(self.messagesClicked)
        layout = row(self._job, self._icon, self.message)
        layout.setContentsMargins(24, 0, 16, 0)
        layout.setStretch(2, 1)
        self.setLayout(layout)
        self.show_job("")
        look.changed.connect(self._redraw)

    def _job_area(self) -> QWidget:
        area = QWidget()
        area.setFixedWidth(480)
        for small in (self.note, self.time_left):
            small.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.time_left.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.time_left.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        words = row(self.title, self.note, self.time_left)
        words.setStretch(1, 1)
        area.setLayout(row(column(0, words, self.bar, 0, spacing=4), self.cancel, 16, spacing=16))
        return area

    def show_job(self, title: str) -> None:
        """Show the running job; an empty title: none."""
        self._job.setVisible(bool(title))
        self.title.setText(title)
        self.note.setText("")
        self.time_left.setText("")
        self.bar.setValue(0)
        self.cancel.setEnabled(True)
        self.cancel.setText("Cancel")
        self._started = time.monotonic()
        layout = self.layout()
        if layout is not None:
            layout.activate()
            self._fit_message()

    def show_progress(self, share: float, note: str, *, with_time: bool = True) -> None:
        """Show the progress of the job and the estimated remaining time, unless the page states a better one."""
        self.bar.setValue(round(1000 * share))
        self.note.setText(note)
        self.note.setToolTip(note)
        elapsed = time.monotonic() - self._started
        if with_time and share > SETTLED_SHARE and elapsed > SETTLED_S:
            self.time_left.setText(f"{duration(elapsed * (1 - share) / share)} left")

    def show_message(self, text: str, hint: str, level: str) -> None:
        """Show the last message with its hint."""
        self._level = level
        self.words = f"{text} {hint}".strip()
        self.message.setToolTip(f"{self.words}\nClick to see all messages.")
        self._fit_message()
        self._redraw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Elide the message to the new width."""
        super().resizeEvent(event)
        self._fit_message()

    def _fit_message(self) -> None:
        room = max(80, self.message.width() - 24)
        self.message.setText(self.message.fontMetrics().elidedText(self.words, Qt.TextElideMode.ElideRight, room))

    def _on_cancel(self) -> None:
        self.cancel.setEnabled(False)
        self.cancel.setText("Stopping…")
        self.cancelClicked.emit()

    def _redraw(self) -> None:
        if self.words:
            self._icon.setPixmap(self._look.icon(*LEVEL_ICONS[self._level]).pixmap(QSize(20, 20)))
