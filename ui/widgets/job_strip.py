"""The status strip: running job, remaining time, last message."""

from __future__ import annotations

import time

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QProgressBar, QSizePolicy, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import duration, with_hint
from ui.widgets.basic import Button, column, label, row

LEVEL_ICONS = {"info": ("info", "soft"), "done": ("pass", "verdict_pass"), "warning": ("warning", "verdict_not_proven")}
LEVEL_ICONS["error"] = ("error", "verdict_fail")
SETTLED_SHARE = 0.03
SETTLED_S = 2.0
LATE_MS = 1000  # after Cancel; a step that is longer, such as compiling the kernels for the first time, is named as the reason
JOB_SHARE, MESSAGE_SHARE = 3, 2  # of the width while a job runs


class JobStrip(QFrame):
    """Running job with progress, step, remaining time and Cancel; the last message with its hint; how many are open.

    The step is never cut: it is broken into lines, and the strip grows.
    """

    cancelClicked = Signal()
    messagesClicked = Signal()

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("strip")
        self.setMinimumHeight(look.theme.sizes["strip"])
        self._look, self._level, self._started, self.words = look, "info", 0.0, ""
        self.title, self.note, self.time_left = label("", "strong"), label("", "small", wrap=True), label("", "small")
        self.bar = QProgressBar()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setAccessibleName(tr("Progress of the job"))
        self.cancel = Button("Cancel", look, "cancel", "normal", "Stop at the next safe point")
        self.cancel.clicked.connect(self._on_cancel)
        self._late = QTimer(self)
        self._late.setSingleShot(True)
        self._late.setInterval(LATE_MS)
        self._late.timeout.connect(lambda: self.note.setText(tr("Stops when the present step ends; nothing new is begun.")))
        self._job = self._job_area()
        self._icon = QLabel()
        self.message = Button("", look, "", "message", "Show all messages")
        self.message.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.message.clicked.connect(self.messagesClicked)
        self.all = Button("", look, "messages", "quiet", "Show all messages")
        self.all.clicked.connect(self.messagesClicked)
        self._places = row(self._job, self._icon, self.message, self.all)
        self._places.setContentsMargins(24, 4, 16, 4)
        self._places.setStretch(2, 1)
        self.setLayout(self._places)
        self.show_job("")
        self.show_open(0)
        look.changed.connect(self._redraw)
        look.changed.connect(self._fit_message)  # an elided text does not follow the language

    def _job_area(self) -> QWidget:
        area = QWidget()
        self.time_left.setAlignment(Qt.AlignmentFlag.AlignRight)
        words = row(self.title, 0, self.time_left)
        area.setLayout(row(column(0, words, self.bar, self.note, 0, spacing=2), self.cancel, 8, spacing=16))
        return area

    def show_job(self, title: str) -> None:
        """Show the running job; an empty title: none."""
        self._job.setVisible(bool(title))
        self._places.setStretch(0, JOB_SHARE if title else 0)
        self._places.setStretch(2, MESSAGE_SHARE if title else 1)
        self._late.stop()
        self.title.setText(translated(title))
        self.note.setText("")
        self.time_left.setText("")
        self.bar.setValue(0)
        self.cancel.setEnabled(True)
        self.cancel.setText(tr("Cancel"))
        self._started = time.monotonic()
        self._places.activate()
        self._fit_message()

    def show_progress(self, share: float, note: str, *, with_time: bool = True) -> None:
        """Show the progress of the job and the estimated remaining time, unless the page states a better one."""
        self.bar.setValue(round(1000 * share))
        if note != self.note.text():
            self.note.setText(translated(note))
        elapsed = time.monotonic() - self._started
        if with_time and share > SETTLED_SHARE and elapsed > SETTLED_S:
            self.time_left.setText(tr("{time} left", time=duration(elapsed * (1 - share) / share)))

    def show_message(self, text: str, hint: str, level: str) -> None:
        """Show one message with its hint; empty: none."""
        self._level = level
        self.words = with_hint(text, hint)
        self.message.setToolTip(tr("{words}\nClick to see all messages.", words=self.words) if self.words else tr("Show all messages"))
        self.message.setAccessibleName(translated(self.words))
        self._fit_message()
        self._redraw()

    def show_open(self, count: int) -> None:
        """Show how many warnings and errors are open."""
        self.all.setText(f"\u2009{count}" if count else "")
        tip = "1 message is open" if count == 1 else tr("{count} messages are open", count=count) if count else "Show all messages"
        self.all.setToolTip(translated(tip))
        self.all.setAccessibleName(translated(tip))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Elide the message to the new width."""
        super().resizeEvent(event)
        self._fit_message()

    def _fit_message(self) -> None:
        room = max(80, self.message.width() - 24)
        self.message.setText(self.message.fontMetrics().elidedText(translated(self.words), Qt.TextElideMode.ElideRight, room))

    def _on_cancel(self) -> None:
        self.cancel.setEnabled(False)
        self.cancel.setText(tr("Stopping…"))
        self._late.start()
        self.cancelClicked.emit()

    def _redraw(self) -> None:
        self._icon.setVisible(bool(self.words))
        if self.words:
            self._icon.setPixmap(self._look.icon(*LEVEL_ICONS[self._level]).pixmap(QSize(20, 20)))
