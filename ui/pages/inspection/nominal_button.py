"""Button to choose the nominal of the part."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFileDialog

from measureapp.data.length_unit import LengthUnit
from ui.controllers.programming import NominalQuestion, ProgrammingController
from ui.look.look import Look
from ui.widgets.basic import Button
from ui.widgets.unit_dialog import UnitDialog

FILES = "Nominals (*.stl *.ply *.obj *.step *.stp)"
TIP = "Choose the nominal of the part: a mesh or a STEP file"


class NominalButton(Button):
    """Asks for a file, and for its unit if it is doubtful."""

    def __init__(self, look: Look, programming: ProgrammingController) -> None:
        super().__init__("Nominal…", look, "open", "quiet", TIP)
        self._look, self._programming, self.dialog = look, programming, None
        self.clicked.connect(self._choose)
        programming.unitAsked.connect(self._ask)

    def _choose(self) -> None:
        chosen, _ = QFileDialog.getOpenFileName(self, "Choose the nominal", str(Path.home()), FILES)
        if chosen:
            self._programming.set_nominal(Path(chosen))

    @Slot(object)
    def _ask(self, asked: NominalQuestion) -> None:
        question = asked.question
        dialog = self.dialog = UnitDialog(self._look, question.what, question.finding, LengthUnit(question.unit), parent=self)
        dialog.chosen.connect(lambda unit: self._programming.set_nominal(asked.path, unit))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
