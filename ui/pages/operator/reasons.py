"""Why a part is measured again: a choice of usual reasons, so that nobody has to type with gloves on."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QWidget

from ui.controllers.operator_nouns import UNREASONED
from ui.look.look import Look
from ui.pages.operator.big import BigButton
from ui.widgets.basic import row

REASONS = {
    "cleaned": "The part was cleaned",
    "clamped again": "It was clamped wrongly",
    "reworked": "It was reworked",
    UNREASONED: "No reason",
}


class ReasonChoice(QWidget):
    """One button for each reason; value(), changed."""

    changed = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._group = QButtonGroup(self)
        self._group.setExclusive(True)
        self.buttons = {reason: BigButton(words, look) for reason, words in REASONS.items()}
        for button in self.buttons.values():
            button.setCheckable(True)
            self._group.addButton(button)
            button.clicked.connect(self.changed)
        self.setLayout(row(*self.buttons.values(), 0, spacing=12))

    def value(self) -> str:
        """Return the chosen reason; empty while none is chosen."""
        return next((reason for reason, button in self.buttons.items() if button.isChecked()), "")

    def clear(self) -> None:
        """Choose none."""
        self._group.setExclusive(False)
        for button in self.buttons.values():
            button.setChecked(False)
        self._group.setExclusive(True)
