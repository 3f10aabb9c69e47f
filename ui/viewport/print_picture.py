"""Pictures for print: the scene drawn anew at print resolution, with its furniture laid out for that size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from PySide6.QtGui import QImage, QPainter

from ui.viewport.overlay.style import OverlayStyle
from ui.viewport.render_window import RenderWindow
from ui.viewport.stage import Stage, free_fractions

MM_PER_INCH, POINTS_PER_INCH = 25.4, 72.0
LETTERS_PT, LETTERS_PX = 8.0, 12.0  # size on paper of letters that have 12 px in the window
Background = Literal["white", "transparent"]


@dataclass(frozen=True)
class PrintSize:
    """Width on paper, resolution and background of a picture."""

    width_mm: float = 170.0
    dpi: float = 300.0
    background: Background = "white"

    @property
    def width_px(self) -> int:
        """Number of pixels across."""
        return round(self.width_mm / MM_PER_INCH * self.dpi)

    @property
    def scale(self) -> float:
        """Magnification of letters and lines."""
        return self.dpi * LETTERS_PT / POINTS_PER_INCH / LETTERS_PX


def print_picture(stage: Stage, window: RenderWindow, size: PrintSize, style: OverlayStyle, corner: Sequence[str] = ()) -> QImage:
    """Draw a stage for print, completely, in the proportions of its window.

    ``style`` has the colours for light paper; ``corner`` is printed in the lower right: part and date.
    """
    width = size.width_px
    height = round(width * stage.height / stage.width)
    renderer, scene = stage.scene.renderer, stage.scene
    large = replace(style, scale=size.scale)
    former = stage.width, stage.height, tuple(window.vtk.GetSize()), window.vtk.GetUseOffScreenBuffers(), scene.camera.free
    colours = renderer.GetBackground(), renderer.GetBackground2(), renderer.GetBackgroundAlpha()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetBackground2(1.0, 1.0, 1.0)
    renderer.SetGradientBackground(size.background == "white")
    renderer.SetBackgroundAlpha(1.0 if size.background == "white" else 0.0)
    window.vtk.SetUseOffScreenBuffers(True)
    scene.camera.free = free_fractions(stage.furniture, width, height, large)
    try:
        drawn = _draw(stage, window, (width, height), size.background == "transparent")
    finally:
        renderer.SetGradientBackground(True)
        renderer.SetBackground(colours[0])
        renderer.SetBackground2(colours[1])
        renderer.SetBackgroundAlpha(colours[2])
        window.vtk.SetUseOffScreenBuffers(former[3])
        window.vtk.SetSize(*former[2])
        scene.camera.free = former[4]
    _paint(drawn, stage, large, tuple(corner))
    drawn.setDotsPerMeterX(round(size.dpi / MM_PER_INCH * 1000.0))
    drawn.setDotsPerMeterY(round(size.dpi / MM_PER_INCH * 1000.0))
    stage.refreshWanted.emit()
    return drawn


def _draw(stage: Stage, window: RenderWindow, size_px: tuple[int, int], with_alpha: bool) -> QImage:
    scene = stage.scene
    scene.set_moving(False)
    window.put_in(scene, *size_px)
    scene.begin_picture()
    window.draw()
    while not scene.is_complete:
        scene.go_on()
        window.draw()
    return window.image(with_alpha=with_alpha).convertToFormat(
        QImage.Format.Format_ARGB32_Premultiplied if with_alpha else QImage.Format.Format_RGB32
    )


def _paint(drawn: QImage, stage: Stage, style: OverlayStyle, corner: tuple[str, ...]) -> None:
    """Paint the furniture at the size of the print; dragged flags keep their places."""
    furniture = replace(stage.furniture, corner=corner, progress="", hovered="", moving=False)
    furniture.forget_places()
    painter = QPainter(drawn)
    furniture.paint(painter, stage.scene.camera.view(drawn.width(), drawn.height()), style)
    painter.end()
