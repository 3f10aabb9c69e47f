"""Choosing the drawing that the part is compared with."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFileDialog

from measureapp.data.length_unit import LengthUnit
from ui.controllers.programming import Asked, ProgrammingController
from ui.look.look import Look
from ui.widgets.basic import Button
from ui.widgets.unit_dialog import UnitDialog

FILES = "Drawings (*.stl *.ply *.obj *.step *.stp)"
TIP = "Choose the nominal that the part is compared with: a mesh or a STEP file"


class DrawingButton(Button):
    """Asks for a file, and for its unit where that is doubtful."""

    def __init__(self, look: Look, programming: ProgrammingController) -> None:
        super().__init__("Drawing…", look, "open", "quiet", TIP)
        self._look, self._programming, self.dialog = look, programming, None
        self.clicked.connect(self._choose)
        programming.unitAsked.connect(self._ask)

    def _choose(self) -> None:
        chosen, _ = QFileDialog.getOpenFileName(self, "Choose the drawing", str(Path.home()), FILES)
        if chosen:
            self._programming.take_drawing(Path(chosen))

    @Slot(object)
    def _ask(self, asked: Asked) -> None:
        question = asked.question
        dialog = self.dialog = UnitDialog(self._look, question.what, question.finding, LengthUnit(question.unit), parent=self)
        dialog.chosen.connect(lambda unit: self._programming.take_drawing(asked.path, unit))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
