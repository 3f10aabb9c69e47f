"""The values of a feature that is not in the program yet: position, direction and sizes, to be checked and corrected."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from ui.look.language.words import later, translated
from ui.widgets.basic import label
from ui.widgets.number_field import NumberField
from ui.widgets.number_fields import NumberFields

VECTORS = {  # key of an entry, or of its pattern -> words, unit, digits
    "point_mm": (later("Coordinates"), "mm", 3),
    "direction": (later("Direction"), "", 5),
    "along": (later("Long direction"), "", 5),
    "axis_point_mm": (later("Pattern centre"), "mm", 3),
    "step_mm": (later("Step"), "mm", 3),
    "row_step_mm": (later("Step of rows"), "mm", 3),
}
SIZES = {
    "radius_mm": later("Diameter"),
    "width_mm": later("Width"),
    "length_mm": later("Length"),
    "height_mm": later("Slice"),
    "strip_mm": later("Strip"),
    "gap_mm": later("Gap"),
    "count": later("Copies"),
    "angle_deg": later("Angle step"),
}
TIPS = {
    "height_mm": "Height of the slice of the wall that is measured",
    "strip_mm": "Width of the strip of the surface that is measured",
    "gap_mm": "Distance from the edge within which points are not used",
}
IN_PATTERN = ("axis_point_mm", "step_mm", "row_step_mm", "count", "angle_deg")
MOST_MM, MOST_COPIES = 100_000.0, 1000
COLUMNS = 3  # of sizes


class ContourFields(QWidget):
    """Editors of the values that an entry has: value(), setValue(entry), valueChanged."""

    valueChanged = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._entry: dict[str, Any] = {}
        self.vectors = {key: NumberFields(("x", "y", "z"), unit, digits) for key, (_, unit, digits) in VECTORS.items()}
        self.sizes = {key: _field(key, words) for key, words in SIZES.items()}
        self._words: dict[str, QLabel] = {key: label(words, "soft") for key, (words, *_) in VECTORS.items()}
        self._words |= {key: label(words, "soft") for key, words in SIZES.items()}
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        for column in range(COLUMNS):
            grid.setColumnStretch(2 * column + 1, 1)
        self._grid = grid
        self.setLayout(grid)
        for widget in (*self.vectors.values(), *self.sizes.values(), *self._words.values()):
            widget.setParent(self)  # those that the first entry lacks are in no layout yet
            widget.hide()
        for vector in self.vectors.values():
            vector.valueChanged.connect(self.valueChanged)
        for field in self.sizes.values():
            field.valueChanged.connect(self.valueChanged)

    def value(self) -> dict[str, Any]:
        """Return the entry with the values shown, also those whose entry was not completed yet; invalid ones change nothing."""
        made = deepcopy(self._entry)
        for key in self._shown():
            into = made["repeat"] if key in IN_PATTERN else made
            if key in self.vectors:
                entered = self.vectors[key].value()
                into[key] = list(entered) if entered else into[key]
                continue
            field = self.sizes[key]
            number = field.valueFromText(field.cleanText())
            if round(number, field.decimals()) != round(_shown_size(key, into[key]), field.decimals()):
                into[key] = number / 2 if key == "radius_mm" else int(number) if key == "count" else number
        return made

    def setValue(self, entry: dict[str, Any]) -> None:
        """Show the values that an entry has."""
        self._entry = entry
        shown = self._shown()
        for place, vector in enumerate(key for key in VECTORS if key in shown):
            self._grid.addWidget(self._words[vector], place, 0)
            self._grid.addWidget(self.vectors[vector], place, 1, 1, 2 * COLUMNS - 1)
        first = len([key for key in VECTORS if key in shown])
        for place, size in enumerate(key for key in SIZES if key in shown):
            self._grid.addWidget(self._words[size], first + place // COLUMNS, 2 * (place % COLUMNS))
            self._grid.addWidget(self.sizes[size], first + place // COLUMNS, 2 * (place % COLUMNS) + 1)
        for key, words in self._words.items():
            editor = self.vectors.get(key) or self.sizes[key]
            for widget in (words, editor):
                widget.setVisible(key in shown)
            if key in shown:
                self._fill(key)

    def _shown(self) -> tuple[str, ...]:
        repeat = self._entry.get("repeat") or {}
        return tuple(key for key in (*VECTORS, *SIZES) if key in (repeat if key in IN_PATTERN else self._entry))

    def _fill(self, key: str) -> None:
        value = (self._entry["repeat"] if key in IN_PATTERN else self._entry)[key]
        editor = self.vectors.get(key) or self.sizes[key]
        blocked = editor.blockSignals(True)
        editor.setValue(value if key in self.vectors else _shown_size(key, value))
        editor.blockSignals(blocked)


def _shown_size(key: str, value: float) -> float:
    return 2 * value if key == "radius_mm" else value


def _field(key: str, words: str) -> NumberField:
    made = NumberField()
    made.setKeyboardTracking(False)  # what is half entered is not tried
    made.setDecimals(0 if key == "count" else 3)
    made.setRange(*((2, MOST_COPIES) if key == "count" else (-360.0, 360.0) if key == "angle_deg" else (0.0, MOST_MM)))
    made.setSuffix("" if key == "count" else " °" if key == "angle_deg" else " mm")
    made.setProperty("plain", True)
    made.setAccessibleName(translated(words))
    made.setToolTip(translated(TIPS.get(key, words)))
    return made
