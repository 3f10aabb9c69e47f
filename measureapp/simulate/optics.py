"""Light of projector and lamp, and what a camera makes of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot

import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate import kernels
from measureapp.simulate.effects.bounce import Bounce
from measureapp.simulate.effects.sharpness import gaussian
from measureapp.simulate.options import LightSettings

FLOOR = 0.004  # black level, share of full scale
MARGIN_PX, MARGIN_SHARE = 3.0, 0.005  # around the image box of an object
OUTLINE_SAMPLES = 9
NO_RESIDUAL = np.zeros((1, 1, 2), np.float32)
NO_COMA = np.zeros(4)


@dataclass(frozen=True, slots=True, eq=False)
class SeeingCamera:
    """A camera as it really is: lens parameters, and the distortion that they lack."""

    pinhole: PinholeCamera
    residual_px: FloatArray = field(default_factory=lambda: NO_RESIDUAL)  # (rows, columns, 2), see `kernels.pixel_rays`
    coma: FloatArray = field(default_factory=lambda: NO_COMA)  # (4,), likewise

    @property
    def parameters(self) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Parameters of the lens for the kernels."""
        return (*lens_parameters(self.pinhole), self.residual_px, self.coma)


@dataclass(frozen=True, slots=True, eq=False)
class ProjectorLight:
    """The projector as the light source of a scene."""

    pinhole: PinholeCamera
    scene_from_projector: RigidTransform
    standoff_mm: float

    @property
    def position(self) -> FloatArray:
        """Position of the light source, (3,)."""
        return np.array(self.scene_from_projector.translation_mm)

    @property
    def from_scene(self) -> FloatArray:
        """Transform from scene to projector, (4, 4)."""
        return np.array(self.scene_from_projector.inverse().matrix)


def image_box(camera: PinholeCamera, camera_from_scene: RigidTransform, outline_mm: FloatArray) -> IntArray | None:
    """Return first row, end row, first and end column of the image box of ``outline_mm`` (N, 3); None when it is not visible."""
    points = camera_from_scene.apply(outline_mm)
    if points[:, 2].min() <= 0.0:
        whole = np.array([0, camera.height_px, 0, camera.width_px])
        return whole if points[:, 2].max() > 0.0 else None
    pixels = camera.project(points)
    margin = MARGIN_PX + MARGIN_SHARE * camera.width_px
    low = np.maximum(np.floor(pixels.min(axis=0) - margin), 0)
    high = np.minimum(np.ceil(pixels.max(axis=0) + margin), [camera.width_px, camera.height_px])
    return np.array([low[1], high[1], low[0], high[0]], np.int64) if np.all(low < high) else None


def lens_parameters(pinhole: PinholeCamera) -> tuple[FloatArray, FloatArray]:
    """Return (fx, fy, cx, cy) and (k1, k2, p1, p2, k3) for the kernels."""
    m = pinhole.matrix
    coefficients = np.zeros(5)
    coefficients[: len(pinhole.distortion)] = pinhole.distortion
    return np.array([m[0, 0], m[1, 1], m[0, 2], m[1, 2]]), coefficients


def project_images(images: ImageArray | FloatArray, settings: LightSettings, vignetting: float = 0.0) -> FloatArray:
    """Apply response, black level, loss towards the corners and defocus of the projector to images (n, h, w), levels 0…255 or floats 0…1.

    Returns light 0…1, float32.
    """
    levels = images.astype(np.float32) / (255.0 if images.dtype == np.uint8 else 1.0)
    light = settings.black + (1.0 - settings.black) * levels**settings.gamma
    if vignetting:
        y, x = np.mgrid[-1.0 : 1.0 : light.shape[1] * 1j, -1.0 : 1.0 : light.shape[2] * 1j]
        light *= 1.0 - vignetting * (x**2 + y**2) / 2.0
    return np.stack([gaussian(image, settings.defocus_px) for image in light.astype(np.float32)])


def expose(
    light: FloatArray,
    pattern: FloatArray | None,
    exposure_us: int,
    settings: LightSettings,
    width_px: float = 0.0,
    second: Bounce | None = None,
) -> FloatArray:
    """Compute the mean image (H, W) float32, relative to full scale, from the light map of `Surface.illuminate`.

    Parameters
    ----------
    light : (H, W, 4) float32
    pattern : (h, w) light of the projector; None for the head lamp, which illuminates beyond the projector's field
    width_px : standard deviation of the pixel aperture if ``light`` is sampled at pixel centres
    second : light that comes by way of other surfaces
    """
    mean = np.empty(light.shape[:2], np.float32)
    scale = exposure_us / settings.reference_exposure_us
    shown = np.zeros((2, 2), np.float32) if pattern is None else pattern * np.float32(settings.projector)
    lamp = settings.lamp if pattern is None else 0.0
    kernels.in_bands(kernels.expose, 0, mean.size, light.reshape(-1, 4), shown, lamp, settings.ambient, scale, FLOOR, mean.reshape(-1))
    if second is not None:
        mean += np.float32(scale) * second.light(None if pattern is None else shown, settings.lamp)
    return gaussian(mean, hypot(settings.lens_blur_px, width_px))
