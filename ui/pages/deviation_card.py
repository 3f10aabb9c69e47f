"""The deviations from the drawing in figures: histogram, legend and one line that sums up."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFrame

from ui.look.look import Look
from ui.look.wording import millimetres, percent
from ui.viewport.colouring import DIVERGING, UNKNOWN, upper_end
from ui.widgets.basic import column, label, row
from ui.widgets.histogram import Histogram

if TYPE_CHECKING:
    from ui.session import Comparison


class DeviationCard(QFrame):
    """Histogram with the scale of the picture."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.setObjectName("card")
        self.histogram = Histogram(look)
        self.words = label("", "soft", wrap=True)
        self.unmeasured = label("", "small")
        swatch = QFrame()
        swatch.setFixedSize(12, 12)
        swatch.setStyleSheet(f"background: rgb({UNKNOWN[0]}, {UNKNOWN[1]}, {UNKNOWN[2]}); border-radius: 3px")
        legend = row(swatch, self.unmeasured, 0, spacing=8)
        heading = label("Deviation from the drawing", "heading")
        self.setLayout(column(heading, self.words, self.histogram, legend, margin=16, spacing=8))

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
        self.unmeasured.setText(f"Not measured: {percent(found.unmeasured_share)} of the drawing's surface")


def scale_end_mm(comparison: Comparison) -> float:
    """Return the end of the symmetrical colour scale."""
    return upper_end(abs(comparison.deviation.distances_mm))
