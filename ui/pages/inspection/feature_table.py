"""The list of measured features; several can be selected, to define dimensions and constructed features with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QItemSelectionModel, Signal
from PySide6.QtWidgets import QAbstractItemView

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import NOTHING, counted, quantity, sentence_case
from ui.pages.inspection.dimension_rows import shape_words
from ui.widgets.data_table import Cell, DataTable, number

if TYPE_CHECKING:
    from measureapp.data.feature import Feature

HEADERS = ["Feature", "Datum", "Shape", "Size", "Form", "Points"]


class FeatureTable(DataTable):
    """Shows features by name; `names()` are those selected, in the order in which they were selected."""

    chosen = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__(look, HEADERS, numeric=(3, 4, 5), stretch=0)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setAccessibleName(tr("Features"))
        self.setAccessibleDescription(tr("Hold Ctrl to select several features."))
        self._features: tuple[Feature, ...] = ()
        self._shown: tuple[Sequence[Feature], Mapping[str, str]] = ((), {})
        self._order: list[str] = []
        self._awaited: list[str] = []  # selected, but not measured yet
        self.selectionModel().selectionChanged.connect(self._follow)

    def show_features(self, features: Sequence[Feature], letters: Mapping[str, str]) -> None:
        """Show these features with the letters of those that are datums; the selected ones stay selected."""
        if self._shown[0] is features and self._shown[1] == letters:
            return
        self._shown = (features, dict(letters))
        kept, self._features = [*self._order, *self._awaited], tuple(features)
        blocked = self.selectionModel().blockSignals(True)
        self.set_rows([_cells(one, letters.get(one.name, "")) for one in features])
        self.selectionModel().clearSelection()
        self.selectionModel().blockSignals(blocked)
        self.select_names(kept)

    def names(self) -> tuple[str, ...]:
        """Return the names of the selected features, in the order in which they were selected; also of those being measured."""
        return (*self._order, *self._awaited)

    def name_at(self, place: int) -> str:
        """Return the name of the feature in a row."""
        return self._features[place].name

    def select_names(self, names: Sequence[str]) -> None:
        """Select features by name."""
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
        chosen = [*self._order, *self._awaited]
        self.select_names([one for one in chosen if one != name] if name in chosen else [*chosen, name])

    def _follow(self) -> None:
        now = [self._features[index.row()].name for index in self.selectionModel().selectedRows()]
        self._order = [name for name in self._order if name in now] + [name for name in now if name not in self._order]
        self.chosen.emit()


def _cells(feature: Feature, letter: str) -> list[Cell]:
    size = NOTHING if feature.radius_mm is None else f"⌀ {quantity(2 * feature.radius_mm, '')}"
    measured = feature.points > 0
    return [
        Cell(sentence_case(feature.name)),
        Cell(letter),
        Cell(shape_words(feature) if measured else tr("{shape_words}, constructed", shape_words=shape_words(feature))),
        number(size),
        number(quantity(feature.form_error_mm, "") if measured else NOTHING),
        number(counted(feature.points) if measured else NOTHING),
    ]
