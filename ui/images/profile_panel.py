"""Profile along a line: its ends as numbers, two charts, and a table to save."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSpinBox, QWidget

from ui.images.profile import Pixel, Profile, profile
from ui.images.profile_chart import ProfileChart
from ui.look.language.words import later, translated
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row

ENDS = ("From row", later("column"), "to row", later("column"))
GAP, ROUND_WORDS = 8, 72  # px, between two parts; a button more than its words
NAMES = ("Row of the first end", "Column of the first end", "Row of the second end", "Column of the second end")


class ProfilePanel(QWidget):
    """Edits the ends of a line; shows the values of two quantities along it."""

    lineEdited = Signal(object)  # ((row, column), (row, column)), by the keyboard
    saveAsked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.profile: Profile | None = None
        self.fields = tuple(self._field(name) for name in NAMES)
        self.upper, self.lower = ProfileChart(look), ProfileChart(look)
        self._save = Button("Save table…", look, "export", "quiet", "The values of all maps along the line, as CSV")
        self._save.clicked.connect(self.saveAsked)
        self._save.allow_compact()
        parts = [part for words, field in zip(ENDS, self.fields, strict=True) for part in (label(words, "soft"), field)]
        self.captions = tuple(label("", "caption") for _ in range(2))
        charts = row(*(column(*pair, spacing=0) for pair in zip(self.captions, (self.upper, self.lower), strict=True)), spacing=8)
        layout = column(row(*parts, 0, self._save, spacing=GAP), charts, spacing=4)
        layout.setStretch(1, 1)
        self._parts: tuple[QWidget, ...] = tuple(parts)
        self.setLayout(layout)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show the button without words before they would be cut."""
        super().resizeEvent(event)
        others = sum(part.sizeHint().width() + GAP for part in self._parts)
        words = self._save.fontMetrics().horizontalAdvance(self._save.accessibleName()) + ROUND_WORDS
        self._save.set_compact(others + words > self.width())

    def value(self) -> tuple[Pixel, Pixel]:
        """Return the ends of the line."""
        top, left, bottom, right = (field.value() for field in self.fields)
        return (top, left), (bottom, right)

    def setValue(self, ends: tuple[Pixel, Pixel]) -> None:
        """Set the ends of the line, without telling."""
        for field, place in zip(self.fields, (*ends[0], *ends[1]), strict=True):
            field.blockSignals(True)
            field.setValue(place)
            field.blockSignals(False)

    def fit(self, shape: tuple[int, int]) -> None:
        """Keep the ends within an image; a line that has no length becomes the middle row."""
        for field, limit in zip(self.fields, (*shape, *shape), strict=True):
            field.blockSignals(True)
            field.setRange(0, limit - 1)
            field.blockSignals(False)
        if self.value()[0] == self.value()[1]:
            self.setValue(((shape[0] // 2, 0), (shape[0] // 2, shape[1] - 1)))

    def show_profile(self, layers: dict[str, np.ndarray], upper: tuple[str, str], lower: tuple[str, str], saturation: float) -> None:
        """Show two of the layers along the line, each by its name and words; grey levels (``lower``) with the limit of saturation."""
        self.profile = profile(self.value(), layers)
        for caption, (_, words) in zip(self.captions, (upper, lower), strict=True):
            caption.setText(translated(words))
        for chart, (name, words), limit in ((self.upper, upper, None), (self.lower, lower, saturation)):
            chart.show_curves(words, self.profile.distance_px, {name: self.profile.values[name]}, limit)

    def _field(self, name: str) -> QSpinBox:
        field = QSpinBox()
        field.setAccessibleName(translated(name))
        field.setMinimumWidth(72)
        field.valueChanged.connect(lambda _value: self.lineEdited.emit(self.value()))
        return field
