"""Viewing rays and epipolar lines of a calibration, computed at the first request and kept."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from measureapp.arrays import FloatArray, in_bands, read_only
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.reconstruct import kernels
from measureapp.reconstruct.phase_view import table_step
from measureapp.reconstruct.rectification.jacobian import PixelJacobian
from measureapp.reconstruct.rectification.rectified_grid import RectifiedGrid, rectified_grid
from measureapp.reconstruct.rectification.rectify import RectifiedPair, pixel_rays, rectify


@dataclass(frozen=True, slots=True, eq=False)
class EpipolarLines:
    """Rectified coordinates of the pixels of a camera; pixels of equal y are on one epipolar line."""

    rectified: FloatArray  # (H, W, 2) float32, (x, y)
    sampled_y: FloatArray  # (H', W') float32, y of the pixels that are sorted into tables
    jacobian: PixelJacobian
    direction: tuple[float, float]  # of the lines in the middle of the image, unit, towards growing x


@dataclass(frozen=True, slots=True, eq=False)
class Rectifier:
    """The viewing rays and rectified pairs of one calibration. Make one and pass it to every `reconstruct` with that calibration."""

    cameras: CameraArrayCalibration
    _rays: dict[str, FloatArray] = field(default_factory=dict)
    _pairs: dict[tuple[str, str], RectifiedPair] = field(default_factory=dict)
    _ray_jacobians: dict[str, PixelJacobian] = field(default_factory=dict)
    _lines: dict[tuple[str, str, str], EpipolarLines] = field(default_factory=dict)
    _rectified: dict[tuple[str, str], tuple[RectifiedGrid, Rectifier]] = field(default_factory=dict)

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

    def ray_jacobian(self, name: str) -> PixelJacobian:
        """Return the Jacobian of the viewing rays of a camera."""
        if name not in self._ray_jacobians:
            self._ray_jacobians[name] = PixelJacobian.of(self.rays(name))
        return self._ray_jacobians[name]

    def lines(self, here: str, there: str, camera: str) -> EpipolarLines:
        """Return the epipolar lines of the pair (``here``, ``there``) in the image of one of both; 10 bytes per pixel are kept."""
        key = (here, there, camera)
        if key not in self._lines:
            pair, rays = self.pair(here, there), self.rays(camera)
            view = pair.here if camera == here else pair.there
            xy = np.empty_like(rays)
            in_bands(lambda start, stop: kernels.rectify_pixels(rays, view.rectified_from_camera, view.frame, start, stop, xy), len(rays))
            jacobian = PixelJacobian.of(xy)
            along = np.linalg.inv(jacobian.at_centre())[:, 0]
            along /= np.linalg.norm(along)
            every = table_step(xy.shape)
            direction = (float(along[0]), float(along[1]))
            self._lines[key] = EpipolarLines(read_only(xy), read_only(xy[::every, ::every, 1]), jacobian, direction)
        return self._lines[key]

    def rectified(self, here: str, there: str) -> tuple[RectifiedGrid, Rectifier]:
        """Return the rectified grid of camera ``here`` and the rectifier of the calibration in which it replaces that camera."""
        if (here, there) not in self._rectified:
            grid = rectified_grid(self.cameras, here, there)
            replaced = {**self.cameras.cameras, here: grid.camera}
            self._rectified[here, there] = (grid, Rectifier(replace(self.cameras, cameras=replaced)))
        return self._rectified[here, there]
