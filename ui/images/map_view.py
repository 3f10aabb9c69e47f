"""A map of numbers, or a picture of which pixels are chosen: zoom, cursor, scale of the colours, a line for a profile."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent

from ui.charts.chart import Chart
from ui.images.layers import SATURATED, Layer
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import with_unit

if TYPE_CHECKING:
    from pyqtgraph.GraphicsScene.mouseEvents import MouseClickEvent

    from ui.charts.plotting import Plot
    from ui.look.theme import Theme

Pixel = tuple[int, int]  # row, column
GREYS = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)  # colours by level
MARKED = np.vstack([GREYS[:-1], np.array(SATURATED, np.uint8)])  # the last level is saturation
ARROWS = {Qt.Key.Key_Up: (-1, 0), Qt.Key.Key_Down: (1, 0), Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1)}


class MapView(Chart):
    """Shows one layer or picture; the wheel zooms, dragging pans, a double click shows all, a click or the arrow keys move the cursor."""

    pointed = Signal(int, int)  # row, column under the mouse, or of the cursor
    pixelChosen = Signal(int, int)  # row, column, by a click or a key
    lineMoved = Signal(object)  # ((row, column), (row, column)), by the mouse

    def __init__(self, look: Look, *, axes: bool = True, over: Callable[[Plot, Theme], None] | None = None) -> None:
        """``axes``: rows and columns are numbered at the edges; ``over`` draws on top of the image, in its pixels; it must not refer to the view."""
        super().__init__(look, MapView._make_plot, MapView._draw_image, ground="sunken")
        self._numbered, self._over = axes, over
        self.layer: Layer | None = None
        self.pixels: np.ndarray | None = None  # (H, W, 3) uint8, where a picture is shown
        self.saturation: int | None = None
        self.cursor_pixel: Pixel | None = None
        self._shape = (0, 0)
        self._is_unfitted = False  # an image of another size is not fitted into the view yet
        self._ends: tuple[Pixel, Pixel] | None = None  # of the line
        self._items: dict[str, Any] = {}
        self._moving = False  # the line, by the program
        self.setMinimumSize(320, 240)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(tr("Map"))

    def show_layer(self, layer: Layer, saturation: int | None = None) -> None:
        """Show a layer; pixels of an image that reach ``saturation`` are marked. Zoom is kept for images of one size."""
        self.layer, self.pixels, self.saturation = layer, None, saturation
        self._show(layer.quantity, layer.values.shape)

    def show_pixels(self, pixels: np.ndarray) -> None:
        """Show a picture (H, W, 3) uint8, red green blue. Zoom is kept for pictures of one size."""
        self.layer, self.pixels = None, pixels
        self._show("Picture", pixels.shape[:2])

    def _show(self, words: str, shape: tuple[int, ...]) -> None:
        self._is_unfitted, self._shape = self._is_unfitted or shape != self._shape, (shape[0], shape[1])
        self.redraw(tr("{words}, {width} × {height} px", words=words, width=shape[1], height=shape[0]))

    @property
    def is_empty(self) -> bool:
        """Whether nothing is shown."""
        return self.layer is None and self.pixels is None

    def clear(self) -> None:
        """Show nothing."""
        self.layer, self.pixels, self.cursor_pixel = None, None, None
        self._shape = (0, 0)
        if self.plot is not None:
            self.plot.clear()

    def show_all(self) -> None:
        """Fit the image into the view."""
        if self.plot is not None:
            self._is_unfitted = False
            height, width = self._shape
            self.plot.setRange(xRange=(-0.5, width - 0.5), yRange=(-0.5, height - 0.5), padding=0.0)

    def show_line(self, ends: tuple[Pixel, Pixel] | None) -> None:
        """Draw the line of a profile between two pixels, or none."""
        self._ends = ends
        if self.plot is not None:
            self._place_line(self.plot)

    def _place_line(self, plot: Plot) -> None:
        if self._ends is None and "line" not in self._items:
            return
        line = self._line(plot)
        line.setVisible(self._ends is not None)
        if self._ends is not None:
            self._moving = True
            for handle, (row, column) in zip(line.getHandles(), self._ends, strict=True):
                line.movePoint(handle, (column, row), coords="parent")
            self._moving = False

    def pixel_at(self, place: QPointF) -> Pixel | None:
        """Return the pixel (row, column) at a position of the widget; None outside the image."""
        if self.plot is None or self.is_empty:
            return None
        at = self.plot.getViewBox().mapSceneToView(self.plot.mapToScene(self.plot.mapFrom(self, place.toPoint())))
        row, column = round(at.y()), round(at.x())
        return (row, column) if 0 <= row < self._shape[0] and 0 <= column < self._shape[1] else None

    def place_of(self, row: int, column: int) -> QPointF:
        """Return the position of the centre of a pixel in the widget."""
        assert self.plot is not None
        scene = self.plot.getViewBox().mapViewToScene(QPointF(column, row))
        return QPointF(self.plot.mapTo(self, self.plot.mapFromScene(scene)))

    def point_at(self, row: int, column: int) -> None:
        """Move the cursor to a pixel, and tell it."""
        self.choose((row, column))
        self.pointed.emit(row, column)

    def choose(self, pixel: Pixel | None) -> None:
        """Put the cursor on a pixel, and scroll to it; or remove the cursor."""
        self.cursor_pixel = pixel
        if self.plot is not None:
            self._place_cursor(self.plot)

    def _place_cursor(self, plot: Plot) -> None:
        pixel = self.cursor_pixel
        self._mark_cursor()
        if pixel is not None and not plot.getViewBox().viewRect().contains(QPointF(pixel[1], pixel[0])):
            shown = plot.getViewBox().viewRect()
            shown.moveCenter(QPointF(pixel[1], pixel[0]))
            plot.setRange(shown, padding=0.0)

    def _mark_cursor(self) -> None:
        pixel = self.cursor_pixel
        self._items["cursor"].setData(*([], []) if pixel is None else ([pixel[1]], [pixel[0]]))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move the cursor by one pixel, with Shift by ten."""
        step = ARROWS.get(Qt.Key(event.key()))
        if step is None or self.is_empty:
            super().keyPressEvent(event)
            return
        by = 10 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1
        height, width = self._shape
        row, column = self.cursor_pixel or (height // 2, width // 2)
        pixel = min(max(0, row + by * step[0]), height - 1), min(max(0, column + by * step[1]), width - 1)
        self.point_at(*pixel)
        self.pixelChosen.emit(*pixel)

    def _make_plot(self) -> Plot:
        import pyqtgraph as pg

        from ui.charts.plotting import NumberAxis, Plot

        plot = Plot(NumberAxis("bottom", "Column [px]"), NumberAxis("left", "Row [px]"), steerable=True)
        plot.invertY(True)
        plot.setAspectLocked(True)
        plot.setFocusProxy(self)
        if not self._numbered:
            plot.leave_axes()
        image = pg.ImageItem(
            np.zeros((1, 1), np.float32), axisOrder="row-major"
        )  # without data it would keep the scale's range for pictures
        self._items = {"image": image, "cursor": pg.ScatterPlotItem(size=14, symbol="+")}
        plot.scene().sigMouseMoved.connect(self._tell_pointed)
        plot.scene().sigMouseClicked.connect(self._take_click)
        return plot

    def _line(self, plot: Plot) -> Any:
        """Return the line of a profile, which is made when it is needed first: live images need none."""
        import pyqtgraph as pg

        from ui.charts.plotting import adopt_menu

        if "line" not in self._items:
            line = pg.LineSegmentROI([(0, 0), (1, 1)], pen=pg.mkPen(self._look.theme.colour("accent"), width=2))
            line.setZValue(20)
            for handle in line.getHandles():
                adopt_menu(plot, handle.menu)
            line.sigRegionChanged.connect(self._tell_line)
            self._items["line"] = line
            plot.addItem(line)
        return self._items["line"]

    def _show_scale(self, plot: Plot, layer: Layer | None) -> None:
        """Show the scale of a layer, made when it is needed first, or none."""
        from ui.charts.plotting import ColourScale

        if layer is not None:
            if "scale" not in self._items:
                self._items["scale"] = ColourScale(plot, self._items["image"])
            scale = self._items["scale"]
            scale.show(layer.colours, layer.span, with_unit(layer.quantity, layer.unit))
            scale.dress(self._look.theme)
        elif "scale" in self._items:
            self._items["scale"].leave()

    def _draw_image(self, plot: Plot) -> None:
        import pyqtgraph as pg

        layer, theme = self.layer, self._look.theme
        if self.is_empty:
            return
        image = self._items["image"]
        is_scaled = layer is not None and not layer.categories and layer.colours != "grey"
        if layer is None:
            image.setImage(self.pixels, levels=None, autoLevels=False)
        elif layer.categories:
            image.setImage(_coloured(layer), levels=None, autoLevels=False)
        elif layer.colours == "grey":
            image.setImage(
                _levels(layer.values, self.saturation), levels=None, autoLevels=False, lut=GREYS if self.saturation is None else MARKED
            )
        else:
            image.setImage(layer.values, autoLevels=False, levels=layer.span)
        self._show_scale(plot, layer if is_scaled else None)
        image.setRect(-0.5, -0.5, self._shape[1], self._shape[0])  # the centre of the first pixel is (0, 0)
        if "line" in self._items:
            self._items["line"].setPen(pg.mkPen(theme.colour("accent"), width=2))
        self._items["cursor"].setPen(pg.mkPen(theme.colour("verdict_not_proven"), width=2))
        for name in ("image", "cursor", "line"):
            if name in self._items:
                plot.addItem(self._items[name])
        self._mark_cursor()
        self._place_line(plot)
        if self._is_unfitted:
            self.show_all()
        if self._over is not None:
            self._over(plot, theme)

    def _tell_pointed(self, place: QPointF) -> None:
        assert self.plot is not None
        pixel = self.pixel_at(QPointF(self.plot.mapTo(self, self.plot.mapFromScene(place))))
        if pixel is not None:
            self.pointed.emit(*pixel)

    def _take_click(self, event: MouseClickEvent) -> None:
        assert self.plot is not None
        if event.double():
            self.show_all()
            return
        pixel = self.pixel_at(QPointF(self.plot.mapTo(self, self.plot.mapFromScene(event.scenePos()))))
        if pixel is not None and event.button() == Qt.MouseButton.LeftButton:
            self.point_at(*pixel)
            self.pixelChosen.emit(*pixel)

    def _tell_line(self) -> None:
        if self._moving or self.layer is None:
            return
        line = self._items["line"]
        ends = []
        for handle in line.getHandles():
            at = line.mapToParent(handle.pos())
            ends.append((min(max(0, round(at.y())), self._shape[0] - 1), min(max(0, round(at.x())), self._shape[1] - 1)))
        self._ends = ends[0], ends[1]  # where it stays when the image is another
        self.lineMoved.emit(self._ends)


def _coloured(layer: Layer) -> np.ndarray:
    """Return the colours (H, W, 4) uint8 of a map of categories."""
    table = np.array([(*one.colour, 255) for one in layer.categories] + [(0, 0, 0, 0)], np.uint8)
    return table[np.where(np.isfinite(layer.values), layer.values, len(layer.categories)).astype(np.intp)]


def _levels(values: np.ndarray, saturation: int | None) -> np.ndarray:
    """Return the levels (H, W) uint8 of an image: 255 where it is saturated and nowhere else; without ``saturation`` up to its brightest pixel.

    Images of 8 bits are returned as they are: live ones come ten times per second from every camera.
    """
    if values.dtype == np.uint8 and saturation in (None, 255):
        return values
    if saturation is None:
        return (values * np.float32(255.0 / max(1.0, float(values.max(initial=0))))).astype(np.uint8)
    levels = np.minimum(values * np.float32(255.0 / saturation), 254).astype(np.uint8)
    levels[values >= saturation] = 255
    return levels
