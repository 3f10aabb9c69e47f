"""Weights of the exposures in the sum of their images."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.fringe.noise.model import CameraNoise

WHOLE_SUM = 32  # of all weights: so many images of eight bits and four steps can be added in 16 bits
ACCEPTED_LOSS = 0.02
BRIGHTEST = 0.55  # mean grey level of a pixel that just does not saturate, as a share of saturation, at usual contrast
LEVELS = 9
HIGHEST_CONTRAST = 0.9  # modulation over mean grey level
SOFTNESS = np.concatenate([np.geomspace(0.005, 4.0, 40), [np.inf]])  # exposure, over the longest, below which a weight falls


@lru_cache(maxsize=4096)
def exposure_weights(exposures_us: tuple[int, ...], noise: CameraNoise, saturation: float, least_modulation: float) -> tuple[int, ...]:
    """Return the whole-number weights with which the images of the exposures, from long to short, are added.

    Of a pixel with mean grey level A at the longest exposure, the phase of exposure t (relative to it) has the information
    B²t²/(gAt + f), with g and f the shot and dark noise of the camera. The best weights of images are t/(t + f/(gA)): equal where
    shot noise dominates, and t where dark noise does. All ones, the plain sum, stay within 2 % of the best standard deviation for the paper's
    bracket; they are kept wherever that holds for every pixel that can be decoded. Otherwise the short exposures of a wide
    bracket would add mostly dark noise to dark pixels: then the weights t/(t + c), rounded, are chosen whose worst loss over all pixels,
    bright ones included that only the short exposures do not saturate, is least.

    Parameters
    ----------
    least_modulation : of pixels that are decoded, in grey levels
    """
    shares = np.array(exposures_us, float) / max(exposures_us)
    ones = np.ones((1, len(shares)))
    scenes = _scenes(shares, saturation, least_modulation / HIGHEST_CONTRAST)
    if len(shares) == 1 or _worst_loss(ones, shares, scenes, noise, saturation)[0] <= ACCEPTED_LOSS:
        return (1,) * len(shares)
    soft = np.where(np.isinf(SOFTNESS[:, None]), shares, shares / (shares + np.where(np.isinf(SOFTNESS), 0.0, SOFTNESS)[:, None]))
    largest = np.arange(1, WHOLE_SUM)
    candidates = np.maximum(1, np.rint(soft[:, None, :] / soft.max(axis=1)[:, None, None] * largest[None, :, None]))
    candidates = np.concatenate([ones, candidates.reshape(-1, len(shares))])
    candidates = np.unique(candidates[candidates.sum(axis=1) <= max(WHOLE_SUM, len(shares))], axis=0)
    best = candidates[int(np.argmin(_worst_loss(candidates, shares, scenes, noise, saturation)))]
    return tuple(int(weight) for weight in best)


def _scenes(shares: FloatArray, saturation: float, darkest_grey: float) -> list[tuple[int, FloatArray]]:
    """Return which exposures pixels use (all from a first one on) and the grey levels, at the longest exposure, of such pixels."""
    top = BRIGHTEST * saturation
    scenes: list[tuple[int, FloatArray]] = [(0, np.geomspace(min(darkest_grey, top), top, LEVELS))]
    for first in range(1, len(shares)):
        scenes.append((first, np.geomspace(top / shares[first - 1], top / shares[first], 3)))
    return scenes


def sigma_loss(weights: FloatArray | IntArray, shares: FloatArray, grey: FloatArray, noise: CameraNoise, saturation: float) -> FloatArray:
    """Return by how much the phase noise of weighted sums exceeds the least possible, as a share, (..., levels).

    Parameters
    ----------
    weights : (..., E); shares : (E,) exposures over the longest; grey : (levels,) mean grey level above black at the longest
    """
    variance = grey[:, None] * shares / noise.electrons_per_grey(saturation) + noise.floor_variance(saturation)
    least = 1 / (shares**2 / variance).sum(axis=1)
    own = (np.square(weights)[..., None, :] * variance).sum(axis=-1) / np.square((weights * shares).sum(axis=-1))[..., None]
    return np.asarray(np.sqrt(own / least) - 1)


def _worst_loss(
    weights: FloatArray, shares: FloatArray, scenes: list[tuple[int, FloatArray]], noise: CameraNoise, saturation: float
) -> FloatArray:
    losses = [sigma_loss(weights[:, first:], shares[first:], grey, noise, saturation).max(axis=-1) for first, grey in scenes]
    return np.asarray(np.max(losses, axis=0))
