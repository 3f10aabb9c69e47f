"""One VTK render window for all 3-D views of a window: each view has a scene of its own, which is put in to be drawn."""

from __future__ import annotations

import time

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from ui.viewport.frame_budget import FrameBudget
from ui.viewport.scene import Scene

LEAST_VIEW_PX = 64
SAMPLES = 4  # of multisampling by a graphics card; by the processor it is too slow at any size


class RenderWindow(QObject):
    """Draws one scene at a time; the graphics memory of the others stays, so that changing between them is quick."""

    closing = Signal()

    def __init__(self, window: vtkRenderWindow, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.vtk = window
        self.budget: FrameBudget | None = None
        self._scene: Scene | None = None
        self._users: set[QObject] = set()
        self.is_used = False  # by a view, not only for preparation

    def join(self, user: QObject) -> None:
        """Count a view that uses the window."""
        self._users.add(user)

    def leave(self, user: QObject) -> None:
        """Count a view less; the last one closes the window."""
        self._users.discard(user)
        if not self._users and self.parent() is not None:
            self.closing.emit()
            self.vtk.Finalize()
            self.setParent(None)
            self.deleteLater()

    def wait_for_view(self) -> None:
        """Be ready to draw before there is a view."""

    def take_out(self, scene: Scene) -> None:
        """Release the graphics memory of a scene."""
        if self._scene is scene:
            self.vtk.RemoveRenderer(scene.renderer)
            self._scene = None
        scene.renderer.ReleaseGraphicsResources(self.vtk)

    def shows(self, scene: Scene) -> bool:
        """Whether the last picture is that of this scene."""
        return self._scene is scene

    def put_in(self, scene: Scene, width: int, height: int) -> None:
        """Make this the scene that is drawn, at this size in pixels."""
        self.is_used = self.is_used or width > LEAST_VIEW_PX
        if self._scene is not scene:
            if self._scene is not None:
                self.vtk.RemoveRenderer(self._scene.renderer)
            self.vtk.AddRenderer(scene.renderer)
            self._scene = scene
        if tuple(self.vtk.GetSize()) != (width, height):
            self.vtk.SetSize(width, height)
        if self.budget is None:
            self.vtk.Initialize()  # needed for the capability report
            self.budget = FrameBudget(self.vtk.ReportCapabilities())
            self.vtk.SetMultiSamples(0 if self.budget.software else SAMPLES)
        if type(scene.budget) is FrameBudget:  # all scenes learn together what a point costs
            scene.budget = self.budget

    def draw(self) -> float:
        """Draw a frame and return the time it took in s."""
        started = time.perf_counter()
        self.vtk.Render()
        self.vtk.WaitForCompletion()
        taken = time.perf_counter() - started
        if self._scene is not None:
            self._scene.observe(taken)
        return taken

    def image(self, *, with_alpha: bool = False) -> QImage:
        """Return the last frame."""
        return grab(self.vtk, with_alpha=with_alpha)


def grab(window: vtkRenderWindow, *, with_alpha: bool = False) -> QImage:
    """Return the last frame of a window."""
    width, height = window.GetSize()
    data = vtkUnsignedCharArray()
    if with_alpha:
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, data)
    else:
        window.GetPixelData(0, 0, width - 1, height - 1, 0, data, 0)
    channels = 4 if with_alpha else 3
    pixels = np.ascontiguousarray(vtk_to_numpy(data).reshape(height, width, channels)[::-1])
    kind = QImage.Format.Format_RGBA8888 if with_alpha else QImage.Format.Format_RGB888
    return QImage(pixels.data, width, height, channels * width, kind).copy()


def shared_window(widget: QWidget) -> RenderWindow | None:
    """Return the render window of a widget's top-level window, if there is one already."""
    top = widget.window()
    return next((found for found in top.findChildren(RenderWindow) if found.parent() is top), None)
