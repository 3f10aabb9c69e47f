"""Native backend: VTK draws directly into a window of the desktop; one such window serves all 3-D views of the program's window."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPaintEngine, QPainter, QPaintEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper2D, vtkRenderer, vtkRenderWindow, vtkTexture, vtkTexturedActor2D

from ui.viewport.depth import hidden_places, pick_at
from ui.viewport.mouse import Mouse
from ui.viewport.pick import Pick
from ui.viewport.render_window import LEAST_VIEW_PX, RenderWindow
from ui.viewport.stage import Stage


class Overlay:
    """What is painted over the picture, as a texture in front of the scene, because a desktop window hides the widgets over it."""

    def __init__(self) -> None:
        self.renderer = vtkRenderer()
        self.renderer.SetLayer(1)
        self.renderer.InteractiveOff()
        self.renderer.PreserveDepthBufferOn()  # picks read the depth of the scene
        self._image, self._texture, self._pixels = vtkImageData(), vtkTexture(), np.empty(0, np.uint8)
        self._texture.SetInputData(self._image)
        self._texture.SetColorModeToDirectScalars()
        self._corners, data = vtkPoints(), vtkPolyData()
        self._corners.SetNumberOfPoints(4)
        cells = vtkCellArray()
        cells.InsertNextCell(4)
        for corner in range(4):
            cells.InsertCellPoint(corner)
        data.SetPoints(self._corners)
        data.SetPolys(cells)
        places = numpy_to_vtk(np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32), deep=True)
        places.SetName("texture")
        data.GetPointData().SetTCoords(places)
        mapper, self._actor = vtkPolyDataMapper2D(), vtkTexturedActor2D()
        mapper.SetInputData(data)
        self._actor.SetMapper(mapper)
        self._actor.SetTexture(self._texture)
        self.renderer.AddViewProp(self._actor)

    def show(self, image: QImage) -> None:
        """Show an image of the size of the window, with transparent parts."""
        straight = image.convertToFormat(QImage.Format.Format_RGBA8888)
        width, height = straight.width(), straight.height()
        raw = np.frombuffer(straight.constBits(), np.uint8).reshape(height, straight.bytesPerLine())[:, : 4 * width]
        self._pixels = np.ascontiguousarray(raw.reshape(height, width, 4)[::-1]).reshape(-1, 4)
        if self._image.GetDimensions()[:2] != (width, height):
            self._image.SetDimensions(width, height, 1)
            for corner, (x, y) in enumerate(((0, 0), (width, 0), (width, height), (0, height))):
                self._corners.SetPoint(corner, x, y, 0)
            self._corners.Modified()
        self._image.GetPointData().SetScalars(numpy_to_vtk(self._pixels))
        self._image.Modified()


class NativeSurface(QWidget):
    """The desktop window in which VTK draws; it is moved into the view that is visible."""

    drawAsked = Signal()
    windowChanged = Signal()  # the desktop gave it another window

    def __init__(self) -> None:
        super().__init__()
        for attribute in (
            Qt.WidgetAttribute.WA_NativeWindow,
            Qt.WidgetAttribute.WA_PaintOnScreen,
            Qt.WidgetAttribute.WA_OpaquePaintEvent,
            Qt.WidgetAttribute.WA_NoSystemBackground,
            Qt.WidgetAttribute.WA_DontCreateNativeAncestors,
        ):
            self.setAttribute(attribute)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.window_id = 0

    def paintEngine(self) -> QPaintEngine | None:  # type: ignore[override]
        """Return none: Qt does not paint here."""
        return None

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Let the view draw."""
        self.drawAsked.emit()

    def resizeEvent(self, _event: QResizeEvent) -> None:
        """Let the view draw at the new size."""
        self.drawAsked.emit()

    def event(self, event: QEvent) -> bool:
        """Notice another window of the desktop."""
        if event.type() == QEvent.Type.WinIdChange and self.window_id:
            self.windowChanged.emit()
        return super().event(event)


class NativeWindow(RenderWindow):
    """The render window in a desktop window."""

    def __init__(self, parent: QWidget) -> None:
        window = vtkRenderWindow()
        window.SetNumberOfLayers(2)
        window.SetAlphaBitPlanes(True)
        super().__init__(window, parent)
        self.surface, self.overlay = NativeSurface(), Overlay()
        self.holder: NativeView | None = None
        self.surface.drawAsked.connect(self._draw_holder)
        self.surface.windowChanged.connect(self._take_window)

    def wait_for_view(self) -> None:
        """Be in sight of the desktop, which draws in no other window, but outside of the program's window."""
        top = self.parent()
        assert isinstance(top, QWidget)
        self.surface.setParent(top)
        self.surface.setGeometry(-2 * LEAST_VIEW_PX, -2 * LEAST_VIEW_PX, LEAST_VIEW_PX, LEAST_VIEW_PX)
        self.surface.show()
        self._take_window()
        clear = QImage(LEAST_VIEW_PX, LEAST_VIEW_PX, QImage.Format.Format_ARGB32_Premultiplied)
        clear.fill(Qt.GlobalColor.transparent)
        self.overlay.show(clear)

    def give_to(self, holder: NativeView) -> None:
        """Move the desktop window into a view."""
        if self.holder is holder:
            return
        former, self.holder = self.holder, None  # nothing is drawn before VTK has the window, or it would open one of its own
        if former is not None:
            former.give_up()
        holder.layout().addWidget(self.surface)
        self.surface.show()
        self._take_window()
        self.holder = holder

    def take_from(self, holder: NativeView) -> None:
        """Take the desktop window out of a view that is closed."""
        if self.holder is holder:
            self.holder = None
            self.surface.setParent(None)

    def _take_window(self) -> None:
        wanted = int(self.surface.winId())
        if wanted != self.surface.window_id:
            if self.surface.window_id:
                self.vtk.Finalize()
            self.surface.window_id = wanted
            self.vtk.SetWindowInfo(str(wanted))
            self.vtk.AddRenderer(self.overlay.renderer)

    def _draw_holder(self) -> None:
        """Draw soon: buttons that appear beside the view resize it one after the other, and each picture takes a tenth of a second."""
        if self.holder is not None:
            self.holder.refresh()


