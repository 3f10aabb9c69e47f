"""Boxes around triangles, or around slices of those that are long for their height.

CAD programs divide curved faces into needles (120 mm × 0.1 mm); a box around the whole of one that lies askew contains hundreds of others,
and a search would visit all of them. Slices share the needle but have small boxes (spatial splits, M. Stich et al., Spatial splits in
bounding volume hierarchies, HPG 2009).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray

SLENDER = 8.0  # length of a slice in heights of its triangle
MOST_SLICES = 64  # per triangle
MOST_PER_TRIANGLE = 3  # slices on average: more of them take longer to build than they save


@dataclass(frozen=True, slots=True, eq=False)
class References:
    """Axis-aligned boxes of which each contains a slice of a triangle; the slices of a triangle cover it."""

    triangles: IntArray  # (M,), triangle of each box
    low_mm: FloatArray  # (M, 3)
    high_mm: FloatArray  # (M, 3)


def box_references(corners_mm: FloatArray) -> References:
    """Enclose triangles (T, 3, 3), in slices across the longest edge where this is many times the height."""
    ordered, lengths, heights = _longest_edge_first(corners_mm)
    counts = _slice_counts(lengths, heights)
    triangles = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(triangles)) - np.repeat(np.cumsum(counts) - counts, counts)
    low, high = _boxes_of_slices(ordered[triangles], number / counts[triangles], (number + 1) / counts[triangles])
    return References(triangles, low, high)


def _longest_edge_first(corners_mm: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the corners as start and end of the longest edge and the corner opposite; the length and the height above it."""
    edges = np.linalg.norm(np.roll(corners_mm, -1, axis=1) - corners_mm, axis=2)
    first = edges.argmax(axis=1)
    ordered = corners_mm[np.arange(len(corners_mm))[:, None], (first[:, None] + np.arange(3)) % 3]
    lengths = edges.max(axis=1)
    areas = np.linalg.norm(np.cross(ordered[:, 1] - ordered[:, 0], ordered[:, 2] - ordered[:, 0]), axis=1)
    return ordered, lengths, areas / lengths


def _slice_counts(lengths: FloatArray, heights: FloatArray) -> IntArray:
    """Return the number of slices of each triangle: so many that they are stout, as far as there may be so many."""
    wanted = np.minimum(lengths / (SLENDER * heights), MOST_SLICES)
    shortest = lengths.sum() / (MOST_PER_TRIANGLE * len(lengths))
    return np.maximum(np.ceil(np.minimum(wanted, lengths / shortest)), 1).astype(np.int64)


def _boxes_of_slices(ordered: FloatArray, start: FloatArray, end: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the boxes of slices of triangles from a share ``start`` (M,) to a share ``end`` (M,) of the longest edge."""
    first, last, apex = np.moveaxis(ordered, 1, 0)
    along = last - first
    foot = np.clip(np.einsum("md,md->m", apex - first, along) / np.einsum("md,md->m", along, along), 0.0, 1.0)
    outline = [first + start[:, None] * along, first + end[:, None] * along]
    for share in (start, end, np.clip(foot, start, end)):
        rising = (share / np.maximum(foot, 1e-300))[:, None]
        falling = ((1 - share) / np.maximum(1 - foot, 1e-300))[:, None]
        outline.append(np.where((share <= foot)[:, None], first + rising * (apex - first), last + falling * (apex - last)))
    low, high = np.minimum.reduce(outline), np.maximum.reduce(outline)
    margin = 1e-9 * np.maximum(np.abs(low), np.abs(high)).max() if len(low) else 0.0  # rounding of the cuts
    return low - margin, high + margin
