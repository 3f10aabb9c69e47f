"""Identification of a circle grid: complete circles, and positions that are certainly empty."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.circle_lattice import DetectedCircles, detect_circles
from measureapp.calibrate.boards.refine import apply_homography, local_axes
from measureapp.calibrate.boards.squares import blur
from measureapp.data.board import CirclesDescription

AROUND = np.array([[np.cos(angle), np.sin(angle)] for angle in np.linspace(0, 2 * np.pi, 24, endpoint=False)])
HARMONICS = np.column_stack([np.ones(len(AROUND)), AROUND, AROUND[:, 0] ** 2 - AROUND[:, 1] ** 2, AROUND[:, 0] * AROUND[:, 1]])
SMOOTH = HARMONICS @ np.linalg.pinv(HARMONICS)  # of a value per direction, its part that an ellipse about any centre near by has
INNERMOST, OUTERMOST, SAMPLES = 0.5, 1.5, 48  # of the radius: range in which the outline is searched
NEAR = 0.2  # of the radius: how far from the outline it is dark within, and white around
CUT_PX, CUT_FACTOR = 0.3, 4.0  # what an outline may leave its ellipse by, px, and times what the median circle's does
DISC_SHARES = (0.0, 0.5, 1.0)  # of the radius: where a position is tested for being empty
LEVEL_SHARE = 0.25  # of the contrast: what white may differ by from the white round the circles next to it
LEAST_CONTRAST = 0.35  # of the median circle's
LEAST_RUN = 4  # empty places in a row; a white sheet that is laid over the board cuts circles unless it lies along a row
NEXT = ((1, 1), (1, -1), (-1, 1), (-1, -1))  # steps to the nearest circles
# Where a board is tilted, a circle of the same row may be nearer than those of the next one, and be taken for one of the steps of the lattice.
# Circles are as round as they should be under the right steps only.
SHEARS = np.array([((1, 0), (0, 1)), ((1, 1), (0, 1)), ((1, -1), (0, 1)), ((1, 0), (1, 1)), ((1, 0), (-1, 1))])
OFF_SHARE = 0.15  # of the distance of circles: what lens distortion may leave of a homography
Placement = tuple[int, int, int]  # quarter turns, and what is added to x and y of a place, to make it one of the board


@dataclass(frozen=True, slots=True, eq=False)
class CircleGrid:
    """The whole circles of a grid, and the places beside them where there is nothing but white."""

    places: IntArray  # (N, 2), as of `DetectedCircles`
    centres_px: FloatArray  # (N, 2)
    empty: IntArray  # (M, 2)


def detect_grid(grey: ImageArray, board: CirclesDescription) -> CircleGrid | None:
    """Detect complete circles of ``board``'s size, and empty positions; None without a grid."""
    found = detect_circles(grey)
    if found is None:
        return None
    smooth = blur(grey)
    best, most = None, 0
    for seen in (replace(found, places=_shear(found.places, shear)) for shear in SHEARS):
        plane = _plane(seen, board)
        if plane is None:
            continue
        whole, levels = _whole(grey, seen, plane, board)
        if whole.sum() > most:
            empty = _empty(smooth, seen, whole, levels, plane, board)
            best, most = CircleGrid(seen.places[whole], seen.centres_px[whole], empty), int(whole.sum())
    return best


def possible_placements(board: CirclesDescription, grid: CircleGrid) -> list[Placement]:
    """Return every placement of the grid on the board: all circles on it, and none at an empty position."""
    found = []
    size = np.array([2 * board.columns, board.rows])
    for quarter in range(4):
        places, empty = rotate_places(grid.places, quarter), rotate_places(grid.empty, quarter)
        low, room = places.min(axis=0), size - 1 - np.ptp(places, axis=0)
        for x in range(int(room[0]) + 1):
            for y in range(int(room[1]) + 1):
                shift = np.array([x, y]) - low
                if shift.sum() % 2 == 0 and not np.any(np.all((empty + shift >= 0) & (empty + shift < size), axis=1)):
                    found.append((quarter, int(shift[0]), int(shift[1])))
    return found


def is_whole(grey: ImageArray, board: CirclesDescription) -> bool:
    """Whether the image shows all circles of ``board``, and white on all four sides of them."""
    grid = detect_grid(grey, board)
    if grid is None or len(grid.places) < board.count:
        return False
    size = (2 * board.columns, board.rows)
    ends = [rotate_places(grid.empty, quarter) + np.array([x, y]) for quarter, x, y in possible_placements(board, grid)]
    return any(bool(np.all(np.any(end < 0, axis=0) & np.any(end >= size, axis=0))) for end in ends)


