"""What changes the inspection program on the Inspect page: buttons, the bar for dimensions, the program as text, the drawing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from ui.controllers.programming import ProgrammingController
from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.pages.inspection.dimension_bar import DimensionBar
from ui.pages.inspection.drawing_button import DrawingButton
from ui.pages.inspection.program_dialog import ProgramDialog
from ui.session import Session
from ui.widgets.basic import Button

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.measurement import Inspection
    from ui.controllers.growing import GrownFeature

TIP = "Change the inspection program as text: alignment, features, dimensions"


class ProgramTools(QObject):
    """Offered to engineers, while there is a measured project on disk."""

    def __init__(self, look: Look, session: Session, programming: ProgrammingController, page: QWidget) -> None:
        super().__init__(page)
        self._session, self.programming = session, programming
        self.bar, self.drawing, self.dialog = DimensionBar(look), DrawingButton(look, programming), ProgramDialog(look, programming, page)
        self.text = Button("Program…", look, "report", "quiet", TIP)
        self.text.clicked.connect(self.dialog.show_program)
        self.bar.asked.connect(self._add_dimension)
        self._added = ""  # the dimension that was added last, until it is measured

    @property
    def is_offered(self) -> bool:
        """Whether the program may be changed here at all."""
        return self._session.measurement is not None and self._session.role == "engineer"

    def show_state(self) -> None:
        """Offer the buttons, or not."""
        for button in (self.text, self.drawing, self.bar.button):
            button.setEnabled(self.programming.can_change)
            button.setVisible(self.is_offered)
        if not self.is_offered:
            self.bar.button.setChecked(False)

    def show_inspection(self, inspection: Inspection) -> None:
        """Offer the features that were found."""
        self.bar.show_features([feature.name for feature in inspection.features], [found.name for found in inspection.dimensions])

    def newest(self, dimensions: Sequence[Dimension]) -> int | None:
        """Return the row of the dimension that was added last, once."""
        place = next((place for place, found in enumerate(dimensions) if found.name == self._added), None)
        self._added = self._added if place is None else ""
        return place

    def add_feature(self, grown: GrownFeature) -> None:
        """Put a feature that grew into the program."""
        self.programming.add(grown.entry, sentence_case(grown.feature.name))

    def _add_dimension(self) -> None:
        wanted = self.bar.value()
        self._added = wanted.name
        self.programming.add(wanted.lines, sentence_case(wanted.name))
