"""Where a ray meets the part."""

from __future__ import annotations

import numpy as np

PARALLEL = 1e-12
SLACK = 1e-9  # so that a ray along an edge of two triangles meets one of them


def first_hit(
    corners_mm: np.ndarray, guide_from_part: np.ndarray, origin: np.ndarray, direction: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return point and normal (3,) in the part's frame where a ray first meets its triangles; None if it misses.

    After Möller and Trumbore, Journal of Graphics Tools 2(1), 1997.

    Parameters
    ----------
    corners_mm : (T, 3, 3), in the part's frame
    guide_from_part : (4, 4)
    origin, direction : (3,), in the guide frame
    """
    turn = guide_from_part[:3, :3]
    start, along = turn.T @ (np.asarray(origin, float) - guide_from_part[:3, 3]), turn.T @ np.asarray(direction, float)
    corner = corners_mm[:, 0].astype(float)
    one, other = corners_mm[:, 1] - corner, corners_mm[:, 2] - corner
    across = np.cross(along, other)
    determinant = np.einsum("ni,ni->n", one, across)
    usable = np.abs(determinant) > PARALLEL
    inverse = np.divide(1.0, determinant, out=np.zeros_like(determinant), where=usable)
    gap = start - corner
    u = np.einsum("ni,ni->n", gap, across) * inverse
    crossed = np.cross(gap, one)
    v = crossed @ along * inverse
    distance = np.einsum("ni,ni->n", other, crossed) * inverse
    hit = usable & (u >= -SLACK) & (v >= -SLACK) & (u + v <= 1.0 + SLACK) & (distance > 0.0)
    if not hit.any():
        return None
    nearest = int(np.argmin(np.where(hit, distance, np.inf)))
    normal = np.cross(one[nearest], other[nearest])
    normal /= np.linalg.norm(normal)
    return start + distance[nearest] * along, normal if normal @ along < 0.0 else -normal
