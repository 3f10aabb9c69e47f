"""The dark circles of an image as places of a square lattice, and where the lattice certainly has none."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.squares import full_size, shrink

SEARCH_PX = 1300
BLOCK_SHARE = 0.12  # side of the neighbourhood that says what is dark, over the longer side
DARKER = 12  # grey levels
LEAST_AREA_PX = 20.0
LEAST_FILL = 0.2  # of its box: an ellipse three times as long as wide, lying across, fills 0.47
ROUNDNESS = 0.12  # how far the area may be from that of the ellipse with the same moments
LIKE_THE_MEDIAN = 4.0  # areas of the circles of one board differ by no more
NEXT_SHARE = 0.3  # how far off its place a circle may lie, over the distance of circles
LEAST_CIRCLES = 6  # fewer are no grid
Lattice = dict[tuple[int, int], int]  # place in steps to nearest neighbours -> blob


@dataclass(frozen=True, slots=True, eq=False)
class DetectedCircles:
    """A staggered grid of unknown size; its x and y turn as those of the image do.

    Places count half the distances along rows and whole distances between rows from an arbitrary circle: x + y is even.
    """

    places: IntArray  # (N, 2) x, y
    centres_px: FloatArray  # (N, 2), full-size pixels, to a pixel or so

    @property
    def count(self) -> int:
        """How many circles were found."""
        return len(self.places)

    @property
    def size(self) -> tuple[int, int]:
        """Circles in a row, and rows, of the smallest grid that holds all; named as is usual, with more rows than circles in a row."""
        spans = np.ptp(self.places, axis=0)
        return (int(spans.min()) + 1) // 2 or 1, int(spans.max()) + 1


def detect_circles(grey: ImageArray) -> DetectedCircles | None:
    """Detect a staggered grid of dark circles of any size."""
    small, scale = shrink(grey, SEARCH_PX)
    blobs = _blobs(small)
    lattice = _lattice(blobs)
    if len(lattice) < LEAST_CIRCLES:
        return None
    steps = np.array(list(lattice))
    places = np.column_stack([steps[:, 0] - steps[:, 1], steps[:, 0] + steps[:, 1]])
    return DetectedCircles(places, full_size(blobs[np.array(list(lattice.values()))], scale))


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
