"""How far saturated pixels bloom into their neighbours, from the difference of two exposures of the same neighbours."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.fringe import FringeStack
from measureapp.fringe.noise.model import CameraNoise

FARTHEST_PX = 16
CERTAIN = 5.0  # standard errors by which the light of a ring must exceed the prediction from the shorter exposure
HARMFUL = 0.5  # of the noise of a pixel: less light than that is not worth losing an exposure for
BRIGHTEST = 0.8  # of saturation: brighter pixels are partly clipped by their own noise
DIMMEST = 0.1  # of saturation: rounding to whole grey levels changes the ratio of darker pixels
LEAST_PIXELS = 50  # of a ring


def spill_radius_px(stack: FringeStack, camera: str, noise: CameraNoise) -> int:
    """Return how close to saturated pixels the images of a camera hold light that is not their own, for `DecodeSettings.blooming_radius_px`.

    A pixel that is not saturated itself must be as much brighter as it was exposed longer. Beside saturated pixels of a sensor that
    blooms it is brighter still, in the long exposure alone; the halo of a lens grows with the exposure and does not count. Rings of
    growing distance are evaluated by their mean; pixels far from any saturated one determine the ratio of the exposures.

    Returns
    -------
    0 … 16; 0 where nothing spills over, and where one exposure or no saturated pixel gives nothing to compare
    """
    images = stack.images[camera]
    excess, variance, counts = (np.zeros(FARTHEST_PX + 1) for _ in range(3))
    for longer, shorter in pairwise(images):
        for long, short in zip(longer, shorter, strict=True):
            ring = _rings(long, short, float(stack.saturation), noise)
            excess, variance, counts = excess + ring[0], variance + ring[1], counts + ring[2]
    known = counts >= LEAST_PIXELS
    certain = excess > CERTAIN * np.sqrt(variance)
    harmful = excess > HARMFUL * np.sqrt(variance * counts)
    spilt = (known & certain & harmful)[1:]
    return int(np.argmin(np.append(spilt, False)))  # the rings from the first on, without a gap


def _rings(long: ImageArray, short: ImageArray, saturation: float, noise: CameraNoise) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return by distance from saturated pixels, 0 … 16 px, the sums of excess light and of its variance, and how many pixels they are of."""
    nothing = np.zeros(FARTHEST_PX + 1)
    clipped = long >= saturation
    if not clipped.any() or clipped.all():
        return nothing, nothing, nothing
    distance = np.rint(cv2.distanceTransform((~clipped).astype(np.uint8), cv2.DIST_C, 3)).astype(int)
    bright, faint = long.astype(float) - noise.black_grey, short.astype(float) - noise.black_grey
    lit = ~clipped & (bright > DIMMEST * saturation)
    far = lit & (distance > FARTHEST_PX)
    if np.count_nonzero(far) < LEAST_PIXELS:
        return nothing, nothing, nothing
    ratio = float(bright[far].sum() / faint[far].sum())
    near = lit & (distance <= FARTHEST_PX) & (ratio * faint < BRIGHTEST * saturation)
    place, predicted = distance[near], ratio * faint[near]
    shot = noise.variance(predicted + noise.black_grey, saturation)
    spread = np.asarray(shot + ratio**2 * noise.variance(short[near].astype(float), saturation))
    over, variance, count = (
        np.bincount(place, weights, FARTHEST_PX + 1).astype(float) for weights in (bright[near] - predicted, spread, np.ones(len(place)))
    )
    return over, variance, count
