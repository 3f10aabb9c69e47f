"""Asks for another name of a feature."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QLineEdit, QWidget

from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.inspection.asking import ask_in
from ui.widgets.basic import Button, label


class RenameDialog(QDialog):
    """Takes a name; one that is refused stays in the dialog with the reason."""

    chosen = Signal(str)

    def __init__(self, look: Look, name: str, refusal: Callable[[str], str], parent: QWidget | None = None) -> None:
        """``refusal`` returns why a name cannot be used; empty: it can."""
        super().__init__(parent)
        self.setWindowTitle(tr("Rename"))
        self._refusal = refusal
        self.line, self.problem = QLineEdit(name), label("", "small", wrap=True)
        self.line.setAccessibleName(tr("Name"))
        self.line.selectAll()
        self.use = Button("Rename", look, "", "primary", "All that refers to the feature follows; it can be undone")
        self.use.clicked.connect(self._use)
        self.line.textChanged.connect(self._show)
        ask_in(self, look, name, [self.line, self.problem], self.use)
        self._show()

    def _show(self) -> None:
        problem = self._refusal(self.line.text())
        self.problem.setText(translated(problem))
        self.use.setEnabled(not problem)

    def _use(self) -> None:
        self.accept()
        self.chosen.emit(self.line.text().strip())
