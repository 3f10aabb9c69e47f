"""A table with expandable rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QFont, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStyleOptionViewItem, QTreeView

from ui.look.look import Look
from ui.widgets.data_table import ROW_HEIGHT, SIGN_ROLE, Cell, Index, SignDelegate

INDENT = 20


@dataclass(frozen=True)
class Branch:
    """One row with its child rows, one line of text each."""

    cells: tuple[Cell, ...]
    leaves: tuple[str, ...] = ()


class RowDelegate(SignDelegate):
    """Gives rows and children the height of table rows."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """Return the width of the text and the height of a row."""
        return QSize(super().sizeHint(option, index).width(), ROW_HEIGHT)


class DataTree(QTreeView):
    """A read-only table with expandable rows; one row or child can be selected."""

    rowSelected = Signal(int, int)  # row, child; -1: the row itself
    heightChanged = Signal()  # a row was expanded or collapsed

    def __init__(self, look: Look, headers: Sequence[str], *, numeric: Sequence[int] = (), stretch: int = 0) -> None:
        super().__init__()
        self._headers, self._numeric = tuple(headers), frozenset(numeric)
        self._branches: tuple[Branch, ...] = ()
        self._items = QStandardItemModel(0, len(self._headers), self)
        self.setModel(self._items)
        self.setItemDelegate(RowDelegate(look, self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setIndentation(INDENT)
        self.setUniformRowHeights(True)
        self._label_columns()
        header = self.header()
        header.setStretchLastSection(False)
        header.setHighlightSections(False)
        header.setFixedHeight(ROW_HEIGHT)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(stretch, QHeaderView.ResizeMode.Stretch)
        self.selectionModel().currentRowChanged.connect(lambda now, _before: self.rowSelected.emit(*self._place(now)))
        for moved in (self.expanded, self.collapsed):
            moved.connect(self._emit_height_changed)
        look.changed.connect(self.viewport().update)

    def set_branches(self, branches: Sequence[Branch]) -> None:
        """Show these rows; selection and expanded rows are kept."""
        chosen = self.selected()
        opened = {row for row in range(self._items.rowCount()) if self.isExpanded(self._items.index(row, 0))}
        self._branches = tuple(branches)
        self._items.removeRows(0, self._items.rowCount())
        for row, branch in enumerate(self._branches):
            items = [_item(cell) for cell in branch.cells]
            for words in branch.leaves:
                items[0].appendRow(_item(Cell(words)))
            self._items.appendRow(items)
            for leaf in range(len(branch.leaves)):
                self.setFirstColumnSpanned(leaf, self._items.index(row, 0), True)
            self.setExpanded(self._items.index(row, 0), row in opened)
        if 0 <= chosen[0] < len(self._branches):
            self.select(*chosen)

    def select(self, row: int, leaf: int = -1) -> None:
        """Select a row, or one of its children."""
        index = self._items.index(row, 0)
        leaf = min(leaf, self._items.rowCount(index) - 1)
        if leaf >= 0:
            self.expand(index)
        self.setCurrentIndex(index if leaf < 0 else self._items.index(leaf, 0, index))

    def selected(self) -> tuple[int, int]:
        """Return the selected row and child; -1: none."""
        return self._place(self.currentIndex())

    def texts(self) -> list[list[str]]:
        """Return the texts of all rows."""
        return [[cell.text for cell in branch.cells] for branch in self._branches]

    def leaves(self, row: int) -> tuple[str, ...]:
        """Return the children of a row."""
        return self._branches[row].leaves

    def fitted_height(self) -> int:
        """Return the height at which all expanded rows are visible."""
        opened = sum(len(branch.leaves) for row, branch in enumerate(self._branches) if self.isExpanded(self._items.index(row, 0)))
        return ROW_HEIGHT * (1 + len(self._branches) + opened) + 4

    def _emit_height_changed(self, _index: QModelIndex) -> None:
        self.heightChanged.emit()

    def _label_columns(self) -> None:
        for column, name in enumerate(self._headers):
            item = QStandardItem(name)
            side = Qt.AlignmentFlag.AlignRight if column in self._numeric else Qt.AlignmentFlag.AlignLeft
            item.setTextAlignment(side | Qt.AlignmentFlag.AlignVCenter)
            self._items.setHorizontalHeaderItem(column, item)

    def _place(self, index: QModelIndex) -> tuple[int, int]:
        above = index.parent()
        return (above.row(), index.row()) if above.isValid() else (index.row(), -1)


def _item(cell: Cell) -> QStandardItem:
    item = QStandardItem(cell.text)
    side = Qt.AlignmentFlag.AlignRight if cell.kind == "number" else Qt.AlignmentFlag.AlignLeft
    item.setTextAlignment(side | Qt.AlignmentFlag.AlignVCenter)
    item.setToolTip(cell.tip or cell.text)
    if cell.sign:
        item.setData(cell.sign, SIGN_ROLE)
    if cell.bold:
        font = QFont()
        font.setWeight(QFont.Weight.DemiBold)
        item.setFont(font)
    return item
