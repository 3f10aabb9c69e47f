"""A page of a document as a picture that is fitted to the width available."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget


class PagePicture(QWidget):
    """Shows one page, centred.

    The page is scaled when it is painted, and only then: to scale all pages of a report at once takes 20 ms a page, most of which are out of sight.
    """

    def __init__(self, image: QImage, width: int) -> None:
        super().__init__()
        self.image = image
        self._scaled, self._width = QImage(), 0
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.fit(width)

    def fit(self, width: int) -> None:
        """Show the page at a width in logical pixels."""
        if width != self._width:
            self._width = width
            self.setFixedHeight(self.sizeHint().height())
            self.update()

    def sizeHint(self) -> QSize:
        """Return the size of the page as it is shown."""
        return QSize(self._width, round(self.image.height() * self._width / max(1, self.image.width())))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Paint the page, scaled to the pixels of the screen."""
        ratio, width = self.devicePixelRatioF(), round(self._width * self.devicePixelRatioF())
        if self._scaled.width() != width:
            self._scaled = self.image.scaledToWidth(width, Qt.TransformationMode.SmoothTransformation)
            self._scaled.setDevicePixelRatio(ratio)
        QPainter(self).drawImage((self.width() - self._width) // 2, 0, self._scaled)
