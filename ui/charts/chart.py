"""What every chart has: axes with their units, the colours of the theme, a name for screen readers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from ui.charts.turns import turns
from ui.look.language.words import translated
from ui.look.look import Look

if TYPE_CHECKING:
    from ui.charts.plotting import Plot


class Chart(QWidget):
    """Axes that are made with the first data in sight, and drawn upon again when data, theme or language have changed.

    What cannot be seen is drawn when it comes into sight: the charts of all pages, drawn at every event of a job, would hold up the window.
    """

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
        """Draw the present data as soon as the chart is in sight; ``spoken`` describes them to a screen reader."""
        self.setAccessibleDescription(translated(spoken))
        self._is_outdated = True
        self._catch_up()

    def begin(self) -> bool:
        """Make the axes, which takes a while, and draw; whether there was something to do."""
        if self.plot is not None or not self._is_wanted:
            return False
        self.plot = self._axes_of(self)
        self.layout().addWidget(self.plot)
        self.plot.show()  # else only with the next event
        self._dress(self.plot)
        return True

    @property
    def _is_wanted(self) -> bool:
        return self._is_outdated and self.isVisible()

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what was changed while the chart could not be seen."""
        super().showEvent(event)
        if self._is_outdated and self.plot is not None:
            self._dress(self.plot)  # the theme may be another
        else:
            self._catch_up()

    def _catch_up(self) -> None:
        if not self._is_wanted:
            return
        if self.plot is None:
            turns().wait(self)
        else:
            self._draw(self.plot)

    def _draw(self, plot: Plot) -> None:
        plot.clear()
        self._draw_on(self, plot)
        self._is_outdated = False

    def _follow_theme(self) -> None:
        if self.plot is None:
            return  # axes are made in the theme
        self._is_outdated = True
        if self.isVisible():
            self._dress(self.plot)

    def _dress(self, plot: Plot) -> None:
        plot.dress(self._look.theme, self._ground)
        self._draw(plot)
