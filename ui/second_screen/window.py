"""The window that covers a screen with one image, pixel for pixel."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPointF, QRect, Qt
from PySide6.QtGui import QBackingStore, QExposeEvent, QImage, QPainter, QRegion, QScreen, QSurface, QWindow

from measureapp.arrays import ImageArray
from measureapp.errors import DeviceError
from ui.second_screen.screens import check_size

OPAQUE = np.uint32(0xFF000000)
FORMATS_32 = (QImage.Format.Format_RGB32, QImage.Format.Format_ARGB32, QImage.Format.Format_ARGB32_Premultiplied)


class PatternWindow(QWindow):
    """Shows grey images of the screen's size without any scaling; dark until told otherwise.

    Parameters
    ----------
    width_px, height_px : size of all images, in pixels of the screen

    Raises
    ------
    InputError
        The screen has another size.
    """

    def __init__(self, screen: QScreen, width_px: int, height_px: int) -> None:
        super().__init__()
        check_size(screen, width_px, height_px)
        self._image: ImageArray = np.zeros((height_px, width_px), np.uint8)
        self.setSurfaceType(QSurface.SurfaceType.RasterSurface)
        self.setScreen(screen)
        self.setFlags(Qt.WindowType.Window | Qt.WindowType.FramelessWindowHint | Qt.WindowType.WindowStaysOnTopHint)
        self.setCursor(Qt.CursorShape.BlankCursor)
        self.setTitle("Patterns")
        self.setGeometry(screen.geometry())
        self._store = QBackingStore(self)

    def display(self, image: ImageArray) -> None:
        """Paint a grey image (height, width) and hand it to the screen; returns when that has happened.

        Raises
        ------
        DeviceError
            A pixel was not painted as given, so that the pattern would be wrong.
        """
        self._image = image
        if not self._paint():
            raise DeviceError(
                f"The screen {self.screen().name()} cannot show the patterns pixel by pixel at a scaling of {self.devicePixelRatio():g}.",
                "Set the scaling of this screen to 100 %.",
            )

    def exposeEvent(self, _event: QExposeEvent) -> None:
        """Paint again what another window had covered."""
        if self.isExposed():
            self._paint()

    def _paint(self) -> bool:
        """Paint and flush; return whether every pixel reads back from the surface as given."""
        height, width = self._image.shape
        whole = QRegion(QRect(0, 0, self.width(), self.height()))
        self._store.resize(self.size())
        self._store.beginPaint(whole)
        surface = self._store.paintDevice()
        painter = QPainter(surface)
        painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_Source)
        painter.fillRect(QRect(0, 0, self.width() + 1, self.height() + 1), Qt.GlobalColor.black)  # with a rounded size one column remains
        pixels = self._image * np.uint32(0x010101) | OPAQUE
        picture = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
        picture.setDevicePixelRatio(self.devicePixelRatio())
        painter.drawImage(QPointF(0.0, 0.0), picture)
        painter.end()
        exact = isinstance(surface, QImage) and _shows(surface, self._image, pixels)
        self._store.endPaint()
        self._store.flush(whole)
        return exact


def _shows(surface: QImage, image: ImageArray, pixels: npt.NDArray[np.uint32]) -> bool:
    """Whether a surface has an image (height, width), also given as pixels of 32 bits, in its upper left corner."""
    height, width = image.shape
    if surface.format() not in FORMATS_32:
        return np.array_equal(read_grey(surface)[:height, :width], image)
    rows = np.frombuffer(surface.constBits(), np.uint32).reshape(surface.height(), surface.bytesPerLine() // 4)
    return np.array_equal(rows[:height, :width] | OPAQUE, pixels)


def read_grey(image: QImage) -> ImageArray:
    """Return the grey levels of an image (height, width) as a copy; colours become grey by their luminance."""
    grey = image.convertToFormat(QImage.Format.Format_Grayscale8)
    rows = np.frombuffer(grey.constBits(), np.uint8).reshape(grey.height(), grey.bytesPerLine())
    return rows[:, : grey.width()].copy()
