"""Repeat screen: why the same part is measured again."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.pages.operator.big import BigButton, big_card, big_label
from ui.pages.operator.reasons import ReasonChoice
from ui.widgets.basic import column, row

COUNTS = "With a reason the new run counts; without one the first run counts. All runs are kept."


class RepeatScreen(QWidget):
    """Asks for the reason."""

    backClicked = Signal()
    repeatClicked = Signal(str)

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.title = big_label("Measure this part again?", "title")
        self.reasons = ReasonChoice(look)
        self.back = BigButton("Back", look, "unfold")
        self.again = BigButton("Measure again", look, "again", "primary")
        card = big_card(big_label("Why is it measured again?", "strong"), self.reasons, big_label(COUNTS, wrap=True))
        layout = column(self.title, card, 0, row(self.back, 0, self.again), spacing=16)
        layout.setContentsMargins(24, 24, 24, 12)
        self.setLayout(layout)
        self.reasons.changed.connect(self._show)
        self.back.pressedOnce.connect(self.backClicked)
        self.again.pressedOnce.connect(lambda: self.repeatClicked.emit(self.reasons.value()))

    def showEvent(self, event: QShowEvent) -> None:
        """Begin without a choice."""
        super().showEvent(event)
        self.reasons.clear()
        self._show()
        next(iter(self.reasons.buttons.values())).setFocus()

    def _show(self) -> None:
        self.again.setEnabled(bool(self.reasons.value()))
