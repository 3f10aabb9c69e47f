"""Off-screen backend: renders to memory and paints the image; mouse and wheel events are forwarded."""

from __future__ import annotations

import time

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QMouseEvent, QPainter, QPaintEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor

from ui.viewport.frame_budget import FrameBudget
from ui.viewport.scene import Scene

REST_MS = 200
CLICK_REACH_PX = 4
BUTTONS = {Qt.MouseButton.LeftButton: "LeftButton", Qt.MouseButton.MiddleButton: "MiddleButton", Qt.MouseButton.RightButton: "RightButton"}


class OffScreenView(QWidget):
    """Shows a scene rendered off-screen."""

    clicked = Signal(float, float)  # pixel of the picture, y from the bottom

    def __init__(self, scene: Scene, window: vtkRenderWindow, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self._scene, self._window, self._image, self._stale = scene, window, QImage(), True
        window.Initialize()  # needed for the capability report
        scene.budget = FrameBudget(window.ReportCapabilities())
        window.SetMultiSamples(0 if scene.budget.software else 4)  # multisampling by the processor is too slow at any size
        window.AddRenderer(scene.renderer)
        self._interactor = vtkGenericRenderWindowInteractor()
        self._interactor.SetRenderWindow(window)
        self._interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        self._interactor.EnableRenderOff()
        self._interactor.Initialize()
        self._interactor.AddObserver("RenderEvent", self._on_render_wanted)  # type: ignore[arg-type]
        self._pressed_at = QPointF()
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(REST_MS)
        self._rest.timeout.connect(self._come_to_rest)
        self._more = QTimer(self)
        self._more.setSingleShot(True)
        self._more.timeout.connect(self._go_on)

    def refresh(self) -> None:
        """Schedule a redraw."""
        self._stale = True
        self.update()

    def image(self) -> QImage:
        """Return the present picture."""
        self._render()
        while not self._scene.is_complete:
            self._go_on()
        return self._image.copy()

    def close_view(self) -> None:
        """Release the graphics memory."""
        self._rest.stop()
        self._more.stop()
        self._interactor.RemoveAllObservers()
        self._window.RemoveRenderer(self._scene.renderer)
        self._window.Finalize()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the rendered image."""
        self._render()
        QPainter(self).drawImage(0, 0, self._image)

    def resizeEvent(self, _event: QResizeEvent) -> None:
        """Render at the new size."""
        self.refresh()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Start to rotate, pan or zoom."""
        self._pressed_at = event.position()
        self._forward(event, "PressEvent")

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End rotation, pan or zoom; a click picks."""
        self._forward(event, "ReleaseEvent")
        moved = (event.position() - self._pressed_at).manhattanLength()
        if event.button() == Qt.MouseButton.LeftButton and moved < CLICK_REACH_PX:
            ratio = self.devicePixelRatioF()
            self.clicked.emit(event.position().x() * ratio, (self.height() - event.position().y() - 1) * ratio)
            return
        self._rest.start()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Rotate, pan or zoom."""
        moved = (event.position() - self._pressed_at).manhattanLength()
        if event.buttons() != Qt.MouseButton.NoButton and moved >= CLICK_REACH_PX:
            self._begin_move()
            self._place(event.position(), event)
            self._interactor.MouseMoveEvent()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom."""
        self._begin_move()
        self._place(event.position(), event)
        if event.angleDelta().y() > 0:
            self._interactor.MouseWheelForwardEvent()
        else:
            self._interactor.MouseWheelBackwardEvent()
        self._rest.start()
        event.accept()

    def _forward(self, event: QMouseEvent, kind: str) -> None:
        name = BUTTONS.get(event.button())
        if name is not None:
            self._place(event.position(), event)
            getattr(self._interactor, name + kind)()

    def _place(self, position: QPointF, event: QMouseEvent | QWheelEvent) -> None:
        ratio = self.devicePixelRatioF()
        keys = event.modifiers()
        control = bool(keys & Qt.KeyboardModifier.ControlModifier)
        shift = bool(keys & Qt.KeyboardModifier.ShiftModifier)
        x, y = round(position.x() * ratio), round((self.height() - position.y() - 1) * ratio)
        self._interactor.SetEventInformation(x, y, control, shift, "\0", 0, "")

    def _begin_move(self) -> None:
        self._rest.start()
        self._scene.set_moving(True)

    def _come_to_rest(self) -> None:
        self._scene.set_moving(False)
        self.refresh()

    def _on_render_wanted(self, _caller: object, _event: str) -> None:
        self.refresh()

    def _render(self) -> None:
        ratio = self.devicePixelRatioF()
        width, height = max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))
        if not self._stale and (self._image.width(), self._image.height()) == (width, height):
            return
        self._window.SetSize(width, height)
        self._interactor.SetSize(width, height)
        self._scene.begin_picture()
        self._draw(width, height)
        self._stale = False

    def _go_on(self) -> None:
        """Add points to an incomplete picture."""
        if not self._stale and not self._scene.is_complete:
            self._scene.go_on()
            self._draw(self._image.width(), self._image.height())
            self.update()

    def _draw(self, width: int, height: int) -> None:
        started = time.perf_counter()
        self._window.Render()
        self._window.WaitForCompletion()
        if self._scene.is_presentable or (self._image.width(), self._image.height()) != (width, height):
            self._image = _grab(self._window, width, height)
            self._image.setDevicePixelRatio(self.devicePixelRatioF())
        self._scene.budget.observe(self._scene.frame_points, time.perf_counter() - started)
        if not self._scene.is_complete:
            self._more.start()

    def changeEvent(self, event: QEvent) -> None:
        """Redraw when the theme changes."""
        if event.type() == QEvent.Type.PaletteChange:
            self.refresh()
        super().changeEvent(event)


def _grab(window: vtkRenderWindow, width: int, height: int) -> QImage:
    data = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, True, data, 0)
    pixels = np.ascontiguousarray(vtk_to_numpy(data).reshape(height, width, 3)[::-1])
    return QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()
