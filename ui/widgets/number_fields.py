"""A row of numbers that are entered together and taken over with Enter or when the field is left."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from ui.look.language.words import translated
from ui.widgets.basic import label, row

WIDTH = 68
INVALID = "This is not a number."


class NumberFields(QWidget):
    """Numbers with one unit: value(), setValue(numbers), valueChanged. An invalid entry changes nothing and is marked."""

    valueChanged = Signal(object)  # tuple of numbers

    def __init__(self, names: Sequence[str], unit: str, digits: int) -> None:
        super().__init__()
        self._digits = digits
        self._shown: tuple[float, ...] = ()
        self.lines = [QLineEdit() for _ in names]
        for line, name in zip(self.lines, names, strict=True):
            line.setAlignment(Qt.AlignmentFlag.AlignRight)
            line.setMinimumWidth(WIDTH)
            line.setAccessibleName(translated(name))
            line.setPlaceholderText(translated(name))
            line.setToolTip(translated(name))
            line.editingFinished.connect(self._take)
        self.setLayout(row(*self.lines, label(unit, "soft"), spacing=4))

    def value(self) -> tuple[float, ...]:
        """Return the numbers shown last or entered since; empty while nothing valid is entered."""
        try:
            entered = tuple(float(line.text().replace("\u2212", "-").replace(",", ".")) for line in self.lines)
        except ValueError:
            return ()
        if not all(isfinite(number) for number in entered):
            return ()
        rounded = tuple(float(self._text(number)) for number in self._shown)
        return tuple(
            shown if number == near else number
            for number, near, shown in zip(entered, rounded or entered, self._shown or entered, strict=True)
        )

    def setValue(self, numbers: Sequence[float] | None) -> None:
        """Show numbers; None: they differ, or there are none."""
        self._shown = tuple(numbers or ())
        for place, line in enumerate(self.lines):
            line.setText(translated(self._text(self._shown[place])) if self._shown else "")
            self._mark(line, "")

    def _text(self, number: float) -> str:
        return f"{round(number, self._digits) + 0.0:.{self._digits}f}"

    def _take(self) -> None:
        entered = self.value()
        if not entered and any(line.text().strip() for line in self.lines):
            for line in self.lines:
                self._mark(line, INVALID if line.text().strip() else "")
            return
        for line in self.lines:
            self._mark(line, "")
        if entered and entered != self._shown:
            self._shown = entered
            self.valueChanged.emit(entered)

    def _mark(self, line: QLineEdit, problem: str) -> None:
        line.setToolTip(translated(problem) or translated(line.accessibleName()))
        if line.property("invalid") != bool(problem):
            line.setProperty("invalid", bool(problem))
            line.style().unpolish(line)
            line.style().polish(line)