class NativeView(QWidget):
    """Shows a stage in the desktop window while it is visible."""

    def __init__(self, stage: Stage, window: NativeWindow, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._stage, self._window, self._stale = stage, window, True
        self._shows_own = False  # False: the desktop shows what was there before, of another view or size
        window.join(self)
        self.mouse: Mouse | None = None
        self._more, self._next = QTimer(self), QTimer(self)
        for timer, action in ((self._more, self._go_on), (self._next, self._render)):
            timer.setSingleShot(True)
            timer.timeout.connect(action)
        stage.refreshWanted.connect(self.refresh)
        stage.paintWanted.connect(self.refresh)
        stage.places_hidden = self._hidden

    @property
    def render_window(self) -> RenderWindow:
        """The window that draws the scene."""
        return self._window

    def refresh(self) -> None:
        """Schedule a redraw."""
        self._stale = True
        if self._window.holder is self:
            self._next.start()

    def showEvent(self, event: QShowEvent) -> None:
        """Get the desktop window."""
        super().showEvent(event)
        self.take()

    def take(self) -> None:
        """Get the desktop window, when the view becomes visible."""
        self._window.give_to(self)
        if self.mouse is None:
            self._shows_own = False
            self.mouse = Mouse(self._window.surface, self._stage, self.pick)
        self.refresh()

    def give_up(self) -> None:
        """Lose the desktop window to another view."""
        self._more.stop()
        self._next.stop()
        if self.mouse is not None:
            self._window.surface.removeEventFilter(self.mouse)
            self.mouse.deleteLater()
            self.mouse = None

    def draw_now(self) -> None:
        """Draw at once, for what needs the picture."""
        self._stale = True
        self._render()

    def image(self) -> QImage:
        """Return the complete picture with what is painted over it."""
        self.take()
        self._stage.scene.set_moving(False)
        self.draw_now()
        while not self._stage.scene.is_complete:
            self._go_on()
        return self._window.image()

    def close_view(self) -> None:
        """Release the graphics memory before Qt destroys the window."""
        self.give_up()
        surface = self._window.surface
        self._window.take_from(self)
        self._window.take_out(self._stage.scene)
        self._window.leave(self)
        if self._window.holder is None:
            surface.hide()

    def pick(self, place: QPointF) -> Pick:
        """Return what is at a place of the widget, in logical pixels from the top left corner."""
        if not self._window.shows(self._stage.scene):
            self.draw_now()
        ratio = self._window.surface.devicePixelRatioF()
        return pick_at(self._stage.scene, self._window.vtk, place.x() * ratio, (self.height() - place.y()) * ratio - 1.0)

    def _render(self) -> None:
        if self._window.holder is not self or not self._stale or not self.isVisible():
            return
        surface = self._window.surface
        ratio = surface.devicePixelRatioF()
        width, height = max(1, round(surface.width() * ratio)), max(1, round(surface.height() * ratio))
        self._shows_own = self._shows_own and (width, height) == tuple(self._window.vtk.GetSize())
        self._stage.resize(surface.width(), surface.height())
        self._stage.fit_room()
        self._window.put_in(self._stage.scene, width, height)
        self._stage.scene.begin_picture()
        self._stale = False
        self._draw(width, height, ratio)

    def _draw(self, width: int, height: int, ratio: float) -> None:
        """Draw a frame; one that is too thin stays in memory, while the desktop shows the former picture, if that is of this view.

        Frames of a growing picture are drawn over each other with what is painted over them, so that a changing number would stay in it.
        """
        scene, window = self._stage.scene, self._window
        shown = scene.is_presentable or not self._shows_own
        self._shows_own = self._shows_own or scene.is_presentable
        window.overlay.renderer.SetDraw(shown)
        if shown:
            self._stage.say_progress(counting=scene.is_moving)
            window.overlay.show(self._painted(width, height, ratio))
        window.vtk.SetSwapBuffers(shown)
        window.draw()
        if not scene.is_complete:
            self._more.start()
        else:
            self._stage.picture_ready()

    def _painted(self, width: int, height: int, ratio: float) -> QImage:
        image = QImage(width, height, QImage.Format.Format_ARGB32_Premultiplied)
        image.setDevicePixelRatio(ratio)
        image.fill(Qt.GlobalColor.transparent)
        painter = QPainter(image)
        self._stage.paint(painter)
        self._stage.paint_handles(painter)
        painter.end()
        return image

    def _go_on(self) -> None:
        """Add points to an incomplete picture; begin anew where another view was drawn since."""
        scene = self._stage.scene
        if self._stale or scene.is_complete or self._window.holder is not self:
            return
        scene.go_on()
        width, height = self._window.vtk.GetSize()
        self._draw(width, height, self._window.surface.devicePixelRatioF())

    def _hidden(self, places_mm: np.ndarray) -> set[int]:
        if not self._window.shows(self._stage.scene):
            return set(self._stage.furniture.hidden)
        return hidden_places(self._stage.scene, self._window.vtk, places_mm)
