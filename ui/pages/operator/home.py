"""Home screen: choose a part program by its card or a code."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from ui.controllers.operator import OperatorController
from ui.controllers.operator_nouns import ProgramCard
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import several
from ui.pages.operator.big import big_label
from ui.pages.operator.cards import CardGrid
from ui.widgets.basic import column, row

EMPTY = "There is no part program in {folder}. Call the engineer."
HELD = "{count} not released by the engineer: not offered here."
NOTHING_FOUND = "No part program has “{words}” in its name or numbers."


class HomeScreen(QWidget):
    """Search field and cards."""

    chosen = Signal(object)  # ProgramCard

    def __init__(self, look: Look, controller: OperatorController) -> None:
        super().__init__()
        self._controller = controller
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Scan the code, or type the name or number of the part"))
        self.search.setAccessibleName(tr("Search for a part"))
        self.search.setClearButtonEnabled(True)
        self.grid = CardGrid(look)
        self.note = big_label("Reading the part programs…", "soft", wrap=True)
        layout = column(row(big_label("Which part?", "title"), 24, self.search), self.note, self.grid, spacing=16)
        layout.setContentsMargins(24, 24, 24, 16)
        layout.setStretch(2, 1)
        self.setLayout(layout)
        self.search.textChanged.connect(self._show)
        self.search.returnPressed.connect(self._take_only)
        self.grid.chosen.connect(self.chosen)
        controller.stock.changed.connect(self._show)

    def showEvent(self, event: QShowEvent) -> None:
        """Give the search field the focus, so that a person can type at once."""
        super().showEvent(event)
        self.search.clear()
        self.search.setFocus()

    @property
    def found(self) -> tuple[ProgramCard, ...]:
        """The cards that have the searched words in their name or numbers."""
        shelf, words = self._controller.shelf, self.search.text().strip().casefold()
        return () if shelf is None else tuple(card for card in shelf.cards if words in _searched(card))

    def _show(self) -> None:
        shelf, found = self._controller.shelf, self.found
        if shelf is None:
            return
        self.grid.show_cards(found)
        held = len(shelf.unreleased)
        none = tr(EMPTY, folder=shelf.settings.programs_folder) if not shelf.cards and not held else ""
        missed = "" if found or not self.search.text().strip() else tr(NOTHING_FOUND, words=self.search.text().strip())
        self.note.setText(
            translated(none) or " ".join(filter(None, (missed, tr(HELD, count=several(held, "part program")) if held else "")))
        )
        self.note.setVisible(bool(self.note.text()))

    def _take_only(self) -> None:
        """Choose the card if the search left one."""
        found = self.found
        if len(found) == 1 and self.search.text().strip():
            self.chosen.emit(found[0])


def _searched(card: ProgramCard) -> str:
    if card.program is None:
        return card.name.casefold()
    facts = card.program.facts
    return "\n".join((facts.name, facts.part_number, facts.identification.drawing)).casefold()
