"""Native backend: VTK renders directly into the window."""

from __future__ import annotations

import time

import numpy as np
from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QImage, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget
from vtkmodules.qt.QVTKRenderWindowInteractor import QVTKRenderWindowInteractor
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera

from ui.viewport.frame_budget import FrameBudget
from ui.viewport.scene import Scene

REST_MS = 200


class NativeView(QWidget):
    """Shows a scene in VTK's own window."""

    clicked = Signal(float, float)  # pixel of the picture, y from the bottom

    def __init__(self, scene: Scene, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene = scene
        self._interactor = QVTKRenderWindowInteractor(self)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._interactor)
        self._window = self._interactor.GetRenderWindow()
        self._window.SetMultiSamples(4)
        self._window.AddRenderer(scene.renderer)
        self._window.AddObserver("StartEvent", self._begin_frame)  # type: ignore[arg-type]
        self._window.AddObserver("EndEvent", self._end_frame)  # type: ignore[arg-type]
        self._adding, self._knows_renderer, self._started = False, False, 0.0
        style = vtkInteractorStyleTrackballCamera()
        self._interactor.SetInteractorStyle(style)
        style.AddObserver("StartInteractionEvent", self._begin_move)  # type: ignore[arg-type]
        style.AddObserver("EndInteractionEvent", self._end_move)  # type: ignore[arg-type]
        self._interactor.Initialize()
        self._pressed_at, self._was_framed = (0, 0), True
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self._come_to_rest)
        self._more = QTimer(self)
        self._more.setSingleShot(True)
        self._more.timeout.connect(self._go_on)

    def refresh(self) -> None:
        """Schedule a redraw."""
        self._interactor.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Redraw at the new size."""
        super().resizeEvent(event)
        self.refresh()

    def image(self) -> QImage:
        """Return the present picture."""
        self._window.Render()
        while not self._scene.is_complete:
            self._go_on()
        width, height = self._window.GetSize()
        data = vtkUnsignedCharArray()
        self._window.GetPixelData(0, 0, width - 1, height - 1, True, data, 0)
        pixels = np.ascontiguousarray(vtk_to_numpy(data).reshape(height, width, 3)[::-1])
        return QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()

    def close_view(self) -> None:
        """Release the window before Qt destroys it."""
        self._rest.stop()
        self._more.stop()
        self._window.RemoveAllObservers()
        self._window.RemoveRenderer(self._scene.renderer)
        self._interactor.Finalize()

    def _go_on(self) -> None:
        """Add points to an incomplete picture."""
        if not self._scene.is_complete:
            self._adding = True
            self._window.Render()
            self._adding = False

    def _begin_frame(self, _caller: object, _event: str) -> None:
        if self._adding:
            self._scene.go_on()
        else:
            self._scene.begin_picture()
        self._started = time.perf_counter()

    def _end_frame(self, _caller: object, _event: str) -> None:
        if not self._knows_renderer:
            self._scene.budget, self._knows_renderer = FrameBudget(self._window.ReportCapabilities()), True
            if self._scene.budget.software:
                self._window.SetMultiSamples(0)
            return
        self._window.WaitForCompletion()
        self._scene.budget.observe(self._scene.frame_points, time.perf_counter() - self._started)
        if not self._scene.is_complete:
            self._more.start()

    def _begin_move(self, _caller: object, _event: str) -> None:
        self._rest.stop()
        self._pressed_at, self._was_framed = self._interactor.GetEventPosition(), self._scene.keep_framed
        self._scene.set_moving(True)

    def _end_move(self, _caller: object, _event: str) -> None:
        x, y = self._interactor.GetEventPosition()
        if (x, y) == tuple(self._pressed_at):
            self._scene.set_moving(False)
            self._scene.keep_framed = self._was_framed
            self.clicked.emit(float(x), float(y))
        else:
            self._rest.start()

    def _come_to_rest(self) -> None:
        self._scene.set_moving(False)
        self.refresh()
