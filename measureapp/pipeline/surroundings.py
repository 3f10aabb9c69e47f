"""Table, fixtures and background in the clouds: what cameras see beside the part is excluded before views are laid onto each other.

What stands still while the table turns would pull the views apart, and what turns with it would be measured as if it were the part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.cell import Fixture
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.rig import RigDescription
from measureapp.data.surroundings import ABOVE_TABLE_MM, Surroundings
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.part_on_table import assumed_pose, table_level_mm

BEYOND_MM, BEYOND_SHARE = 50.0, 0.5  # room around the part as it should stand, of its size: it is put down by hand
LEVEL_MM = 15.0  # the table's top is sought so far above and below where the description has it
BESIDE_MM = 10.0  # from the circle around the part, outside of which nothing but table and fixtures is expected
BIN_MM, NEAR_LEVEL_MM = 0.5, 1.5  # of the heights among which the table's top is the most frequent
LEAST_TABLE_POINTS = 300
STEEPEST_COSINE = 0.996  # 5° between a normal of the table's top and the axis
WIDE_MM = 20.0  # standard deviation of the table's points along the narrow side, below which their plane is taken as level
AROUND_FIXTURE_MM = 0.5
FAR_MM, FAR_SHARE = 5.0, 0.02  # distance from the nominal, and share of its diagonal, beyond which a point is not of the part
SEEN_SHARE = 0.003  # of all points, above which the surroundings are in the picture: fewer are stray
ALIGNED_POINTS = 60_000
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True, eq=False)
class PartRoom:
    """Where points of the part may lie, in the frame `part`."""

    radius_mm: float  # about the axis of the table
    highest_mm: float
    beside_mm: float  # radius outside of which no point of the part is expected
    level_mm: float  # of the table's top by the description of the rig
    fixtures: tuple[Fixture, ...]  # that turn with the table

    @classmethod
    def of(cls, placed_mm: FloatArray, level_mm: float, rig: RigDescription) -> PartRoom:
        """Return the room of a part whose corners should lie at ``placed_mm`` (N, 3)."""
        size = float(np.ptp(placed_mm, axis=0).max())
        beyond = max(BEYOND_MM, BEYOND_SHARE * size)
        reach = float(np.hypot(placed_mm[:, 0], placed_mm[:, 1]).max())
        turning = tuple(fixture for fixture in rig.cell.fixtures if fixture.on_table)
        return cls(reach + beyond, float(placed_mm[:, 2].max()) + beyond, reach + BESIDE_MM, level_mm, turning)

    def is_background(self, points_mm: FloatArray) -> BoolArray:
        """Whether points (N, 3) lie outside of the room."""
        away = np.hypot(points_mm[:, 0], points_mm[:, 1])
        return np.asarray((away > self.radius_mm) | (points_mm[:, 2] > self.highest_mm) | (points_mm[:, 2] < self.level_mm - LEVEL_MM))

    def is_fixture(self, points_mm: FloatArray) -> BoolArray:
        """Whether points (N, 3) lie in a fixture of the description."""
        inside = np.zeros(len(points_mm), np.bool_)
        above = points_mm - [0.0, 0.0, self.level_mm]
        for fixture in self.fixtures:
            low, high = np.array(fixture.low_mm), np.array(fixture.high_mm)
            around = (np.abs(above - (low + high) / 2.0) <= (high - low) / 2.0 + AROUND_FIXTURE_MM).all(axis=1)
            if fixture.shape == "cylinder":
                radius = float(min(high[:2] - low[:2])) / 2.0 + AROUND_FIXTURE_MM
                around &= np.hypot(*(above[:, :2] - ((low + high) / 2.0)[:2]).T) <= radius
            inside |= around
        return inside

    def table_top(self, points_mm: FloatArray, normals: FloatArray) -> FloatArray | None:
        """Return the plane of the table's top, z = p[0] + p[1] x + p[2] y, from points beside the part; None where it was not seen."""
        beside = np.hypot(points_mm[:, 0], points_mm[:, 1]) > self.beside_mm
        level = (normals @ UP > STEEPEST_COSINE) & (np.abs(points_mm[:, 2] - self.level_mm) < LEVEL_MM)
        seen = points_mm[beside & level]
        if len(seen) < LEAST_TABLE_POINTS:
            return None
        counts, edges = np.histogram(seen[:, 2], np.arange(self.level_mm - LEVEL_MM, self.level_mm + LEVEL_MM + BIN_MM, BIN_MM))
        middle = float(edges[int(np.argmax(counts))]) + BIN_MM / 2.0
        seen = seen[np.abs(seen[:, 2] - middle) < NEAR_LEVEL_MM]
        if len(seen) < LEAST_TABLE_POINTS:
            return None
        height = float(np.median(seen[:, 2]))
        if np.sqrt(np.linalg.eigvalsh(np.cov(seen[:, :2].T))[0]) < WIDE_MM:
            return np.array([height, 0.0, 0.0])
        design = np.column_stack([np.ones(len(seen)), seen[:, :2]])
        return np.asarray(np.linalg.lstsq(design, seen[:, 2], rcond=None)[0])


