"""A zoomable picture for choosing pixels: the wheel zooms, dragging pans, a click chooses."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.painting import picture_painter

LARGEST = 64.0  # approximate greatest size of an image pixel in screen pixels
STEP, CLICK_PX, SMOOTH_BELOW = 1.25, 4.0, 2.0
ARROWS = {Qt.Key.Key_Up: (-1, 0), Qt.Key.Key_Down: (1, 0), Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1)}


def coloured_image(pixels: np.ndarray) -> QImage:
    """Convert an array (H, W, 3) uint8, red green blue, to a QImage."""
    pixels = np.ascontiguousarray(pixels)
    return QImage(pixels.data, pixels.shape[1], pixels.shape[0], pixels.strides[0], QImage.Format.Format_RGB888).copy()


class PixelPicture(QWidget):
    """Shows an image fitted to the widget, with the chosen pixel marked."""

    pixelChosen = Signal(int, int)  # row, column

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look, self._image = look, QImage()
        self._zoom, self._centre = 1.0, QPointF()
        self._pressed: QPointF | None = None
        self._dragged = False
        self.chosen: tuple[int, int] | None = None
        self.setMinimumSize(320, 240)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setToolTip(tr("Click a pixel to explain it. The wheel zooms, dragging pans, the arrow keys move by one pixel."))
        look.changed.connect(self.update)

    @property
    def is_empty(self) -> bool:
        """Whether there is no image."""
        return self._image.isNull()

    def show_image(self, image: QImage) -> None:
        """Show an image; for the same size zoom and position are kept."""
        if image.size() != self._image.size():
            self._zoom, self._centre = 1.0, QPointF(image.width() / 2, image.height() / 2)
        self._image = image
        self.update()

    def clear(self) -> None:
        """Show nothing."""
        self._image, self.chosen = QImage(), None
        self.update()

    def choose(self, pixel: tuple[int, int] | None) -> None:
        """Mark a pixel (row, column), and scroll to it."""
        self.chosen = pixel
        if pixel is not None and not self.rect().adjusted(8, 8, -8, -8).contains(self.place_of(*pixel).toPoint()):
            self._centre = QPointF(pixel[1] + 0.5, pixel[0] + 0.5)
            self._keep_inside()
        self.update()

    def place_of(self, row: int, column: int) -> QPointF:
        """Return the position of the centre of a pixel in the widget."""
        return (QPointF(column + 0.5, row + 0.5) - self._centre) * self._scale() + QRectF(self.rect()).center()

    def pixel_at(self, place: QPointF) -> tuple[int, int] | None:
        """Return the pixel (row, column) at a position of the widget; None outside the image."""
        if self.is_empty:
            return None
        at = self._centre + (place - QRectF(self.rect()).center()) / self._scale()
        row, column = int(np.floor(at.y())), int(np.floor(at.x()))
        return (row, column) if 0 <= row < self._image.height() and 0 <= column < self._image.width() else None

    def _scale(self) -> float:
        width, height = max(1, self._image.width()), max(1, self._image.height())
        return self._zoom * min(self.width() / width, self.height() / height)

    def _keep_inside(self) -> None:
        """Limit the pan so that the image fills the widget."""
        scale = self._scale()
        for size, room, set_to, now in (
            (self._image.width(), self.width(), self._centre.setX, self._centre.x()),
            (self._image.height(), self.height(), self._centre.setY, self._centre.y()),
        ):
            half = min(size / 2, room / scale / 2)
            set_to(min(max(now, half), size - half))

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom around the mouse position."""
        if self.is_empty or not event.angleDelta().y():
            return
        middle = QRectF(self.rect()).center()
        under = self._centre + (event.position() - middle) / self._scale()
        most = LARGEST * self._zoom / self._scale()
        self._zoom = min(max(1.0, self._zoom * STEP ** (event.angleDelta().y() / 120)), max(1.0, most))
        self._centre = under - (event.position() - middle) / self._scale()
        self._keep_inside()
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Start a click or a pan."""
        self._pressed, self._dragged = event.position(), False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Pan the image."""
        if self._pressed is None or self.is_empty:
            return
        moved = event.position() - self._pressed
        if self._dragged or moved.manhattanLength() > CLICK_PX:
            self._dragged = True
            self._centre -= moved / self._scale()
            self._pressed = event.position()
            self._keep_inside()
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Choose the pixel under the mouse, unless the image was panned."""
        pixel = None if self._dragged or self._pressed is None else self.pixel_at(event.position())
        self._pressed = None
        if pixel is not None:
            self.choose(pixel)
            self.pixelChosen.emit(*pixel)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move by one pixel."""
        step = ARROWS.get(Qt.Key(event.key()))
        if step is None or self.chosen is None:
            super().keyPressEvent(event)
            return
        row = min(max(0, self.chosen[0] + step[0]), self._image.height() - 1)
        column = min(max(0, self.chosen[1] + step[1]), self._image.width() - 1)
        self.choose((row, column))
        self.pixelChosen.emit(row, column)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the image, and a circle around the chosen pixel."""
        painter = picture_painter(self, self._look.theme)
        if self.is_empty:
            return
        scale = self._scale()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, scale < SMOOTH_BELOW)
        corner = QRectF(self.rect()).center() - self._centre * scale
        painter.drawImage(QRectF(corner, QSizeF(self._image.size()) * scale), self._image)
        if self.chosen is not None:
            place, radius = self.place_of(*self.chosen), max(9.0, scale)
            for colour, width in ((QColor(0, 0, 0), 4.0), (QColor(255, 255, 255), 2.0)):
                painter.setPen(QPen(colour, width))
                painter.drawEllipse(place, radius, radius)
