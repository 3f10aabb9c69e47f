"""Actions on rows of the table of dimensions: duplicate, delete, move, copy; by menu and by key."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QMenu

from ui.controllers.program_rows import DimensionRow
from ui.controllers.programming import ProgrammingController
from ui.look.wording import several
from ui.pages.inspection.cell_edits import free_name
from ui.pages.inspection.dimension_model import CellEdit, Column
from ui.pages.inspection.dimension_table import DimensionTable


class RowActions(QObject):
    """Edits the program by actions on the selected rows."""

    def __init__(self, table: DimensionTable, programming: ProgrammingController) -> None:
        super().__init__(table)
        self._table, self._programming = table, programming
        table.menuAsked.connect(self._fill)
        keys: dict[QKeySequence, Callable[[], None]] = {
            QKeySequence(Qt.Key.Key_Delete): self.remove,
            QKeySequence("Ctrl+D"): self.duplicate,
            QKeySequence("Alt+Up"): lambda: self.move(-1),
            QKeySequence("Alt+Down"): lambda: self.move(1),
        }
        for key, act in keys.items():
            QShortcut(key, table, act, context=Qt.ShortcutContext.WidgetShortcut)

    @property
    def chosen(self) -> list[DimensionRow]:
        """The selected rows that can be edited, in the order shown."""
        ids = self._table.selected_ids()
        return [row for row in self._table.shown_rows if row.id in ids and row.entry is not None]

    def duplicate(self) -> None:
        """Insert a copy of each selected dimension behind it."""
        from measureapp.project.program_edit import duplicate_entry

        taken = [row.name for row in self._table.rows]
        copies = []
        for row in self.chosen:
            copies.append((row.name, free_name(row.name, taken)))
            taken.append(copies[-1][1])

        def change(text: str) -> str:
            for name, new in copies:
                text = duplicate_entry(text, name, new)
            return text

        if copies and self._programming.edit(change, f"{several(len(copies), 'dimension')} duplicated."):
            self._select_named(copies[-1][1])

    def remove(self) -> None:
        """Delete the selected dimensions."""
        from measureapp.project.program_text import remove_entry

        names = [row.name for row in self.chosen]

        def change(text: str) -> str:
            for name in names:
                text = remove_entry(text, name)
            return text

        if names:
            self._programming.edit(change, f"{several(len(names), 'dimension')} deleted.")

    def move(self, steps: int) -> None:
        """Move the selected dimensions up or down in the order of the report, which is shown then."""
        from measureapp.project.program_edit import move_entry

        names = [row.name for row in self.chosen]
        order = [row.name for row in self._table.rows]
        names.sort(key=order.index, reverse=steps > 0)

        def change(text: str) -> str:
            for name in names:
                text = move_entry(text, name, steps)
            return text

        if names:
            self._table.sort_by_program()
            self._programming.edit(change, "Order of the dimensions changed.")

    def restore_nominal(self) -> None:
        """Set the nominals to those of the CAD model."""
        from measureapp.project.program_edit import change_entry

        wanted = [(row.name, row.drawing) for row in self.chosen if row.drawing is not None and not row.is_linked]

        def change(text: str) -> str:
            for name, value in wanted:
                text = change_entry(text, name, {"nominal": value})
            return text

        if wanted:
            self._programming.edit(change, "Nominal set to that of the CAD model.")

    def set_tolerance(self, text: str) -> None:
        """Set one tolerance for all selected dimensions."""
        from ui.pages.inspection.cell_edits import apply_edit

        apply_edit(self._programming, self._table.rows, CellEdit(tuple(row.id for row in self.chosen), Column.TOLERANCE, text))

    def _fill(self, menu: QMenu) -> None:
        can = bool(self.chosen) and self._programming.can_change
        edits = (
            ("Rename", "F2", lambda: self._table.edit_cell(Column.NAME)),
            ("Edit the nominal", "", lambda: self._table.edit_cell(Column.NOMINAL)),
            ("Edit the tolerance", "", lambda: self._table.edit_cell(Column.TOLERANCE)),
            ("Restore the nominal of the CAD model", "", self.restore_nominal),
            ("", "", None),
            ("Duplicate", "Ctrl+D", self.duplicate),
            ("Delete", "Del", self.remove),
            ("Move up", "Alt+Up", lambda: self.move(-1)),
            ("Move down", "Alt+Down", lambda: self.move(1)),
        )
        for words, key, act in edits:
            if act is None:
                menu.addSeparator()
                continue
            action = menu.addAction(words, act)
            action.setShortcut(QKeySequence(key))
            action.setEnabled(can)
            if act == self.restore_nominal:
                action.setEnabled(can and any(row.drawing is not None and not row.is_linked for row in self.chosen))
        menu.addSeparator()
        copied = menu.addAction("Copy rows", self._table.copy)
        copied.setShortcut(QKeySequence(QKeySequence.StandardKey.Copy))
        closer = menu.addAction("Zoom to its features", self._table.closerAsked.emit)
        closer.setShortcut(QKeySequence(Qt.Key.Key_Return))

    def _select_named(self, name: str) -> None:
        row = next((row for row in self._table.rows if row.name == name), None)
        if row is not None:
            self._table.select(row.id)
