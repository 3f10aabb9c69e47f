"""The list of measured features; several can be selected, to define dimensions and constructed features with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QItemSelectionModel, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView

from ui.controllers.program_rows import Construction, ProgramEntries, constructions_by_name, entries_by_name
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import NOTHING, counted, quantity, sentence_case
from ui.pages.inspection.dimension_rows import shape_words, source_words
from ui.widgets.data_table import Cell, DataTable, bring_into_sight, is_in_sight, number
from ui.widgets.empty_rows import EmptyRows

if TYPE_CHECKING:
    from measureapp.data.feature import Feature
    from measureapp.data.inspection_program import FeatureProgram

HEADERS = ["Feature", "Datum", "Shape", "Size", "Form", "Points"]
DATUM = HEADERS.index("Datum")


class FeatureTable(DataTable):
    """Shows features by name; `names()` are those selected, in the order in which they were selected."""

    chosen = Signal()
    menuAsked = Signal(object)  # QMenu of the selected features, to be completed

    def __init__(self, look: Look) -> None:
        super().__init__(look, HEADERS, numeric=(3, 4, 5), stretch=0)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setAccessibleName(tr("Features"))
        self.setAccessibleDescription(tr("Hold Ctrl to select several features."))
        self.empty = EmptyRows(self, "No features yet. Press Pick faces or Feature and click the part, or write them with Program.")
        self._features: tuple[Feature, ...] = ()
        self._shown: tuple[Sequence[Feature], Mapping[str, str], Sequence[FeatureProgram]] = ((), {}, ())
        self.constructed: Mapping[str, Construction] = {}  # by name: what those that are not measured themselves are made from
        self._order: list[str] = []
        self._awaited: list[str] = []  # selected, but not measured yet
        self.selectionModel().selectionChanged.connect(self._follow)

    def show_features(self, features: Sequence[Feature], letters: Mapping[str, str], entries: Sequence[FeatureProgram]) -> None:
        """Show these features with the letters of those that are datums; the selected ones stay selected.

        ``entries`` are those of the edited program: what it has no more is not waited for, and what has just been measured is shown.
        """
        if self._shown[0] is features and self._shown[1:] == (letters, entries):
            return
        self._shown = (features, dict(letters), entries)
        self.constructed = constructions_by_name(entries)
        self._features = tuple(features)
        measured, coming = {one.name for one in features}, entries_by_name(entries)
        arrived = [name for name in self._awaited if name in measured]
        kept = [name for name in self.names() if name in measured or name in coming]
        blocked = self.selectionModel().blockSignals(True)
        self.setColumnHidden(DATUM, not any(letters.get(one.name) for one in features))  # names need its room
        self.set_rows([_cells(one, letters.get(one.name, ""), self.constructed.get(one.name)) for one in features])
        self.selectionModel().clearSelection()
        self.selectionModel().blockSignals(blocked)
        self._select(kept)
        if arrived:
            self._bring_into_sight(arrived[-1])

    def names(self) -> tuple[str, ...]:
        """Return the names of the selected features, in the order in which they were selected; also of those being measured."""
        return (*self._order, *self._awaited)

    def name_at(self, place: int) -> str:
        """Return the name of the feature in a row."""
        return self._features[place].name

    def entries(self) -> list[FeatureProgram]:
        """Return the entries of the selected features in the edited program, that of a pattern once."""
        known = entries_by_name(self._shown[2])
        return list({known[name].name: known[name] for name in self.names() if name in known}.values())

    def program_entries(self) -> ProgramEntries:
        """Return what of the program is selected."""
        entries = self.entries()
        return ProgramEntries("feature", tuple(one.name for one in entries), len(entries) == 1 and entries[0].repeat is not None)

    def select_names(self, names: Sequence[str]) -> None:
        """Select features by name, and bring the last one into sight."""
        self._select(names)
        if self._order:
            self._bring_into_sight(self._order[-1])

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the feature in sight that was selected last, where the bar below takes room."""
        super().resizeEvent(event)
        place = self._place(self._order[-1]) if self._order else None
        if place is not None and is_in_sight(self, self.model().index(place, 0), event.oldSize().height()):
            self._bring_into_sight(self._order[-1])

    def _place(self, name: str) -> int | None:
        return next((place for place, one in enumerate(self._features) if one.name == name), None)

    def _bring_into_sight(self, name: str) -> None:
        place = self._place(name)
        if place is not None:
            bring_into_sight(self, self.model().index(place, 0))

    def _select(self, names: Sequence[str]) -> None:
        places = {one.name: place for place, one in enumerate(self._features)}
        model = self.selectionModel()
        blocked = model.blockSignals(True)
        model.clearSelection()
        for name in (one for one in names if one in places):
            flags = QItemSelectionModel.SelectionFlag.Select | QItemSelectionModel.SelectionFlag.Rows
            model.select(self.model().index(places[name], 0), flags)
        model.blockSignals(blocked)
        self._order = [name for name in names if name in places]
        self._awaited = [name for name in names if name not in places]
        self.viewport().update()
        self.chosen.emit()

    def toggle(self, name: str) -> None:
        """Add a feature to the selected ones, or remove it."""
        chosen = self.names()
        if name in chosen:
            self._select([one for one in chosen if one != name])
        else:
            self.select_names([*chosen, name])

    def _follow(self) -> None:
        now = [self._features[index.row()].name for index in self.selectionModel().selectedRows()]
        self._order = [name for name in self._order if name in now] + [name for name in now if name not in self._order]
        self.chosen.emit()


def _cells(feature: Feature, letter: str, made: Construction | None) -> list[Cell]:
    """Return the cells of a feature; a constructed one has neither points nor form, whatever its features have."""
    size = NOTHING if feature.radius_mm is None else f"⌀ {quantity(2 * feature.radius_mm, '')}"
    if feature.shape == "slot":
        size = f"{quantity(2 * (feature.radius_mm or 0.0), '')} × {quantity(feature.length_mm or 0.0, '')}"
    measured, shape = feature.points > 0 and made is None, shape_words(feature, made)
    source = "" if made is None else tr("Constructed from {names}", names=source_words(made))
    return [
        Cell(sentence_case(feature.name)),
        Cell(letter),
        Cell(shape if measured else tr("{shape_words}, constructed", shape_words=shape), tip=source),
        number(size),
        number(quantity(feature.form_error_mm, "") if measured else NOTHING),
        number(counted(feature.points) if measured else NOTHING),
    ]
