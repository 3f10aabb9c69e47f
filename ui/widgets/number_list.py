"""Any number of numbers in one line, separated by commas."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from ui.look.language.words import tr, translated
from ui.widgets.basic import label, row


class NumberList(QWidget):
    """Numbers separated by commas: value(), setValue(numbers), valueChanged; an empty line is an empty list."""

    valueChanged = Signal(object)  # tuple of numbers

    def __init__(self, name: str, tip: str, unit: str, *, most: int | None = None) -> None:
        super().__init__()
        self._tip, self._most = tip, most
        self._shown: tuple[float, ...] = ()
        self.line = QLineEdit()
        self.line.setAccessibleName(translated(name))
        self.line.setToolTip(translated(tip))
        self.line.editingFinished.connect(self._take)
        self.setLayout(row(self.line, label(unit, "soft"), spacing=4))

    def value(self) -> tuple[float, ...] | None:
        """Return the numbers entered; None if they cannot be read."""
        parts = [part.strip() for part in self.line.text().replace(";", ",").split(",") if part.strip()]
        try:
            numbers = tuple(float(part) for part in parts)
        except ValueError:
            return None
        return numbers if all(isfinite(number) for number in numbers) and len(numbers) <= (self._most or len(numbers)) else None

    def setValue(self, numbers: Sequence[float] | None) -> None:
        """Show numbers; None: none."""
        self._shown = tuple(numbers or ())
        self.line.setText(", ".join(f"{number:.10g}" for number in self._shown))
        self._mark(is_invalid=False)

    def set_default(self, words: str) -> None:
        """Show what applies while the line is empty."""
        self.line.setPlaceholderText(translated(words))

    def _take(self) -> None:
        entered = self.value()
        self._mark(is_invalid=entered is None)
        if entered is not None and entered != self._shown:
            self._shown = entered
            self.valueChanged.emit(entered)

    def _mark(self, *, is_invalid: bool) -> None:
        self.line.setToolTip(tr("This cannot be read. {tip}.", tip=self._tip) if is_invalid else translated(self._tip))
        if self.line.property("invalid") != is_invalid:
            self.line.setProperty("invalid", is_invalid)
            self.line.style().unpolish(self.line)
            self.line.style().polish(self.line)
