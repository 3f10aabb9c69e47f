"""A notice that the results have an alignment which nobody chose."""

from __future__ import annotations

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFrame

from ui.controllers.programming import ProgrammingController
from ui.look.look import Look
from ui.widgets.basic import Button, label, row

WORDS = "No alignment was chosen: a best fit was used, which spreads defects over the whole part."
TIP = "Align by datums, 3-2-1 or reference points. To keep the best fit, state it in the text of the program."


class NoAlignment(QFrame):
    """Says so while the program states no alignment, and offers to choose one."""

    def __init__(self, look: Look, programming: ProgrammingController) -> None:
        super().__init__()
        self.setObjectName("card")
        self._programming = programming
        self.words = label(WORDS, "problem", wrap=True)
        self.choose = Button("Choose…", look, "", "quiet", TIP)
        content = row(self.words, self.choose, margin=8, spacing=8)
        content.setStretch(0, 1)
        self.setLayout(content)
        self.hide()
        programming.changed.connect(self.show_program)

    @Slot()
    def show_program(self) -> None:
        """Show the notice if the program at hand has the default alignment, not a stated one."""
        state = self._programming.state
        self.setVisible(state is not None and bool(state.program.dimensions) and "alignment" not in state.program.model_fields_set)
