"""Tools to change the inspection program: dimension bar, text editor, and nominal."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QWidget

from measureapp.data.length_unit import LengthUnit
from ui.controllers.controllers import Controllers
from ui.controllers.nominal import NominalController
from ui.controllers.program_jobs import NominalQuestion
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.inspection.dimension_bar import DimensionBar
from ui.pages.inspection.program_dialog import ProgramDialog
from ui.session import Session
from ui.settings.dialogs import choose_file
from ui.widgets.basic import Button
from ui.widgets.unit_dialog import UnitDialog

if TYPE_CHECKING:
    from measureapp.data.measurement import Inspection
    from ui.controllers.growing import GrownFeature
    from ui.controllers.program_rows import DimensionRow

NOMINAL_FILES = "Nominals (*.stl *.ply *.obj *.step *.stp)"
NOMINAL_TIP = "Choose the nominal of the part: a mesh or a STEP file"
PROGRAM_TIP = "Edit the inspection program as text: alignment, features, dimensions"


class NominalButton(Button):
    """Asks for a file, and for its unit if it is doubtful."""

    def __init__(self, look: Look, nominal: NominalController) -> None:
        super().__init__("Nominal…", look, "open", "quiet", NOMINAL_TIP)
        self._look, self._nominal, self.dialog = look, nominal, None
        self.clicked.connect(self._choose)
        nominal.unitAsked.connect(self._ask)

    def _choose(self) -> None:
        chosen = choose_file(self, "Choose the nominal", NOMINAL_FILES, "nominals")
        if chosen is not None:
            self._nominal.use(chosen)

    @Slot(object)
    def _ask(self, asked: NominalQuestion) -> None:
        question = asked.question
        dialog = self.dialog = UnitDialog(self._look, question.what, question.finding, LengthUnit(question.unit), parent=self)
        dialog.chosen.connect(lambda unit: self._nominal.use(asked.path, unit))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()


class ProgramTools(QObject):
    """Available to engineers for a measured project on disk."""

    def __init__(self, look: Look, session: Session, controllers: Controllers, page: QWidget) -> None:
        super().__init__(page)
        self._session, self.programming = session, controllers.programming
        programming = self.programming
        self.bar, self.nominal, self.dialog = (
            DimensionBar(look),
            NominalButton(look, controllers.nominal),
            ProgramDialog(look, programming, page),
        )
        self.text = Button("Program…", look, "report", "quiet", PROGRAM_TIP)
        self.text.clicked.connect(self.dialog.show_program)
        self.bar.asked.connect(self._add_dimension)
        self._added = ""  # the last added dimension, until it is measured

    @property
    def is_offered(self) -> bool:
        """Whether the program may be changed."""
        return self._session.measurement is not None and self._session.role == "engineer"

    def show_state(self) -> None:
        """Show and enable the buttons as available."""
        for button in (self.text, self.nominal, self.bar.button):
            button.setEnabled(self.programming.can_change)
            button.setVisible(self.is_offered)
        if not self.is_offered:
            self.bar.button.setChecked(False)

    def show_inspection(self, inspection: Inspection) -> None:
        """Offer the measured features."""
        self.bar.show_features([feature.name for feature in inspection.features], [found.name for found in inspection.dimensions])

    def newest(self, rows: Sequence[DimensionRow]) -> int | None:
        """Return the number of the dimension that was added last, once."""
        found = next((row.id for row in rows if row.name == self._added), None)
        self._added = self._added if found is None else ""
        return found

    def add_feature(self, grown: GrownFeature) -> None:
        """Add a grown feature to the program."""
        self.programming.add(grown.entry, sentence_case(grown.feature.name))

    def _add_dimension(self) -> None:
        wanted = self.bar.value()
        self._added = wanted.name
        self.programming.add(wanted.lines, sentence_case(wanted.name))
