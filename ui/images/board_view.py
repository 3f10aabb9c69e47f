"""A camera image with overlays: detected corners, coverage, and the wanted next position of the board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor

from ui.images.camera_view import CameraView
from ui.look.look import Look

if TYPE_CHECKING:
    from ui.charts.plotting import Plot
    from ui.look.theme import Theme

DOT_PX = 6.0
HEAT = 0.35  # opacity of covered cells
DARK, LIT = QColor(0, 0, 0, 160), QColor("#EDAE49")  # on images, which are grey in every theme


@dataclass(frozen=True, eq=False)
class Overlay:
    """Overlays of an image, in its pixels."""

    corners_px: np.ndarray | None = None  # (N, 2)
    left_out_px: np.ndarray | None = None  # (M, 2), corners rejected by the calibration
    ghost_px: np.ndarray | None = None  # (K, 2), outline of the wanted next position of the board
    coverage: np.ndarray | None = None  # (rows, columns) number of corners in each cell


class Marks:
    """What is drawn on top of an image of a board."""

    def __init__(self) -> None:
        self.overlay, self.size = Overlay(), (1, 1)  # size: height and width of the image in px
        self.chosen: frozenset[str] = frozenset({"corners", "coverage", "ghost"})

    def draw(self, plot: Plot, theme: Theme) -> None:
        """Draw coverage, ghost and corners."""
        shown = self.overlay
        if "coverage" in self.chosen and shown.coverage is not None:
            _draw_coverage(plot, shown.coverage, self.size, theme.colour("accent"))
        if "ghost" in self.chosen and shown.ghost_px is not None:
            _draw_ghost(plot, shown.ghost_px)
        if "corners" in self.chosen:
            for corners, colour in ((shown.corners_px, "verdict_pass"), (shown.left_out_px, "verdict_fail")):
                if corners is not None:
                    _draw_corners(plot, corners, theme.colour(colour))


class BoardView(CameraView):
    """Shows one image with overlays and a caption, or words."""

    def __init__(self, look: Look) -> None:
        self.marks = Marks()
        super().__init__(look, over=self.marks.draw)
        self.setMinimumSize(320, 200)

    def show_board(self, pixels: np.ndarray, overlay: Overlay, caption: str) -> None:
        """Show an image (H, W) with its overlays."""
        self.marks.overlay, self.marks.size = overlay, (pixels.shape[0], pixels.shape[1])
        self.show_image(pixels, caption)

    def show_layers(self, names: Sequence[str]) -> None:
        """Choose the overlays: ``corners``, ``coverage`` and ``ghost``."""
        self.marks.chosen = frozenset(names)
        if self.map.layer is not None:
            self.map.show_layer(self.map.layer)


def _draw_coverage(plot: Plot, coverage: np.ndarray, size: tuple[int, int], colour: QColor) -> None:
    """Tint the covered cells."""
    import pyqtgraph as pg

    tint = np.zeros((*coverage.shape, 4), np.uint8)
    tint[..., :3] = colour.getRgb()[:3]
    tint[..., 3] = np.where(coverage > 0, 255 * HEAT * (0.3 + 0.7 * coverage / max(1.0, float(coverage.max()))), 0)
    cells = pg.ImageItem(axisOrder="row-major")
    cells.setImage(tint, levels=None, autoLevels=False)  # else colours are stretched to the brightest
    cells.setRect(-0.5, -0.5, size[1], size[0])
    plot.addItem(cells)


def _draw_ghost(plot: Plot, outline: np.ndarray) -> None:
    import pyqtgraph as pg

    closed = np.vstack([outline, outline[:1]])
    for pen in (pg.mkPen(DARK, width=5), pg.mkPen(LIT, width=2.5, style=Qt.PenStyle.DashLine)):
        plot.addItem(pg.PlotCurveItem(closed[:, 0], closed[:, 1], pen=pen))


def _draw_corners(plot: Plot, corners: np.ndarray, colour: QColor) -> None:
    import pyqtgraph as pg

    plot.addItem(pg.ScatterPlotItem(corners[:, 0], corners[:, 1], size=DOT_PX, pen=pg.mkPen(DARK, width=1), brush=pg.mkBrush(colour)))
