"""Corners to sub-pixel, and how well each is known."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.board import BoardDescription
from measureapp.errors import CalibrationError

WINDOW_SHARE = 0.35  # half the refining window over the distance of neighbouring corners: its diagonal ends at the next edge
WINDOW_LIMITS_PX = (2, 12)
LARGEST_SHIFT = 0.75  # a corner that wanders further than this share of the window has found another edge
REFINE_UNTIL = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)
LEAST_MARKS_FOR_CUBIC, LINEAR_TERMS = 40, 3
FAR_FACTOR, FAR_PX = 8.0, 0.4  # standard deviations and pixels beyond which a mark is not where the grid has it
CUT_FACTOR, CUT_PX = 5.0, 0.1  # the same in a part of a board, whose marks at the edge may be cut
MOST_CUT = 0.25  # share of the marks of a part
MEDIAN_TO_SIGMA = 1.4826
LEAST_SIGMA_PX = 0.005
WEAK_CORNER = 5.0  # a mark said to be this many times worse than the median one counts as no worse than that


def window_of(spacing_px: float, free_px: float = np.inf) -> int:
    """Return half the side of the refining window for corners ``spacing_px`` apart with nothing else within ``free_px``."""
    return int(np.clip(min(WINDOW_SHARE * spacing_px, free_px), *WINDOW_LIMITS_PX))


def refine_corners(grey: ImageArray, corners: FloatArray, spacing_px: float, window: int) -> FloatArray:
    """Refine corners (N, 2) to sub-pixel [1]_.

    Raises
    ------
    CalibrationError
        The squares are too small in the image, or a corner moved to another edge.

    References
    ----------
    .. [1] W. Förstner, E. Gülch, Proc. ISPRS Intercommission Conference, 281-305, 1987.
    """
    start = np.ascontiguousarray(corners, np.float32).reshape(-1, 1, 2)
    better = np.asarray(cv2.cornerSubPix(grey, start.copy(), (window, window), (-1, -1), REFINE_UNTIL), np.float64).reshape(-1, 2)
    shift = np.linalg.norm(better - corners, axis=1)
    if spacing_px < 2 * WINDOW_LIMITS_PX[0] or not np.all(shift <= LARGEST_SHIFT * max(window, 4)):
        raise CalibrationError(
            "The corners of the board cannot be refined.", "Take a sharper image, or move closer so that the squares appear larger."
        )
    return better


def homography(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> FloatArray:
    """Return the plane-to-image homography (3, 3) through the marks ``ids``. Raises CalibrationError where they do not determine it."""
    found = cv2.findHomography(board.flat_corners_mm[ids, :2], corners_px)[0] if len(ids) >= 4 else None
    if found is None or not np.all(np.isfinite(found)):
        raise CalibrationError("The marks of the board that are visible are too few, or lie on one line.", "Show more of the board.")
    return np.asarray(found, np.float64)


def apply_homography(matrix: FloatArray, points: FloatArray) -> FloatArray:
    """Map points (N, 2) by a homography."""
    high = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    return np.asarray(high[:, :2] / high[:, 2:])


def local_axes(matrix: FloatArray, points_mm: FloatArray) -> FloatArray:
    """Return the images of 1 mm along x and y of the board, px, at points (N, 2): (N, 2 axes, 2)."""
    high = np.column_stack([points_mm, np.ones(len(points_mm))]) @ matrix.T
    flat = high[:, :2] / high[:, 2:]
    return np.stack([(matrix[:2, a] - flat * matrix[2, a]) / high[:, 2:] for a in (0, 1)], axis=1)


@dataclass(frozen=True, slots=True, eq=False)
class SmoothGrid:
    """Where a board's plane appears: a homography, and a lens distortion that is cubic in the image."""

    matrix: FloatArray  # (3, 3)
    centre_px: FloatArray  # (2,)
    span_px: float
    bend: FloatArray  # (terms, 2), px

    def image_of(self, points_mm: FloatArray) -> FloatArray:
        """Return the images (N, 2) of points (N, 2) of the plane."""
        flat = apply_homography(self.matrix, points_mm)
        return np.asarray(flat + _cubic_terms((flat - self.centre_px) / self.span_px)[:, : len(self.bend)] @ self.bend)


