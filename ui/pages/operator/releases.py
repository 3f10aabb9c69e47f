"""Which part programs are released for operators, and by whom; the engineer releases them here."""

from __future__ import annotations

from PySide6.QtWidgets import QLineEdit, QWidget

from ui.controllers.operator_nouns import ProgramCard
from ui.controllers.operator_shelf import ShelfController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row
from ui.widgets.data_table import Cell, DataTable
from ui.widgets.empty_rows import EmptyRows

HEADERS = ("Part program", "Release", "State")
ABOUT = "Operators are offered released programs only. Whatever changes a program makes it a new one, which is released again."
HEIGHT = 160
READING = "Reading the part programs…"
NO_PROGRAMS = "No part programs in the folder. Save one with Save as a template in the menu Project."


class Releases(QWidget):
    """The part programs of the folder with their state; `Release` releases the selected ones under the name that is stated."""

    def __init__(self, look: Look, stock: ShelfController) -> None:
        super().__init__()
        self._stock = stock
        self.table = DataTable(look, HEADERS, numeric=(1,), stretch=0)
        self.table.setMinimumHeight(HEIGHT)
        self.empty = EmptyRows(self.table, READING)
        self.table.setSelectionMode(DataTable.SelectionMode.ExtendedSelection)
        self.by = QLineEdit()
        self.by.setPlaceholderText(tr("Your name, printed in every report"))
        self.by.setAccessibleName(tr("Released by"))
        self.release = Button("Release", look, "", "normal", "Release the selected programs for operators, as their next revision")
        self.release.clicked.connect(self._release)
        line = row(self.by, self.release)
        line.setStretch(0, 1)
        layout = column(label("Released part programs", "heading"), label(ABOUT, "small", wrap=True), self.table, line, spacing=8)
        layout.setStretch(2, 1)
        self.setLayout(layout)
        self.by.textChanged.connect(self._show_state)
        self.table.selectionModel().selectionChanged.connect(self._show_state)
        stock.changed.connect(self._show)
        self._show()

    @property
    def cards(self) -> tuple[ProgramCard, ...]:
        """Programs that can be used, those to be released first."""
        shelf = self._stock.shelf
        return () if shelf is None else (*shelf.unreleased, *(card for card in shelf.cards if card.program is not None))

    def _show(self) -> None:
        self.empty.say(READING if self._stock.shelf is None else NO_PROGRAMS)
        self.table.set_rows([_row(card) for card in self.cards])
        self._show_state()

    def _chosen(self) -> tuple[ProgramCard, ...]:
        rows = sorted(index.row() for index in self.table.selectionModel().selectedRows())
        return tuple(card for number, card in enumerate(self.cards) if number in rows and not card.is_released)

    def _show_state(self) -> None:
        self.release.setEnabled(bool(self._chosen()) and bool(self.by.text().strip()))

    def _release(self) -> None:
        self._stock.release(self._chosen(), self.by.text().strip())


def _row(card: ProgramCard) -> tuple[Cell, ...]:
    assert card.program is not None
    facts = card.program.facts
    if card.is_released and facts.release is not None:
        state = tr("Released by {by}, {at}", by=facts.release.by, at=facts.release.at[:10])
    else:
        state = "Changed since" if facts.revision else "Not released"
    return Cell(facts.name), Cell(str(facts.revision) if facts.revision else ""), Cell(state)
