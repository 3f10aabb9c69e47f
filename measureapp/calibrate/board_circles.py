"""The circles of a staggered grid, with the centres where the circles' centres are, not those of their images."""

from __future__ import annotations

import cv2
import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.calibrate.board_refine import homography, local_axes, mapped
from measureapp.calibrate.board_squares import full_size, shrunk
from measureapp.data.board import CirclesDescription

SEARCH_PX = 1300
BLOCK_SHARE = 0.12  # side of the neighbourhood that says what is dark, over the longer side
DARKER = 12  # grey levels
LEAST_AREA_PX = 20.0
LEAST_FILL = 0.2  # of its box: an ellipse three times as long as wide, lying across, fills 0.47
ROUNDNESS = 0.12  # how far the area may be from that of the ellipse with the same moments
LIKE_THE_MEDIAN = 4.0  # areas of the circles of one board differ by no more
NEXT_SHARE = 0.3  # how far off its place a circle may lie, over the distance of circles
RING_SHARE = 0.35  # half the width of the ring of pixels around the outline, over the radius; within the gap to the next circle
ROUNDS = 3  # of the correction: each shrinks what is left by the ratio of bias to spacing
Lattice = dict[tuple[int, int], int]  # place in the lattice of nearest neighbours -> blob


def find_circles(grey: ImageArray, board: CirclesDescription) -> tuple[FloatArray, float] | None:
    """Find the projected centres (N, 2) of all circles to sub-pixel and the smallest distance of neighbours, px; None without a grid.

    The centre of a circle's image is not the image of its centre [1]_: what separates them follows from the homography of the whole
    board and is taken off, until it no longer changes. What lens distortion adds within one circle is left: below a hundredth of
    the shift of the distortion over the circle's diameter.

    References
    ----------
    .. [1] J. Heikkilä, IEEE Trans. Pattern Analysis and Machine Intelligence 22(10), 1066-1077, 2000.
    """
    small, scale = shrunk(grey, SEARCH_PX)
    blobs = _blobs(small)
    order = _ordered(_lattice(blobs), board)
    if order is None:
        return None
    coarse = full_size(blobs[order], scale)
    ids = np.arange(board.count)
    matrix = homography(board, ids, coarse)
    seen = np.array([_centre(grey, place, ellipse) for place, ellipse in zip(coarse, _ellipses(matrix, board), strict=True)])
    centres = seen
    for _ in range(ROUNDS):
        matrix = homography(board, ids, centres)
        centres = seen - perspective_bias(matrix, board)
    axes = local_axes(matrix, board.flat_corners_mm[:, :2])
    diagonals = np.stack([axes[:, 0] + axes[:, 1], axes[:, 0] - axes[:, 1]], axis=1) * board.spacing_mm
    return centres, float(np.linalg.norm(diagonals, axis=2).min())


def perspective_bias(matrix: FloatArray, board: CirclesDescription) -> FloatArray:
    """Return centre of the image minus image of the centre (N, 2) of every circle under a homography."""
    centres = board.flat_corners_mm[:, :2]
    duals = _dual_conics(matrix, board)
    return duals[:, :2, 2] / duals[:, 2:, 2] - mapped(matrix, centres)


