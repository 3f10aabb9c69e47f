"""Uses the native 3-D view in an X window; run by `test_native_window` in a process of its own, because Qt has one platform a process."""

from __future__ import annotations

import sys
import time

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QStackedWidget

from ui.look.look import Look
from ui.viewport.cloud_view import CloudView
from ui.viewport.layers import CloudLayer
from ui.viewport.native import NativeView
from ui.viewport.overlay.legend import Legend

COUNT, PATIENCE_S = 60_000, 20.0
COLOURS = ((210, 40, 40), (40, 80, 210))


def settle(application: QApplication, views: list[CloudView]) -> None:
    """Wait until nothing is being drawn."""
    end = time.monotonic() + PATIENCE_S
    calm = time.monotonic() + 0.4
    while time.monotonic() < min(end, calm):
        application.processEvents()
        if any(view.isVisible() and view.stage and not (view.stage.is_resting and view.stage.scene.is_complete) for view in views):
            calm = time.monotonic() + 0.4


def on_screen(application: QApplication, top: QStackedWidget) -> np.ndarray:
    """Return what the screen shows of the window, (H, W, 3)."""
    image = application.primaryScreen().grabWindow(top.winId()).toImage().convertToFormat(QImage.Format.Format_RGB888)
    raw = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return raw[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def drag(widget, start: QPoint, end: QPoint) -> None:
    left, nothing = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    QTest.mousePress(widget, left, pos=start)
    for step in range(1, 6):
        place = QPointF(start + (end - start) * (step / 5))
        QApplication.sendEvent(widget, QMouseEvent(QEvent.Type.MouseMove, place, place, Qt.MouseButton.NoButton, left, nothing))
        QApplication.processEvents()
    QTest.mouseRelease(widget, left, pos=end)


def main() -> None:
    application = QApplication([])
    assert application.platformName() == "xcb"
    top = QStackedWidget()
    top.resize(900, 640)
    views = [CloudView(Look("light")) for _ in COLOURS]
    rng = np.random.default_rng(0)
    points = rng.normal(size=(COUNT, 3))
    points = points / np.linalg.norm(points, axis=1)[:, None] * [100, 60, 60]
    for view, colour in zip(views, COLOURS, strict=True):
        top.addWidget(view)
        view.set_clouds([CloudLayer(points, np.tile(np.array(colour, np.uint8), (COUNT, 1)))])
        view.set_legend(Legend("Surface deviation", -0.1, 0.1, tolerance=(-0.05, 0.05)))
        view.activate()
    top.show()
    assert QTest.qWaitForWindowExposed(top)
    settle(application, views)
    check(application, top, views)
    for view in views:
        view.close_view()
    top.close()
    top.deleteLater()
    application.processEvents()
    sys.stdout.write("all good\n")


def check(application: QApplication, top: QStackedWidget, views: list[CloudView]) -> None:
    assert all(isinstance(view._view, NativeView) for view in views if view.is_live)
    shown = on_screen(application, top)
    middle = shown[shown.shape[0] // 2, shown.shape[1] // 3]
    assert middle[0] > middle[2] + 60, f"the first view is red, but the screen shows {middle}"
    surface, picks = views[0]._view._window.surface, []
    views[0].picked.connect(picks.append)
    QTest.mouseClick(surface, Qt.MouseButton.LeftButton, pos=QPoint(300, 320))
    assert picks and picks[0].is_point, "the click met no point"
    x, y = views[0].stage.scene.camera.pixels(points_of(views[0])[picks[0].index][None])[0]
    ratio = surface.devicePixelRatioF()
    height = views[0].stage.scene.camera.size_px[1]
    assert abs(x / ratio - 300) < 8 and abs((height - y) / ratio - 320) < 8, "the picked point is elsewhere"
    axes = views[0].stage.scene.camera.axes.copy()
    drag(surface, QPoint(300, 320), QPoint(420, 300))
    settle(application, views)
    assert np.abs(views[0].stage.scene.camera.axes - axes).max() > 0.2, "the part did not turn"
    assert (on_screen(application, top) != shown).mean() > 0.01, "the screen did not change"
    QTest.keyClick(surface, Qt.Key.Key_3)
    QTest.keyClick(surface, Qt.Key.Key_P)
    assert not views[0]._view._window.vtk.GetStereoRender()
    top.setCurrentIndex(1)
    settle(application, views)
    shown = on_screen(application, top)
    middle = shown[shown.shape[0] // 2, shown.shape[1] // 3]
    assert middle[2] > middle[0] + 60, f"the second view is blue, but the screen shows {middle}"
    top.setCurrentIndex(0)
    top.resize(700, 520)
    settle(application, views)
    size = views[0].stage.scene.camera.size_px
    assert abs(size[0] - 700 * ratio) <= 2 and abs(size[1] - 520 * ratio) <= 2, size
    assert len({id(view._view._window) for view in views}) == 1
    drawn = pictures(views[0]._view._window)
    for width in range(690, 660, -10):  # as when buttons appear beside the view
        surface.resize(width, 500)
    assert not drawn, "a picture was drawn for every size on the way"
    settle(application, views)
    assert drawn


def pictures(window) -> list[float]:
    """Return a list that grows with every frame of a render window."""
    frames, draw = [], window.draw
    window.draw = lambda: frames.append(draw()) or frames[-1]
    return frames


def points_of(view: CloudView) -> np.ndarray:
    return view._clouds[0].points_mm


if __name__ == "__main__":
    main()
