"""List of all messages, newest first."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime
from typing import Protocol

from PySide6.QtWidgets import QDialog, QHeaderView, QWidget

from ui.look.look import Look
from ui.widgets.basic import column, label
from ui.widgets.data_table import ROW_HEIGHT, Cell, DataTable
from ui.widgets.job_strip import LEVEL_ICONS


class MessageLike(Protocol):
    """Interface of a message."""

    @property
    def text(self) -> str: ...  # noqa: D102
    @property
    def hint(self) -> str: ...  # noqa: D102
    @property
    def level(self) -> str: ...  # noqa: D102
    @property
    def at(self) -> datetime: ...  # noqa: D102


class MessagesDialog(QDialog):
    """A modeless window with all messages."""

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Messages")
        self.resize(960, 480)
        self.table = DataTable(look, ["Time", "What happened", "What to do"], stretch=1)
        self.table.horizontalHeader().setSectionResizeMode(2, QHeaderView.ResizeMode.Stretch)
        self.table.setWordWrap(True)
        self.table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.verticalHeader().setMinimumSectionSize(ROW_HEIGHT)
        self.setLayout(column(label("Messages", "title"), self.table, margin=24, spacing=16))

    def show_messages(self, messages: Iterable[MessageLike]) -> None:
        """Show these messages, the newest at the top."""
        self.table.set_rows(
            [
                [Cell(message.at.strftime("%H:%M:%S"), sign=LEVEL_ICONS[message.level][0]), Cell(message.text), Cell(message.hint)]
                for message in reversed(list(messages))
            ]
        )
