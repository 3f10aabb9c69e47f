"""The message centre: what is open and what was, newest first, each with its remedy."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QHeaderView, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.messages import Message, Messages
from ui.widgets.basic import Button, column, label, row
from ui.widgets.data_table import ROW_HEIGHT, Cell, DataTable
from ui.widgets.empty_rows import EmptyRows
from ui.widgets.job_strip import LEVEL_ICONS
from ui.widgets.segments import Segments

SHOWN = {"open": "Still open", "all": "All"}


class MessagesDialog(QDialog):
    """A modeless window with the messages of this start of the program."""

    remedyAsked = Signal(str)  # id of an action
    logAsked = Signal()

    def __init__(self, look: Look, messages: Messages, words_of: Callable[[str], str], parent: QWidget | None = None) -> None:
        """``words_of``: returns the words of an action by its id, empty if there is none."""
        super().__init__(parent)
        self.setWindowTitle(tr("Messages"))
        self.resize(960, 520)
        self._messages, self._words_of = messages, words_of
        self._rows: list[Message] = []
        self._place = -1  # row that is selected
        self.which = Segments(SHOWN, name="Messages shown")
        self.which.setValue("all")
        self.table = DataTable(look, ["Time", "What happened", "What to do", "State"], stretch=1)
        self.table.horizontalHeader().setSectionResizeMode(2, QHeaderView.ResizeMode.Stretch)
        self.table.setWordWrap(True)
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.verticalHeader().setMinimumSectionSize(ROW_HEIGHT)
        EmptyRows(self.table, "No messages. What happens during a measurement is listed here.")
        self.remedy = Button("", look, "", "primary", "Do what helps")
        self.dismiss = Button("Seen to", look, "pass", "normal", "Close this message, because its cause is gone")
        self.copy = Button("Copy", look, "copy", "normal", "Copy all messages as text")
        self.log = Button(
            "Save log for support…", look, "export", "normal", "Save log, settings and versions in one file; it holds no secrets"
        )
        top = row(label("Messages", "title"), 0, self.which)
        self.setLayout(column(top, self.table, row(self.copy, self.log, 0, self.dismiss, self.remedy), margin=24, spacing=16))
        self.which.valueChanged.connect(self.refresh)
        self.table.rowSelected.connect(self._offer)
        self.remedy.clicked.connect(self._do_remedy)
        self.dismiss.clicked.connect(self._dismiss)
        self.copy.clicked.connect(self._copy)
        self.log.clicked.connect(self.logAsked)
        messages.added.connect(self.refresh)
        messages.changed.connect(self.refresh)
        self._offer(-1)

    def begin(self) -> None:
        """Show the window with the present messages."""
        self.show()
        self.raise_()
        self.refresh()

    def refresh(self, *_: object) -> None:
        """Show the present messages, the newest at the top."""
        if not self.isVisible():
            return
        chosen = self._chosen()
        shown = self._messages.open if self.which.value() == "open" else tuple(self._messages)
        self._rows = list(reversed(shown))
        self.table.set_rows([self._cells(message) for message in self._rows])
        place = next((row for row, message in enumerate(self._rows) if chosen is not None and message.id == chosen.id), -1)
        if place >= 0:
            self.table.selectRow(place)
        else:
            self.table.clearSelection()
        self._offer(place)

    def _cells(self, message: Message) -> list[Cell]:
        is_open = self._messages.is_open(message)
        state = "Still open" if is_open else ""
        sign = LEVEL_ICONS[message.level][0]
        was_open = message.level in ("warning", "error")
        return [
            Cell(message.at.strftime("%H:%M:%S"), sign=sign),
            Cell(message.text, bold=is_open, soft=was_open and not is_open),
            Cell(message.hint, soft=was_open and not is_open),
            Cell(state, bold=is_open),
        ]

    def _chosen(self) -> Message | None:
        return self._rows[self._place] if 0 <= self._place < len(self._rows) else None

    def _offer(self, row: int) -> None:
        self._place = row
        chosen = self._chosen()
        is_open = chosen is not None and self._messages.is_open(chosen)
        words = self._words_of(chosen.remedy) if chosen is not None and is_open and chosen.remedy else ""
        self.dismiss.setVisible(is_open)
        self.remedy.setText(translated(words))
        self.remedy.setVisible(bool(words))

    def _do_remedy(self) -> None:
        chosen = self._chosen()
        if chosen is not None and chosen.remedy:
            self.remedyAsked.emit(chosen.remedy)

    def _dismiss(self) -> None:
        chosen = self._chosen()
        if chosen is not None:
            self._messages.dismiss(chosen.id)

    def _copy(self) -> None:
        lines = [f"{message.at:%Y-%m-%d %H:%M:%S}\t{message.level}\t{message.text} {message.hint}".strip() for message in self._messages]
        QGuiApplication.clipboard().setText("\n".join(lines))
