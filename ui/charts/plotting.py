"""What all charts draw with; imported when the first chart has something to show, since pyqtgraph would delay the start."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor

from ui.look.theme import Theme, font
from ui.look.wording import MINUS

EDGE = 20  # px by which the number at the end of an axis may reach beyond it


class NumberAxis(pg.AxisItem):
    """An axis in one stated unit: no prefixes that change with the range, and a true minus sign."""

    def __init__(self, side: str, words: str, *, numbers: bool = True) -> None:
        super().__init__(side)
        self.enableAutoSIPrefix(False)
        self.words = words
        self.setStyle(showValues=numbers, tickLength=-4, hideOverlappingLabels=EDGE)

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        """Return the numbers at the ticks."""
        return [text.replace("-", MINUS) for text in super().tickStrings(values, scale, spacing)]

    def dress(self, theme: Theme) -> None:
        """Take colours and letters from the theme."""
        small = theme.sizes["small"]
        self.setTickFont(font(small))
        self.setPen(theme.colour("line"))
        self.setTextPen(theme.colour("soft"))
        if self.words:
            self.setLabel(self.words, **{"color": theme.colours["soft"], "font-size": f"{small}px"})


class Plot(pg.PlotWidget):
    """Axes without menu and without buttons; only those who ask for it can zoom and pan."""

    def __init__(self, bottom: NumberAxis, left: NumberAxis, *, steerable: bool = False) -> None:
        super().__init__(axisItems={"bottom": bottom, "left": left}, enableMenu=False)
        self.axes = (bottom, left)
        self.hideButtons()
        menu = self.getPlotItem().ctrlMenu
        menu.setParent(
            self, menu.windowFlags()
        )  # pyqtgraph makes it without a parent even where it is never shown: it would outlive the chart
        self.setMouseEnabled(steerable, steerable)
        self.setFrameShape(pg.QtWidgets.QFrame.Shape.NoFrame)
        if not steerable:
            self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)  # so that the wheel still scrolls the page
            self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def sizeHint(self) -> QSize:
        """Leave the size to the chart."""
        return QSize(0, 0)

    def minimumSizeHint(self) -> QSize:
        """Leave the size to the chart."""
        return QSize(0, 0)

    def leave_edges(self) -> None:
        """Leave room for the numbers at the ends of the bottom axis, where no left axis does."""
        self.hideAxis("left")
        self.getPlotItem().layout.setContentsMargins(EDGE, 0, EDGE, 0)

    def dress(self, theme: Theme, ground: str) -> None:
        """Take colours and letters from the theme."""
        self.setBackground(theme.colour(ground))
        for axis in self.axes:
            axis.dress(theme)


def bars(edges: np.ndarray, tops: np.ndarray, fills: Sequence[QColor], outline: QColor | None = None) -> pg.BarGraphItem:
    """Return upright bars between edges (N + 1,), from zero to tops (N,), each in its colour."""
    return pg.BarGraphItem(
        x0=edges[:-1], x1=edges[1:], y0=np.zeros(len(tops)), y1=tops, brushes=list(fills), pen=pg.mkPen(outline) if outline else None
    )
