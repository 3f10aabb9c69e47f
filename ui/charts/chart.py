"""What every chart has: axes with their units, the colours of the theme, a name for screen readers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

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
        """Draw the present data, now or as soon as the chart is in sight; ``spoken`` describes them to a screen reader."""
        self.setAccessibleDescription(translated(spoken))
        if self.isVisible():
            self.draw()
        else:
            self._is_outdated = True

    def draw(self) -> None:
        """Draw the present data at once."""
        plot = self.prepare()
        plot.clear()
        self._draw_on(self, plot)
        self._is_outdated = False

    def prepare(self) -> Plot:
        """Return the axes; they are made where there are none yet, which takes a while."""
        if self.plot is None:
            self.plot = self._axes_of(self)
            self.layout().addWidget(self.plot)
            self.plot.show()  # else only with the next event
            self.plot.dress(self._look.theme, self._ground)
        return self.plot

    def showEvent(self, event: QShowEvent) -> None:
        """Draw what was changed while the chart could not be seen; axes are made after the page is laid out, as they take a while."""
        if self._is_outdated and self.plot is not None:
            self._dress()
        elif self._is_outdated:
            QTimer.singleShot(0, self, self._catch_up)
        super().showEvent(event)

    def _catch_up(self) -> None:
        if self._is_outdated and self.isVisible():
            self._dress()

    def _follow_theme(self) -> None:
        self._is_outdated = self._is_outdated or self.plot is not None  # axes that are made later are made in the theme
        self._catch_up()

    def _dress(self) -> None:
        if self.plot is not None:
            self.plot.dress(self._look.theme, self._ground)
        self.draw()
