"""Horizontal bar chart of one quantity."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.charts.chart import Chart
from ui.look.language.words import translated
from ui.look.look import Look
from ui.look.wording import millimetres, with_unit

if TYPE_CHECKING:
    from ui.charts.plotting import Plot

LINE, TALLEST_LINE, AXIS = 20, 48, 48  # px
THICKNESS = 0.5  # of the distance of two bars
NUMBERS = 80  # px, room for the number behind the longest bar


@dataclass(frozen=True)
class Bar:
    """One bar, in the unit of its chart."""

    name: str
    value: float
    strong: bool = False


class BarChart(Chart):
    """Bars from top to bottom, each with its name and its value; axis in their unit."""

    def __init__(
        self, look: Look, quantity: str, unit: str = "mm", written: Callable[[float], str] = millimetres, *, most: float | None = None
    ) -> None:
        """``written`` returns a value with its unit; ``most`` is the largest value there can be."""
        super().__init__(look, BarChart._make_plot, BarChart._draw_data)
        self._quantity, self._unit, self._written, self._most = quantity, unit, written, most
        self.bars: tuple[Bar, ...] = ()
        self._longest = 1.0
        self.setAccessibleName(translated(quantity))

    def show_bars(self, bars: Sequence[Bar]) -> None:
        """Show these bars."""
        self.bars = tuple(bars)
        self.setMinimumHeight(AXIS + LINE * len(self.bars))
        self.setMaximumHeight(AXIS + TALLEST_LINE * len(self.bars))
        self.redraw(", ".join(f"{bar.name} {self._written(bar.value)}" for bar in self.bars))

    def _leave_room(self) -> None:
        """Leave the numbers the same room in every width."""
        if self.plot is not None:
            width = max(2.0 * NUMBERS, self.plot.getViewBox().width())
            self.plot.setXRange(0.0, self._longest * width / (width - NUMBERS), padding=0.0)

    def _make_plot(self) -> Plot:
        from ui.charts.plotting import NumberAxis, Plot

        plot = Plot(NumberAxis("bottom", with_unit(self._quantity, self._unit), most=self._most), NumberAxis("left", ""))
        plot.invertY(True)
        plot.getViewBox().sigResized.connect(self._leave_room)  # also when the names need more room
        return plot

    def _draw_data(self, plot: Plot) -> None:
        import pyqtgraph as pg

        from ui.look.theme import font

        theme = self._look.theme
        plot.axes[1].setTicks([[(place, translated(bar.name)) for place, bar in enumerate(self.bars)]])
        plot.axes[1].setTextPen(theme.colour("text"))
        longest = max((bar.value for bar in self.bars), default=0.0) or 1.0
        self._longest = longest
        self._leave_room()
        plot.setYRange(-0.5, max(0.5, len(self.bars) - 0.5), padding=0.0)
        if not self.bars:
            return
        plot.addItem(
            pg.BarGraphItem(
                x0=0.0,
                y=list(range(len(self.bars))),
                width=[bar.value for bar in self.bars],
                height=THICKNESS,
                pen=None,
                brushes=[theme.colour("accent" if bar.strong else "faint") for bar in self.bars],
            )
        )
        for place, bar in enumerate(self.bars):
            value = pg.TextItem(self._written(bar.value), theme.colour("text"), anchor=(0.0, 0.5))
            value.setFont(font(theme.sizes["small"], bold=bar.strong))
            value.setPos(bar.value, place)
            plot.addItem(value)
