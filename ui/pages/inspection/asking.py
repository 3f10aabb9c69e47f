"""What all dialogs have that ask for one thing about a feature."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QDialog, QLayout, QWidget

from ui.look.look import Look
from ui.look.wording import sentence_case
from ui.widgets.basic import Button, column, label, row

WIDTH = 420


def ask_in(dialog: QDialog, look: Look, name: str, asked: Sequence[QWidget | QLayout], use: Button) -> None:
    """Lay out a dialog: the feature's name, what is asked, and a button that uses it beside one that changes nothing."""
    use.setDefault(True)
    cancel = Button("Cancel", look, "", "normal", "Change nothing")
    cancel.clicked.connect(dialog.reject)
    dialog.setLayout(column(label(sentence_case(name), "heading"), *asked, 8, row(0, cancel, use), margin=24))
    dialog.setFixedWidth(WIDTH)
    dialog.setModal(True)
