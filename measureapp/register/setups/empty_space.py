"""Space that a view saw as empty: between its camera and the surface that it measured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform

CELL_PER_SPACING = 4.0
MOST_CELLS = 400  # per direction
MARGIN_MM = 2.0  # a point this far in front of the measured surface would have hidden it
MARGIN_CELLS = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class SeenSpace:
    """Depth of the nearest surface that one view measured, per direction; a point in front of it contradicts the view."""

    camera_from_part: RigidTransform
    low: FloatArray  # (2,), of the directions x/z, y/z
    cell: float
    nearest_mm: FloatArray  # (H, W), depth along z; -inf where the view states nothing
    margin_mm: float

    @classmethod
    def of(cls, cloud: PointCloud, part_from_camera: RigidTransform) -> Self:
        """Find the nearest depth in cells of the view's directions. At the border of what was measured nothing is stated."""
        points = np.asarray(cloud.points_mm)
        points = points[points[:, 2] > 0]
        directions = points[:, :2] / points[:, 2:]
        low, extent = directions.min(axis=0), np.ptp(directions, axis=0)
        cell = max(CELL_PER_SPACING * float(np.sqrt(extent.prod() / len(points))), float(extent.max()) / MOST_CELLS, 1e-6)
        column, row = np.floor((directions - low) / cell).astype(int).T
        nearest = np.full((row.max() + 3, column.max() + 3), np.inf)
        np.minimum.at(nearest, (row + 1, column + 1), points[:, 2])
        around = np.stack([np.roll(nearest, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)])
        stated = np.isfinite(around).all(axis=0)
        margin = max(MARGIN_MM, MARGIN_CELLS * cell * float(np.median(points[:, 2])))
        return cls(part_from_camera.inverse(), low - cell, cell, np.where(stated, around.min(axis=0), -np.inf), margin)

    def contradicts(self, points_mm: FloatArray) -> BoolArray:
        """Return which points (N, 3), in the part's frame, lie where the view saw through."""
        seen = self.camera_from_part.apply(points_mm)
        depth = np.maximum(seen[:, 2], 1e-9)
        column, row = np.floor((seen[:, :2] / depth[:, None] - self.low) / self.cell).astype(np.int64).T
        height, width = self.nearest_mm.shape
        inside = (seen[:, 2] > 0) & (row >= 0) & (row < height) & (column >= 0) & (column < width)
        nearest = np.full(len(points_mm), -np.inf)
        nearest[inside] = self.nearest_mm[row[inside], column[inside]]
        return np.asarray(seen[:, 2] < nearest - self.margin_mm)


def contradicted_share(seen: tuple[SeenSpace, ...], points_mm: FloatArray) -> float:
    """Return the share of points that contradict any of the views."""
    contradicted = np.zeros(len(points_mm), np.bool_)
    for view in seen:
        contradicted |= view.contradicts(points_mm)
    return float(contradicted.mean()) if len(points_mm) else 0.0
