"""What of a calibration does not depend on images, made when first asked for and kept."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from measureapp.arrays import FloatArray, in_bands, read_only
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import table_step
from measureapp.reconstruct.rectification.cubics import PixelSteps
from measureapp.reconstruct.rectification.rectified_grid import RectifiedGrid, rectified_grid
from measureapp.reconstruct.rectification.rectify import RectifiedPair, pixel_rays, rectify


@dataclass(frozen=True, slots=True, eq=False)
class EpipolarLines:
    """Where every pixel of a camera lies in the rectified image of a pair."""

    pixels: FloatArray  # (H, W, 2) float32, rectified (x, y); pixels of equal y lie on one epipolar line
    levels: FloatArray  # (H', W') float32, the y of the pixels that are sorted into tables
    steps: PixelSteps
    direction: tuple[float, float]  # of the lines in the middle of the image, unit, towards growing x


@dataclass(frozen=True, slots=True, eq=False)
class Rectifier:
    """The viewing rays and rectified pairs of one calibration. Make one and pass it to every `reconstruct` with that calibration."""

    cameras: CameraArrayCalibration
    _rays: dict[str, FloatArray] = field(default_factory=dict)
    _pairs: dict[tuple[str, str], RectifiedPair] = field(default_factory=dict)
    _ray_steps: dict[str, PixelSteps] = field(default_factory=dict)
    _lines: dict[tuple[str, str, str], EpipolarLines] = field(default_factory=dict)
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

    def ray_steps(self, name: str) -> PixelSteps:
        """Return how the viewing rays of a camera change from pixel to pixel."""
        if name not in self._ray_steps:
            self._ray_steps[name] = PixelSteps.of(self.rays(name))
        return self._ray_steps[name]

    def lines(self, here: str, there: str, camera: str) -> EpipolarLines:
        """Return the epipolar lines of the pair (``here``, ``there``) in the image of one of both; 10 bytes per pixel are kept."""
        key = (here, there, camera)
        if key not in self._lines:
            pair, rays = self.pair(here, there), self.rays(camera)
            view = pair.here if camera == here else pair.there
            pixels = np.empty_like(rays)
            in_bands(
                lambda start, stop: kernels.rectified_lines(rays, view.rectified_from_camera, view.frame, start, stop, pixels), len(rays)
            )
            steps = PixelSteps.of(pixels)
            along = np.linalg.inv(steps.at_centre())[:, 0]
            along /= np.linalg.norm(along)
            every = table_step(pixels.shape)
            levels = read_only(pixels[::every, ::every, 1])
            self._lines[key] = EpipolarLines(read_only(pixels), levels, steps, (float(along[0]), float(along[1])))
        return self._lines[key]

    def rectified(self, here: str, there: str) -> tuple[RectifiedGrid, Rectifier]:
        """Return the rectified grid of camera ``here`` and the rectifier of the calibration in which it replaces the real camera."""
        if (here, there) not in self._turned:
            grid = rectified_grid(self.cameras, here, there)
            replaced = {**self.cameras.cameras, here: grid.camera}
            self._turned[here, there] = (grid, Rectifier(replace(self.cameras, cameras=replaced)))
        return self._turned[here, there]
