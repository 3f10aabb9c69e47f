"""What all charts draw with; imported when the first chart has something to show, since pyqtgraph would delay the start."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QFrame, QMenu, QWidget

from ui.look.language.words import translated
from ui.look.theme import Theme, font
from ui.look.wording import MINUS

EDGE = 20  # px by which the number at the end of an axis may reach beyond it
SCALE_NUMBERS = 64  # px, width of the numbers and words beside the scale of a map


class NumberAxis(pg.AxisItem):
    """An axis in one stated unit: no prefixes that change with the range, and a true minus sign."""

    def __init__(self, side: str, words: str, *, numbers: bool = True, most: float | None = None) -> None:
        """``most``: no number is written beyond it, as there is nothing."""
        super().__init__(side)
        self.enableAutoSIPrefix(False)
        self.words, self.most = words, most
        self.setStyle(showValues=numbers, tickLength=-4, hideOverlappingLabels=EDGE)

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        """Return the numbers at the ticks."""
        written = [text.replace("-", MINUS) for text in super().tickStrings(values, scale, spacing)]
        return [text if self.most is None or value <= self.most else "" for value, text in zip(values, written, strict=True)]

    def say(self, words: str, theme: Theme) -> None:
        """Name another quantity."""
        self.words = words
        self.dress(theme)

    def dress(self, theme: Theme) -> None:
        """Take colours and letters from the theme."""
        small = theme.sizes["small"]
        self.setTickFont(font(small))
        self.setPen(theme.colour("line"))
        self.setTextPen(theme.colour("soft"))
        if self.words:
            self.setLabel(translated(self.words), **{"color": theme.colours["soft"], "font-size": f"{small}px"})


class Plot(pg.PlotWidget):
    """Axes without menu and without buttons; only those who ask for it can zoom and pan."""

    def __init__(self, bottom: NumberAxis, left: NumberAxis, *, steerable: bool = False) -> None:
        super().__init__(axisItems={"bottom": bottom, "left": left}, enableMenu=False)
        self.axes = (bottom, left)
        self.hideButtons()
        adopt_menu(self, self.getPlotItem().ctrlMenu)
        self.setMouseEnabled(steerable, steerable)
        self.setFrameShape(QFrame.Shape.NoFrame)
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

    def leave_axes(self) -> None:
        """Leave the whole area to what is drawn."""
        self.hideAxis("left")
        self.hideAxis("bottom")

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


class ColourScale:
    """The scale beside a map: colours, numbers, unit; its ends can be dragged."""

    def __init__(self, plot: Plot, image: pg.ImageItem) -> None:
        self._bar = pg.ColorBarItem(width=16, interactive=True, colorMapMenu=False, limits=None, rounding=1e-6)
        adopt_menu(plot, self._bar.ctrlMenu)
        plot.getPlotItem().layout.addItem(self._bar, 2, 5)
        plot.getPlotItem().layout.setColumnFixedWidth(4, 8)
        self._bar.axis.enableAutoSIPrefix(False)
        self._bar.axis.setWidth(SCALE_NUMBERS)
        self._bar.setImageItem(image)
        self.leave()

    @property
    def words(self) -> str:
        """Quantity and unit, as written beside it."""
        return str(self._bar.axis.labelText)

    @property
    def is_shown(self) -> bool:
        """Whether the map has a scale."""
        return bool(self._bar.isVisible())

    def show(self, colours: str, span: tuple[float, float], words: str) -> None:
        """Colour the image between two values."""
        self._bar.setVisible(True)
        self._bar.rounding = max(1e-9, (span[1] - span[0]) / 1000)
        self._bar.setColorMap(pg.colormap.get(colours))
        self._bar.setLevels(span)
        self._bar.axis.setLabel(translated(words))

    def leave(self) -> None:
        """Show no scale."""
        self._bar.setVisible(False)

    def dress(self, theme: Theme) -> None:
        """Take colours and letters from the theme."""
        small = theme.sizes["small"]
        axis = self._bar.axis
        axis.setTickFont(font(small))
        axis.setPen(theme.colour("line"))
        axis.setTextPen(theme.colour("soft"))
        axis.setLabel(translated(axis.labelText), **{"color": theme.colours["soft"], "font-size": f"{small}px"})


def adopt_menu(owner: QWidget, menu: QMenu) -> None:
    """Give a menu a parent: pyqtgraph makes it without one even where it is never shown, so it would outlive the chart."""
    menu.setParent(owner, menu.windowFlags())
