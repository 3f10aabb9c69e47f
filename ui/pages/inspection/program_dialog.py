"""Text editor of the inspection program."""

from __future__ import annotations

from PySide6.QtCore import Slot
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QDialog, QPlainTextEdit, QWidget

from measureapp.errors import InputError
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row

HOW = "Features and dimensions in TOML; the help of the Inspect page lists all options."
SIZE = (760, 640)


class ProgramDialog(QDialog):
    """Edits the program of the open project; "Measure again" checks it first and reports the wrong entry."""

    def __init__(self, look: Look, programming: ProgrammingController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Inspection program"))
        self._programming = programming
        self.text = QPlainTextEdit()
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setAccessibleName(tr("Inspection program"))
        self.text.setTabChangesFocus(True)
        self.problem = label("", wrap=True)
        self.measure = Button("Measure again", look, "again", "primary", "Check the program and measure what has changed")
        self.measure.clicked.connect(self._measure)
        close = Button("Close", look, "", "normal", "Discard the changes")
        close.clicked.connect(self.reject)
        self.setLayout(
            column(
                label("Inspection program", "title"), label(HOW, "soft"), self.text, self.problem, row(0, close, self.measure), margin=24
            )
        )
        self.resize(*SIZE)

    def show_program(self) -> None:
        """Show the program of the project."""
        self.text.setPlainText(self._programming.text())
        self.problem.hide()
        self.open()

    @Slot()
    def _measure(self) -> None:
        try:
            self._programming.replace(self.text.toPlainText())
        except InputError as error:
            self.problem.setText(str(error))
            self.problem.show()
        else:
            self.accept()
