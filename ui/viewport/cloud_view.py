"""The 3-D widget; it shows a placeholder until VTK is loaded."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QShowEvent
from PySide6.QtWidgets import QLabel, QStackedLayout, QWidget

from ui.look.look import Look
from ui.viewport.backend import NO_GRAPHICS, choose_backend, off_screen_window
from ui.viewport.layers import CloudLayer, Label, LineLayer, SurfaceLayer
from ui.viewport.shuffled_cloud import ShuffledCloud, shuffle

if TYPE_CHECKING:
    from ui.viewport.native import NativeView
    from ui.viewport.off_screen import OffScreenView
    from ui.viewport.scene import Scene

STEP_DEG = 15.0
TURNS = {
    Qt.Key.Key_Left: (-STEP_DEG, 0.0),
    Qt.Key.Key_Right: (STEP_DEG, 0.0),
    Qt.Key.Key_Up: (0.0, STEP_DEG),
    Qt.Key.Key_Down: (0.0, -STEP_DEG),
}
ZOOMS = {Qt.Key.Key_Plus: 1.25, Qt.Key.Key_Equal: 1.25, Qt.Key.Key_Minus: 0.8}
PICKS = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
KEYS = "Arrow keys rotate, plus and minus zoom, Home shows everything, Enter picks the point in the centre."
PREPARING = "Preparing 3-D view…"


class CloudView(QWidget):
    """Shows clouds, a surface, lines and labels; drag rotates, Shift and drag pans, the wheel zooms, a click picks a point.

    Keys: arrows rotate, + and − zoom, Home shows everything, Enter picks the point in the centre.
    """

    pointPicked = Signal(int, int)  # layer, index in the layer
    rayClicked = Signal(object, object)  # origin and direction, where a click hits no point

    def __init__(self, look: Look, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._look = look
        self._scene: Scene | None = None
        self._view: OffScreenView | NativeView | None = None
        self._allowed = False
        self._clouds: tuple[CloudLayer, ...] = ()
        self._cloud = shuffle(())
        self._surface: SurfaceLayer | None = None
        self._lines: tuple[LineLayer, ...] = ()
        self._labels: tuple[Label, ...] = ()
        self._framing: tuple[np.ndarray | None, tuple[float, float, float]] | None = None
        self._placeholder = QLabel(PREPARING, alignment=Qt.AlignmentFlag.AlignCenter)
        self._placeholder.setProperty("role", "soft")
        self._placeholder.setWordWrap(True)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self._placeholder)
        self.setMinimumSize(280, 240)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName("3-D view")
        self.setAccessibleDescription(KEYS)
        look.changed.connect(self._apply_theme)

    @property
    def is_live(self) -> bool:
        """Whether the 3-D view draws."""
        return self._view is not None

    def activate(self) -> None:
        """Enable drawing, when the widget is visible; VTK should have been imported, or the window waits for it."""
        self._allowed = True
        if self.isVisible():
            self._create()

    def explain(self, problem: str) -> None:
        """Show the reason for a missing 3-D view."""
        self._placeholder.setText(problem)

    def set_clouds(self, layers: Sequence[CloudLayer], cloud: ShuffledCloud | None = None) -> None:
        """Show these clouds; ``cloud``: all of them, if they were shuffled already in a thread."""
        self._clouds = tuple(layers)
        self._cloud = shuffle(self._clouds) if cloud is None else cloud
        if self._scene is not None:
            self._scene.set_cloud(self._cloud)
            self._refresh()

    def set_surface(self, layer: SurfaceLayer | None) -> None:
        """Show this surface, or none."""
        self._surface = layer
        if self._scene is not None:
            self._scene.set_surface(layer)
            self._refresh()

    def set_lines(self, layers: Sequence[LineLayer]) -> None:
        """Show these lines."""
        self._lines = tuple(layers)
        if self._scene is not None:
            self._scene.set_lines(self._lines)
            self._refresh()

    def set_labels(self, labels: Sequence[Label]) -> None:
        """Show these labels."""
        self._labels = tuple(labels)
        if self._scene is not None:
            self._scene.set_labels(self._labels)
            self._refresh()

    def reset_camera(self) -> None:
        """Show everything."""
        if self._scene is not None:
            self._scene.keep_framed = True
            self._refresh()

    def frame(self, points_mm: np.ndarray | None, direction: tuple[float, float, float]) -> None:
        """Open the camera on these points (N, 3), None: on everything, from a direction; a camera that was moved by hand stays."""
        self._framing = (points_mm, direction)
        if self._scene is not None:
            self._scene.frame(*self._framing)
            self._refresh()

    def look_at(self, points_mm: np.ndarray) -> None:
        """Move the camera to these points (N, 3) without rotation."""
        if self._scene is not None and len(points_mm):
            self._scene.look_at(np.asarray(points_mm, float))
            self._refresh()

    def screenshot(self) -> QImage:
        """Return the picture; empty while there is no 3-D view."""
        return QImage() if self._view is None else self._view.image()

    def close_view(self) -> None:
        """Release the graphics memory and show the placeholder."""
        if self._view is not None:
            self._view.close_view()
            self._stack.removeWidget(self._view)
            self._view.deleteLater()
        self._view, self._scene, self._allowed = None, None, False

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Rotate, zoom and pick by keyboard."""
        key, scene = Qt.Key(event.key()), self._scene
        if scene is None or not (key in TURNS or key in ZOOMS or key in PICKS or key == Qt.Key.Key_Home):
            super().keyPressEvent(event)
        elif key in PICKS:
            width, height = scene.renderer.GetSize()
            self._pick(width / 2, height / 2)
        else:
            if key in TURNS:
                scene.turn(*TURNS[key])
            elif key in ZOOMS:
                scene.approach(ZOOMS[key])
            else:
                scene.keep_framed = True
            self._refresh()

    def showEvent(self, event: QShowEvent) -> None:
        """Create the 3-D view when it is first visible."""
        super().showEvent(event)
        if self._allowed:
            self._create()

    def _create(self) -> None:
        if self._view is not None:
            return
        from ui.viewport.scene import Scene

        scene = Scene()
        view = _new_view(scene)
        if view is None:
            self._allowed = False
            self.explain(NO_GRAPHICS)
            return
        self._scene, self._view = scene, view
        view.clicked.connect(self._pick)
        self._apply_theme()
        if self._framing is not None:
            scene.frame(*self._framing)
        scene.set_cloud(self._cloud)
        scene.set_surface(self._surface)
        scene.set_lines(self._lines)
        scene.set_labels(self._labels)
        self._stack.addWidget(view)
        self._stack.setCurrentWidget(view)
        self._refresh()

    def _pick(self, x_px: float, y_px: float) -> None:
        found = self._scene.pick(x_px, y_px) if self._scene is not None else None
        if found is not None:
            self.pointPicked.emit(*found)
        elif self._scene is not None:
            self.rayClicked.emit(*self._scene.ray(x_px, y_px))

    def _apply_theme(self) -> None:
        if self._scene is not None:
            theme = self._look.theme
            self._scene.set_background(_rgb(theme.colour("viewport_top")), _rgb(theme.colour("viewport_bottom")))
            self._refresh()

    def _refresh(self) -> None:
        if self._view is not None:
            self._view.refresh()


def _new_view(scene: Scene) -> OffScreenView | NativeView | None:
    if choose_backend() == "native":
        from ui.viewport.native import NativeView

        return NativeView(scene)
    window = off_screen_window()
    if window is None:
        return None
    from ui.viewport.off_screen import OffScreenView

    return OffScreenView(scene, window)


def _rgb(colour: QColor) -> tuple[float, float, float]:
    return colour.redF(), colour.greenF(), colour.blueF()
