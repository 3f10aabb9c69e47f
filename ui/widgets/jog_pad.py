"""Moving single axes by hand: one row per axis, a step size, buttons that are held."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QGridLayout, QWidget

from ui.look.look import Look
from ui.look.wording import quantity
from ui.widgets.basic import Button, column, label, row
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.data.fringe import AxisReadback

ROWS = {
    "x": "Robot x",
    "y": "Robot y",
    "z": "Robot z",
    "rx": "Turn about x",
    "ry": "Turn about y",
    "rz": "Turn about z",
    "guide": "Linear guide",
    "table": "Rotary table",
}
ANGLES = ("rx", "ry", "rz", "table")
STEPS = {"0.1": "0.1", "1": "1", "10": "10"}
HELD = "While a button is held, one step follows the other; the motion ends with the step under way when it is released."


class JogPad(QWidget):
    """Emits `stepRequested(axis, step)`; tell it by `step_ended` when the step is done, so that the next can follow."""

    stepRequested = Signal(str, float)

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._held: tuple[str, int] | None = None
        self._under_way = False
        self.step = Segments(STEPS, name="Step")
        self.step.setValue("1")
        self._values = {axis: label("–", "body") for axis in ROWS}
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        grid.setColumnStretch(1, 1)
        self.buttons: dict[tuple[str, int], Button] = {}
        for place, (axis, words) in enumerate(ROWS.items()):
            value = self._values[axis]
            value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            grid.addWidget(label(words, "soft"), place, 0)
            grid.addWidget(value, place, 1)
            for where, sign, icon in ((2, -1, "minus"), (3, 1, "plus")):
                made = Button("", look, icon, "normal", f"{words} {'−' if sign < 0 else '+'}. {HELD}")
                made.setFixedWidth(48)
                made.pressed.connect(self._pressing(axis, sign))
                made.released.connect(self._release)
                self.buttons[axis, sign] = made
                grid.addWidget(made, place, where)
        steps = row(label("Step in mm or degrees", "soft"), 0, self.step)
        layout = column(steps, 4, grid, spacing=8)
        self.setLayout(layout)

    def show_readback(self, readback: AxisReadback | None) -> None:
        """Show where the axes are."""
        if readback is None:
            for value in self._values.values():
                value.setText("–")
            return
        position = readback.base_from_flange.translation_mm
        for axis, millimetres in zip("xyz", position, strict=True):
            self._values[axis].setText(quantity(float(millimetres), "mm", 2))
        turned = np.degrees(readback.base_from_flange.rotation_vector)
        for axis, degrees in zip(("rx", "ry", "rz"), turned, strict=True):
            self._values[axis].setText(quantity(float(degrees), "°", 2))
        self._values["guide"].setText(quantity(readback.guide_mm, "mm", 2))
        self._values["table"].setText(quantity(float(np.degrees(readback.table_rad)), "°", 3))

    @Slot()
    def step_ended(self) -> None:
        """The requested step has ended: the next follows while the button is held."""
        self._under_way = False
        if self._held is not None and self.isEnabled():
            self._request(*self._held)

    def _pressing(self, axis: str, sign: int) -> Callable[[], None]:
        def press() -> None:
            self._held = (axis, sign)
            if not self._under_way:
                self._request(axis, sign)

        return press

    def _release(self) -> None:
        self._held = None

    def _request(self, axis: str, sign: int) -> None:
        self._under_way = True
        self.stepRequested.emit(axis, sign * float(self.step.value()))
