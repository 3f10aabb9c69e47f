"""All shortcuts, by page."""

from __future__ import annotations

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QWidget

from ui.actions.actions import EVERYWHERE, Actions
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import column, label
from ui.widgets.data_table import Cell, DataTable


class ShortcutList(QDialog):
    """Lists what the keys do."""

    def __init__(self, look: Look, actions: Actions, contexts: dict[str, str], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Shortcuts"))
        self.resize(640, 560)
        self._actions, self._contexts = actions, contexts
        self.table = DataTable(look, ["Keys", "Command", "Where"], stretch=1)
        self.setLayout(column(label("Shortcuts", "title"), self.table, margin=24, spacing=16))

    def begin(self) -> None:
        """Show the present list."""
        bound = [action for action in self._actions.all() if action.shortcut]
        bound.sort(key=lambda action: action.context != EVERYWHERE)
        self.table.set_rows(
            [
                [
                    Cell(QKeySequence(action.shortcut).toString(QKeySequence.SequenceFormat.NativeText), bold=True),
                    Cell(action.text),
                    Cell(self._contexts.get(action.context, "Everywhere"), soft=True),
                ]
                for action in bound
            ]
        )
        self.show()
        self.raise_()
