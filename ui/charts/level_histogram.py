"""Grey levels of one image, from black to saturated."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ui.charts.chart import Chart
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import percent

if TYPE_CHECKING:
    from ui.charts.plotting import Plot

BINS = 64
SATURATED_IS_MUCH = 0.002  # share of the pixels; more hides corners and fringes
EVERY = 4  # pixels, in rows and columns


class LevelHistogram(Chart):
    """Shares of the grey levels on a root scale, so that small ones show; the saturated end is marked where it is much."""

    def __init__(self, look: Look) -> None:
        super().__init__(look, LevelHistogram._make_plot, LevelHistogram._draw_data, ground="sunken")
        self.shares = np.zeros(BINS)
        self.saturated = 0.0
        self._saturation = 255
        self.setMinimumSize(144, 72)
        self.setMaximumHeight(96)
        self.setAccessibleName(tr("Grey levels"))

    def show_levels(self, pixels: np.ndarray, saturation: int) -> None:
        """Show the levels of an image (H, W)."""
        thin = pixels[::EVERY, ::EVERY]
        counts, _ = np.histogram(thin, BINS, (0, saturation + 1))
        self.shares = counts / max(1, counts.sum())
        self.saturated = float(np.mean(thin >= saturation)) if thin.size else 0.0
        self._saturation = saturation
        self.redraw(tr("Saturated {saturated}", saturated=percent(self.saturated)))

    def _make_plot(self) -> Plot:
        from ui.charts.plotting import NumberAxis, Plot

        plot = Plot(NumberAxis("bottom", ""), NumberAxis("left", ""))
        plot.leave_edges()  # a root scale has no readable numbers
        return plot

    def _draw_data(self, plot: Plot) -> None:
        from ui.charts.plotting import bars

        theme = self._look.theme
        end = float(self._saturation + 1)
        heights = np.sqrt(self.shares / (self.shares.max() or 1.0))
        fills = [theme.colour("accent")] * (BINS - 1)
        fills.append(theme.colour("verdict_fail" if self.saturated > SATURATED_IS_MUCH else "accent"))
        plot.addItem(bars(np.linspace(0.0, end, BINS + 1), heights, fills))
        plot.axes[0].setTicks([[(share * end, f"{share * self._saturation:.0f}") for share in (0.0, 0.25, 0.5, 0.75, 1.0)]])
        plot.setXRange(0.0, end, padding=0.0)
        plot.setYRange(0.0, 1.0, padding=0.0)
