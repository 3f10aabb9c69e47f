"""Places of the parts of a legend, and which of them is under the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF

from ui.viewport.overlay.legend import Legend, one_two_five
from ui.viewport.overlay.legend_edits import Handle, value_of
from ui.viewport.overlay.style import OverlayStyle

PANEL_WIDTH, MARGIN, PADDING = 184.0, 12.0, 10.0
BAR_WIDTH, HISTOGRAM_WIDTH, NUMBERS_GAP, BRACKET = 18.0, 52.0, 18.0, 8.0
LEAST_BAR, LARGEST_FRACTION = 120.0, 0.45  # of the height of the picture
LINE, GRIP, BEYOND = 16.0, 7.0, 10.0
Part = Handle | Literal["legend"]


@dataclass(frozen=True)
class LegendLayout:
    """Rectangles of one legend in a picture."""

    panel: QRectF
    header: QRectF
    bar: QRectF
    histogram: QRectF
    footer: QRectF
    scale: float
    low: float
    high: float

    def y_of(self, value: float) -> float:
        """Return the height of a value on the bar."""
        return self.bar.bottom() - (value - self.low) / max(self.high - self.low, 1e-12) * self.bar.height()

    def handle_box(self, legend: Legend, handle: Handle) -> QRectF:
        """Return where a handle can be taken: a wide strip at its number."""
        y = float(np.clip(self.y_of(value_of(legend, handle)), self.bar.top(), self.bar.bottom()))
        half = GRIP * self.scale
        if handle in ("low", "high"):
            return QRectF(self.bar.left() - half, y - half, self.panel.right() - self.bar.left() + half, 2 * half)
        return QRectF(self.bar.right(), y - half, (BRACKET + 6.0) * self.scale, 2 * half)


def lay_out_legend(legend: Legend, width: float, height: float, style: OverlayStyle, top: float = 0.0) -> LegendLayout:
    """Place a legend at the right of a picture, below ``top``; at most 45 % of its height where that suffices."""
    scale = style.scale
    line, padding = LINE * scale, PADDING * scale
    head = 2 * line + (line if legend.note else 0.0) + 4 * scale
    foot = 4 * line + 6 * scale if legend.fractions is not None else 0.0
    fixed = head + foot + 2 * padding + 2 * BEYOND * scale
    panel_height = max(LARGEST_FRACTION * height, fixed + LEAST_BAR * scale)
    panel_height = min(panel_height, max(height - top - 2 * MARGIN * scale, fixed + 40 * scale))
    panel_width = max(PANEL_WIDTH * scale, style.measure(legend.quantity, 12, bold=True).width() + 2 * padding)
    left = width - panel_width - MARGIN * scale
    start = max(top + MARGIN * scale, (height - panel_height) / 2.0)
    panel = QRectF(left, min(start, max(MARGIN * scale, height - panel_height - MARGIN * scale)), panel_width, panel_height)
    header = QRectF(panel.left() + padding, panel.top() + padding, panel.width() - 2 * padding, head)
    bar_top = header.bottom() + BEYOND * scale
    bar_left = panel.left() + padding + HISTOGRAM_WIDTH * scale
    bar = QRectF(bar_left, bar_top, BAR_WIDTH * scale, panel.bottom() - padding - foot - BEYOND * scale - bar_top)
    histogram = QRectF(panel.left() + padding, bar.top(), HISTOGRAM_WIDTH * scale - 4 * scale, bar.height())
    footer = QRectF(panel.left() + padding, panel.bottom() - padding - foot + 6 * scale, panel.width() - 2 * padding, foot)
    return LegendLayout(panel, header, bar, histogram, footer, scale, legend.low, legend.high)


def part_at(legend: Legend, layout: LegendLayout, place: QPointF) -> Part | None:
    """Return the handle at a place, ``"legend"`` elsewhere on the panel, None beside it."""
    if not layout.panel.contains(place):
        return None
    if not legend.editable:
        return "legend"
    handles: tuple[Handle, ...] = ("tolerance low", "tolerance high") if legend.tolerance is not None else ()
    for handle in (*handles, "low", "high"):
        if layout.handle_box(legend, handle).contains(place):  # type: ignore[arg-type]
            return handle  # type: ignore[return-value]
    return "legend"


def ticks(legend: Legend, room: QSizeF) -> list[float]:
    """Return round values on the axis, with enough room between their numbers; the ends of the range are apart."""
    count = max(2.0, room.height() / room.width())
    step = one_two_five(legend.span / count)
    first = np.ceil(legend.low / step - 1e-9)
    return [float(round(place * step, 9)) for place in np.arange(first, legend.high / step + 1e-9)]


def digits_of(legend: Legend) -> int:
    """Return the number of decimals that the numbers of a legend need."""
    step = max(legend.span / 20.0, 1e-6)
    return int(np.clip(np.ceil(-np.log10(step) - 1e-9), 0, 4))
