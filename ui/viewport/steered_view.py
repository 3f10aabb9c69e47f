"""What keys, menus and buttons do with a 3-D view."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from ui.viewport.clip_box import ClipBox

if TYPE_CHECKING:
    from ui.viewport.stage import Stage


class SteeredView(QWidget):
    """A view with a stage, once it is live; before, steering does nothing."""

    sectionAsked = Signal()  # C
    clipAsked = Signal()  # X
    labelsToggled = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.stage: Stage | None = None
        self.selection_mm: np.ndarray | None = None  # (N, 3), what Shift+F shows

    def look_from(self, name: str) -> None:
        """Show everything from a standard direction: front, back, left, right, top, bottom, isometric."""
        if self.stage is not None:
            self.stage.look_from(name)

    def fit(self) -> None:
        """Show everything without rotation."""
        if self.stage is not None:
            self.stage.fit()

    def fit_selection(self) -> None:
        """Show what is selected without rotation; everything, if nothing is."""
        if self.stage is None:
            return
        if self.selection_mm is None or not len(self.selection_mm):
            self.stage.fit()
        else:
            self.stage.scene.look_at(np.asarray(self.selection_mm, float))
            self.stage.refreshWanted.emit()

    def toggle_parallel(self) -> None:
        """Change between parallel and perspective projection."""
        if self.stage is not None:
            self.stage.set_parallel(not self.stage.scene.camera.is_parallel)

    def toggle_edges(self) -> None:
        """Show or hide the edges of the triangles."""
        if self.stage is not None:
            scene = self.stage.scene
            scene.show_surface_as(transparent=scene.is_transparent, edges=not scene.has_edges)
            self.stage.refreshWanted.emit()

    def toggle_transparent(self) -> None:
        """Show the surface transparent or solid."""
        if self.stage is not None:
            scene = self.stage.scene
            scene.show_surface_as(transparent=not scene.is_transparent, edges=scene.has_edges)
            self.stage.refreshWanted.emit()

    def toggle_labels(self) -> None:
        """Show or hide flags."""
        if self.stage is not None:
            furniture = self.stage.furniture
            furniture.has_flags = not furniture.has_flags
            self.stage.paintWanted.emit()
            self.labelsToggled.emit(furniture.has_flags)

    def toggle_furniture(self) -> None:
        """Show or hide triad, cube, scale bar and legend."""
        if self.stage is not None:
            self.stage.furniture.is_visible = not self.stage.furniture.is_visible
            self.stage.furniture.forget_places()
            self.stage.paintWanted.emit()

    def turn(self, right_rad: float, up_rad: float) -> None:
        """Rotate the part."""
        if self.stage is not None:
            camera = self.stage.scene.camera
            self.stage.steer(lambda: camera.turn(right_rad, up_rad))

    def pan(self, right: float, up: float) -> None:
        """Move the part by fractions of the picture's height."""
        if self.stage is not None:
            camera, height = self.stage.scene.camera, self.stage.scene.camera.size_px[1]
            self.stage.steer(lambda: camera.pan(right * height, up * height))

    def zoom(self, times: float) -> None:
        """Enlarge the picture about its middle."""
        if self.stage is not None:
            camera = self.stage.scene.camera
            self.stage.steer(lambda: camera.zoom(times))

    def set_clip(self, clip: ClipBox | None) -> None:
        """Hide what is outside a box; None: without a box."""
        if self.stage is not None:
            self.stage.set_clip(clip)

    @property
    def clip(self) -> ClipBox | None:
        """The clip box, which may be switched off."""
        return None if self.stage is None else self.stage.scene.clip
