"""Subdivision of sliver triangles for closest-point queries in single precision.

The error of the closest point on a triangle of length L and height h is about (L/h)²·ε·L in single precision (ε = 6e-8): 0.08 mm on
facets of 120 mm × 1.5 mm, as CAD programs generate them. Halving the longest edges would not terminate: at the tip of a needle each half
is as slender as the whole. Transverse cuts, at distances that the local width allows, are few.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray

SLENDER = 8.0  # L/h below which a subdivision gains nothing in single precision
LARGEST = 768.0  # mm, (L/h)²·L of a piece: error of 5e-5 mm
MOST_CUTS = 4000  # per needle; the remaining tip is narrower than the resolution of points


@dataclass(frozen=True, slots=True, eq=False)
class Pieces:
    """Triangles, or pieces of them."""

    parents: IntArray  # (M,), triangle of each piece
    weights: FloatArray  # (M, 3, 3), barycentric coordinates of each piece's corners in its triangle

    def corners_mm(self, corners_mm: FloatArray) -> FloatArray:
        """Return the corners (M, 3, 3) of the pieces from those of the triangles (T, 3, 3)."""
        return np.asarray(np.matmul(self.weights, corners_mm[self.parents]))


def split_slivers(corners_mm: FloatArray) -> Pieces:
    """Subdivide triangles (T, 3, 3) until the closest points of their pieces are accurate to 5e-5 mm."""
    whole = Pieces(np.arange(len(corners_mm)), np.broadcast_to(np.eye(3), (len(corners_mm), 3, 3)))
    slender = _is_slender(corners_mm)
    if not slender.any():
        return whole
    needles = _orient_needles(Pieces(whole.parents[slender], whole.weights[slender]), corners_mm)
    still = _is_slender(needles.corners_mm(corners_mm))
    parts = (
        Pieces(whole.parents[~slender], whole.weights[~slender]),
        Pieces(needles.parents[~still], needles.weights[~still]),
        _cut_across(Pieces(needles.parents[still], needles.weights[still]), corners_mm),
    )
    return _concatenate(parts)


def _is_slender(corners_mm: FloatArray) -> BoolArray:
    """Return which triangles are too long for their height; degenerate ones cannot be improved."""
    longest, height = _size(corners_mm)
    return np.asarray((longest > SLENDER * height) & (longest**3 > LARGEST * height**2) & (height > 0))


def _size(corners_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the longest edge (T,) and the height above it (T,)."""
    edges = np.roll(corners_mm, -1, axis=1) - corners_mm
    longest = np.linalg.norm(edges, axis=2).max(axis=1)
    twice_area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    return longest, np.divide(twice_area, longest, out=np.zeros(len(longest)), where=longest > 0)


def _orient_needles(triangles: Pieces, corners_mm: FloatArray) -> Pieces:
    """Order the corners of triangles with the tip of the needle first; split those with two tips at the foot of their height."""
    places = triangles.corners_mm(corners_mm)
    rows = np.arange(len(places))
    apex = (np.linalg.norm(np.roll(places, -1, axis=1) - places, axis=2).argmax(axis=1) + 2) % 3
    weights = triangles.weights[rows[:, None], (apex[:, None] + np.arange(3)) % 3]  # apex, then the ends of the longest edge
    top, start, end = np.moveaxis(np.matmul(weights, corners_mm[triangles.parents]), 1, 0)
    along = end - start
    foot = np.einsum("td,td->t", top - start, along) / np.einsum("td,td->t", along, along)
    _, height = _size(places)
    margin = height / np.linalg.norm(along, axis=1)
    two = (foot > margin) & (foot < 1 - margin)  # otherwise the end next to the foot is the needle's base
    middle = weights[:, 1] + foot[:, None] * (weights[:, 2] - weights[:, 1])
    from_start = np.stack([weights[:, 1], np.where(two[:, None], middle, weights[:, 2]), weights[:, 0]], axis=1)
    from_end = np.stack([weights[:, 2], weights[:, 0], np.where(two[:, None], middle, weights[:, 1])], axis=1)
    one = ~two
    return _concatenate(
        (
            Pieces(triangles.parents[two], from_start[two]),
            Pieces(triangles.parents[two], from_end[two]),
            Pieces(triangles.parents[one], np.where((foot > 0.5)[:, None, None], from_start, from_end)[one]),
        )
    )


def _cut_across(needles: Pieces, corners_mm: FloatArray) -> Pieces:
    """Cut needles (tip first) transversely from the base, at distances that the local width allows, until the tip is short enough.

    A piece of length ℓ at width w is accurate if ℓ³ ≤ LARGEST · w²; both decrease towards the tip.
    """
    length, width = _size(needles.corners_mm(corners_mm))
    left = np.ones(len(length))  # share of the length between the tip and the last cut
    parts: list[Pieces] = []
    for _ in range(MOST_CUTS):
        going = np.flatnonzero(left**3 * length**3 > LARGEST * (width * left) ** 2)
        if len(going) == 0:
            break
        here = width[going] * left[going]
        step = np.maximum(np.cbrt(LARGEST * here**2) / 2, here) / length[going]  # half, as a piece is narrower at its other end
        after = np.maximum(left[going] - step, 0.5 * left[going])
        parts += _slices(Pieces(needles.parents[going], needles.weights[going]), left[going], after)
        left[going] = after
    tips = needles.weights.copy()
    tips[:, 1:] = _toward_base(needles.weights, left)
    return _concatenate((*parts, Pieces(needles.parents, tips)))


def _toward_base(weights: FloatArray, share: FloatArray) -> FloatArray:
    """Return the two points (N, 2, 3) at a share of the distance from a needle's tip to the corners of its base."""
    return np.asarray(weights[:, :1] + share[:, None, None] * (weights[:, 1:] - weights[:, :1]))


def _slices(needles: Pieces, before: FloatArray, after: FloatArray) -> tuple[Pieces, Pieces]:
    """Return the two triangles between two cuts of each needle."""
    far, near = _toward_base(needles.weights, before), _toward_base(needles.weights, after)
    return (
        Pieces(needles.parents, np.stack([near[:, 0], far[:, 0], far[:, 1]], axis=1)),
        Pieces(needles.parents, np.stack([near[:, 0], far[:, 1], near[:, 1]], axis=1)),
    )


def _concatenate(parts: tuple[Pieces, ...]) -> Pieces:
    return Pieces(np.concatenate([part.parents for part in parts]), np.concatenate([part.weights for part in parts]))
