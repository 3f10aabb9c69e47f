"""A field for a number with digits after the point."""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import QDoubleSpinBox


class NumberField(QDoubleSpinBox):
    """Takes a comma for the point as well: Qt takes it for a separator of thousands and drops it, which makes 0,05 a 5."""

    def validate(self, text: str, place: int) -> Any:
        """Return whether a text is a number in the range, with its commas as points."""
        return super().validate(text.replace(",", "."), place)

    def valueFromText(self, text: str) -> float:
        """Return the number of a text."""
        return super().valueFromText(text.replace(",", "."))
