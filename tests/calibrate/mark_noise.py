"""How well the marks of a simulated image can be known, from its noise and its blur."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.calibrate.boards.refine import homography, local_axes, window_of
from measureapp.data.board import BoardDescription, CharucoDescription, CirclesDescription
from measureapp.simulate.board_kernel import SUPERSAMPLES
from measureapp.simulate.options import LightSettings

# An estimator is as good as the formula only where its window holds all that is told of the mark. Beside markers the window is as small as
# 3 px and its Gaussian weight falls within the blur of the edges; of a circle the tangents count, whose noise grows away from the outline.
OVER_FORMULA = {"checkerboard": 1.3, "charuco": 3.0, "circles": 2.5}


def mark_sigma(image: ImageArray, noise_free: ImageArray, marks_px: FloatArray, board: BoardDescription) -> float:
    """Return the standard deviation of one coordinate of a mark that noise and blur of an image let expect, rms over the marks.

    Corners are where lines along the edges meet: with gradients g at offsets d from the corner and noise σ of a grey level, the error has
    the covariance A⁻¹ (Σ w² σ²/2 |d|² g gᵀ) A⁻¹ with A = Σ w g gᵀ. Circles: the Cramér-Rao bound σ² (Σ g gᵀ)⁻¹. The gradients are
    those of the noise-free image, so that blur is in them. The renderer samples an edge `SUPERSAMPLES` times a pixel, which adds a uniform
    error of that step to each, averaged by the lens' blur.
    """
    axes = local_axes(homography(board, np.arange(board.count), marks_px), board.flat_corners_mm[:, :2])
    half = _window(board, axes)
    variances = [_variance(image, noise_free, mark, half, isinstance(board, CirclesDescription)) for mark in marks_px]
    return OVER_FORMULA[str(board.kind)] * float(np.sqrt(np.nanmean(variances)))


def _window(board: BoardDescription, axes: FloatArray) -> int:
    if isinstance(board, CirclesDescription):
        return int(np.ceil(1.2 * board.diameter_mm / 2 * np.linalg.norm(axes, axis=2).max()))
    spacing = board.neighbour_mm * float(np.linalg.norm(axes, axis=2).min())
    if isinstance(board, CharucoDescription):
        return window_of(spacing, spacing * (board.square_mm - board.marker_mm) / (2 * board.square_mm) - 1.0)
    return window_of(spacing)


def _variance(image: ImageArray, noise_free: ImageArray, mark: FloatArray, half: int, is_circle: bool) -> float:
    column, row = np.round(mark).astype(int)
    cut = np.s_[row - half - 1 : row + half + 2, column - half - 1 : column + half + 2]
    patch = noise_free[cut].astype(float)
    if patch.shape != (2 * half + 3, 2 * half + 3):
        return float("nan")
    step = float(np.ptp(np.percentile(patch, (5, 95)))) / (SUPERSAMPLES * np.sqrt(12.0))
    noise = float(np.mean((image[cut].astype(float) - patch) ** 2)) + step**2 / (4 * np.pi * LightSettings().lens_blur_px ** 2)
    slopes = np.stack([(patch[1:-1, 2:] - patch[1:-1, :-2]) / 2, (patch[2:, 1:-1] - patch[:-2, 1:-1]) / 2], -1).reshape(-1, 2)
    if is_circle:
        return noise * float(np.trace(np.linalg.inv(slopes.T @ slopes))) / 2
    y, x = np.mgrid[-half : half + 1, -half : half + 1].astype(float)
    weight = np.exp(-((x / half) ** 2) - (y / half) ** 2).reshape(-1, 1)
    away = ((x + column - mark[0]) ** 2 + (y + row - mark[1]) ** 2).reshape(-1, 1)
    inverse = np.linalg.inv((weight * slopes).T @ slopes)
    return float(np.trace(inverse @ ((weight**2 * away * noise / 2 * slopes).T @ slopes) @ inverse)) / 2