def circles_in_sight(grey: ImageArray) -> tuple[tuple[int, int], int] | None:
    """Look for any staggered grid: circles in a row and rows of the smallest grid that holds all, and how many there are."""
    blobs = _blobs(shrunk(grey, SEARCH_PX)[0])
    lattice = _lattice(blobs)
    if len(lattice) < 6:
        return None
    places = _turned(np.array(list(lattice)), 0)
    spans = np.ptp(places, axis=0)
    rows = int(spans.max()) + 1  # the usual way to name such a grid: more rows than circles in a row
    return ((int(spans.min()) + 1) // 2 or 1, rows), len(lattice)


def _blobs(small: ImageArray) -> FloatArray:
    """Centres (M, 2) of dark ellipses of like size."""
    block = max(3, int(BLOCK_SHARE * max(small.shape)) | 1)
    level = cv2.boxFilter(small, -1, (block, block))
    dark = (small.astype(np.int16) + DARKER < level).astype(np.uint8)
    count, labels, stats, centres = cv2.connectedComponentsWithStats(dark, connectivity=4)
    good = []
    sides = np.sort(stats[:, 2:4], axis=1)
    likely = (stats[:, 4] >= LEAST_AREA_PX) & (sides[:, 1] <= 6 * sides[:, 0]) & (sides[:, 1] <= max(small.shape) / 6)
    full = stats[:, 4] / (sides[:, 0] * sides[:, 1])  # π / 4 of the box of an upright ellipse, less of one that lies across it
    likely &= (full > LEAST_FILL) & (np.arange(count) > 0)
    for label in np.flatnonzero(likely):
        left, top, width, height, area = stats[label]
        moments = cv2.moments((labels[top : top + height, left : left + width] == label).astype(np.uint8), binaryImage=True)
        spread = moments["mu20"] * moments["mu02"] - moments["mu11"] ** 2
        if abs(4 * np.pi * np.sqrt(max(spread, 0.0)) / area**2 - 1) < ROUNDNESS:  # the area of that ellipse is 4π √det / area
            good.append((area, *centres[label]))
    found = np.array(good).reshape(-1, 3)
    ratio = found[:, 0] / np.median(found[:, 0]) if len(found) else np.empty(0)
    return found[(ratio < LIKE_THE_MEDIAN) & (ratio > 1 / LIKE_THE_MEDIAN), 1:]


def _lattice(blobs: FloatArray) -> Lattice:
    """Number the blobs by steps to nearest neighbours, from the middle outwards."""
    if len(blobs) < 4:
        return {}
    tree = cKDTree(blobs)
    seed = int(tree.query(np.median(blobs, axis=0))[1])
    _, near = tree.query(blobs[seed], k=min(9, len(blobs)))
    steps = blobs[near[1:]] - blobs[seed]
    first = steps[0]
    across = np.abs(steps @ first) < 0.6 * np.linalg.norm(steps, axis=1) * np.linalg.norm(first)
    if not across.any():
        return {}
    second = steps[across][0]
    if first[0] * second[1] - first[1] * second[0] < 0:
        second = -second
    lattice: Lattice = {(0, 0): seed}
    queue = [((0, 0), np.array([first, second]))]
    taken = {seed}
    while queue:
        place, basis = queue.pop(0)
        for axis in (0, 1):
            for sign in (1, -1):
                new = (place[0] + sign * (axis == 0), place[1] + sign * (axis == 1))
                if new in lattice:
                    continue
                off, blob = tree.query(blobs[lattice[place]] + sign * basis[axis])
                if off > NEXT_SHARE * np.linalg.norm(basis[axis]) or blob in taken:
                    continue
                lattice[new] = int(blob)
                taken.add(blob)
                own = basis.copy()
                own[axis] = (blobs[blob] - blobs[lattice[place]]) * sign
                queue.append((new, own))
    return lattice


def _turned(places: IntArray, quarter: int) -> IntArray:
    """Places (N, 2) in steps (x, y) of the board's half distances, for one of four ways the board may lie."""
    x, y = places[:, 0] - places[:, 1], places[:, 0] + places[:, 1]
    for _ in range(quarter):
        x, y = -y, x
    return np.column_stack([x, y])


def _ordered(lattice: Lattice, board: CirclesDescription) -> IntArray | None:
    """Return the blob of every circle of ``board``, where exactly such a grid is there."""
    if len(lattice) < board.count:
        return None
    wanted = np.round(board.flat_corners_mm[:, :2] / board.spacing_mm).astype(int)
    blob_of = np.array(list(lattice.values()))
    answers = []
    for quarter in range(4):
        places = _turned(np.array(list(lattice)), quarter)
        at = {(int(x), int(y)): int(blob) for (x, y), blob in zip(places, blob_of, strict=True)}
        answers += [
            np.array([at[x, y] for x, y in (wanted + start).tolist()])
            for start in places
            if all((x, y) in at for x, y in (wanted + start).tolist())
        ]
    expected = 2 if board.is_symmetric else 1
    return answers[0] if len(answers) == expected and len(lattice) == board.count else None


def _dual_conics(matrix: FloatArray, board: CirclesDescription) -> FloatArray:
    """The images of the circles as dual conics (N, 3, 3)."""
    radius = board.diameter_mm / 2.0
    x, y = board.flat_corners_mm[:, :2].T
    one = np.ones_like(x)
    duals = np.array([[x * x - radius**2, x * y, x], [x * y, y * y - radius**2, y], [x, y, one]]).transpose(2, 0, 1)
    return np.asarray(matrix @ duals @ matrix.T)


def _ellipses(matrix: FloatArray, board: CirclesDescription) -> FloatArray:
    """The shape (N, 2, 2) of each image about its centre: points at a distance of one from it are the outline."""
    duals = _dual_conics(matrix, board)
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
