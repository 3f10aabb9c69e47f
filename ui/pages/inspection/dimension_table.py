"""The table of dimensions: edited in place, the worst verdict first, selection kept by row number."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide6.QtCore import QItemSelectionModel, QPoint, Qt, Signal, Slot
from PySide6.QtGui import QAction, QFontMetrics, QGuiApplication, QKeyEvent, QKeySequence, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemDelegate, QAbstractItemView, QHeaderView, QMenu, QTableView, QWidget

from ui.controllers.program_rows import DimensionRow
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.inspection.dimension_delegate import DimensionDelegate
from ui.pages.inspection.dimension_filter import PROGRAM_ORDER, DimensionFilter
from ui.pages.inspection.dimension_model import COPIED, EDITABLE, FRAME_ROLE, HEADERS, ROW_ROLE, CellEdit, Column, DimensionModel, cell_text
from ui.viewport.overlay.control_frame import frame_width
from ui.viewport.overlay.style import OverlayStyle
from ui.widgets.data_table import ROW_HEIGHT, Index, bring_into_sight, is_in_sight
from ui.widgets.empty_rows import EmptyRows

STATUS_WIDTH, LEAST_NAME_WIDTH, WIDEST_NAME = 24, 96, 176
# In this order, where there is little room, as the properties show them: the deviation first, which nominal and value state, too.
LEFT_OUT = (Column.DEVIATION, Column.TOLERANCE, Column.ALIGNMENT, Column.NOMINAL)
CELL_ROOM, SIGN_ROOM, SORT_ROOM = 16, 28, 26  # px beside the text: margins, sign of the verdict, arrow of the order
NAME_SHARE = 3  # of what names have beyond the least, one part is given up before a column that is edited is left out
WIDEST_TOLERANCE = "−0.000 / +0.000 2768-m"  # a longer one is elided, its tip states it: it would take the room of the other columns
EDIT_KEYS = QAbstractItemView.EditTrigger.EditKeyPressed | QAbstractItemView.EditTrigger.AnyKeyPressed
NONE = -1
NO_ROWS = "No dimensions yet. Select features in the list Features, or add one with Dimension above the picture."
NONE_FITS = "No dimension fits the filter. Clear the search, or show all verdicts."


class DimensionTable(QTableView):
    """Shows `DimensionRow`s; one is current, several can be selected."""

    rowSelected = Signal(int)  # number of the current row; -1: none
    closerAsked = Signal()
    frameAsked = Signal(str)  # name of a dimension whose control frame is to be edited
    menuAsked = Signal(object)  # QMenu of a row, to be completed

    def __init__(self, look: Look, edit: Callable[[CellEdit], bool], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.dimensions = DimensionModel(edit, self)
        self.shown = DimensionFilter(self.dimensions, self)
        self._edit_cells = edit
        self._look, self._current = look, NONE
        self._widths: dict[Column, int] = {}  # as fitted last
        self._needs: dict[Column, int] = {}  # of their texts, also while they are hidden
        self._chosen = set[Column]()  # shown or hidden by the user
        self._has_alignments = False  # of which one column is shown
        self._is_waiting = False  # to be sorted again when the editor is closed
        self.setModel(self.shown)
        self.setItemDelegate(DimensionDelegate(look, self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(EDIT_KEYS)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setAccessibleName(tr("Dimensions"))
        self.setAccessibleDescription(tr("F2 edits a cell, Enter zooms to the features of the row."))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(ROW_HEIGHT)
        self._set_up_header()
        self.selectionModel().currentRowChanged.connect(self._follow)
        self.empty = EmptyRows(self, NO_ROWS)
        look.changed.connect(self._follow_look)

    def _set_up_header(self) -> None:
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setFixedHeight(ROW_HEIGHT)
        header.setMinimumSectionSize(STATUS_WIDTH)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(Column.STATUS, QHeaderView.ResizeMode.Fixed)
        header.resizeSection(Column.STATUS, STATUS_WIDTH)
        header.setSectionResizeMode(Column.NAME, QHeaderView.ResizeMode.Stretch)
        header.setSectionsClickable(True)
        header.setSortIndicatorShown(True)
        header.setSortIndicatorClearable(True)
        header.setSortIndicator(Column.VERDICT, Qt.SortOrder.AscendingOrder)
        header.sortIndicatorChanged.connect(self._sort)
        header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        header.customContextMenuRequested.connect(self._show_header_menu)
        self.setColumnHidden(Column.ALIGNMENT, True)
        self.shown.sort(Column.VERDICT)

    @property
    def rows(self) -> tuple[DimensionRow, ...]:
        """All rows, in the order of the program."""
        return self.dimensions.rows

    @property
    def shown_rows(self) -> list[DimensionRow]:
        """The rows that are shown, in their order."""
        return [self.shown.index(place, 0).data(ROW_ROLE) for place in range(self.shown.rowCount())]

    @property
    def is_editing(self) -> bool:
        """Whether a cell is being edited."""
        return self.state() == QAbstractItemView.State.EditingState

    def set_rows(self, rows: Sequence[DimensionRow]) -> None:
        """Show these rows; the selected ones stay selected, and the current one in sight where its verdict gives it another place."""
        self.empty.say(NONE_FITS if rows else NO_ROWS)
        kept, current = self.selected_ids(), self._current
        was_in_sight = is_in_sight(self, self.currentIndex())
        blocked = self.selectionModel().blockSignals(True)
        was_reset = self.dimensions.set_rows(rows)
        self.selectionModel().blockSignals(blocked)
        self._show_alignments(len({row.aligned_by for row in self.rows}) > 1)
        self._fit_columns()
        if self.is_editing:
            self._is_waiting = True
            return
        self._sort_keeping(kept, current)
        if was_in_sight:
            bring_into_sight(self, self.currentIndex())
        if was_reset and self.current_id() != current:
            self._follow()

    def _show_alignments(self, are_several: bool) -> None:
        """Show the column of alignments where dimensions differ in them; a common one is stated above the picture."""
        if are_several == self._has_alignments:
            return
        self._has_alignments = are_several
        self.setColumnHidden(Column.ALIGNMENT, not are_several)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Leave columns out where there is no room for them; the current row stays in sight."""
        super().resizeEvent(event)
        self._leave_out_columns()
        if is_in_sight(self, self.currentIndex(), event.oldSize().height()):
            bring_into_sight(self, self.currentIndex())

    def _leave_out_columns(self) -> None:
        """Hide columns until names, values and verdicts can be read; those that the user chose stay as he chose."""
        offered = [one for one in LEFT_OUT if one not in self._chosen and (one is not Column.ALIGNMENT or self._has_alignments)]
        shown = [column for column in COPIED if column is not Column.NAME and (column in offered or not self.isColumnHidden(column))]
        names = min(max(self._needs.get(Column.NAME, 0), LEAST_NAME_WIDTH), WIDEST_NAME)
        excess = sum(map(self._width_for, shown)) - (self.viewport().width() - STATUS_WIDTH - names)
        for column in offered:
            spare = max(names - LEAST_NAME_WIDTH, 0) // NAME_SHARE if column in EDITABLE else 0
            is_left_out = excess > spare
            self.setColumnHidden(column, is_left_out)
            excess -= self._width_for(column) if is_left_out else 0

    def _width_for(self, column: Column) -> int:
        return self._needs.get(column, 0) if self.isColumnHidden(column) else self.columnWidth(column)

    def _choose_column(self, column: Column, shown: bool) -> None:
        self._chosen.add(column)
        self.setColumnHidden(column, not shown)

    def set_filter(self, chips: frozenset[str], words: str) -> None:
        """Show some of the rows; the current one stays current if it is among them."""
        kept, current = self.selected_ids(), self._current
        self.shown.set_filter(chips, words)
        self._select_ids(kept, current)

    def select(self, row_id: int) -> None:
        """Select a row by its number, and bring it into sight."""
        self._select_ids([row_id], row_id)
        bring_into_sight(self, self.currentIndex())

    def select_first(self) -> None:
        """Select the first row shown: the worst, unless another order was chosen."""
        if self.shown.rowCount():
            self.selectRow(0)

    def current_id(self) -> int:
        """Return the number of the current row; -1: none."""
        row = self.current_row()
        return NONE if row is None else row.id

    def current_row(self) -> DimensionRow | None:
        """Return the current row."""
        index = self.currentIndex()
        return index.data(ROW_ROLE) if index.isValid() else None

    def selected_ids(self) -> list[int]:
        """Return the numbers of the selected rows, in the order shown."""
        chosen = sorted(self.selectionModel().selectedRows(), key=lambda index: index.row())
        return [index.data(ROW_ROLE).id for index in chosen]

    def texts(self) -> list[list[str]]:
        """Return the texts of all rows in the order of the program: name, nominal, measured, deviation, uncertainty, verdict."""
        return [[cell_text(row, column) for column in COPIED] for row in self.rows]

    def copy(self) -> None:
        """Copy the selected rows with their headings as text with tabs."""
        wanted = set(self.selected_ids())
        lines = [[HEADERS[column] for column in COPIED]]
        lines += [[cell_text(row, column) for column in COPIED] for row in self.shown_rows if row.id in wanted]
        QGuiApplication.clipboard().setText("\n".join("\t".join(words) for words in lines))

    def commit(self, index: Index, text: str) -> bool:
        """Edit a cell, and the same cell of all selected rows if its row is one of them."""
        row_id, column, chosen = index.data(ROW_ROLE).id, Column(index.column()), self.selected_ids()
        together = column is not Column.NAME and len(chosen) > 1 and row_id in chosen
        return self._edit_cells(CellEdit(tuple(chosen) if together else (row_id,), column, text))

    def edit_cell(self, column: Column) -> None:
        """Open the editor of the current row in a column."""
        index = self.currentIndex().siblingAtColumn(column)
        if index.isValid() and index.flags() & Qt.ItemFlag.ItemIsEditable:
            if self.isColumnHidden(column):
                self._choose_column(column, True)
            self.setCurrentIndex(index)
            self.edit(index)

    def sort_by_program(self) -> None:
        """Show the order of the program, which is that of the report."""
        self.horizontalHeader().setSortIndicator(PROGRAM_ORDER, Qt.SortOrder.AscendingOrder)

    def sort_worst_first(self) -> None:
        """Show the worst verdict first."""
        self.horizontalHeader().setSortIndicator(Column.VERDICT, Qt.SortOrder.AscendingOrder)

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        """Go down after Enter; sort what was waiting."""
        place = self.currentIndex()
        super().closeEditor(editor, hint)
        if hint == QAbstractItemDelegate.EndEditHint.SubmitModelCache and place.isValid():
            below = place.siblingAtRow(place.row() + 1)
            if below.isValid():
                self.setCurrentIndex(below)
        if self._is_waiting and not self.is_editing:
            self._is_waiting = False
            self._sort_keeping(self.selected_ids(), self.current_id())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Copy, zoom to the row with Enter, or edit."""
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and not self.is_editing:
            self.closerAsked.emit()
        elif event.key() == Qt.Key.Key_F2 and self.current_row() is not None:
            column = Column(self.currentIndex().column())
            self.edit_cell(column if column in EDITABLE else Column.TOLERANCE)
        else:
            super().keyPressEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Edit a control frame, or a cell that can be edited; else zoom to the row."""
        index = self.indexAt(event.position().toPoint())
        row = index.data(ROW_ROLE) if index.isValid() else None
        if row is not None and row.entry is not None and index.data(FRAME_ROLE) is not None:
            self.frameAsked.emit(row.name)
        elif index.isValid() and index.flags() & Qt.ItemFlag.ItemIsEditable:
            self.edit(index)
        elif index.isValid():
            self.closerAsked.emit()

    def contextMenuEvent(self, event: Any) -> None:
        """Open the menu of a row."""
        menu = self.offered_menu()
        if menu is not None:
            menu.popup(event.globalPos())

    def offered_menu(self) -> QMenu | None:
        """Return the menu of the current row; None without one."""
        if self.current_row() is None:
            return None
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.menuAsked.emit(menu)
        return menu

    def header_menu(self) -> QMenu:
        """Return the menu of the header: order and columns."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(tr("Worst verdict first"), self.sort_worst_first)
        menu.addAction(tr("Order of the report"), self.sort_by_program)
        menu.addSeparator()
        for column in (one for one in COPIED if one not in (Column.NAME, Column.VERDICT)):
            action = QAction(translated(HEADERS[column]), menu, checkable=True, checked=not self.isColumnHidden(column))
            action.toggled.connect(lambda shown, column=column: self._choose_column(column, shown))
            menu.addAction(action)
        return menu

    def _show_header_menu(self, place: QPoint) -> None:
        self.header_menu().popup(self.horizontalHeader().mapToGlobal(place))

    def _sort(self, column: int, order: Qt.SortOrder) -> None:
        kept, current = self.selected_ids(), self.current_id()
        self.shown.sort(column, order)
        self._select_ids(kept, current)

    def _sort_keeping(self, kept: list[int], current: int) -> None:
        blocked = self.selectionModel().blockSignals(True)
        self.shown.resort()
        self.selectionModel().blockSignals(blocked)
        self._select_ids(kept, current)

    def _select_ids(self, ids: Sequence[int], current: int) -> None:
        places = {row.id: place for place, row in enumerate(self.shown_rows)}
        model, column = self.selectionModel(), max(0, self.currentIndex().column())
        blocked = model.blockSignals(True)
        model.clearSelection()
        flags = QItemSelectionModel.SelectionFlag.Select | QItemSelectionModel.SelectionFlag.Rows
        for row_id in ids:
            if row_id in places:
                model.select(self.shown.index(places[row_id], 0), flags)
        if current in places:
            model.setCurrentIndex(self.shown.index(places[current], column), QItemSelectionModel.SelectionFlag.NoUpdate)
        model.blockSignals(blocked)
        self.viewport().update()
        self._follow()

    def _fit_columns(self) -> None:
        """Fit the columns to their texts, except those that the user resized."""
        header, letters = self.horizontalHeader(), self.fontMetrics()
        for column in COPIED:
            cell = max((self._width_of(row, column, letters) for row in self.rows), default=0) + (
                SIGN_ROOM if column is Column.VERDICT else 0
            )
            heading = header.fontMetrics().horizontalAdvance(translated(HEADERS[column])) + (SORT_ROOM if column is Column.VERDICT else 0)
            wanted = self._needs[column] = max(cell, heading) + CELL_ROOM
            if column is Column.NAME:  # takes what the others leave
                continue
            if self.columnWidth(column) == self._widths.get(column, self.columnWidth(column)):
                self.setColumnWidth(column, wanted)
                self._widths[column] = self.columnWidth(column)
        self._leave_out_columns()

    def _width_of(self, row: DimensionRow, column: Column, letters: QFontMetrics) -> int:
        if column is Column.TOLERANCE and row.frame is not None:
            return int(frame_width(row.frame, OverlayStyle.of(self._look.theme)))
        width = letters.horizontalAdvance(self.dimensions.shown_text(row, column))
        return min(width, letters.horizontalAdvance(WIDEST_TOLERANCE)) if column is Column.TOLERANCE else width

    @Slot()
    def _follow_look(self) -> None:
        """Draw anew, with the widths that the words of another language need."""
        self._fit_columns()
        self.viewport().update()

    def _follow(self) -> None:
        """Tell which row is current, once."""
        now = self.current_id()
        if now != self._current:
            self._current = now
            self.rowSelected.emit(now)
