"""A scan plan as a tree in which viewpoints are selected, renamed and changed in place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QItemSelection, QItemSelectionModel, QItemSelectionRange, QModelIndex, QSignalBlocker, Signal
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTreeView

from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.data_table import ROW_HEIGHT
from ui.widgets.data_tree import INDENT, RowDelegate
from ui.widgets.empty_rows import EmptyRows
from ui.widgets.plan_tree_model import NAME, TOP, Aims, PlanTreeModel, RowState

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint

NO_ROWS = "No viewpoints yet. Generate a plan, add a viewpoint above, or open the file of a plan."
WIDTHS = (0, 64, 80, 100, 78, 84)
OPENED_GROUPS = 4  # of a new plan; more would hide each other


class PlanTree(QTreeView):
    """Shows a plan; several rows can be selected."""

    selectionMoved = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setAccessibleName(tr("Viewpoints"))
        self.rows = PlanTreeModel(self)
        self.setModel(self.rows)
        self.setItemDelegate(RowDelegate(look, self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setIndentation(INDENT)
        self.setUniformRowHeights(True)
        EmptyRows(self, NO_ROWS)
        header = self.header()
        header.setStretchLastSection(False)
        header.setFixedHeight(ROW_HEIGHT)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        header.setMinimumSectionSize(56)
        for column, width in enumerate(WIDTHS):
            if width:
                header.resizeSection(column, width)
        header.setSelectionModel(
            QItemSelectionModel(self.rows, header)
        )  # else it asks about every row of each column whenever it is painted
        self.selectionModel().selectionChanged.connect(self.selectionMoved)
        look.changed.connect(self.viewport().update)

    def show_plan(self, plan: ScanPlan | None, aims: Aims | None) -> None:
        """Show a plan; selection and opened groups are kept by name.

        Where only contents have changed, nothing is laid out again: Qt needs half a second for ten thousand rows.
        """
        names, opened = self.names(), self._opened()
        top = self.verticalScrollBar().value()
        with QSignalBlocker(self.selectionModel()):
            if self.rows.set_plan(plan, aims):
                self.viewport().update()
                self.selectionMoved.emit()
                return
        groups = () if plan is None else plan.groups
        known = {group.id for group in groups} & opened
        for group in groups[:OPENED_GROUPS] if not known else groups:
            if not known or group.id in known:
                self.expand(self.rows.find(group.id))
        self.select(names)
        self.verticalScrollBar().setValue(top)

    def show_states(self, states: Mapping[str, RowState]) -> None:
        """Show which viewpoints can be scanned."""
        self.rows.set_states(states)
        self.viewport().update()

    def names(self) -> tuple[str, ...]:
        """Return the names of the selected rows, from top to bottom."""
        return tuple(self.rows.name_of(*place) for place in sorted(self._selected(), key=_order))

    def viewpoints(self) -> tuple[Viewpoint, ...]:
        """Return the selected viewpoints; of a group its first."""
        return tuple(self.rows.viewpoint_of(*place) for place in self._selected())

    def current_viewpoint(self) -> Viewpoint | None:
        """Return the viewpoint in the row with the focus, or the first selected one."""
        index = self.currentIndex()
        if index.isValid() and self.selectionModel().isRowSelected(index.row(), index.parent()):
            return self.rows.viewpoint_at(index)
        chosen = next(self._selected(), None)
        return None if chosen is None else self.rows.viewpoint_of(*chosen)

    def selectAll(self) -> None:
        """Select all rows, those in groups included, as one range each; Qt would ask about every row by itself."""
        rows, last_column = self.rows, self.rows.columnCount() - 1
        parents = (QModelIndex(), *(rows.index(row, 0) for row in rows.rows_of_groups()))
        whole = QItemSelection()
        for parent in parents:
            if count := rows.rowCount(parent):
                whole.append(QItemSelectionRange(rows.index(0, 0, parent), rows.index(count - 1, last_column, parent)))
        self.selectionModel().select(whole, QItemSelectionModel.SelectionFlag.ClearAndSelect)

    def _selected(self) -> Iterator[tuple[int, int]]:
        """Yield row and group's row of the selected rows; by ranges, for Qt asks the model about every cell for `selectedRows`."""
        for part in self.selectionModel().selection():
            above = part.parent().row() if part.parent().isValid() else TOP
            yield from ((row, above) for row in range(part.top(), part.bottom() + 1))

    def select(self, names: Sequence[str]) -> None:
        """Select the rows with these names; others are deselected."""
        selection = self.selectionModel()
        with QSignalBlocker(selection):
            found = [index for name in names if (index := self.rows.find(name)).isValid()]
            selection.select(_ranges(found, self.rows.columnCount() - 1), QItemSelectionModel.SelectionFlag.ClearAndSelect)
            last = next((index for name in reversed(names) if (index := self.rows.find(name)).isValid()), None)
            if last is not None:
                selection.setCurrentIndex(last, QItemSelectionModel.SelectionFlag.NoUpdate)
        if last is not None:
            self.expand(last.parent())
            self.scrollTo(last)
        self.viewport().update()
        self.selectionMoved.emit()

    def _opened(self) -> set[str]:
        groups = (self.rows.index(row, 0) for row in self.rows.rows_of_groups())
        return {self.rows.name_at(index) for index in groups if self.isExpanded(index)}


def _order(place: tuple[int, int]) -> tuple[int, int]:
    """Return the place of a row from top to bottom."""
    row, above = place
    return (row, -1) if above == TOP else (above, row)


def _ranges(rows: Sequence[QModelIndex], last_column: int) -> QItemSelection:
    """Return rows as a selection; rows below each other as one range, for Qt is slow with many ranges."""
    selection = QItemSelection()
    order = sorted(rows, key=lambda index: (index.internalId(), index.row()))
    start = 0
    for place, index in enumerate(order):
        following = order[place + 1] if place + 1 < len(order) else None
        if following is None or following.internalId() != index.internalId() or following.row() != index.row() + 1:
            selection.append(QItemSelectionRange(order[start], index.siblingAtColumn(last_column)))
            start = place + 1
    return selection
