"""Form for a point filter and its parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QComboBox, QSizePolicy, QSpinBox, QStackedWidget, QWidget

from ui.look.language.words import later, tr, translated
from ui.look.look import Look
from ui.widgets.basic import Button, column, label, row
from ui.widgets.number_field import NumberField
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.register.clouds.filter_chain import Filter

KINDS = {"statistical": "Statistical", "radius": "Radius", "islands": "Patches", "box": "Box", "plane": "Plane"}
TIPS = {
    "statistical": "Statistical outlier removal, by the mean distance to neighbours",
    "radius": "Radius outlier removal, by the number of neighbours",
    "islands": "Remove small isolated patches",
    "box": "Keep the points inside a box",
    "plane": "Keep the points on one side of a plane",
}
SIDES = {
    later("above z"): (0, 0, 1),
    later("below z"): (0, 0, -1),
    later("above x"): (1, 0, 0),
    later("below x"): (-1, 0, 0),
    later("above y"): (0, 1, 0),
    later("below y"): (0, -1, 0),
}
LIMIT_MM, FIELD_WIDTH, SIDE_WIDTH = 20_000.0, 80, 64
ROOM_FOR_WORDS = 500  # px


class FilterForm(QWidget):
    """One kind of filter with its parameters: `value()` is a `Filter`; `asked` fires when the button is pressed."""

    valueChanged = Signal(object)
    asked = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.kind = Segments(KINDS, name="Kind of filter", tips=TIPS)
        self.sigmas, self.neighbours = _length(2.0, 0.0, 100.0, ""), _count(20)
        self.radius, self.least = _length(2.0, 0.01, LIMIT_MM, " mm"), _count(5)
        self.area = _length(25.0, 0.0, 1e6, " mm²")
        self.sides = [_length(sign * 1000.0, -LIMIT_MM, LIMIT_MM, "") for _ in "xyz" for sign in (-1, 1)]
        for side in self.sides:
            side.setFixedWidth(SIDE_WIDTH)
        self.side, self.offset = QComboBox(), _length(0.0, -LIMIT_MM, LIMIT_MM, " mm")
        for words in SIDES:
            self.side.addItem(translated(words), words)
        for field, words in self._described_editors():
            field.setAccessibleName(translated(words))
            field.setToolTip(translated(words))
        self.fields = QStackedWidget()
        for line in self._lines():
            shown = QWidget()
            shown.setLayout(row(*line, 0, spacing=4))
            self.fields.addWidget(shown)
        self.button = Button("Filter", look, "filter", tip="Apply to the merged cloud; the stitched cloud is kept")
        self.button.clicked.connect(self.asked)
        self.button.allow_compact()
        self.setLayout(column(row(self.kind, 0, self.button), self.fields, margin=8))
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self.kind.valueChanged.connect(self._show_kind)
        for field in (self.sigmas, self.neighbours, self.radius, self.least, self.area, *self.sides, self.offset):
            field.valueChanged.connect(self._change)
        self.side.currentIndexChanged.connect(self._change)

    def _described_editors(self) -> list[tuple[QWidget, str]]:
        """Return the editors with their descriptions."""
        ends = [(tr("{end} limit of the box along {axis}, in mm", end=end, axis=axis)) for axis in "xyz" for end in ("Lower", "Upper")]
        return [
            (self.sigmas, "Limit in standard deviations above the mean distance"),
            (self.neighbours, "Number of neighbours for the mean distance"),
            (self.radius, "Radius in mm"),
            (self.least, "Least number of other points within the radius"),
            (self.area, "Least area of a patch to keep, in mm²"),
            (self.side, "Side of the plane to keep"),
            (self.offset, "Position of the plane along its axis, in mm"),
            *zip(self.sides, ends, strict=True),
        ]

    def _lines(self) -> list[list[QWidget]]:
        """Return the editors of each kind, with labels."""
        box: list[QWidget] = []
        for axis, (low, high) in zip("xyz", (self.sides[0:2], self.sides[2:4], self.sides[4:6]), strict=True):
            box += [label(axis, "soft"), low, high]
        return [
            [label("Remove beyond", "soft"), self.sigmas, label("σ over", "soft"), self.neighbours, label("neighbours", "soft")],
            [label("Remove with fewer than", "soft"), self.least, label("others within", "soft"), self.radius],
            [label("Remove isolated patches below", "soft"), self.area],
            [*box, label("mm", "soft")],
            [label("Keep points", "soft"), self.side, label("=", "soft"), self.offset],
        ]  # fmt: skip

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Reduce the button to its icon where there is little room."""
        super().resizeEvent(event)
        self.button.set_compact(self.width() < ROOM_FOR_WORDS)

    def value(self) -> Filter:
        """Return the chosen filter. Raises InputError for an empty box."""
        from measureapp.register.clouds.filter_chain import Filter

        kind = self.kind.value()
        if kind == "statistical":
            return Filter("statistical", (self.sigmas.value(), self.neighbours.value()))
        if kind == "radius":
            return Filter("radius", (self.radius.value(), self.least.value()))
        if kind == "islands":
            return Filter("islands", (self.area.value(),))
        if kind == "box":
            return Filter("box", tuple(side.value() for side in self.sides))
        normal = SIDES[self.side.currentData()]
        return Filter("plane", (*normal, sum(normal) * self.offset.value()))

    def setValue(self, wanted: Filter) -> None:
        """Show a filter; a plane along an axis."""
        numbers = wanted.numbers
        if wanted.kind == "statistical":
            self.sigmas.setValue(numbers[0])
            self.neighbours.setValue(int(numbers[1]))
        elif wanted.kind == "radius":
            self.radius.setValue(numbers[0])
            self.least.setValue(int(numbers[1]))
        elif wanted.kind == "islands":
            self.area.setValue(numbers[0])
        elif wanted.kind == "box":
            for side, number in zip(self.sides, numbers, strict=True):
                side.setValue(number)
        else:
            self.side.setCurrentIndex(list(SIDES.values()).index(tuple(numbers[:3])))
            self.offset.setValue(sum(numbers[:3]) * numbers[3])
        self.kind.setValue(wanted.kind)

    def show_extent(self, points_mm: np.ndarray) -> None:
        """Initialise the box with the extent of these points, and the plane with their centre."""
        low, high = points_mm.min(axis=0), points_mm.max(axis=0)
        for axis in range(3):
            self.sides[2 * axis].setValue(float(np.floor(low[axis])))
            self.sides[2 * axis + 1].setValue(float(np.ceil(high[axis])))
        self.offset.setValue(float(np.round((low[2] + high[2]) / 2)))

    def _show_kind(self) -> None:
        self.fields.setCurrentIndex(list(KINDS).index(self.kind.value()))
        self._change()

    def _change(self) -> None:
        self.valueChanged.emit(self.kind.value())


def _length(value: float, least: float, most: float, unit: str) -> NumberField:
    made = NumberField()
    made.setRange(least, most)
    made.setDecimals(2 if unit != "" or most < 1000 else 1)
    made.setSuffix(unit)
    made.setValue(value)
    made.setFixedWidth(FIELD_WIDTH + (16 if unit else 0))
    made.setProperty("plain", True)  # without arrows, which a row of six has no room for
    return made


def _count(value: int) -> QSpinBox:
    made = QSpinBox()
    made.setRange(1, 1000)
    made.setFixedWidth(FIELD_WIDTH)
    made.setProperty("plain", True)  # without arrows, which a row of six has no room for
    made.setValue(value)
    return made
