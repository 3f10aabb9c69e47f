"""What every chart has: axes with their units, the colours of the theme, a name for screen readers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from ui.look.language.words import translated
from ui.look.look import Look

if TYPE_CHECKING:
    from ui.charts.plotting import Plot


class Chart(QWidget):
    """Axes that are made with the first data, and drawn upon again when the theme changes."""

    def __init__(self, look: Look, axes: Callable[[Any], Plot], draw: Callable[[Any, Plot], None], *, ground: str = "surface") -> None:
        """``axes(chart)`` returns new axes, ``draw(chart, axes)`` draws on empty ones in the colours of the theme; ``ground``: token of their background.

        Both are functions of the chart's class, not bound to it: a widget that refers to itself is freed piece by piece while Qt still paints it.
        """
        super().__init__()
        self._look, self._ground = look, ground
        self._axes_of, self._draw_on = axes, draw
        self.plot: Plot | None = None
        self._is_outdated = False
        layout = QVBoxLayout()
        layout.setContentsMargins(0, 0, 0, 0)
        self.setLayout(layout)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        look.changed.connect(self._follow_theme)

    def redraw(self, spoken: str) -> None:
        """Draw the present data; ``spoken`` describes them to a screen reader."""
        self.setAccessibleDescription(translated(spoken))
        plot = self.prepare()
        plot.clear()
        self._draw_on(self, plot)

    def prepare(self) -> Plot:
        """Return the axes; they are made where there are none yet, which takes a while."""
        if self.plot is None:
            self.plot = self._axes_of(self)
            self.layout().addWidget(self.plot)
            self.plot.show()  # else only with the next event
            self.plot.dress(self._look.theme, self._ground)
        return self.plot

    def showEvent(self, event: QShowEvent) -> None:
        """Take the theme and the language that were chosen while the chart could not be seen."""
        if self._is_outdated:
            self._dress()
        super().showEvent(event)

    def _follow_theme(self) -> None:
        if self.isVisible():
            self._dress()
        else:  # the charts of all pages at once would hold up the window
            self._is_outdated = True

    def _dress(self) -> None:
        self._is_outdated = False
        if self.plot is not None:
            self.plot.dress(self._look.theme, self._ground)
            self.plot.clear()
            self._draw_on(self, self.plot)
