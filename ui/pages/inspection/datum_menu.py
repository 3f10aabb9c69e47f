"""Menu of a feature: the letter that it has as a datum."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPoint, Qt
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMenu

from measureapp.data.datum_letters import GIVEN, is_datum_letter, letters_of
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.look.wording import sentence_case
from ui.pages.inspection.feature_table import FeatureTable


class DatumMenu(QObject):
    """Gives the feature under the pointer another datum letter; one that is taken changes places with it."""

    def __init__(self, table: FeatureTable, programming: ProgrammingController) -> None:
        super().__init__(table)
        self._table, self._programming = table, programming
        table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        table.customContextMenuRequested.connect(self._open)

    def menu(self, name: str) -> QMenu:
        """Return the menu of a feature, its present letter ticked."""
        menu = QMenu(self._table)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        state = self._programming.state
        letters = {} if state is None else letters_of(state.program)
        mine, holders = letters.get(name, ""), {letter: feature for feature, letter in letters.items() if is_datum_letter(letter)}
        chosen = menu.addMenu(tr("Datum letter of {name}", name=sentence_case(name)))
        chosen.setEnabled(self._programming.can_change and (not mine or is_datum_letter(mine)))  # a common datum has those of its features
        group = QActionGroup(chosen)
        for letter in ("", *sorted({*GIVEN, *holders}, key=lambda one: (len(one), one))):
            holder = holders.get(letter, "")
            words = (
                tr("{letter}  changes places with {name}", letter=letter, name=sentence_case(holder))
                if holder not in ("", name)
                else letter
            )
            action = group.addAction(words or tr("None"))
            action.setCheckable(True)
            action.setChecked(letter == mine)
            action.triggered.connect(lambda _checked, letter=letter: self.give(name, letter))
            chosen.addAction(action)
        self._table.menuAsked.emit(menu)
        return menu

    def offered_menu(self) -> QMenu | None:
        """Return the menu of the feature selected last; None without one."""
        chosen = self._table.names()
        return self.menu(chosen[-1]) if chosen and self._programming.state is not None else None

    def give(self, name: str, letter: str) -> None:
        """Give a feature a letter; an empty one removes it."""
        from measureapp.inspection.programming import edits

        words = tr("{name} is datum {letter}.", name=name, letter=letter) if letter else tr("{name} is no datum.", name=name)
        self._programming.edit(lambda program: edits.set_datum_letter(program, name, letter), words)

    def _open(self, place: QPoint) -> None:
        index = self._table.indexAt(place)
        if index.isValid() and self._programming.state is not None:
            name = self._table.name_at(index.row())
            if name not in self._table.names():  # the actions of the menu are those on what is selected
                self._table.select_names([name])
            self.menu(name).popup(self._table.viewport().mapToGlobal(place))
