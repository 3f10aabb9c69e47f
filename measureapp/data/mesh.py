"""Triangle meshes: measured surfaces and nominals."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.geometry.transform import RigidTransform


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """Triangles in one frame, corners counter-clockwise seen from outside."""

    vertices_mm: FloatArray  # (V, 3) float64
    triangles: IntArray  # (T, 3) int32
    frame: str
    measured: BoolArray | None = None  # (V,), False where a hole was filled without points; None: all measured

    def __post_init__(self) -> None:
        object.__setattr__(self, "vertices_mm", read_only(self.vertices_mm, np.float64, (None, 3)))
        object.__setattr__(self, "triangles", read_only(self.triangles, np.int32, (None, 3)))
        if self.measured is not None:
            object.__setattr__(self, "measured", read_only(self.measured, np.bool_, (len(self.vertices_mm),)))

    def seen_from(self, transform: RigidTransform) -> Mesh:
        """Return the same surface in ``transform.to_frame``."""
        return replace(self, vertices_mm=transform.apply(self.vertices_mm), frame=transform.to_frame)
