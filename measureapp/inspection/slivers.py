"""Long, narrow triangles divided for searches in single precision.

The closest point of a triangle L long and h high is off by about (L/h)²·ε·L in single precision (ε = 6e-8): 0.08 mm on
facets of 120 mm × 1.5 mm, as CAD programs make them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray

SLENDER = 8.0  # longest edge over height; off by (L/h)²·ε·L = 5e-5 mm where the longest edge is 12 mm
MOST_PIECES = 4_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Pieces:
    """Triangles, or pieces of them."""

    parents: IntArray  # (M,), the triangle each is a piece of
    weights: FloatArray  # (M, 3, 3), barycentric coordinates of each piece's corners in its triangle

    def corners_mm(self, corners_mm: FloatArray) -> FloatArray:
        """Return the corners (M, 3, 3) of the pieces from those of the triangles (T, 3, 3)."""
        return np.asarray(np.matmul(self.weights, corners_mm[self.parents]))


def divided(corners_mm: FloatArray) -> Pieces:
    """Halve the longest edges of triangles (T, 3, 3) until none is slender."""
    made = Pieces(np.arange(len(corners_mm)), np.broadcast_to(np.eye(3), (len(corners_mm), 3, 3)))
    places = corners_mm
    while True:
        opposite = np.stack([places[:, (k + 2) % 3] - places[:, (k + 1) % 3] for k in range(3)], axis=1)  # the edge opposite each corner
        squares = np.einsum("mkd,mkd->mk", opposite, opposite)
        twice = np.einsum("md,md->m", opposite[:, 0], opposite[:, 1])
        area = np.sqrt(np.maximum(squares[:, 0] * squares[:, 1] - twice**2, 0.0))  # longest edge times height
        slender = np.flatnonzero(squares.max(axis=1) > SLENDER * area)
        if len(slender) == 0 or len(made.parents) + len(slender) > MOST_PIECES:
            return made
        made = _halved(made, slender, squares[slender].argmax(axis=1))
        places = made.corners_mm(corners_mm)


def _halved(made: Pieces, which: IntArray, corner: IntArray) -> Pieces:
    """Cut some pieces from a corner to the middle of the edge opposite."""
    weights = made.weights[which]
    rows = np.arange(len(which))
    tip, first, second = (weights[rows, (corner + turn) % 3] for turn in range(3))
    middle = (first + second) / 2
    new = np.concatenate([np.stack([tip, first, middle], axis=1), np.stack([tip, middle, second], axis=1)])
    kept = np.ones(len(made.parents), bool)
    kept[which] = False
    parents = np.concatenate([made.parents[kept], made.parents[which], made.parents[which]])
    return Pieces(parents, np.concatenate([made.weights[kept], new]))
