"""Order and filter of the table of dimensions: the worst first, chips by verdict, and a search field."""

from __future__ import annotations

from PySide6.QtCore import QObject, QSortFilterProxyModel, Qt

from ui.controllers.program_rows import DimensionRow
from ui.pages.inspection.dimension_model import Column, DimensionModel, rank, sort_key
from ui.widgets.data_table import Index

PROGRAM_ORDER = -1  # sort column: the order of the program, which is that of the report
STALE = "stale"


class DimensionFilter(QSortFilterProxyModel):
    """Sorts only when asked, so that no row moves while a cell is edited."""

    def __init__(self, model: DimensionModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._chips: frozenset[str] = frozenset()
        self._words: tuple[str, ...] = ()
        self.setDynamicSortFilter(False)
        self.setSourceModel(model)
        self.dimensions = model

    @property
    def is_filtering(self) -> bool:
        """Whether rows may be hidden."""
        return bool(self._chips or self._words)

    def set_filter(self, chips: frozenset[str], words: str) -> None:
        """Show the rows of these verdicts or states (none: of all) whose names contain all words."""
        self.beginFilterChange()
        self._chips, self._words = chips, tuple(words.casefold().split())
        self.endFilterChange()
        self.resort()

    def resort(self) -> None:
        """Sort again by the chosen column; also filter again what has changed."""
        self.invalidate()
        self.sort(self.sortColumn(), self.sortOrder())

    def filterAcceptsRow(self, source_row: int, _parent: Index) -> bool:
        """Return whether a row is shown."""
        row = self.dimensions.rows[source_row]
        return self._has_chip(row) and all(word in f"{row.name} {row.kind}".replace("_", " ").casefold() for word in self._words)

    def _has_chip(self, row: DimensionRow) -> bool:
        if not self._chips:
            return True
        return (STALE if row.is_outdated else row.verdict) in self._chips

    def lessThan(self, left: Index, right: Index) -> bool:
        """Return the order of two rows; equal ones are in the order of the worst first."""
        one, other = self.dimensions.rows[left.row()], self.dimensions.rows[right.row()]
        column = Column(self.sortColumn())
        keys = sort_key(one, column), sort_key(other, column)
        if keys[0] != keys[1]:
            return bool(keys[0] < keys[1])
        return (rank(one), left.row()) < (rank(other), right.row())

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Sort by a column; `PROGRAM_ORDER`: the order of the program."""
        super().sort(column, order)
