"""Actions on rows of the table of dimensions: duplicate, delete, move, copy; by menu and by key."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QMenu

from measureapp.data.control_frame import CHARACTERISTICS
from ui.controllers.program_rows import DimensionRow, ProgramEntries
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import several
from ui.pages.inspection.cell_edits import apply_edit, one_after_the_other
from ui.pages.inspection.dimension_model import CellEdit, Column
from ui.pages.inspection.dimension_table import DimensionTable

if TYPE_CHECKING:
    from measureapp.data.dimension_program import DimensionProgram
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.length_certificate import LengthCertificate
    from measureapp.inspection.session.graph import Node


class RowActions(QObject):
    """Edits the program by actions on the selected rows."""

    toleranceAsked = Signal()  # a new geometrical tolerance

    def __init__(self, look: Look, table: DimensionTable, programming: ProgrammingController) -> None:
        super().__init__(table)
        self._look, self._table, self._programming = look, table, programming
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
        from measureapp.inspection.programming import edits

        nodes, names = self._nodes(), list[str]()

        def change(program: InspectionProgram) -> InspectionProgram:
            for node in nodes:
                program, name = edits.duplicate(program, node)
                names.append(name)
            return program

        if nodes and self._programming.edit(change, tr("{dimensions} duplicated.", dimensions=several(len(nodes), "dimension"))):
            self._select_named(names[-1])

    def remove(self) -> None:
        """Delete the selected dimensions."""
        self._programming.remove(ProgramEntries("dimension", tuple(row.name for row in self.chosen)))

    def move(self, steps: int) -> None:
        """Move the selected dimensions up or down in the order of the report, which is shown then."""
        from measureapp.inspection.programming import edits

        order = [row.name for row in self._table.rows]
        nodes = sorted(self._nodes(), key=lambda node: order.index(node.name), reverse=steps > 0)
        if nodes:
            self._table.sort_by_program()
            changes = [lambda program, node=node: edits.move(program, node, steps) for node in nodes]
            self._programming.edit(one_after_the_other(changes), "Order of the dimensions changed.")

    def restore_nominal(self) -> None:
        """Let the nominals follow the nominal features again."""
        from measureapp.inspection.programming import edits

        changes = [lambda program, name=row.name: edits.link_nominal(program, name) for row in self.chosen if not row.is_zone]
        if changes:
            self._programming.edit(one_after_the_other(changes), "The nominal follows the nominal features again.")

    def edit_frame(self) -> None:
        """Edit the control frame of the current row."""
        name = self._current_frame()
        if name:
            self._table.frameAsked.emit(name)

    def certify(self) -> None:
        """Ask for the certificate of the current length."""
        entry = self._current_length()
        if entry is None:
            return
        from ui.pages.inspection.certificate_dialog import CertificateDialog

        self.dialog = CertificateDialog(self._look, entry, self._table.window())
        self.dialog.chosen.connect(lambda length_mm, certificate: self._certify(entry.name, length_mm, certificate))
        self.dialog.open()

    def _certify(self, name: str, length_mm: float, certificate: LengthCertificate | None) -> None:
        from measureapp.inspection.programming import edits

        done = tr("Lengths are corrected by {name}.", name=name) if certificate else tr("{name} corrects no lengths any more.", name=name)
        self._programming.edit(lambda program: edits.set_certificate(program, name, length_mm, certificate), done)

    def _current_length(self) -> DimensionProgram | None:
        """Return the entry of the current row if it is a length that can be certified."""
        row = self._table.current_row()
        return row.entry if row is not None and row.entry is not None and row.entry.is_single_length else None

    def _current_frame(self) -> str:
        """Return the name of the current row if it has a control frame."""
        row = self._table.current_row()
        return "" if row is None or row.entry is None or row.entry.kind not in CHARACTERISTICS else row.name

    def set_tolerance(self, text: str) -> None:
        """Set one tolerance for all selected dimensions."""
        apply_edit(self._programming, self._table.rows, CellEdit(tuple(row.id for row in self.chosen), Column.TOLERANCE, text))

    def _fill(self, menu: QMenu) -> None:
        can = bool(self.chosen) and self._programming.can_change
        edits = (
            ("Rename", "F2", lambda: self._table.edit_cell(Column.NAME)),
            ("Edit the nominal", "", lambda: self._table.edit_cell(Column.NOMINAL)),
            ("Edit the tolerance", "", lambda: self._table.edit_cell(Column.TOLERANCE)),
            ("Edit the tolerance frame…", "", self.edit_frame),
            ("New geometrical tolerance…", "", self.toleranceAsked.emit),
            ("Restore the nominal of the CAD features", "", self.restore_nominal),
            ("Certified length…", "", self.certify),
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
            action = menu.addAction(translated(words), act)
            action.setShortcut(QKeySequence(key))
            action.setEnabled(can)
            if act == self.edit_frame:
                action.setEnabled(can and self._current_frame() != "")
            if act == self.certify:
                action.setEnabled(can and self._current_length() is not None)
            if act == self.restore_nominal:
                action.setEnabled(can and any(not row.is_zone and not row.is_linked for row in self.chosen))
        menu.addSeparator()
        copied = menu.addAction(tr("Copy rows"), self._table.copy)
        copied.setShortcut(QKeySequence(QKeySequence.StandardKey.Copy))
        closer = menu.addAction(tr("Zoom to its features"), self._table.closerAsked.emit)
        closer.setShortcut(QKeySequence(Qt.Key.Key_Return))

    def _nodes(self) -> list[Node]:
        from measureapp.inspection.session.graph import Node

        return [Node("dimension", row.name) for row in self.chosen]

    def _select_named(self, name: str) -> None:
        row = next((row for row in self._table.rows if row.name == name), None)
        if row is not None:
            self._table.select(row.id)
