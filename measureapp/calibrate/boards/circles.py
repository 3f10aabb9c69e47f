"""The circles of a staggered grid, with the centres where the circles' centres are, not those of their images."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.circle_grid import detect_grid, ids_of, possible_placements
from measureapp.calibrate.boards.part import LEAST_MARKS, identify_part
from measureapp.calibrate.boards.refine import SmoothGrid, cut_off, homography, local_axes, smooth_grid
from measureapp.data.board import CirclesDescription

RING_SHARE = 0.35  # half the width of the ring of pixels around the outline, over the radius; within the gap to the next circle
OUTLINE = 24  # points of a circle whose images give its image's centre
ROUNDS = 3  # of the correction: each shrinks what is left by the ratio of bias to spacing


def find_circles(
    grey: ImageArray, board: CirclesDescription, expected_px: FloatArray | None = None
) -> tuple[IntArray, FloatArray, float] | None:
    """Find ids (N,), projected centres (N, 2) to sub-pixel and the smallest distance of neighbours, px; None where no grid fits.

    Which circles are seen follows from where the grid certainly ends, or else from where they are ``expected_px`` (all, 2). The centre of a circle's image is not the image of its
    centre [1]_: what separates them follows from the homography of all circles and from the lens distortion that bends their grid, and is
    taken off, until it no longer changes. Circles that are cut count as not seen.

    Raises
    ------
    CalibrationError
        Several parts of the board look like the one that is seen.

    References
    ----------
    .. [1] J. Heikkilä, IEEE Trans. Pattern Analysis and Machine Intelligence 22(10), 1066-1077, 2000.
    """
    grid = detect_grid(grey, board)
    if grid is None or len(grid.places) < LEAST_MARKS:
        return None
    lies = possible_placements(board, grid)
    if not lies:
        return None
    parts = [(ids_of(board, grid.places, lie), grid.centres_px) for lie in lies]
    ids, _ = parts[identify_part(board, parts, expected_px, symmetry=2 if board.is_symmetric else 1)]  # either end may come first
    order = np.argsort(ids)
    ids, coarse = ids[order], grid.centres_px[order]
    marks = board.flat_corners_mm[ids, :2]
    matrix = homography(board, ids, coarse)
    seen = np.array([_centre(grey, place, ellipse) for place, ellipse in zip(coarse, _ellipses(matrix, board, marks), strict=True)])
    centres = seen
    for _ in range(ROUNDS):
        centres = seen - centre_bias(smooth_grid(board, ids, centres), board, ids)
    good = ~cut_off(board, ids, centres)
    axes = local_axes(homography(board, ids, centres), marks)
    diagonals = np.stack([axes[:, 0] + axes[:, 1], axes[:, 0] - axes[:, 1]], axis=1) * board.spacing_mm
    return ids[good], centres[good], float(np.linalg.norm(diagonals, axis=2).min())


def centre_bias(grid: SmoothGrid, board: CirclesDescription, ids: IntArray) -> FloatArray:
    """Return centre of the image minus image of the centre (N, 2) of the circles ``ids``: of the ellipse through points of each outline."""
    marks = board.flat_corners_mm[ids, :2]
    angles = np.linspace(0, 2 * np.pi, OUTLINE, endpoint=False)
    outline = board.diameter_mm / 2 * np.column_stack([np.cos(angles), np.sin(angles)])
    centres = grid.image_of(marks)
    away = grid.image_of((marks[:, None] + outline).reshape(-1, 2)).reshape(-1, OUTLINE, 2) - centres[:, None]
    unit = np.abs(away).max(axis=(1, 2))
    x, y = np.moveaxis(away / unit[:, None, None], 2, 0)
    a, b, c, d, e = (np.linalg.pinv(np.stack([x * x, x * y, y * y, x, y], axis=2)) @ np.ones((OUTLINE, 1)))[..., 0].T
    return np.asarray(np.column_stack([b * e - 2 * c * d, b * d - 2 * a * e]) * (unit / (4 * a * c - b * b))[:, None])


def _dual_conics(matrix: FloatArray, board: CirclesDescription, marks_mm: FloatArray) -> FloatArray:
    """The images of the circles at (N, 2) as dual conics (N, 3, 3)."""
    radius = board.diameter_mm / 2.0
    x, y = marks_mm.T
    one = np.ones_like(x)
    duals = np.array([[x * x - radius**2, x * y, x], [x * y, y * y - radius**2, y], [x, y, one]]).transpose(2, 0, 1)
    return np.asarray(matrix @ duals @ matrix.T)


def _ellipses(matrix: FloatArray, board: CirclesDescription, marks_mm: FloatArray) -> FloatArray:
    """The shape (N, 2, 2) of each image about its centre: points at a distance of one from it are the outline."""
    duals = _dual_conics(matrix, board, marks_mm)
    duals = duals / duals[:, 2:, 2:]
    centre = duals[:, :2, 2]
    return np.asarray(np.linalg.inv(centre[:, :, None] * centre[:, None, :] - duals[:, :2, :2]))


def _centre(grey: ImageArray, place: FloatArray, ellipse: FloatArray) -> FloatArray:
    """Return the centre of the ellipse whose tangents are the lines across the grey level gradient near its outline [1]_.

    References
    ----------
    .. [1] J.-N. Ouellet, P. Hébert, Machine Vision and Applications 21, 59-67, 2009.
    """
    half = int(np.ceil((1 + RING_SHARE) * np.sqrt(1.0 / np.linalg.eigvalsh(ellipse)[0]))) + 2
    column, row = np.round(place).astype(int)
    top, left = max(row - half, 0), max(column - half, 0)
    patch = grey[top : row + half + 1, left : column + half + 1].astype(np.float64)
    gx, gy = cv2.Sobel(patch, cv2.CV_64F, 1, 0), cv2.Sobel(patch, cv2.CV_64F, 0, 1)
    y, x = np.mgrid[0 : patch.shape[0], 0 : patch.shape[1]].astype(np.float64)
    x, y = x + left - place[0], y + top - place[1]
    ring = _on_ring(x, y, ellipse)
    gx, gy, x, y = gx[ring], gy[ring], x[ring], y[ring]
    a, b, c = gx, gy, -(gx * x + gy * y) / half
    rows = np.column_stack([a * a, 2 * a * b, b * b, 2 * a * c, 2 * b * c])
    solved = np.linalg.lstsq(rows, -c * c, rcond=None)[0]
    return np.asarray(place + solved[3:] * half)


def _on_ring(x: FloatArray, y: FloatArray, ellipse: FloatArray) -> BoolArray:
    level = np.sqrt(ellipse[0, 0] * x * x + 2 * ellipse[0, 1] * x * y + ellipse[1, 1] * y * y)
    return np.asarray(np.abs(level - 1.0) < RING_SHARE)
