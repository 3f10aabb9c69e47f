"""PIN screen: a number pad for touch, and a field for passwords typed on a keyboard."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QGridLayout, QLineEdit, QWidget

from ui.controllers.operator_roles import RoleController
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.pages.operator.big import BigButton, big_card, big_label
from ui.widgets.basic import column, row

KEYS = ("1", "2", "3", "4", "5", "6", "7", "8", "9", "⌫", "0", "OK")
FORGOTTEN = "PIN forgotten? Run this command on this computer, then set a new one: measureapp gui --reset-engineer-pin"


class PinScreen(QWidget):
    """Asks for the engineer's PIN."""

    backClicked = Signal()

    def __init__(self, look: Look, roles: RoleController) -> None:
        super().__init__()
        self._roles = roles
        self.field = QLineEdit()
        self.field.setEchoMode(QLineEdit.EchoMode.Password)
        self.field.setAccessibleName(tr("PIN or password of the engineer"))
        self.field.setMaxLength(200)
        self.problem = big_label("", "error", wrap=True)
        pad = QGridLayout()
        pad.setSpacing(8)
        self.keys = {key: BigButton(key, look, "", "key") for key in KEYS}
        for place, (key, button) in enumerate(self.keys.items()):
            button.clicked.connect(lambda _=False, key=key: self._press(key))  # each press of a digit counts, however fast
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            button.setFixedSize(112, 76)
            pad.addWidget(button, place // 3, place % 3)
        self.back = BigButton("Back to operator mode", look, "unfold")
        words = column(
            big_label("Engineer", "title"),
            big_label("PIN or password"),
            self.field,
            self.problem,
            0,
            big_label(FORGOTTEN, "soft", wrap=True),
            self.back,
            spacing=12,
        )
        both = row(words, pad, spacing=32)
        both.setStretch(0, 1)
        card = big_card(both)
        card.setFixedWidth(920)
        self.setLayout(column(0, row(0, card, 0), 0))
        self.field.returnPressed.connect(self._give)
        self.back.pressedOnce.connect(self.backClicked)
        roles.pinRefused.connect(self._refuse)

    def showEvent(self, event: QShowEvent) -> None:
        """Begin with an empty field."""
        super().showEvent(event)
        self.field.clear()
        self.problem.setText("")
        self.field.setFocus()

    def _press(self, key: str) -> None:
        if key == "OK":
            self._give()
        elif key == "⌫":
            self.field.backspace()
        else:
            self.field.insert(key)

    def _give(self) -> None:
        pin = self.field.text()
        if pin:
            self.keys["OK"].setEnabled(False)
            self._roles.give_pin(pin)

    def _refuse(self, words: str) -> None:
        self.keys["OK"].setEnabled(True)
        self.field.clear()
        self.problem.setText(translated(words))

    def hideEvent(self, event: QHideEvent) -> None:
        """Keep no PIN in the field."""
        super().hideEvent(event)
        self.keys["OK"].setEnabled(True)
        self.field.clear()
