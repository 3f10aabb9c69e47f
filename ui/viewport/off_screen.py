"""Off-screen backend: renders to memory and paints the image."""

from __future__ import annotations

import time

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt, QTimer
from PySide6.QtGui import QImage, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

from ui.viewport.depth import hidden_places, pick_at
from ui.viewport.frame_budget import FRAME_S
from ui.viewport.mouse import Mouse
from ui.viewport.pick import Pick
from ui.viewport.render_window import RenderWindow
from ui.viewport.stage import Stage

GRAB_S = 0.25  # between images of a picture that is not complete
SLOW_RATIO = 0.5


class OffScreenView(QWidget):
    """Shows a stage whose scene is rendered off-screen."""

    def __init__(self, stage: Stage, window: RenderWindow, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._stage, self._window, self._image, self._stale = stage, window, QImage(), True
        self._grabbed = 0.0  # time of the last image
        self._drawn_for = (0, 0, 0.0)  # size and pixel ratio of the widget for which the image was drawn
        self._was_slow = False  # the last frame of a moving camera
        self._is_slow = False  # so slow that pictures of a moving camera have half the resolution
        window.join(self)
        self.mouse = Mouse(self, stage, self.pick)
        self._more = QTimer(self)
        self._more.setSingleShot(True)
        self._more.timeout.connect(self._go_on)
        stage.refreshWanted.connect(self.refresh)
        stage.paintWanted.connect(self.update)
        stage.places_hidden = self._hidden

    @property
    def render_window(self) -> RenderWindow:
        """The window that draws the scene."""
        return self._window

    def refresh(self) -> None:
        """Schedule a redraw."""
        self._stale = True
        self.update()

    def image(self) -> QImage:
        """Return the complete picture with what is painted over it."""
        self._stage.scene.set_moving(False)
        self._stale = True
        self._render()
        while not self._stage.scene.is_complete:
            self._go_on()
        made = self._image.copy()
        made.setDevicePixelRatio(self.devicePixelRatioF())
        painter = QPainter(made)
        self._stage.paint(painter)
        painter.end()
        return made

    def close_view(self) -> None:
        """Release the graphics memory."""
        self._more.stop()
        self._window.take_out(self._stage.scene)
        self._window.leave(self)

    def pick(self, place: QPointF) -> Pick:
        """Return what is at a place of the widget, in logical pixels from the top left corner."""
        self._render(anew=not self._window.shows(self._stage.scene))
        ratio = self._stage.scene.camera.size_px[1] / max(self.height(), 1)
        return pick_at(self._stage.scene, self._window.vtk, place.x() * ratio, (self.height() - place.y()) * ratio - 1.0)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the rendered image and what belongs over it."""
        self._render()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(self.rect(), self._image)
        self._stage.paint(painter)
        self._stage.paint_handles(painter)

    def resizeEvent(self, _event: QResizeEvent) -> None:
        """Render at the new size."""
        self.refresh()

    def changeEvent(self, event: QEvent) -> None:
        """Redraw when the theme changes."""
        if event.type() == QEvent.Type.PaletteChange:
            self.refresh()
        super().changeEvent(event)

    def _render(self, *, anew: bool = False) -> None:
        wanted = (self.width(), self.height(), self.devicePixelRatioF())
        if not self._stale and not anew and self._drawn_for == wanted:
            return
        scene = self._stage.scene
        ratio = wanted[2] * (SLOW_RATIO if scene.is_moving and self._is_slow else 1.0)
        self._stage.resize(self.width(), self.height())
        self._stage.fit_room()
        self._window.put_in(scene, max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio)))
        scene.begin_picture()
        is_new = self._drawn_for != wanted
        self._drawn_for, self._stale = wanted, False
        self._draw(resized=is_new)

    def _go_on(self) -> None:
        """Add points to an incomplete picture; begin anew where another view was drawn since."""
        scene = self._stage.scene
        if self._stale or scene.is_complete:
            return
        if not self._window.shows(scene):
            self._stale = True
        else:
            scene.go_on()
            self._draw(resized=False)
        self.update()

    def _draw(self, *, resized: bool) -> None:
        seconds, scene = self._window.draw(), self._stage.scene
        if scene.is_moving and scene.budget.software:
            slow = seconds > (FRAME_S * SLOW_RATIO**2 if self._is_slow else FRAME_S)
            self._is_slow, self._was_slow = slow and (self._was_slow or self._is_slow), slow  # a single slow frame says nothing
        now = time.monotonic()
        if scene.is_complete or resized or (scene.is_presentable and now - self._grabbed > GRAB_S):
            self._grabbed = now
            self._image = self._window.image()
        self._stage.say_progress()
        if not scene.is_complete:
            self._more.start()
        else:
            self._stage.picture_ready()

    def _hidden(self, places_mm: np.ndarray) -> set[int]:
        if not self._window.shows(self._stage.scene):
            return set(self._stage.furniture.hidden)
        return hidden_places(self._stage.scene, self._window.vtk, places_mm)
