"""Question for the unit of a file that is probably not in millimetres; nothing is scaled without an answer."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QDialog, QRadioButton, QWidget

from measureapp.data.length_unit import LengthUnit
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import quantity
from ui.widgets.basic import Button, column, label, row

WIDTH = 480
REASON = "Point and mesh files do not contain a unit. All lengths and verdicts depend on it, so it has to be confirmed."
QUESTIONS = {"points": "In which unit are the points?", "nominal": "In which unit is the nominal?", "mesh": "In which unit is the mesh?"}


class UnitDialog(QDialog):
    """Asks for the unit of one file; `chosen` is emitted with the unit, unless the dialog is cancelled."""

    chosen = Signal(object)  # LengthUnit

    def __init__(
        self, look: Look, what: str, finding: str, likely: LengthUnit, span: float | None = None, parent: QWidget | None = None
    ) -> None:
        """``what``: "points", "nominal" or "mesh"; ``span``: longest side of its bounding box in file units, if known."""
        super().__init__(parent)
        self.setWindowTitle(tr("Unit of lengths"))
        self.units, self._group = {}, QButtonGroup(self)
        for unit in LengthUnit:
            made = QRadioButton(translated(_words(unit, span)))
            made.setAccessibleName(made.text())
            self._group.addButton(made)
            self.units[unit] = made
        self.units[likely].setChecked(True)
        question = label(QUESTIONS[what], "heading")
        evidence = label(tr("{finding}: probably {words}.", finding=finding, words=likely.words), wrap=True)
        self.accept_button = Button("Use this unit", look, "", "primary")
        self.accept_button.clicked.connect(self._accept)
        self.accept_button.setDefault(True)
        cancel = Button("Cancel", look, "", "normal", "Change nothing")
        cancel.clicked.connect(self.reject)
        choices = column(*self.units.values(), spacing=4)
        reason = label(REASON, "small", wrap=True)
        layout = column(question, evidence, 8, choices, 8, reason, 8, row(0, cancel, self.accept_button), margin=24)
        self.setLayout(layout)
        self.setFixedWidth(WIDTH)
        self.setModal(True)

    def value(self) -> LengthUnit:
        """Return the chosen unit."""
        return next(unit for unit, made in self.units.items() if made.isChecked())

    def _accept(self) -> None:
        self.accept()
        self.chosen.emit(self.value())


def _words(unit: LengthUnit, span: float | None) -> str:
    """Return the label of a unit, with the resulting size of the part."""
    words = tr("{words:upper}", words=unit.words)
    return (
        words
        if span is None
        else tr(
            "{words} – the longest side is {quantity}",
            words=words,
            quantity=quantity(span * unit.in_mm, "mm", 1 if span * unit.in_mm < 1e4 else 0),
        )
    )
