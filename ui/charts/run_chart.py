"""Run chart of a series: values in order of measurement with their limits and mean, and the moving ranges below."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt

from ui.charts.chart import Chart
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import quantity, with_unit

if TYPE_CHECKING:
    from ui.charts.plotting import Plot

RANGES, GAP = 0.25, 0.08  # heights of the strip of moving ranges and of the gap above it, in parts of the range of the values
ROOM = 0.08  # above the highest and below the lowest of what is shown, in the same
THICKNESS = 0.5  # of the distance of two parts
POINT_PX = 7
ALIKE = 1e-3  # range, in the unit of the values, where all are equal


@dataclass(frozen=True, eq=False)
class Run:
    """Values of one dimension in order of measurement; NaN where a part has none."""

    quantity: str
    unit: str
    values: np.ndarray  # (N,)
    limits: tuple[float | None, float | None] = (None, None)
    mean: float | None = None


class RunChart(Chart):
    """Points and a line over the number of the part; those beyond a limit are red; bars are the differences of two parts in a row."""

    def __init__(self, look: Look) -> None:
        super().__init__(look, RunChart._make_plot, RunChart._draw_data)
        self.run: Run | None = None
        self.setMinimumSize(320, 160)
        self.setAccessibleName(tr("Run chart: values in order of measurement, with limits and mean; moving ranges below"))

    def show_run(self, run: Run | None) -> None:
        """Show a run, or nothing."""
        self.run = run
        if run is None:
            self.redraw("")
            return
        beyond = int(np.count_nonzero(beyond_limits(run)))
        mean = quantity(run.mean, run.unit, 3) if run.mean is not None else "–"
        self.redraw(
            tr(
                "{name}: {count} values, mean {mean}, {beyond} beyond the limits",
                name=run.quantity,
                count=len(run.values),
                mean=mean,
                beyond=beyond,
            )
        )

    def _make_plot(self) -> Plot:
        from ui.charts.plotting import NumberAxis, Plot

        return Plot(NumberAxis("bottom", "Part"), NumberAxis("left", ""))

    def _draw_data(self, plot: Plot) -> None:
        import pyqtgraph as pg

        run, theme = self.run, self._look.theme
        if run is None:
            return
        there = np.flatnonzero(np.isfinite(run.values))
        parts, values = there + 1.0, run.values[there]
        shown = np.array([*values, *(limit for limit in run.limits if limit is not None)])
        if not shown.size:
            return
        low, high = float(shown.min()), float(shown.max())
        reach = (high - low) or ALIKE
        plot.axes[1].say(with_unit(run.quantity, run.unit), theme)
        for limit in run.limits:
            if limit is not None:
                plot.addItem(pg.InfiniteLine(limit, 0, pen=pg.mkPen(theme.colour("verdict_fail"), width=1.5)))
        if run.mean is not None:
            plot.addItem(pg.InfiniteLine(run.mean, 0, pen=pg.mkPen(theme.colour("faint"), style=Qt.PenStyle.DashLine)))
        colours = [theme.colour("verdict_fail" if out else "accent") for out in beyond_limits(run)[there]]
        plot.addItem(
            pg.PlotDataItem(
                parts, values, pen=pg.mkPen(theme.colour("faint")), symbol="o", symbolSize=POINT_PX, symbolPen=None, symbolBrush=colours
            )
        )
        floor = low - (ROOM + GAP + RANGES) * reach
        ranges = np.abs(np.diff(values))
        if ranges.size:
            tops = floor + RANGES * reach * ranges / (float(ranges.max()) or 1.0)
            plot.addItem(pg.BarGraphItem(x=parts[1:], width=THICKNESS, y0=floor, y1=tops, pen=None, brush=theme.colour("faint")))
        plot.setXRange(0.5, len(run.values) + 0.5, padding=0.0)
        plot.setYRange(floor, high + ROOM * reach, padding=0.0)


def beyond_limits(run: Run) -> np.ndarray:
    """Return which values (N,) lie beyond a limit; NaN does not."""
    low, high = (np.inf * sign if limit is None else limit for limit, sign in zip(run.limits, (-1, 1), strict=True))
    return (run.values < low) | (run.values > high)
