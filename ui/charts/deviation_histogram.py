"""Histogram of deviations on the scale of their legend, in its colours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from ui.charts.chart import Chart
from ui.look.language.words import tr, translated
from ui.look.look import Look
from ui.look.wording import counted, quantity, with_unit
from ui.viewport.overlay.legend import Legend

if TYPE_CHECKING:
    from ui.charts.plotting import Plot

BINS = 48
STRIP = 0.12  # height of the strip with the colours of the legend, in parts of the highest bar


class DeviationHistogram(Chart):
    """Bars over the range of a legend, with its colours below and its tolerance band marked."""

    def __init__(self, look: Look) -> None:
        super().__init__(look, DeviationHistogram._make_plot, DeviationHistogram._draw_data)
        self._legend: Legend | None = None
        self.edges = np.linspace(0.0, 1.0, BINS + 1)
        self.counts = np.zeros(BINS, int)
        self.setMinimumSize(240, 96)

    def show_values(self, values_mm: np.ndarray, legend: Legend) -> None:
        """Show the finite ones of values (N,) on the range of a legend; those beyond it are counted in the outermost bars."""
        self._legend = legend
        finite = values_mm[np.isfinite(values_mm)]
        self.edges = np.linspace(legend.low, legend.high, BINS + 1)
        self.counts, _ = np.histogram(np.clip(finite, legend.low, legend.high), self.edges)
        self.setAccessibleName(translated(legend.quantity))
        ends = " … ".join(quantity(end, legend.unit, signed=True) for end in (legend.low, legend.high))
        self.redraw(tr("{counted} points, {ends}", counted=counted(len(finite)), ends=ends))

    def _make_plot(self) -> Plot:
        from ui.charts.plotting import NumberAxis, Plot

        assert self._legend is not None
        plot = Plot(NumberAxis("bottom", with_unit(self._legend.quantity, self._legend.unit)), NumberAxis("left", "Points"))
        plot.leave_edges()  # the heights are told by comparison; the figures stand beside
        return plot

    def _draw_data(self, plot: Plot) -> None:
        import pyqtgraph as pg

        from ui.charts.plotting import bars

        legend, theme = self._legend, self._look.theme
        if legend is None:
            return
        highest = float(max(1, self.counts.max()))
        fills = [QColor(*(int(part) for part in colour)) for colour in legend.colours((self.edges[1:] + self.edges[:-1]) / 2)]
        plot.addItem(bars(self.edges, self.counts, fills, theme.colour("faint")))
        plot.addItem(bars(self.edges, np.full(BINS, -STRIP * highest), fills))
        for limit in legend.tolerance or ():
            if legend.low < limit < legend.high:
                plot.addItem(pg.InfiniteLine(limit, pen=pg.mkPen(theme.colour("text"), width=1.5, style=Qt.PenStyle.DashLine)))
        plot.setXRange(legend.low, legend.high, padding=0.0)
        plot.setYRange(-STRIP * highest, highest, padding=0.02)
