"""A box that hides what is outside of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

LEAST_MM = 0.1  # edge of a box
FACES = ("−x", "+x", "−y", "+y", "−z", "+z")


@dataclass(frozen=True)
class ClipBox:
    """Limits along the axes of the scene; switched off, it keeps its numbers."""

    low_mm: tuple[float, float, float]
    high_mm: tuple[float, float, float]
    is_on: bool = True

    @classmethod
    def around(cls, points_mm: np.ndarray, is_on: bool = True) -> ClipBox:
        """Return the box that just contains points (N, 3)."""
        low, high = points_mm.min(axis=0), points_mm.max(axis=0)
        return cls(tuple(float(value) for value in low), tuple(float(value) for value in high), is_on)  # type: ignore[arg-type]

    @property
    def corners(self) -> np.ndarray:
        """The least and the greatest coordinates (2, 3)."""
        return np.array([self.low_mm, self.high_mm])

    def with_face(self, face: int, place_mm: float) -> ClipBox:
        """Move one face (in the order of `FACES`); it stops before the opposite one."""
        axis, upper = divmod(face, 2)
        limits = [list(self.low_mm), list(self.high_mm)]
        other = limits[1 - upper][axis]
        limits[upper][axis] = max(place_mm, other + LEAST_MM) if upper else min(place_mm, other - LEAST_MM)
        return replace(self, low_mm=tuple(limits[0]), high_mm=tuple(limits[1]))

    def face_middles(self) -> np.ndarray:
        """Return the middles of the faces (6, 3)."""
        middle, made = self.corners.mean(axis=0), np.repeat(self.corners.mean(axis=0)[None], 6, axis=0)
        assert middle.shape == (3,)
        for face in range(6):
            axis, upper = divmod(face, 2)
            made[face, axis] = self.corners[upper, axis]
        return made

    def normal(self, face: int) -> np.ndarray:
        """Return the outward normal (3,) of a face."""
        axis, upper = divmod(face, 2)
        return np.eye(3)[axis] * (1.0 if upper else -1.0)

    def edges(self) -> list[np.ndarray]:
        """Return the twelve edges, each (2, 3)."""
        corners = np.array([[self.corners[place >> axis & 1, axis] for axis in range(3)] for place in range(8)])
        pairs = [(one, one | 1 << axis) for axis in range(3) for one in range(8) if not one >> axis & 1]
        return [corners[list(pair)] for pair in pairs]
