"""Statement of the closest point in NumPy: every triangle for every point."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray


def closest_on_triangles(points_mm: FloatArray, shapes: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the closest triangle (N,) to each point (N, 3) and the barycentric coordinates (N, 3) of the closest point in it.

    The closest point of a triangle is the foot of the perpendicular on its plane, if this lies inside, else the closest one on its edges.

    Parameters
    ----------
    shapes : (T, 3, 3) first corner of each triangle and the edges from it to the others
    """
    least, found, weights = np.full(len(points_mm), np.inf), np.zeros(len(points_mm), np.int64), np.zeros((len(points_mm), 3))
    for number, (corner, one, other) in enumerate(shapes):
        inside = np.linalg.lstsq(np.column_stack([one, other]), (points_mm - corner).T, rcond=None)[0]
        candidates = [np.column_stack([1 - inside.sum(axis=0), *inside])]
        for start, end in ((0, 1), (1, 2), (2, 0)):
            ends = np.eye(3)[[start, end]]
            from_mm, to_mm = ends @ np.array([corner, corner + one, corner + other])
            share = np.clip((points_mm - from_mm) @ (to_mm - from_mm) / np.sum((to_mm - from_mm) ** 2), 0, 1)[:, None]
            candidates.append((1 - share) * ends[0] + share * ends[1])
        for bary in candidates:
            away = np.linalg.norm(corner + bary[:, 1:] @ np.array([one, other]) - points_mm, axis=1)
            nearer = (away < least) & (bary.min(axis=1) >= 0)
            least[nearer], found[nearer], weights[nearer] = away[nearer], number, bary[nearer]
    return found, weights
