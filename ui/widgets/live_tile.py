"""The live image of a camera with its grey levels: histogram, saturation, darkness."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import exposure, percent
from ui.widgets.basic import column, label
from ui.widgets.image_view import ImageView, grey_image

BINS = 64
SATURATED_IS_MUCH = 0.002  # share of the pixels; more hides corners and fringes
EVERY = 4  # pixels, in rows and columns


class LevelHistogram(QWidget):
    """Grey levels of one image, from black to saturated; the saturated end is marked."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.shares = np.zeros(BINS)
        self.setMinimumSize(144, 48)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        look.changed.connect(self.update)

    def show_levels(self, pixels: np.ndarray, saturation: int) -> None:
        """Show the levels of an image (H, W)."""
        counts, _ = np.histogram(pixels[::EVERY, ::EVERY], BINS, (0, saturation + 1))
        self.shares = counts / max(1, counts.sum())
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the histogram on a root scale, so that small shares show."""
        theme = self._look.theme
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), theme.colour("sunken"))
        if not self.shares.any():
            return
        heights = np.sqrt(self.shares / self.shares.max()) * (self.height() - 4)
        steps = self.width() / BINS
        outline = [QPointF(0.0, float(self.height()))]
        for place, height in enumerate(heights):
            top = float(self.height() - height)
            outline += [QPointF(place * steps, top), QPointF((place + 1) * steps, top)]
        outline.append(QPointF(float(self.width()), float(self.height())))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("accent"))
        painter.drawPolygon(QPolygonF(outline))
        if self.shares[-1] > SATURATED_IS_MUCH:
            painter.setBrush(theme.colour("verdict_fail"))
            painter.drawRect(QRectF(self.width() - steps, self.height() - heights[-1], steps, heights[-1]))


class LiveTile(QWidget):
    """Image, histogram and a line of words for one camera."""

    def __init__(self, look: Look, camera: str, saturation: int) -> None:
        super().__init__()
        self._camera, self._saturation = camera, saturation
        self.image = ImageView(look, camera, whole=True)
        self.image.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.histogram = LevelHistogram(look)
        self.words = label("No image yet.", "small")
        layout = column(self.image, self.histogram, self.words, spacing=4)
        layout.setStretch(0, 1)
        self.setLayout(layout)

    def show_pixels(self, pixels: np.ndarray, exposure_us: int) -> None:
        """Show a new image (H, W)."""
        self.image.show_image(grey_image(pixels), f"{self._camera} · {exposure(exposure_us)}")
        self.histogram.show_levels(pixels, self._saturation)
        thin = pixels[::EVERY, ::EVERY]
        saturated = float(np.mean(thin >= self._saturation))
        median = float(np.median(thin)) / self._saturation
        words = tr("Median level {median} · saturated {saturated}", median=percent(median, 0), saturated=percent(saturated, 1))
        self.words.setText(words + (" – too bright" if saturated > SATURATED_IS_MUCH else ""))
