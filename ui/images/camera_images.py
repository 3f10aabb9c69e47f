"""The latest image of every camera, small, with saturated pixels in red."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QWidget

from ui.images.camera_view import CameraView
from ui.look.language.words import tr
from ui.look.look import Look
from ui.look.wording import exposure, percent
from ui.widgets.basic import clear, column

EVERY = 4  # pixels, in rows and columns, for the share that is saturated
LEAST_SHOWN, HARDLY = 0.0005, 0.01  # saturated share


class CameraImages(QWidget):
    """One `CameraView` per camera, one above the other."""

    def __init__(self, look: Look) -> None:
        super().__init__()
        self._look = look
        self.images: dict[str, CameraView] = {}
        self._saturations: dict[str, int] = {}
        self._shown: dict[str, tuple[str, float]] = {}  # viewpoint and saturated share of the image of a camera
        self._layout = column(spacing=8)
        self.setLayout(self._layout)

    def show_cameras(self, saturations: dict[str, int]) -> None:
        """Make room for these cameras, by the grey level at which each is saturated; images shown stay."""
        if saturations == self._saturations:
            return
        clear(self._layout)
        self._saturations, self._shown = dict(saturations), {}
        self.images = {name: CameraView(self._look, name) for name in saturations}
        for image in self.images.values():
            self._layout.addWidget(image, 1)

    def show_image(self, camera: str, pixels: np.ndarray, exposure_us: int, of: str = "") -> None:
        """Show an image of one camera; unknown cameras are ignored.

        Of the images of one viewpoint, ``of``, the first that is hardly saturated stays: exposures run from long to short, and the shortest
        shows nothing to people.
        """
        before, saturated_before = self._shown.get(camera, ("", 1.0))
        if camera not in self.images or (of and of == before and saturated_before <= HARDLY):
            return
        saturation = self._saturations[camera]
        share = float(np.mean(pixels[::EVERY, ::EVERY] >= saturation))
        self._shown[camera] = (of, share)
        saturated = tr(" · {share} saturated", share=percent(share, 1)) if share > LEAST_SHOWN else ""
        self.images[camera].show_image(pixels, f"{camera} · {exposure(exposure_us)}{saturated}", saturation)

    @property
    def is_empty(self) -> bool:
        """Whether no image is shown."""
        return all(image.is_empty for image in self.images.values())
