"""What of a calibration does not depend on images, made when first asked for and kept."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.reconstruct.rectified_grid import RectifiedGrid, rectified_grid
from measureapp.reconstruct.rectify import RectifiedPair, pixel_rays, rectify


@dataclass(frozen=True, slots=True, eq=False)
class Rectifier:
    """The viewing rays and rectified pairs of one calibration. Make one and pass it to every `reconstruct` with that calibration."""

    cameras: CameraArrayCalibration
    _rays: dict[str, FloatArray] = field(default_factory=dict)
    _pairs: dict[tuple[str, str], RectifiedPair] = field(default_factory=dict)
    _turned: dict[tuple[str, str], tuple[RectifiedGrid, Rectifier]] = field(default_factory=dict)

    def rays(self, name: str) -> FloatArray:
        """Return the normalised image coordinates (H, W, 2) float32 of every pixel of a camera."""
        if name not in self._rays:
            self._rays[name] = pixel_rays(self.cameras.cameras[name].pinhole)
        return self._rays[name]

    def pair(self, here: str, there: str) -> RectifiedPair:
        """Return a pair in the order of its names."""
        if (here, there) not in self._pairs:
            self._pairs[here, there] = rectify(self.cameras.cameras[here], self.cameras.cameras[there])
        return self._pairs[here, there]

    def rectified(self, here: str, there: str) -> tuple[RectifiedGrid, Rectifier]:
        """Return the rectified grid of camera ``here`` and the rectifier of the calibration in which it replaces the real camera."""
        if (here, there) not in self._turned:
            grid = rectified_grid(self.cameras, here, there)
            replaced = {**self.cameras.cameras, here: grid.camera}
            self._turned[here, there] = (grid, Rectifier(replace(self.cameras, cameras=replaced)))
        return self._turned[here, there]
