"""Text editor of the inspection program."""

from __future__ import annotations

from PySide6.QtCore import Slot
from PySide6.QtGui import QFontDatabase, QTextCursor
from PySide6.QtWidgets import QDialog, QPlainTextEdit, QWidget

from measureapp.errors import InputError
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row

HOW = "Features and dimensions in TOML; the help of the Inspect page lists all options."
DRAFT = "Changes of before that were not measured yet. Ctrl+Z shows the program as it is."
SIZE = (760, 640)


class ProgramDialog(QDialog):
    """Edits the program of the open project; "Measure again" checks it first and reports the wrong entry.

    Changes outlive a closed dialog, as Esc is pressed by mistake, until the program is another.
    """

    def __init__(self, look: Look, programming: ProgrammingController, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Inspection program"))
        self._programming = programming
        self._edited = ""  # the program whose changes are kept
        self.text = QPlainTextEdit()
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setAccessibleName(tr("Inspection program"))
        self.text.setTabChangesFocus(True)
        self.problem = label("", wrap=True)
        self.measure = Button("Measure again", look, "again", "primary", "Check the program and measure what has changed")
        self.measure.clicked.connect(self._measure)
        close = Button("Close", look, "", "normal", "Changes are kept for the next time, and measured only then")
        close.clicked.connect(self.reject)
        self.setLayout(
            column(
                label("Inspection program", "title"), label(HOW, "soft"), self.text, self.problem, row(0, close, self.measure), margin=24
            )
        )
        self.resize(*SIZE)

    def show_program(self) -> None:
        """Show the program of the project, with changes of before that were not measured."""
        program, draft = self._programming.text(), self.text.toPlainText()
        is_kept = program == self._edited and draft != program
        self._edited = program
        self.text.setPlainText(program)
        self.problem.setVisible(is_kept)
        if is_kept:
            cursor = self.text.textCursor()
            cursor.select(QTextCursor.SelectionType.Document)
            cursor.insertText(draft)
            self.problem.setText(tr(DRAFT))
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
