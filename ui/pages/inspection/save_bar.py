"""Bar below the table: edits that are not saved, with undo and the ways to save them."""

from __future__ import annotations

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QFrame

from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.look.look import Look
from ui.settings.dialogs import choose_new
from ui.widgets.basic import Button, ElidedLabel, row

UNSAVED = "Program edited, not saved"
MEASURING = "Measuring what has changed…"
STALE = "Results are stale"
STALE_TIP = "The inspection program has changed since they were measured"
PROGRAMS = "Inspection programs (*.toml)"


class SaveBar(QFrame):
    """Visible while the program has edits that are not saved, or results that are stale."""

    def __init__(self, look: Look, programming: ProgrammingController) -> None:
        super().__init__()
        self.setObjectName("sunken")
        self._programming, self._is_away = programming, False
        self.words = ElidedLabel(UNSAVED, "strong")
        self.redo = Button("", look, "redo", "quiet", "Redo (Ctrl+Y)")
        self.again = Button("Measure again", look, "again", "quiet", "Measure everything that is stale")
        self.save_as = Button("Save as…", look, "", "quiet", "Save the program to a file of its own")
        self.save = Button("Save program", look, "", "primary", "Save program, results and report with the project (Ctrl+S)")
        self.redo.clicked.connect(programming.redo)
        self.again.clicked.connect(programming.measure)
        self.save.clicked.connect(programming.save)
        self.save_as.clicked.connect(self._choose)
        layout = row(self.words, self.redo, self.again, self.save_as, self.save, margin=8)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        programming.changed.connect(self.show_state)
        self.show_state()

    def keep_away(self, away: bool) -> None:
        """Leave the room to something else, or show the state again."""
        if away != self._is_away:
            self._is_away = away
            self.show_state()

    @Slot()
    def show_state(self) -> None:
        """Show what is not saved, being measured or stale."""
        programming = self._programming
        stale = programming.state is not None and not programming.is_current and not programming.is_measuring
        self.setVisible((programming.is_modified or stale or programming.is_measuring) and not self._is_away)
        self.words.set_words(MEASURING if programming.is_measuring else STALE if stale else UNSAVED)
        if stale:
            self.words.setToolTip(tr(STALE_TIP))
        self.again.setVisible(stale)
        self.redo.setVisible(programming.stack.canRedo())
        for button in (self.save, self.save_as):
            button.setVisible(programming.is_modified)
            button.setEnabled(programming.can_change)

    @Slot()
    def _choose(self) -> None:
        chosen = choose_new(self, "Save the inspection program", "program.toml", "programs", PROGRAMS)
        if chosen is not None:
            self._programming.save_as(chosen)
