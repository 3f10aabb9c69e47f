"""Corners of squares as saddle points of the image, and the grid they form.

Where two dark and two bright squares meet, the grey level has a saddle: the determinant of its second derivatives is negative (the
response of J.-Y. Bouguet's toolbox and of S. Bennett, J. Lasenby, Computer Vision and Image Understanding 118, 2014). Along a circle
about it the level rises and falls twice, and the second harmonic of it tells both edges and which pair of squares is dark; this pair
alternates from one corner of a board to the next. So a grid grows from one corner to its neighbours, each looked for where the steps
behind it lead, and all squares of a board are found in one pass, whatever its size, also where a part of it is hidden.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray

SMOOTHING_PX = 1.2
APART_PX = 5  # side of the window in which one saddle is the strongest
LEAST_RESPONSE = 0.004  # of the strong ones': a board may be lit unevenly, and its response goes with the square of the contrast
STRONG_PERCENT = 98
MOST_SADDLES = 3000
RING_PX, RING_POINTS = 4.0, 32
LEAST_EVEN = 0.75  # share of the variance along the circle that is the same half a turn further
LEAST_SECOND = 0.35  # share that is its second harmonic: 0.81 for perpendicular edges, 0.4 where perspective leaves 30° between them
LEAST_SWING = 6.0  # grey levels
ALONG_EDGE = 0.35  # a neighbour may lie off an edge's direction by this share of its distance
STEP_REACH = 0.3  # and off the place where the steps behind it lead
ALTERNATES = -0.6  # cosine of the angle between the second harmonics of neighbours
LEAST_SINE = 0.3  # of the angle between a board's edges in the image
MOST_SEEDS = 200
NEAR = 12  # saddles about a seed among which its neighbours are
SIDES = np.array([(0, 1), (1, 0), (0, -1), (-1, 0)])


@dataclass(frozen=True, slots=True, eq=False)
class Saddles:
    """Saddle points of an image that look like corners of squares."""

    points_px: FloatArray  # (N, 2), the strongest first
    seconds: FloatArray  # (N, 2) unit vectors: the second harmonic of the level along a circle


def find_saddles(picture: ImageArray) -> Saddles:
    """Find the saddle points of an image to half a pixel."""
    smooth = cv2.GaussianBlur(picture.astype(np.float32), (0, 0), SMOOTHING_PX)
    xx, yy, xy = (cv2.Sobel(smooth, cv2.CV_32F, *order, ksize=3) for order in ((2, 0), (0, 2), (1, 1)))
    response = xy * xy - xx * yy
    strongest = cv2.dilate(response, np.ones((APART_PX, APART_PX), np.uint8))
    margin = int(np.ceil(RING_PX)) + 1
    peaks = response >= strongest
    peaks[:margin] = peaks[-margin:] = False
    peaks[:, :margin] = peaks[:, -margin:] = False
    peaks &= response > 1.0
    rows, columns = np.nonzero(peaks)
    if not len(rows):
        return Saddles(np.empty((0, 2)), np.empty((0, 2)))
    values = response[rows, columns]
    order = np.argsort(-values)[:MOST_SADDLES]
    rows, columns, values = rows[order], columns[order], values[order]
    angle = 2 * np.pi * np.arange(RING_POINTS) / RING_POINTS
    ring = RING_PX * np.column_stack([np.cos(angle), np.sin(angle)])
    at = (np.column_stack([columns, rows])[:, None] + ring).astype(np.float32)
    level = cv2.remap(smooth, at[..., 0], at[..., 1], cv2.INTER_LINEAR).astype(float)
    level -= level.mean(axis=1, keepdims=True)
    total = np.maximum((level**2).sum(axis=1), 1e-9)
    even = (level + np.roll(level, RING_POINTS // 2, axis=1)) / 2
    second = level @ np.column_stack([np.cos(2 * angle), np.sin(2 * angle)])
    share = 2 * (second**2).sum(axis=1) / RING_POINTS / total
    good = ((even**2).sum(axis=1) > LEAST_EVEN * total) & (share > LEAST_SECOND) & (np.sqrt(total / RING_POINTS) > LEAST_SWING)
    rows, columns, values, second = rows[good], columns[good], values[good], second[good]
    if len(values):
        strong = values >= LEAST_RESPONSE * np.percentile(values, STRONG_PERCENT)
        rows, columns, second = rows[strong], columns[strong], second[strong]
    return Saddles(
        np.column_stack([columns, rows]).astype(float) + _peak_offsets(response, rows, columns),
        second / np.linalg.norm(second, axis=1, keepdims=True),
    )


def _peak_offsets(response: FloatArray, rows: IntArray, columns: IntArray) -> FloatArray:
    here = response[rows, columns]
    found = []
    for before, behind in (
        (response[rows, columns - 1], response[rows, columns + 1]),
        (response[rows - 1, columns], response[rows + 1, columns]),
    ):
        bend = np.maximum(2 * here - before - behind, 1e-9)
        found.append(np.clip((behind - before) / (2 * bend), -0.5, 0.5))
    return np.column_stack(found)


def grow_grid(saddles: Saddles) -> tuple[FloatArray, BoolArray] | None:
    """Return the largest grid among saddles: corners (R, C, 2), NaN where one is missing, and which are there; None without 3 × 3."""
    points, free = saddles.points_px, np.ones(len(saddles.points_px), bool)
    best: dict[tuple[int, int], int] = {}
    for seed in range(min(MOST_SEEDS, len(points))):
        if not free[seed]:
            continue
        grid = _grow(saddles, seed)
        if len(grid) > len(best):
            best = grid
        free[list(grid.values())] = False
        if len(best) > np.count_nonzero(free):
            break
    if len(best) < 9:
        return None
    places = np.array(list(best))
    places -= places.min(axis=0)
    corners = np.full((*(places.max(axis=0) + 1), 2), np.nan)
    corners[places[:, 0], places[:, 1]] = points[list(best.values())]
    return corners, ~np.isnan(corners[..., 0])


def _grow(saddles: Saddles, seed: int) -> dict[tuple[int, int], int]:
    """Grow a grid from one corner: (row, column) -> saddle."""
    points, seconds = saddles.points_px, saddles.seconds
    first = _steps_at(saddles, seed)
    if first is None:
        return {}
    grid = {(0, 0): seed}
    used = np.zeros(len(points), bool)
    used[seed] = True
    steps: dict[tuple[int, int], FloatArray] = {(0, 0): first}  # (2, 2): along rows and columns
    waiting = [(0, 0)]
    for place in waiting:
        here = grid[place]
        along = steps[place]
        for down, right in SIDES:
            target = (place[0] + int(down), place[1] + int(right))
            if target in grid:
                continue
            step = down * along[0] + right * along[1]
            behind = grid.get((place[0] - int(down), place[1] - int(right)))
            guess = points[here] + step
            off = points - guess
            far = off[:, 0] ** 2 + off[:, 1] ** 2
            nearest = int(np.argmin(far))
            length = float(np.hypot(*step))
            if used[nearest] or far[nearest] > (STEP_REACH * length) ** 2:
                continue
            if seconds[nearest] @ seconds[here] > ALTERNATES:
                continue
            grid[target] = nearest
            used[nearest] = True
            new = along.copy()
            seen = points[nearest] - points[here]
            onwards = seen if behind is None else 2 * seen - (points[here] - points[behind])  # steps change steadily under perspective
            axis = 0 if down else 1
            new[axis] = (onwards + seen) / 2 * (down or right)
            steps[target] = new
            waiting.append(target)
    return grid


def _steps_at(saddles: Saddles, seed: int) -> FloatArray | None:
    """Return the steps (2, 2) to the neighbours of a corner, down and right; None where it has no four that lie as on a grid."""
    points, seconds = saddles.points_px, saddles.seconds
    off = points - points[seed]
    distance = np.hypot(*off.T)
    near = np.argsort(distance)[1 : NEAR + 1]
    near = near[seconds[near] @ seconds[seed] < ALTERNATES]
    pairs = []
    for one in near:  # a neighbour has another one opposite
        opposite = np.hypot(*(off[near] + off[one]).T)
        if opposite.min() < STEP_REACH * distance[one]:
            pairs.append((off[one] - off[near[int(np.argmin(opposite))]]) / 2)
    for down in pairs[1:]:
        right = pairs[0]
        sine = (right[0] * down[1] - right[1] * down[0]) / (np.hypot(*right) * np.hypot(*down))
        if abs(sine) > LEAST_SINE:
            steps = np.array([down if sine > 0 else -down, right])
            return steps if _are_nearest(steps, off[near]) else None
    return None


def _are_nearest(steps: FloatArray, off: FloatArray) -> bool:
    """Whether no neighbour (N, 2) is nearer than the longer step but those at the steps: else that step passes one by, like a knight in chess."""
    length = float(np.hypot(*steps.T).max())
    at = np.concatenate([steps, -steps])
    away = np.hypot(*np.moveaxis(off[:, None] - at, -1, 0)).min(axis=1, initial=np.inf)
    return bool(np.all((np.hypot(*off.T) > (1 - STEP_REACH) * length) | (away < STEP_REACH * length)))