def ids_of(board: CirclesDescription, places: IntArray, lie: Placement) -> IntArray:
    """Return which marks (N,) of the board the places (N, 2) are."""
    x, y = (rotate_places(places, lie[0]) + lie[1:]).T
    return np.asarray(y * board.columns + (x - y % 2) // 2, np.int64)


def rotate_places(places: IntArray, quarter: int) -> IntArray:
    """Return places (N, 2) turned by quarters."""
    x, y = places[:, 0], places[:, 1]
    for _ in range(quarter):
        x, y = -y, x
    return np.column_stack([x, y])


def _shear(places: IntArray, shear: IntArray) -> IntArray:
    """Return places (N, 2) as they are numbered by other steps to the nearest circles."""
    steps = places @ ((1, -1), (1, 1)) // 2
    return np.asarray(steps @ shear @ ((1, 1), (-1, 1)))


def _plane(seen: DetectedCircles, board: CirclesDescription) -> FloatArray | None:
    """The homography from places in mm to the image."""
    across = np.linalg.norm(seen.centres_px[1:] - seen.centres_px[0], axis=1).min()
    found = cv2.findHomography(seen.places * board.spacing_mm, seen.centres_px, cv2.RANSAC, OFF_SHARE * float(across))[0]
    return None if found is None or not np.all(np.isfinite(found)) else np.asarray(found, np.float64)


def _whole(
    grey: ImageArray, seen: DetectedCircles, plane: FloatArray, board: CirclesDescription
) -> tuple[BoolArray, tuple[FloatArray, FloatArray]]:
    """Which circles (N,) have the outline that a circle of this size has; grey levels within them and around them (N,).

    The outline is where lines from the middle outwards pass the mean of both levels. An ellipse about any centre near by is a constant and
    two harmonics of it; what is left of a circle that is cut, by the edge of the image or of what covers it, is more than of the others.
    """
    reach = min(OUTERMOST, board.neighbour_mm / board.diameter_mm)
    shares = np.linspace(INNERMOST, reach, SAMPLES)
    spokes = board.diameter_mm / 2 * AROUND @ local_axes(plane, seen.places * board.spacing_mm)  # (N, directions, 2)
    levels = _levels(grey, seen.centres_px[:, None, None] + shares[:, None] * spokes[:, :, None])
    dark, white = np.median(levels[..., 0], axis=1), np.median(levels[..., -1], axis=1)
    brighter = levels > ((dark + white) / 2)[:, None, None]
    within, around = shares <= max(1 - NEAR, INNERMOST), shares >= min(1 + NEAR, reach)
    there = np.isfinite(levels).all(axis=(1, 2)) & ~brighter[..., within].any(axis=(1, 2)) & brighter[..., around].all(axis=(1, 2))
    outline = shares[0] + (shares[1] - shares[0]) * _find_crossings(levels, brighter, (dark + white) / 2)
    left = np.abs(outline - outline @ SMOOTH) * np.linalg.norm(spokes, axis=2)
    rough = left.max(axis=1)
    contrast = white - dark
    if not there.any():
        return np.asarray(there), (dark, white)
    limit = max(CUT_PX, CUT_FACTOR * float(np.median(rough[there])))
    return np.asarray(there & (rough < limit) & (contrast > LEAST_CONTRAST * np.median(contrast[there]))), (dark, white)


def _find_crossings(levels: FloatArray, brighter: BoolArray, middle: FloatArray) -> FloatArray:
    """Where along each line (N, directions) the level first passes ``middle`` (N,), in samples; anything where it does not."""
    after = np.clip(np.argmax(brighter, axis=2), 1, levels.shape[2] - 1)[..., None]
    high, low = np.take_along_axis(levels, after, 2)[..., 0], np.take_along_axis(levels, after - 1, 2)[..., 0]
    rise = np.where(high > low, high - low, 1.0)
    return np.asarray(after[..., 0] - 1 + np.clip((middle[:, None] - low) / rise, 0.0, 1.0))


def _empty(
    smooth: ImageArray,
    seen: DetectedCircles,
    whole: BoolArray,
    levels: tuple[FloatArray, FloatArray],
    plane: FloatArray,
    board: CirclesDescription,
) -> IntArray:
    """The places (M, 2) next to whole circles that are white all over, in rows of some length."""
    taken = {(int(x), int(y)) for x, y in seen.places}
    beside: dict[tuple[int, int], int] = {}
    for number in np.flatnonzero(whole):
        x, y = (int(value) for value in seen.places[number])
        beside |= {(x + a, y + b): int(number) for a, b in NEXT if (x + a, y + b) not in taken}
    if not beside:
        return np.empty((0, 2), np.int64)
    places, next_to = np.array(list(beside)), np.array(list(beside.values()))
    disc = np.concatenate([share * board.diameter_mm / 2 * AROUND for share in DISC_SHARES])
    expected = apply_homography(plane, places * board.spacing_mm)
    off = seen.centres_px[next_to] - apply_homography(
        plane, seen.places[next_to] * board.spacing_mm
    )  # lens distortion, nearly equal for neighbours
    grey = _levels(smooth, (expected + off)[:, None] + disc @ local_axes(plane, places * board.spacing_mm))
    dark, white = levels[0][next_to], levels[1][next_to]
    blank = np.all(np.abs(grey - white[:, None]) < LEVEL_SHARE * (white - dark)[:, None], axis=1)
    return _in_rows(places[blank], min(LEAST_RUN, board.columns))


def _in_rows(places: IntArray, least: int) -> IntArray:
    """Those of the places (M, 2) that have enough others in line with them, each a whole distance of circles from the next."""
    there = {(int(x), int(y)) for x, y in places}
    return np.array([place for place in sorted(there) if any(_run(there, place, axis) >= least for axis in (0, 1))]).reshape(-1, 2)


def _run(there: set[tuple[int, int]], place: tuple[int, int], axis: int) -> int:
    length = 1
    for step in (2, -2):
        x, y = place
        while (x := x + step * (axis == 0), y := y + step * (axis == 1)) in there:
            length += 1
    return length


def _levels(grey: ImageArray, at: FloatArray) -> FloatArray:
    """Grey levels (...) at places (..., 2); not a number outside the image, which is neither dark nor white."""
    x, y = at.reshape(len(at), -1, 2).astype(np.float32).transpose(2, 0, 1)
    inside = (x >= 0) & (y >= 0) & (x <= grey.shape[1] - 1) & (y <= grey.shape[0] - 1)
    levels = np.where(inside, cv2.remap(grey, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE).astype(float), np.nan)
    return np.asarray(levels.reshape(at.shape[:-1]))
