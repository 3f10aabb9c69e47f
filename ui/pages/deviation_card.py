"""The deviations from the drawing in figures: histogram, legend and one line that sums up."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFrame

from ui.look.look import Look
from ui.look.wording import millimetres, percent
from ui.viewport.colouring import DIVERGING, upper_end
from ui.widgets.basic import column, label
from ui.widgets.histogram import Histogram
from ui.widgets.not_measured import NotMeasuredLegend

if TYPE_CHECKING:
    from ui.session import Comparison


class DeviationCard(QFrame):
    """Histogram with the scale of the picture."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("card")
        self.histogram = Histogram(look)
        self.words = label("", "soft", wrap=True)
        self.unmeasured = NotMeasuredLegend(look)
        heading = label("Deviation from the drawing", "heading")
        self.setLayout(column(heading, self.words, self.histogram, self.unmeasured, margin=16, spacing=8))

    def show_comparison(self, comparison: Comparison | None) -> None:
        """Show these deviations, or nothing."""
        self.setVisible(comparison is not None)
        if comparison is None:
            return
        found = comparison.deviation
        self.histogram.show_values(found.distances_mm, DIVERGING, scale_end_mm(comparison))
        self.words.setText(
            f"Mean {millimetres(found.mean_mm, signed=True)}, rms {millimetres(found.rms_mm)}; 95 % lie within {millimetres(found.p95_mm)}."
        )
        self.unmeasured.say(f"Not measured: {percent(found.unmeasured_share)} of the drawing's surface")


def scale_end_mm(comparison: Comparison) -> float:
    """Return the end of the symmetrical colour scale."""
    return upper_end(abs(comparison.deviation.distances_mm))
