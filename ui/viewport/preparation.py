"""Preparation of a render window in idle time: graphics driver and shaders are loaded in steps, between which the window answers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QTimer

from ui.viewport.layers import CloudLayer, LineLayer, SurfaceLayer
from ui.viewport.prepared_surface import prepare_surface
from ui.viewport.render_window import RenderWindow
from ui.viewport.scene import Scene
from ui.viewport.shuffled_cloud import shuffle

SIZE_PX, PAUSE_MS = 64, 30


class Preparation(QTimer):
    """Draws one kind of content after the other in a tiny picture; ends by itself, or as soon as a view is drawn."""

    def __init__(self, window: RenderWindow) -> None:
        super().__init__(window)
        self._window, self._scene = window, Scene()
        corners = np.eye(3)
        grey = np.full((3, 3), 99, np.uint8)
        triangle = np.array([[0, 1, 2]])
        self._steps: list[Callable[[], None]] = [
            lambda: None,  # loads the driver
            lambda: None,
            lambda: self._scene.set_cloud(shuffle([CloudLayer(corners, grey)])),
            lambda: self._scene.set_surface(prepare_surface(SurfaceLayer(corners, triangle))),
            lambda: self._scene.set_surface(prepare_surface(SurfaceLayer(corners, triangle, grey))),
            lambda: self._scene.set_lines([LineLayer((corners,), (9, 9, 9))]),
        ]
        self.setInterval(PAUSE_MS)
        self.timeout.connect(self._step)
        window.closing.connect(self.end)
        self.start()

    def end(self) -> None:
        """Release what was drawn."""
        self.stop()
        self._window.take_out(self._scene)
        self.deleteLater()

    def _step(self) -> None:
        if not self._steps or self._window.is_used:
            self.end()
            return
        is_open = self._window.budget is not None
        self._steps.pop(0)()
        self._window.put_in(self._scene, SIZE_PX, SIZE_PX)
        if not is_open:
            return
        self._scene.begin_picture()
        self._window.draw()
