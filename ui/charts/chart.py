"""What every chart has: axes with their units, the colours of the theme, a name for screen readers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from ui.look.look import Look

if TYPE_CHECKING:
    from ui.charts.plotting import Plot


class Chart(QWidget):
    """Axes that are made with the first data; subclasses keep their data and draw them in `_draw`."""

    def __init__(self, look: Look, *, ground: str = "surface") -> None:
        """``ground``: token of the background's colour."""
        super().__init__()
        self._look, self._ground = look, ground
        self.plot: Plot | None = None
        layout = QVBoxLayout()
        layout.setContentsMargins(0, 0, 0, 0)
        self.setLayout(layout)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self._dress)

    def _make_plot(self) -> Plot:
        """Return the axes of this chart."""
        raise NotImplementedError

    def _draw(self, plot: Plot) -> None:
        """Draw the data on empty axes, in the colours of the present theme."""
        raise NotImplementedError

    def redraw(self, spoken: str) -> None:
        """Draw the present data; ``spoken`` describes them to a screen reader."""
        self.setAccessibleDescription(spoken)
        plot = self.prepare()
        plot.clear()
        self._draw(plot)

    def prepare(self) -> Plot:
        """Return the axes; they are made where there are none yet, which takes a while."""
        if self.plot is None:
            self.plot = self._make_plot()
            self.layout().addWidget(self.plot)
            self.plot.show()  # else only with the next event
            self.plot.dress(self._look.theme, self._ground)
        return self.plot

    def _dress(self) -> None:
        if self.plot is not None:
            self.plot.dress(self._look.theme, self._ground)
            self.plot.clear()
            self._draw(self.plot)
