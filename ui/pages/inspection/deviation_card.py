"""Deviations from the nominal: histogram, legend and key figures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtWidgets import QDoubleSpinBox, QFrame

from ui.look.look import Look
from ui.look.wording import millimetres, percent
from ui.viewport.colouring import DIVERGING, upper_end
from ui.widgets.basic import column, label, row
from ui.widgets.histogram import Histogram
from ui.widgets.not_measured import NotMeasuredLegend

if TYPE_CHECKING:
    from ui.session import Comparison


USUAL_TOLERANCE_MM = 0.1  # initial value
TOLERANCE = "Symmetric tolerance about the nominal in mm, for display only; it does not affect verdicts"


class DeviationCard(QFrame):
    """Histogram with the scale of the picture."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("card")
        self.histogram = Histogram(look)
        self.words = label("", "soft", wrap=True)
        self.unmeasured = NotMeasuredLegend(look)
        self.tolerance, self.bands = QDoubleSpinBox(), label("", "soft", wrap=True)
        self.tolerance.setRange(0.001, 100.0)
        self.tolerance.setDecimals(3)
        self.tolerance.setSingleStep(0.01)
        self.tolerance.setSuffix(" mm")
        self.tolerance.setValue(USUAL_TOLERANCE_MM)
        self.tolerance.lineEdit().setTextMargins(6, 0, 0, 0)
        self.tolerance.setFixedWidth(112)
        self.tolerance.setAccessibleName(TOLERANCE)
        self.tolerance.setToolTip(TOLERANCE)
        self.tolerance.valueChanged.connect(self._show_bands)
        self._distances_mm: np.ndarray = np.empty(0)
        heading = row(label("Deviation", "heading"), 0, label("Tolerance ±", "soft"), self.tolerance)
        self.setLayout(column(heading, self.words, self.bands, self.histogram, self.unmeasured, margin=16, spacing=8))

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Show these deviations, or nothing."""
        if comparison is None:
            return
        found = comparison.deviation
        self._distances_mm = found.distances_mm
        self._show_bands()
        self.histogram.show_values(found.distances_mm, DIVERGING, scale_end_mm(comparison))
        self.words.setText(
            f"Mean {millimetres(found.mean_mm, signed=True)}, rms {millimetres(found.rms_mm)}; 95 % within {millimetres(found.p95_mm)}."
        )
        self.unmeasured.say(f"Not measured: {percent(found.unmeasured_share)} of the nominal's surface")

    def _show_bands(self) -> None:
        """Mark the tolerance, and show the share of points within it."""
        from measureapp.inspection.surface.histogram import bin_deviations

        limit = self.tolerance.value()
        self.histogram.mark(limit)
        if len(self._distances_mm):
            found = bin_deviations(self._distances_mm, -limit, limit)
            self.bands.setText(f"{percent(found.within)} within, {percent(found.below)} below, {percent(found.above)} above")


def scale_end_mm(comparison: Comparison) -> float:
    """Return the end of the symmetrical colour scale."""
    return upper_end(abs(comparison.deviation.distances_mm))
