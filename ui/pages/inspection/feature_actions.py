"""Actions on the selected features of the list: rename, delete; by menu and by key."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QMenu

from measureapp.errors import MeasureError
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.inspection.distance_dialog import DistanceDialog
from ui.pages.inspection.feature_table import FeatureTable
from ui.pages.inspection.rename_dialog import RenameDialog

if TYPE_CHECKING:
    from measureapp.data.feature_program import ConstructedFeature
    from measureapp.data.inspection_program import FeatureProgram


class FeatureActions(QObject):
    """Edits the program by actions on the selected features; what a copy of a pattern is asked for is done to the whole pattern."""

    def __init__(self, look: Look, table: FeatureTable, programming: ProgrammingController) -> None:
        super().__init__(table)
        self._look, self._table, self._programming = look, table, programming
        table.menuAsked.connect(self._fill)
        for key, act in ((Qt.Key.Key_F2, self.rename), (Qt.Key.Key_Delete, self.remove)):
            QShortcut(QKeySequence(key), table, act, context=Qt.ShortcutContext.WidgetShortcut)

    def rename(self) -> None:
        """Ask for another name of the selected feature."""
        entries = self._table.entries()
        if len(entries) != 1 or not self._programming.can_change:
            return
        (entry,) = entries
        dialog = self.dialog = RenameDialog(self._look, entry.name, lambda name: self._refusal(entry.name, name), self._table.window())
        dialog.chosen.connect(lambda name: self._rename(entry, name))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def change_distance(self) -> None:
        """Ask for another distance of the selected offset plane or point on an axis."""
        entry = self._with_distance()
        if entry is None or not self._programming.can_change:
            return
        dialog = self.dialog = DistanceDialog(self._look, entry.name, entry.distance_mm, self._table.window())
        dialog.chosen.connect(lambda distance_mm: self._set_distance(entry.name, distance_mm))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _with_distance(self) -> ConstructedFeature | None:
        """Return the selected feature if it is a single one with a distance."""
        entries = self._table.entries()
        (entry,) = entries if len(entries) == 1 else (None,)
        return entry if getattr(entry, "distance_mm", None) is not None else None

    def _set_distance(self, name: str, distance_mm: float) -> None:
        from measureapp.inspection.programming import edits
        from measureapp.inspection.session.graph import Node

        words = tr("{what} of {name} changed.", what="Distance", name=sentence_case(name))
        self._programming.edit(lambda program: edits.change(program, Node("feature", name), {"distance_mm": distance_mm}), words)

    def remove(self) -> None:
        """Delete the selected features; refused where others need them, with their names."""
        self._programming.remove(self._table.program_entries())

    def _refusal(self, former: str, name: str) -> str:
        """Return why a feature cannot be renamed so; empty: it can."""
        from measureapp.inspection.programming import edits
        from measureapp.inspection.session.graph import Node

        state = self._programming.state
        if state is None:
            return ""
        try:
            edits.rename(state.program, Node("feature", former), name)
        except MeasureError as error:
            return error.message
        return ""

    def _rename(self, entry: FeatureProgram, name: str) -> None:
        from measureapp.data.inspection_program import copy_names
        from measureapp.inspection.programming import edits
        from measureapp.inspection.session.graph import Node

        chosen = self._table.names()
        words = tr("{what} of {name} changed.", what="Name", name=sentence_case(entry.name))
        if self._programming.edit(lambda program: edits.rename(program, Node("feature", entry.name), name), words):
            renamed = dict(zip(copy_names(entry.name, entry.repeat), copy_names(name, entry.repeat), strict=True))
            self._table.select_names([renamed.get(one, one) for one in chosen])

    def _fill(self, menu: QMenu) -> None:
        entries, can = self._table.entries(), self._programming.can_change
        patterns = [one.name for one in entries if one.repeat is not None]
        words = tr("Delete the pattern {name}", name=sentence_case(patterns[0])) if len(patterns) == len(entries) == 1 else "Delete"
        menu.addSeparator()
        if self._with_distance() is not None:
            menu.addAction(tr("Distance…"), self.change_distance).setEnabled(can)
        for text, key, act, is_possible in (
            ("Rename…", Qt.Key.Key_F2, self.rename, len(entries) == 1),
            (words, Qt.Key.Key_Delete, self.remove, bool(entries)),
        ):
            action = menu.addAction(translated(text), act)
            action.setShortcut(QKeySequence(key))
            action.setEnabled(can and is_possible)
