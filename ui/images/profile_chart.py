"""Curves along a line: one quantity in its unit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ui.charts.chart import Chart
from ui.look.language.words import tr
from ui.look.look import Look

if TYPE_CHECKING:
    from ui.charts.plotting import Plot


class ProfileChart(Chart):
    """Curves over the distance from the first end of a line; gaps where there is no value."""

    def __init__(self, look: Look) -> None:
        super().__init__(look, ProfileChart._make_plot, ProfileChart._draw_data)
        self.words = ""
        self.distance_px = np.zeros(0)
        self.curves: dict[str, np.ndarray] = {}
        self.limit: float | None = None
        self.setMinimumSize(240, 120)
        self.setAccessibleName(tr("Profile"))

    def show_curves(self, words: str, distance_px: np.ndarray, curves: Mapping[str, np.ndarray], limit: float | None = None) -> None:
        """Show curves (N,) over distances (N,); ``words``: quantity and unit; ``limit``: a value that is marked, such as saturation."""
        self.words, self.distance_px, self.curves, self.limit = words, distance_px, dict(curves), limit
        finite = np.concatenate([values[np.isfinite(values)] for values in curves.values()] or [np.zeros(0)])
        ends = f", {finite.min():.4g} … {finite.max():.4g}" if finite.size else ", no values"
        self.redraw(tr("{words}, {count} pixels{ends}", words=words, count=len(distance_px), ends=ends))

    def _make_plot(self) -> Plot:
        from ui.charts.plotting import NumberAxis, Plot

        plot = Plot(NumberAxis("bottom", "Distance [px]"), NumberAxis("left", ""), steerable=True)
        plot.axes[1].setWidth(48)
        return plot

    def _draw_data(self, plot: Plot) -> None:
        import pyqtgraph as pg
        from PySide6.QtCore import Qt

        theme = self._look.theme
        for place, (name, values) in enumerate(self.curves.items()):
            colour = theme.colour("accent") if len(self.curves) == 1 else theme.view(place)
            plot.addItem(pg.PlotDataItem(self.distance_px, values, pen=pg.mkPen(colour, width=1.5), connect="finite", name=name))
        if self.limit is not None:
            plot.addItem(pg.InfiniteLine(self.limit, 0, pen=pg.mkPen(theme.colour("verdict_fail"), style=Qt.PenStyle.DashLine)))
        plot.enableAutoRange()
