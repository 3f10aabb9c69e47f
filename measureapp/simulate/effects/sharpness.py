"""Blur that changes over the field and with the depth, and light scattered in a lens."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.simulate.options import LensEffects

FULL_WIDTH_PX = 2592  # of the camera that the magnitudes are stated for
FOCUS_SPREAD_MM = 15.0  # of the plane in focus about the standoff
GLARE_STEP = 32
GLARE_WIDTH = 0.25  # of the image's width, standard deviation of the scattered light
LEAST_CHANGE_PX = 0.02
NARROW_PX = 0.6  # up to here a Gaussian sampled at the pixels has less than its variance


@dataclass(frozen=True, slots=True, eq=False)
class Sharpness:
    """Blur of one camera beyond the one it has everywhere: larger in the corners and away from the plane in focus."""

    corner_px: float
    defocus_px: float  # 100 mm from focus
    part_px: float
    focus_mm: float  # depth in focus
    centre: tuple[float, float]  # of the sharpest place, relative to the image, 0…1
    glare: float

    def blur_px(self, shape: tuple[int, int], depth_mm: FloatArray, *, of_part: bool) -> FloatArray:
        """Return the further blur (rows, columns) of an image of ``shape`` as a standard deviation in pixels on a coarse grid.

        ``depth_mm`` = (at the centre of the image, its change over the width, over the height) of what is seen.
        """
        y, x = np.mgrid[0:1:9j, 0:1:9j]
        away = np.hypot(x - self.centre[0], y - self.centre[1]) / 0.7
        depth = depth_mm[0] + depth_mm[1] * (x - 0.5) + depth_mm[2] * (y - 0.5)
        squares = (self.corner_px * away**2) ** 2 + (self.defocus_px * (depth - self.focus_mm) / 100.0) ** 2
        squares += self.part_px**2 if of_part else 0.0
        return np.sqrt(squares) * shape[1] / FULL_WIDTH_PX

    def blurred(self, image: FloatArray, depth_mm: FloatArray, *, of_part: bool) -> FloatArray:
        """Return the image (H, W) with this blur and the scattered light.

        Where the blur changes, the image is a mixture of the least and the most blurred one with the variance wanted, which is no
        Gaussian, as a real point spread function is none.
        """
        wanted = self.blur_px(image.shape, depth_mm, of_part=of_part)
        low, high = float(wanted.min()), float(wanted.max())
        seen = gaussian(image, high)
        if high - low > LEAST_CHANGE_PX:
            share = cv2.resize(((wanted**2 - low**2) / (high**2 - low**2)).astype(np.float32), image.shape[::-1])
            sharp = gaussian(image, low)
            seen = sharp + share * (seen - sharp)
        return self._scattered(seen)

    def _scattered(self, image: FloatArray) -> FloatArray:
        if self.glare == 0.0:
            return image
        height, width = image.shape
        small = cv2.resize(image, (max(1, width // GLARE_STEP), max(1, height // GLARE_STEP)), interpolation=cv2.INTER_AREA)
        spread = cv2.GaussianBlur(small, (0, 0), GLARE_WIDTH * small.shape[1], borderType=cv2.BORDER_REPLICATE)
        wide = cv2.resize(spread, (width, height), interpolation=cv2.INTER_LINEAR)
        return np.asarray((1.0 - self.glare) * image + self.glare * wide, np.float32)


def draw_sharpness(effects: LensEffects, standoff_mm: float, rng: np.random.Generator) -> Sharpness | None:
    """Draw the blur of one camera; None if there is none."""
    amounts = rng.uniform(0.7, 1.3, 4) * (effects.corner_blur_px, effects.defocus_px, effects.part_blur_px, effects.glare)
    focus = standoff_mm + FOCUS_SPREAD_MM * rng.standard_normal()
    centre = 0.5 + 0.08 * rng.standard_normal(2)
    if not amounts.any():
        return None
    corner, defocus, part, glare = map(float, amounts)
    return Sharpness(corner, defocus, part, float(focus), (float(centre[0]), float(centre[1])), glare)


def object_depth(pinhole: PinholeCamera, points_mm: FloatArray) -> FloatArray:
    """Return the depth of an object as a plane over the image: at the centre, its change over the width, over the height.

    ``points_mm`` (N, 3) are some of its points in the camera's frame.
    """
    front = points_mm[points_mm[:, 2] > 1.0]
    if len(front) < 3:
        return np.zeros(3)
    pixels = pinhole.project(front) / (pinhole.width_px, pinhole.height_px) - 0.5
    inside = np.abs(pixels).max(axis=1) < 0.6
    if np.count_nonzero(inside) < 3:
        return np.array([float(np.median(front[:, 2])), 0.0, 0.0])
    design = np.column_stack([np.ones(np.count_nonzero(inside)), pixels[inside]])
    return np.asarray(np.linalg.lstsq(design, front[inside, 2], rcond=None)[0])


def gaussian(image: FloatArray, sigma_px: float) -> FloatArray:
    """Blur an image (H, W) float32 by a Gaussian; below NARROW_PX by three taps of its variance, as samples of it would hardly blur."""
    if sigma_px == 0.0:
        return image
    if sigma_px <= NARROW_PX:
        side = 0.5 * sigma_px**2
        taps = np.array([side, 1.0 - 2.0 * side, side], np.float32)
        return np.asarray(cv2.sepFilter2D(image, -1, taps, taps, borderType=cv2.BORDER_REPLICATE))
    size = 2 * max(1, round(3.0 * sigma_px)) + 1
    return np.asarray(cv2.GaussianBlur(image, (size, size), sigma_px, borderType=cv2.BORDER_REPLICATE))