def exclude_surroundings(
    views: Sequence[ViewResult], nominal: Mesh, pose: PartPose | None, calibration: RigCalibration, rig: RigDescription
) -> tuple[list[ViewResult], Surroundings]:
    """Return the views without points of table, fixtures and background, and what was excluded.

    Background is what lies outside of a generous room around the part as it should stand. The plane of the table's top is found where
    points beside the part show it. Only where the surroundings are in the picture, points far from the nominal are excluded too, after a
    best fit: on a part by itself they are deviations.

    Parameters
    ----------
    pose : of the part as planned; None: upright in the middle of the table
    """
    assumed = assumed_pose(nominal, pose, calibration, rig)
    placed = [view.part_from_camera.apply(view.cloud.points_mm) for view in views]
    room = PartRoom.of(assumed.apply(nominal.vertices_mm[np.unique(nominal.triangles)]), table_level_mm(calibration, rig), rig)
    kept = [np.ones(len(points), np.bool_) for points in placed]
    found = {"background": _remove(kept, [room.is_background(points) for points in placed])}
    normals = [view.part_from_camera.rotate(np.asarray(view.cloud.normals, float)) for view in views]
    top = room.table_top(*(np.vstack([part[own] for part, own in zip(parts, kept, strict=True)]) for parts in (placed, normals)))
    if top is not None:
        found["table"] = _remove(kept, [points @ [-top[1], -top[2], 1.0] - top[0] < ABOVE_TABLE_MM for points in placed])
    found["fixtures"] = _remove(kept, [room.is_fixture(points) for points in placed])
    points = sum(map(len, placed))
    if sum(found.values()) > SEEN_SHARE * points:
        found["far"] = _remove_far(kept, placed, normals, nominal)
    if not any(found.values()):
        return list(views), Surroundings()
    part = [view if own.all() else replace(view, cloud=view.cloud.where(own)) for view, own in zip(views, kept, strict=True)]
    return part, Surroundings(points, tuple(found.items()))


def _remove(kept: Sequence[BoolArray], foreign: Sequence[BoolArray]) -> int:
    """Take foreign points out of what is kept, and return how many were."""
    removed = 0
    for own, other in zip(kept, foreign, strict=True):
        removed += int(np.count_nonzero(own & other))
        np.logical_and(own, ~other, out=own)
    return removed


def _remove_far(kept: Sequence[BoolArray], placed: Sequence[FloatArray], normals: Sequence[FloatArray], nominal: Mesh) -> int:
    """Take points far from the nominal out of what is kept; none where the nominal does not fit."""
    surface = NominalSurface(nominal)
    points, directions = (np.vstack([part[own] for part, own in zip(parts, kept, strict=True)]) for parts in (placed, normals))
    try:
        fitted = best_fit(MeasuredPoints(points, directions).thin(ALIGNED_POINTS), surface)
    except InspectionError:
        return 0  # said by the inspection, in its words
    limit = max(FAR_MM, FAR_SHARE * surface.diagonal_mm)
    far = []
    for part, own in zip(placed, kept, strict=True):
        foreign = np.zeros(len(part), np.bool_)
        foreign[own] = np.abs(signed_distances(fitted.nominal_from_part.apply(part[own]), surface)) > limit
        far.append(foreign)
    return _remove(kept, far)
