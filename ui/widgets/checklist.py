"""A list of findings with what to do about each: problems, warnings, and what is well."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QLabel, QScrollArea, QWidget

from ui.look.language.words import later, translated
from ui.look.look import Look
from ui.look.wording import keep_units
from ui.widgets.basic import clear, column, label, row

Finding = Literal["problem", "warning", "note", "good"]
SIGNS: dict[Finding, tuple[str, str]] = {
    "problem": ("fail", "verdict_fail"),
    "warning": ("warning", "verdict_not_proven"),
    "note": ("info", "soft"),
    "good": ("pass", "verdict_pass"),
}
NAMES: dict[Finding, str] = {
    "problem": later("Problem"),
    "warning": later("Warning"),
    "note": later("Note"),
    "good": later("Good"),
}  # of signs


@dataclass(frozen=True)
class Item:
    """One finding, with its remedy."""

    kind: Finding
    words: str
    remedy: str = ""


class Checklist(QScrollArea):
    """Shows `Item` after `Item`, each with its sign."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.items: tuple[Item, ...] = ()
        self._rows = column(spacing=12)
        body = QWidget()
        body.setObjectName("clear")
        body.setLayout(self._rows)
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(body)
        look.changed.connect(self._show_again)

    def _show_again(self) -> None:
        self.show_items(self.items)

    def show_items(self, items: Sequence[Item]) -> None:
        """Show these findings."""
        self.items = tuple(items)
        clear(self._rows)
        for item in self.items:
            icon, colour = SIGNS[item.kind]
            sign = QLabel()
            sign.setPixmap(self._look.icon(icon, colour).pixmap(QSize(20, 20)))
            sign.setFixedSize(QSize(24, 24))
            sign.setAccessibleName(translated(NAMES[item.kind]))
            words = [label(keep_units(item.words), "body", wrap=True)]
            if item.remedy:
                words.append(label(keep_units(item.remedy), "soft", wrap=True))
            line = row(sign, column(*words, spacing=0), spacing=8)
            line.setAlignment(sign, Qt.AlignmentFlag.AlignTop)
            line.setStretch(1, 1)
            self._rows.addLayout(line)
        self._rows.addStretch(1)
