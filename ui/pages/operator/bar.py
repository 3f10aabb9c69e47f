"""Top bar of operator mode: where one is, the rig, the way to the engineer; and the call for the engineer below it."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QApplication, QFrame

from ui.controllers.operator_nouns import Step
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.operator.big import BigButton, big_label, short_label
from ui.session import Session
from ui.widgets.basic import row

HEIGHT = 64
STEPS: dict[Step, str] = {"home": "Part", "identify": "Identify", "load": "Load", "run": "Measure", "verdict": "Verdict"}
LONGEST = 160  # characters of what a call is about; the screen says the rest
CALLED = "Engineer called at {time:%H:%M}. {what}"


class OperatorBar(QFrame):
    """Part, steps, rig; home and engineer as buttons."""

    homeClicked = Signal()
    engineerClicked = Signal()

    def __init__(self, look: Look, session: Session) -> None:
        super().__init__()
        self.setObjectName("operator-bar")
        self.setFixedHeight(HEIGHT)
        self._look, self._session = look, session
        self.home, self.part = BigButton("Part programs", look, "home", "quiet"), short_label("", "strong")
        self._steps = {step: big_label(words, "soft") for step, words in STEPS.items()}
        self.rig = big_label("", "soft")
        self.engineer = BigButton("Engineer…", look, "person", "quiet")
        steps = [
            widget
            for number, shown in enumerate(self._steps.values())
            for widget in (*((big_label("›", "soft"),) if number else ()), shown)
        ]
        layout = row(self.home, self.part, 0, *steps, 0, self.rig, self.engineer, spacing=12)
        layout.setContentsMargins(12, 0, 12, 0)
        self.setLayout(layout)
        self.home.pressedOnce.connect(self.homeClicked)
        self.engineer.pressedOnce.connect(self.engineerClicked)
        session.rigChanged.connect(self._show_rig)
        session.cellChanged.connect(self._show_rig)
        self._show_rig()

    def show_step(self, step: Step, part: str) -> None:
        """Show where one is, and the name of the part; there is no way home out of a running measurement."""
        for name, shown in self._steps.items():
            shown.setProperty("op", "strong" if name == step else "soft")
            shown.style().polish(shown)
        self.part.set_words(part)
        self.home.setEnabled(step not in ("home", "run"))

    def _show_rig(self) -> None:
        rig, cell = self._session.rig, self._session.cell
        self.rig.setText(tr("No rig") if rig is None else tr("Rig stopped") if cell.stopped else translated(rig.name))


class CallBar(QFrame):
    """Says since when the engineer is wanted, and why."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("operator-call")
        self.words = big_label("", "strong", wrap=True)
        self.end = BigButton("Done", look, "", "quiet")
        layout = row(self.words, self.end)
        layout.setContentsMargins(24, 8, 12, 8)
        layout.setStretch(0, 1)
        self.setLayout(layout)
        self.end.pressedOnce.connect(self.hide)
        self.hide()

    def call(self, what: str) -> None:
        """Call the engineer, with what it is about."""
        self.words.setText(tr(CALLED, time=datetime.now(), what=shortened(what)).strip())
        self.show()
        QApplication.beep()


def shortened(words: str) -> str:
    """Return the beginning of a text that is too long for a bar.

    >>> len(shortened("No camera answers. " * 20)) <= LONGEST + 1
    True
    """
    return words if len(words) <= LONGEST else words[:LONGEST].rstrip(" ,.;:") + "…"
