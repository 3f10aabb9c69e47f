"""How much phases scatter about smooth surfaces, against their predicted standard deviations: the test of the noise model."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.phase import PixelState

RADIUS, SIDE = 2, 5  # px, of the windows that a quadratic surface is fitted to
SAMPLES = 12_000  # windows of an image
CELLS = 16  # along the longer side of an image
LEAST_OF_VIEW, LEAST_OF_CELL = 300, 30  # windows
LEAST_EXCESS = 1.15  # of the variance, below which predicted and observed agree
CELL_EXCESS, CELL_SIGMAS = 1.3, 4.0  # by which a cell must exceed the image as a whole
NORMAL_MEDIAN = 0.4549  # of the square of a normal variable of variance 1
MEDIAN_SD = 1.65  # standard deviation of the median of such squares over that of their mean


def _residual_weights() -> FloatArray:
    """Return the weights (SIDE²,) of the residual of the central pixel from the quadratic surface through a window, of unit noise gain."""
    y, x = np.mgrid[-RADIUS : RADIUS + 1, -RADIUS : RADIUS + 1].reshape(2, -1).astype(float)
    surface = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)
    weights = -(surface @ np.linalg.pinv(surface))[SIDE * SIDE // 2]
    weights[SIDE * SIDE // 2] += 1
    return np.asarray(weights / np.linalg.norm(weights))


WEIGHTS = _residual_weights()


def scatter_ratios(phase_rad: FloatArray, sigma_rad: FloatArray, state: IntArray) -> tuple[float, FloatArray | None]:
    """Compare the scatter of phases about quadratic surfaces through 5 x 5 pixels with their standard deviations.

    Medians of the squared ratio, so that edges and texture do not count. What scatters more than the camera's noise explains: ripple of
    a projector without gamma correction, images that are not raw, motion, rough surfaces.

    Parameters
    ----------
    phase_rad, sigma_rad : (H, W)
    state : (H, W) of PixelState

    Returns
    -------
    of the image : observed over predicted standard deviation; 1 where too few windows are whole
    of cells : (rows, columns) float32, by how much the standard deviations are to be multiplied, at least 1; None: they hold everywhere
    """
    every = max(1, int(np.sqrt(phase_rad.size / SAMPLES)))
    if min(phase_rad.shape) < 2 * SIDE:
        return 1.0, None
    whole = _windows(state, every, 0, SIDE * SIDE)
    valid = np.all(np.asarray(whole) == PixelState.VALID, axis=0)
    if np.count_nonzero(valid) < LEAST_OF_VIEW:
        return 1.0, None
    centre = sigma_rad[RADIUS : phase_rad.shape[0] - RADIUS : every, RADIUS : phase_rad.shape[1] - RADIUS : every]
    middle = _windows(phase_rad, every, SIDE * SIDE // 2, SIDE * SIDE // 2 + 1)[0]
    residual = np.zeros(middle.shape, np.float32)
    for weight, values in zip(WEIGHTS, _windows(phase_rad, every, 0, SIDE * SIDE), strict=True):
        residual += np.float32(weight) * (values - middle)
    square = np.square(residual[valid].astype(np.float64) / np.maximum(centre[valid], 1e-9))
    overall = float(np.median(square)) / NORMAL_MEDIAN
    ratio = _of_cells(square, valid, max(1.0, overall) if overall > LEAST_EXCESS else 1.0)
    return float(np.sqrt(overall)), np.sqrt(ratio).astype(np.float32) if (ratio > 1).any() else None


def _windows(image: FloatArray | IntArray, every: int, first: int, last: int) -> list[np.ndarray]:
    """Return the pixels ``first`` … ``last`` of windows about every so many pixels, each (rows, columns)."""
    height, width = image.shape
    shifts = [divmod(number, SIDE) for number in range(first, last)]
    return [image[dy : height - SIDE + 1 + dy : every, dx : width - SIDE + 1 + dx : every] for dy, dx in shifts]


def _of_cells(square: FloatArray, valid: FloatArray, base: float) -> FloatArray:
    """Return the ratio of variances of every cell: that of the image, or its own where it clearly exceeds that."""
    height, width = valid.shape
    cell = max(1, max(height, width) // CELLS)
    row, column = np.nonzero(valid)
    across = -(-width // cell)
    place = row // cell * across + column // cell
    order = np.argsort(place, kind="stable")
    ratio = np.full(-(-height // cell) * across, base)
    for number, (start, stop) in enumerate(pairwise(np.searchsorted(place[order], np.arange(len(ratio) + 1)))):
        if stop - start >= LEAST_OF_CELL:
            found = float(np.median(square[order[start:stop]])) / NORMAL_MEDIAN
            if found > base * max(CELL_EXCESS, 1 + CELL_SIGMAS * MEDIAN_SD * np.sqrt(2 / (stop - start))):
                ratio[number] = found
    return ratio.reshape(-1, across)


def widen(sigma_rad: FloatArray, factors: FloatArray) -> None:
    """Multiply standard deviations (H, W), in place, by the factors of cells, interpolated between these."""
    height, width = sigma_rad.shape
    sigma_rad *= cv2.resize(factors, (width, height), interpolation=cv2.INTER_LINEAR)
