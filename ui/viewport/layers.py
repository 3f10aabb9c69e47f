"""Contents of the 3-D view, independent of VTK."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class CloudLayer:
    """A point cloud with colours."""

    points_mm: np.ndarray  # (N, 3)
    colours: np.ndarray  # (N, 3) uint8
    normals: np.ndarray | None = None  # (N, 3), for shading
    to_read: bool = False  # the colours belong to a scale, so they are shaded only slightly


@dataclass(frozen=True, eq=False)
class SurfaceLayer:
    """A triangle mesh in one colour, or one per vertex."""

    vertices_mm: np.ndarray  # (V, 3)
    triangles: np.ndarray  # (T, 3)
    colours: np.ndarray | None = None  # (V, 3) uint8
    colour: tuple[int, int, int] = (190, 198, 203)
    opacity: float = 1.0
    normals: np.ndarray | None = None  # (V, 3); None: computed
    to_read: bool = False  # the colours belong to a scale, so they are shaded only slightly


@dataclass(frozen=True, eq=False)
class LineLayer:
    """Polylines in one colour: outlines of features."""

    lines: tuple[np.ndarray, ...]  # each (K, 3)
    colour: tuple[int, int, int]
    width: float = 2.5


@dataclass(frozen=True, eq=False)
class Label:
    """A text on a leader line."""

    text: str
    point_mm: np.ndarray  # (3,)
    colour: tuple[int, int, int] = (24, 33, 38)
    background: tuple[int, int, int] = (255, 255, 255)
    letters_px: float = 13.0
