"""The command palette: type a few letters of what you want, press Enter. It lists the actions, and buttons and menus of the page."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QDialog, QLineEdit, QWidget

from ui.actions.actions import Action, Actions
from ui.actions.of_page import PageActions
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.widgets.basic import column, label
from ui.widgets.data_table import Cell, DataTable

SIZE = (640, 420)
MOVES = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1, Qt.Key.Key_PageDown: 8, Qt.Key.Key_PageUp: -8}


class CommandPalette(QDialog):
    """Lists all actions with their shortcuts; those that cannot be used say why."""

    def __init__(
        self, look: Look, actions: Actions, contexts: dict[str, str], parent: QWidget, page: Callable[[], tuple[str, QWidget]]
    ) -> None:
        """``contexts``: words of the pages by their names; ``page``: name and widget of the one shown."""
        super().__init__(parent)
        self.setWindowTitle(tr("Commands"))
        self.setMinimumSize(*SIZE)
        self._actions, self._contexts, self._page = actions, contexts, page
        self._of_page = PageActions()
        self._shown: tuple[Action, ...] = ()
        self.line = QLineEdit()
        self.line.setPlaceholderText(tr("Type what you want to do"))
        self.line.setAccessibleName(tr("Search for a command"))
        self.table = DataTable(look, ["Command", "Where", "Keys"], stretch=0)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.hint = label("", "small", wrap=True)
        self.setLayout(column(self.line, self.table, self.hint, margin=16, spacing=8))
        self.line.textChanged.connect(self._search)
        self.line.returnPressed.connect(self._run)
        self.line.installEventFilter(self)
        self.table.rowSelected.connect(self._explain)
        self.table.doubleClicked.connect(self._run)

    def begin(self) -> None:
        """Show all actions and wait for letters."""
        self._of_page.collect(*self._page(), self._actions.all())
        self.line.clear()
        self._search("")
        self.open()
        self.line.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Move through the list with the arrow keys while the letters keep the focus."""
        if watched is self.line and isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = MOVES.get(Qt.Key(event.key()))
            if step is not None and self._shown:
                row = self.table.currentIndex().row() + step
                self.table.selectRow(min(max(row, 0), len(self._shown) - 1))
                return True
        return super().eventFilter(watched, event)

    def _search(self, typed: str) -> None:
        self._shown = self._actions.find(typed, self._of_page.actions)
        self.table.set_rows([self._cells(action) for action in self._shown])
        if self._shown:
            self.table.selectRow(0)
        else:
            self.hint.setText(tr("Nothing fits. Try other words."))

    def _cells(self, action: Action) -> list[Cell]:
        reason = self._actions.reason(action)
        keys = QKeySequence(action.shortcut).toString(QKeySequence.SequenceFormat.NativeText) if action.shortcut else ""
        return [
            Cell(action.text, soft=bool(reason), tip=reason),
            Cell(self._contexts.get(action.context, ""), soft=True),
            Cell(keys, soft=True),
        ]

    def _explain(self, row: int) -> None:
        if 0 <= row < len(self._shown):
            self.hint.setText(translated(self._actions.reason(self._shown[row])))

    def _run(self, *_: object) -> None:
        row = self.table.currentIndex().row()
        if not 0 <= row < len(self._shown):
            return
        chosen = self._shown[row]
        if self._actions.reason(chosen):
            self.hint.setText(translated(self._actions.reason(chosen)))
            return
        self.accept()
        self._actions.run(chosen)