def smooth_grid(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> SmoothGrid:
    """Fit the plane's image to the marks ``ids``; from few of them the distortion's slopes only."""
    matrix = homography(board, ids, corners_px)
    flat = apply_homography(matrix, board.flat_corners_mm[ids, :2])
    centre = flat.mean(axis=0)
    span = float(np.abs(flat - centre).max())
    terms = _cubic_terms((flat - centre) / span)[:, : None if len(ids) >= LEAST_MARKS_FOR_CUBIC else LINEAR_TERMS]
    return SmoothGrid(matrix, centre, span, np.linalg.lstsq(terms, corners_px - flat, rcond=None)[0])


def _cubic_terms(points: FloatArray) -> FloatArray:
    x, y = points.T
    return np.column_stack([x ** (order - b) * y**b for order in range(4) for b in range(order + 1)])


def mark_sigmas(grey: ImageArray, board: BoardDescription, ids: IntArray, corners_px: FloatArray, reach_px: FloatArray) -> FloatArray:
    """Estimate the standard deviation (N,) px of one coordinate of each mark.

    What gradients within ``reach_px`` (N,) say of each mark's place gives the ratios (inverse of the summed products of gradients,
    Förstner 1987); the smoothness of the grid gives the level: what a homography and a cubic distortion leave is noise.
    """
    halves = np.maximum(2, np.round(reach_px).astype(int)) + 1
    shape = np.empty(len(ids))
    for half in np.unique(halves):
        shape[halves == half] = _precision(grey, corners_px[halves == half], int(half))
    shape = np.minimum(shape / np.median(shape), WEAK_CORNER)
    return np.asarray(np.maximum(_level(board, ids, corners_px) * shape, LEAST_SIGMA_PX))


def _precision(grey: ImageArray, corners_px: FloatArray, half: int) -> FloatArray:
    patch = patches_at(grey, corners_px, half).astype(np.float64)
    gx, gy = (patch[:, 1:-1, 2:] - patch[:, 1:-1, :-2]) / 2, (patch[:, 2:, 1:-1] - patch[:, :-2, 1:-1]) / 2
    xx, yy, xy = (np.sum(one, axis=(1, 2)) for one in (gx * gx, gy * gy, gx * gy))
    return np.asarray(np.sqrt((xx + yy) / 2 / np.maximum(xx * yy - xy * xy, 1e-9)))


def patches_at(grey: ImageArray, places: FloatArray, half: int) -> ImageArray:
    """Return the squares (N, 2 half + 1, 2 half + 1) of the image about places (N, 2), moved inwards at its edges."""
    offsets = np.arange(-half, half + 1)
    column, row = np.clip(np.round(places).astype(int), half, np.array(grey.shape[::-1]) - half - 1).T
    return np.asarray(grey[(row[:, None] + offsets)[:, :, None], (column[:, None] + offsets)[:, None, :]])


def off_the_grid(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> BoolArray:
    """Return which marks (N,) are outliers of a smooth grid: refined onto something else, such as a marker's corner."""
    rest, _ = _residuals_of_smooth_grid(board, ids, corners_px)
    away = np.linalg.norm(rest, axis=1)
    return np.asarray(away > max(FAR_FACTOR * MEDIAN_TO_SIGMA * float(np.median(np.abs(rest))), FAR_PX))


def cut_off(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> BoolArray:
    """Return which marks (N,) at the cut edge of a part of a board are displaced: some tenths of a pixel and, along its edge, all to one side.

    Several of them bend the grid that is fitted to all; so the worst is removed and the rest fitted again, until none is far.
    """
    off = np.zeros(len(ids), bool)
    while np.count_nonzero(off) < MOST_CUT * len(ids):
        rest, _ = _residuals_of_smooth_grid(board, ids[~off], corners_px[~off])
        away = np.linalg.norm(rest, axis=1)
        if away.max() <= max(CUT_FACTOR * MEDIAN_TO_SIGMA * float(np.median(np.abs(rest))), CUT_PX):
            break
        off[np.flatnonzero(~off)[np.argmax(away)]] = True
    return off


def _level(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> float:
    rest, terms = _residuals_of_smooth_grid(board, ids, corners_px)
    freedom = max(len(ids) - max(terms, 4), 1)
    return MEDIAN_TO_SIGMA * float(np.median(np.abs(rest))) * float(np.sqrt(len(ids) / freedom))


def _residuals_of_smooth_grid(board: BoardDescription, ids: IntArray, corners_px: FloatArray) -> tuple[FloatArray, int]:
    """Residuals of the marks (N, 2) after a homography and a distortion that is cubic in the image; number of the latter's terms."""
    grid = smooth_grid(board, ids, corners_px)
    return corners_px - grid.image_of(board.flat_corners_mm[ids, :2]), len(grid.bend)
