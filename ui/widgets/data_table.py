"""Tables of results: text left, numbers right, verdicts with icon, text and colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from PySide6.QtCore import QAbstractTableModel, QItemSelectionModel, QModelIndex, QPersistentModelIndex, QRect, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStyle, QStyledItemDelegate, QStyleOptionViewItem, QTableView, QWidget

from ui.look.language.words import translated
from ui.look.look import Look

Index = QModelIndex | QPersistentModelIndex
ROW_HEIGHT = 36
SIGN_ROLE = Qt.ItemDataRole.UserRole
VERDICT_WORDS = {"pass": "Pass", "fail": "Fail", "not proven": "Not proven", "not measured": "Not measured", "no tolerance": "No tolerance"}


@dataclass(frozen=True)
class Cell:
    """One cell. ``sign`` is a verdict, "eye", "hidden" or a colour (#rrggbb) drawn before the text."""

    text: str
    kind: Literal["text", "number"] = "text"
    sign: str = ""
    bold: bool = False
    tip: str = ""
    soft: bool = False  # of less weight than the others


def number(text: str) -> Cell:
    """Return a cell with a number, aligned to the right."""
    return Cell(text, "number")


def verdict_cell(verdict: str, text: str = "", tip: str = "") -> Cell:
    """Return a cell with a verdict, its sign and its colour."""
    return Cell(text or VERDICT_WORDS.get(verdict, verdict), sign=verdict, tip=tip)


def is_in_sight(view: QTableView, index: Index, height: int | None = None) -> bool:
    """Return whether a row is in sight as a whole; ``height`` is that of the viewport, or one it had before."""
    box = view.visualRect(index)
    return box.isValid() and box.top() >= 0 and box.bottom() < (view.viewport().height() if height is None else height)


def bring_into_sight(view: QTableView, index: Index) -> None:
    """Scroll to a row that is not in sight: to the middle, so that its neighbours are seen, too."""
    if index.isValid() and not is_in_sight(view, index):
        view.scrollTo(index, QAbstractItemView.ScrollHint.PositionAtCenter)


class TableModel(QAbstractTableModel):
    """Rows of cells; the view does not change them."""

    def __init__(self, headers: Sequence[str], numeric: Sequence[int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._headers, self._numeric = tuple(headers), frozenset(numeric)
        self.rows: tuple[tuple[Cell, ...], ...] = ()

    def set_rows(self, rows: Sequence[Sequence[Cell]]) -> None:
        """Replace all rows."""
        self.beginResetModel()
        self.rows = tuple(tuple(cells) for cells in rows)
        self.endResetModel()

    def rowCount(self, _parent: Index | None = None) -> int:
        """Return the number of rows."""
        return len(self.rows)

    def columnCount(self, _parent: Index | None = None) -> int:
        """Return the number of columns."""
        return len(self._headers)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the heading of a column."""
        if orientation != Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return translated(self._headers[section])
        if role == Qt.ItemDataRole.TextAlignmentRole:
            side = Qt.AlignmentFlag.AlignRight if section in self._numeric else Qt.AlignmentFlag.AlignLeft
            return side | Qt.AlignmentFlag.AlignVCenter
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return what a cell shows."""
        cell = self.rows[index.row()][index.column()]
        if role == Qt.ItemDataRole.DisplayRole:
            return translated(cell.text)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            side = Qt.AlignmentFlag.AlignRight if cell.kind == "number" else Qt.AlignmentFlag.AlignLeft
            return side | Qt.AlignmentFlag.AlignVCenter
        if role == Qt.ItemDataRole.ToolTipRole:
            return translated(cell.tip or cell.text)
        if role == SIGN_ROLE:
            return cell.sign
        if role == Qt.ItemDataRole.ForegroundRole and cell.soft:
            return QPalette().brush(QPalette.ColorRole.Dark)
        if role == Qt.ItemDataRole.FontRole and cell.bold:
            font = QFont()
            font.setWeight(QFont.Weight.DemiBold)
            return font
        return None


class SignDelegate(QStyledItemDelegate):
    """Draws the sign of a cell before its text."""

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._look = look

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        """Hide the focus rectangle; reserve space for the sign."""
        super().initStyleOption(option, index)
        option.state &= ~QStyle.StateFlag.State_HasFocus
        if index.data(SIGN_ROLE):
            option.decorationSize = QSize(20, 20)
            option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw the cell, then its sign."""
        super().paint(painter, option, index)
        sign = index.data(SIGN_ROLE)
        if not sign:
            return
        box = QRect(option.rect.left() + 8, option.rect.center().y() - 9, 20, 20)
        if sign.startswith("#"):
            painter.save()
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(sign))
            painter.drawRoundedRect(box.adjusted(2, 2, -2, -2), 4, 4)
            painter.restore()
        elif sign in VERDICT_WORDS:
            self._look.icon(sign, "verdict_" + sign.replace(" ", "_")).paint(painter, box)
        else:
            self._look.icon(sign, "soft").paint(painter, box)


class DataTable(QTableView):
    """A read-only table with single-row selection."""

    rowSelected = Signal(int)
    cellClicked = Signal(int, int)

    def __init__(self, look: Look, headers: Sequence[str], *, numeric: Sequence[int] = (), stretch: int = 0) -> None:
        super().__init__()
        self._model = TableModel(headers, numeric, self)
        self.setModel(self._model)
        self.setItemDelegate(SignDelegate(look, self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(ROW_HEIGHT)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setFixedHeight(ROW_HEIGHT)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(stretch, QHeaderView.ResizeMode.Stretch)
        self.selectionModel().currentRowChanged.connect(lambda now, _before: self.rowSelected.emit(now.row()))
        self.clicked.connect(lambda index: self.cellClicked.emit(index.row(), index.column()))
        look.changed.connect(self._follow_look)

    def _follow_look(self) -> None:
        """Follow a change of theme or language; columns get the width of their words."""
        self._model.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, self._model.columnCount() - 1)
        if self._model.rows:
            self._model.dataChanged.emit(
                self._model.index(0, 0), self._model.index(len(self._model.rows) - 1, self._model.columnCount() - 1)
            )
        self.viewport().update()

    def set_rows(self, rows: Sequence[Sequence[Cell]]) -> None:
        """Show these rows; the selected row is kept."""
        chosen = self.currentIndex().row()
        self._model.set_rows(rows)
        if 0 <= chosen < len(rows):  # not by `selectRow`, which selects otherwise while Shift or Ctrl is held down
            flags = QItemSelectionModel.SelectionFlag.ClearAndSelect | QItemSelectionModel.SelectionFlag.Rows
            self.selectionModel().setCurrentIndex(self._model.index(chosen, 0), flags)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Treat the space bar like a click on the first cell of the row."""
        if event.key() == Qt.Key.Key_Space and self.currentIndex().isValid():
            self.cellClicked.emit(self.currentIndex().row(), 0)
        else:
            super().keyPressEvent(event)

    def texts(self) -> list[list[str]]:
        """Return the texts of all rows."""
        return [[cell.text for cell in cells] for cells in self._model.rows]

    def fitted_height(self) -> int:
        """Return the height at which all rows are visible."""
        return ROW_HEIGHT * (1 + self._model.rowCount()) + 4
