"""A camera image scaled to its widget."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QImage, QPaintEvent
from PySide6.QtWidgets import QWidget

from ui.look.look import Look
from ui.look.painting import LEFT, picture_painter, set_letters

MAX_SIDE = 640
RED = 0xFFD1495B
LEVELS = 254  # grey levels; the last entry of the table marks saturation


def grey_image(pixels: np.ndarray) -> QImage:
    """Convert an image (H, W) of 8 or 16 bits to 8 bits, subsampled to at most 640 px per side."""
    step = max(1, -(-max(pixels.shape) // MAX_SIDE))
    thin = pixels[::step, ::step]
    if thin.dtype != np.uint8:
        thin = (thin.astype(np.float32) * (255.0 / max(1.0, float(thin.max())))).astype(np.uint8)
    thin = np.ascontiguousarray(thin)
    return QImage(thin.data, thin.shape[1], thin.shape[0], thin.strides[0], QImage.Format.Format_Grayscale8).copy()


def marked_image(pixels: np.ndarray, saturation: int) -> QImage:
    """Convert an image (H, W) of 8 or 16 bits to 8 bits, at most 640 px per side, with saturated pixels in red."""
    step = max(1, -(-max(pixels.shape) // MAX_SIDE))
    thin = pixels[::step, ::step]
    grey = np.minimum(thin.astype(np.float32) * (LEVELS / saturation), LEVELS).astype(np.uint8)
    grey[thin >= saturation] = LEVELS + 1
    grey = np.ascontiguousarray(grey)
    image = QImage(grey.data, grey.shape[1], grey.shape[0], grey.strides[0], QImage.Format.Format_Indexed8)
    image.setColorTable([0xFF000000 | level << 16 | level << 8 | level for level in range(LEVELS + 1)] + [RED])
    return image.copy()


class ImageView(QWidget):
    """Shows one image with its caption, or an empty frame."""

    def __init__(self, look: Look, caption: str = "", *, whole: bool = False) -> None:
        """``whole``: nothing is cut off; otherwise the image fills the widget."""
        super().__init__()
        self._look, self._image, self.caption = look, QImage(), caption
        self._fit = Qt.AspectRatioMode.KeepAspectRatio if whole else Qt.AspectRatioMode.KeepAspectRatioByExpanding
        self.setMinimumSize(144, 108)
        look.changed.connect(self.update)

    def sizeHint(self) -> QSize:
        """Return the default size."""
        return QSize(208, 156)

    @property
    def is_empty(self) -> bool:
        """Whether there is no image."""
        return self._image.isNull()

    def show_image(self, image: QImage, caption: str) -> None:
        """Show an image."""
        self._image, self.caption = image, caption
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the image with its caption on top."""
        theme = self._look.theme
        painter = picture_painter(self, theme)
        if not self._image.isNull():
            fitted = self._image.size().scaled(self.size(), self._fit)
            target = QRectF(0, 0, fitted.width(), fitted.height())
            target.moveCenter(QRectF(self.rect()).center())
            painter.drawImage(target, self._image)
        if self.caption:
            strip = QRectF(0, self.height() - 24, self.width(), 24)
            if not self._image.isNull():
                painter.fillRect(strip, Qt.GlobalColor.black)
            painter.setPen(Qt.GlobalColor.white if not self._image.isNull() else theme.colour("soft"))
            set_letters(painter, theme.sizes["small"])
            painter.drawText(strip.adjusted(8, 0, -8, 0), LEFT, self.caption)
