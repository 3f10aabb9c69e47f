"""The live image of a camera, saturated pixels in red, with its grey levels: histogram, saturation, darkness."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QSizePolicy, QWidget

from ui.charts.level_histogram import EVERY, SATURATED_IS_MUCH, LevelHistogram
from ui.look.look import Look
from ui.look.wording import exposure, percent
from ui.widgets.basic import column, label
from ui.widgets.image_view import ImageView, marked_image


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
        self.image.show_image(marked_image(pixels, self._saturation), f"{self._camera} · {exposure(exposure_us)}")
        self.histogram.show_levels(pixels, self._saturation)
        thin = pixels[::EVERY, ::EVERY]
        saturated = float(np.mean(thin >= self._saturation))
        median = float(np.median(thin)) / self._saturation
        words = f"Median level {percent(median, 0)} · saturated {percent(saturated, 1)}"
        self.words.setText(words + (" – too bright" if saturated > SATURATED_IS_MUCH else ""))
