"""Interactive section: a plane normal to x, y or z, moved by a slider or to a typed position, with magnified deviations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSlider, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import millimetres
from ui.pages.inspection.section_lines import Whiskers
from ui.viewport.layers import LineLayer
from ui.widgets.basic import Button, ElidedLabel, row
from ui.widgets.number_field import NumberField
from ui.widgets.segments import Segments

if TYPE_CHECKING:
    from measureapp.inspection.surface.nominal import NominalSurface
    from ui.session import Comparison

STEPS = 400
DIGITS = 2
PLACE_WIDTH, SLIDER_WIDTH = 96, 60
HALF_WIDTH_MM = 0.5
NOMINAL = (70, 82, 90)
TIP = "Cut the part by a plane and show the deviations along the section"
AXES = {"x": 0, "y": 1, "z": 2}


@dataclass(frozen=True)
class CutPlane:
    """A plane normal to an axis of the nominal's frame."""

    axis: str
    place_mm: float


class SectionBar(QWidget):
    """Chooses a section: `value()` is a `CutPlane`, or None while it is off."""

    changed = Signal()

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.button = Button("Section", look, "section", "quiet", TIP)
        self.button.setCheckable(True)
        self.button.toggled.connect(self._show)
        self.axis = Segments(
            {name: name for name in "zxy"}, name="Section normal to", tips=dict.fromkeys("zxy", "Axis that the section is normal to")
        )
        self.axis.valueChanged.connect(self._follow_slider)
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setAccessibleName(tr("Position of the section along the axis"))
        self.slider.setToolTip(tr("Position of the section along the axis"))
        self.slider.setRange(0, STEPS)
        self.slider.setValue(STEPS // 2)
        self.slider.valueChanged.connect(self._follow_slider)
        self.place = NumberField()
        self.place.setAccessibleName(tr("Position of the section along the axis"))
        self.place.setToolTip(tr("Type the position; the arrow keys move it by 1 mm, Page Up and Page Down by 10 mm"))
        self.place.setSuffix(" mm")
        self.place.setDecimals(DIGITS)
        self.place.setKeyboardTracking(False)  # not at every digit typed
        self.place.valueChanged.connect(self._follow_number)
        self.place.setButtonSymbols(NumberField.ButtonSymbols.NoButtons)
        self.place.setFixedWidth(PLACE_WIDTH)
        self.slider.setMinimumWidth(SLIDER_WIDTH)
        self.words = ElidedLabel("", "small")  # the first to become shorter, rather than push the tables out of the window
        self._low, self._high = np.zeros(3), np.zeros(3)
        line = row(self.axis, self.slider, self.place, self.words, margin=8, spacing=12)
        line.setStretch(1, 2)
        line.setStretch(3, 1)
        self.setLayout(line)
        self._show()

    def value(self) -> CutPlane | None:
        """Return the chosen plane."""
        if not self.button.isChecked() or not (self._high > self._low).any():
            return None
        return CutPlane(self.axis.value(), self.place.value())

    def setValue(self, plane: CutPlane) -> None:
        """Show this section."""
        self.axis.setValue(plane.axis)
        self.place.setValue(plane.place_mm)
        self.button.setChecked(True)

    def show_extent(self, surface: NominalSurface | None) -> None:
        """Limit the planes to the extent of this nominal; disable the section without one."""
        self.button.setEnabled(surface is not None)
        if surface is None:
            self.button.setChecked(False)
        else:
            self._low, self._high = np.asarray(surface.low_mm), np.asarray(surface.high_mm)
            self._follow_slider()

    def say(self, words: str) -> None:
        """Show a text about the section beside its position."""
        self.words.set_words(words)

    @property
    def _span(self) -> tuple[float, float]:
        """Return the least and the greatest position along the axis."""
        return float(self._low[AXES[self.axis.value()]]), float(self._high[AXES[self.axis.value()]])

    def _follow_slider(self) -> None:
        low, high = self._span
        self.place.blockSignals(True)
        self.place.setRange(low, high)
        self.place.setValue(low + self.slider.value() / STEPS * (high - low))
        self.place.blockSignals(False)
        self._change()

    def _follow_number(self, place_mm: float) -> None:
        low, high = self._span
        self.slider.blockSignals(True)
        self.slider.setValue(round(STEPS * (place_mm - low) / max(high - low, 1e-9)))
        self.slider.blockSignals(False)
        self._change()

    def _show(self) -> None:
        self.setVisible(self.button.isChecked())
        self._change()

    def _change(self) -> None:
        self.changed.emit()


def cut_lines(comparison: Comparison, plane: CutPlane) -> tuple[list[LineLayer], str]:
    """Return the nominal's curve in a plane with the magnified deviations, and a description."""
    from measureapp.errors import InspectionError
    from measureapp.inspection.surface.cutting_surface import CuttingPlane
    from measureapp.inspection.surface.section import cut_section

    assert comparison.surface is not None
    axis = np.eye(3)[AXES[plane.axis]]
    where = f"{plane.axis} = {millimetres(plane.place_mm, 1)}"
    try:
        found = cut_section(
            where, comparison.deviation, comparison.surface, CuttingPlane.through(plane.place_mm * axis, axis), HALF_WIDTH_MM
        )
    except InspectionError:
        return [], "No intersection"
    whiskers = Whiskers.of(found)
    drawn = LineLayer(found.nominal, NOMINAL, 2.0)
    words = tr("Deviations × {gain}", gain=whiskers.gain) if len(found.deviations_mm) else "Not measured"
    return [layer for layer in (drawn, *whiskers.layers()) if layer.lines], words
