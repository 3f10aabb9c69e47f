"""Table, fixtures and background in the clouds: what cameras see beside the part is excluded before views are laid onto each other.

What stands still while the table turns would pull the views apart, and what turns with it would be measured as if it were the part.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.cell import Fixture
from measureapp.data.measurement import ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.rig import RigDescription
from measureapp.data.surroundings import ABOVE_TABLE_MM, Surroundings
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.measured_points import MeasuredPoints, thin_candidates
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.part_on_table import assumed_pose, table_level_mm

BEYOND_MM, BEYOND_SHARE = 50.0, 0.5  # room around the part as it should stand, of its size: it is put down by hand
LEVEL_MM = 15.0  # the table's top is sought so far above and below where the description has it; at any height where it has none
BESIDE_MM = 10.0  # from the circle around the part, outside of which nothing but table and fixtures is expected
BIN_MM, NEAR_LEVEL_MM = 0.5, 1.5  # of the heights among which the table's top is the most frequent
LEAST_TABLE_POINTS = 300
BELOW_SHARE = 0.02  # of the points, that may lie below the table's top: it hides what is there. A flange that juts out does not
LEAST_PART_POINTS = 100  # of all views: where fewer are left, the part is not where it is assumed
STEEPEST_COSINE = 0.996  # 5° between a normal of the table's top and the axis
WIDE_MM = 20.0  # standard deviation of the table's points along the narrow side, below which their plane is taken as level
AROUND_FIXTURE_MM = 0.5
FAR_MM, FAR_SHARE = 5.0, 0.02  # distance from the nominal, and share of its diagonal, beyond which a point is not of the part
SEEN_SHARE = 0.003  # of all points, above which the surroundings are in the picture: fewer are stray
ALIGNED_POINTS = 60_000
UP = np.array([0.0, 0.0, 1.0])
ALL = slice(None)


@dataclass(frozen=True, slots=True, eq=False)
class PlacedView:
    """A view where the axes place it. Its points are placed whenever they are asked for: those of all views would take twice their memory."""

    view: ViewResult
    kept: BoolArray  # (N,), what was not taken out yet

    @classmethod
    def of(cls, view: ViewResult) -> PlacedView:
        """Return a view of which everything is kept."""
        return cls(view, np.ones(len(view.cloud), np.bool_))

    def points_mm(self, rows: IntArray | slice = ALL) -> FloatArray:
        """Return the points (M, 3) of some rows, in the frame `part`."""
        return self.view.part_from_camera.apply(self.view.cloud.points_mm[rows])

    def normals(self, rows: IntArray | slice = ALL) -> FloatArray:
        """Return the normals (M, 3) of some rows, in the frame `part`."""
        return self.view.part_from_camera.rotate(np.asarray(self.view.cloud.normals[rows], float))

    def remove(self, foreign: BoolArray) -> int:
        """Take foreign points (N,) out of what is kept, and return how many were."""
        removed = int(np.count_nonzero(self.kept & foreign))
        np.logical_and(self.kept, ~foreign, out=self.kept)
        return removed

    def result(self) -> ViewResult:
        """Return the view with the points that are kept."""
        return self.view if self.kept.all() else replace(self.view, cloud=self.view.cloud.where(self.kept))


@dataclass(frozen=True, slots=True, eq=False)
class PartRoom:
    """Where points of the part may lie, in the frame `part`."""

    radius_mm: float  # about the axis of the table
    highest_mm: float
    beside_mm: float  # radius outside of which no point of the part is expected
    level_mm: float | None  # of the table's top by the description of the rig; None: anywhere
    fixtures: tuple[Fixture, ...]  # that turn with the table

    @classmethod
    def of(cls, placed_mm: FloatArray, level_mm: float | None, rig: RigDescription) -> PartRoom:
        """Return the room of a part whose corners should lie at ``placed_mm`` (N, 3); of any height where the table's level is unknown."""
        size = float(np.ptp(placed_mm, axis=0).max())
        beyond = max(BEYOND_MM, BEYOND_SHARE * size)
        reach = float(np.hypot(placed_mm[:, 0], placed_mm[:, 1]).max())
        turning = tuple(fixture for fixture in rig.cell.fixtures if fixture.on_table)
        return cls(reach + beyond, float(placed_mm[:, 2].max()) + beyond, reach + BESIDE_MM, level_mm, turning)

    def is_background(self, points_mm: FloatArray) -> BoolArray:
        """Whether points (N, 3) lie outside of the room."""
        outside = np.hypot(points_mm[:, 0], points_mm[:, 1]) > self.radius_mm
        if self.level_mm is not None:
            outside |= (points_mm[:, 2] > self.highest_mm) | (points_mm[:, 2] < self.level_mm - LEVEL_MM)
        return np.asarray(outside)

    def is_fixture(self, points_mm: FloatArray) -> BoolArray:
        """Whether points (N, 3) lie in a fixture of the description."""
        inside = np.zeros(len(points_mm), np.bool_)
        if self.level_mm is None:
            return inside
        above = points_mm - [0.0, 0.0, self.level_mm]
        for fixture in self.fixtures:
            low, high = np.array(fixture.low_mm), np.array(fixture.high_mm)
            around = (np.abs(above - (low + high) / 2.0) <= (high - low) / 2.0 + AROUND_FIXTURE_MM).all(axis=1)
            if fixture.shape == "cylinder":
                radius = float(min(high[:2] - low[:2])) / 2.0 + AROUND_FIXTURE_MM
                around &= np.hypot(*(above[:, :2] - ((low + high) / 2.0)[:2]).T) <= radius
            inside |= around
        return inside

    def table_top(self, seen: FloatArray) -> FloatArray | None:
        """Return the plane of the table's top, z = p[0] + p[1] x + p[2] y, from the `level_points` (N, 3) of all views; None where it was not seen."""
        if len(seen) < LEAST_TABLE_POINTS:
            return None
        counts, edges = np.histogram(seen[:, 2], np.arange(float(seen[:, 2].min()), float(seen[:, 2].max()) + BIN_MM, BIN_MM))
        middle = float(edges[int(np.argmax(counts))]) + BIN_MM / 2.0
        seen = seen[np.abs(seen[:, 2] - middle) < NEAR_LEVEL_MM]
        if len(seen) < LEAST_TABLE_POINTS:
            return None
        height = float(np.median(seen[:, 2]))
        if np.sqrt(np.linalg.eigvalsh(np.cov(seen[:, :2].T))[0]) < WIDE_MM:
            return np.array([height, 0.0, 0.0])
        design = np.column_stack([np.ones(len(seen)), seen[:, :2]])
        return np.asarray(np.linalg.lstsq(design, seen[:, 2], rcond=None)[0])

    def level_points(self, placed: PlacedView, points_mm: FloatArray) -> FloatArray:
        """Return those points (M, 3) of a view's (N, 3) that may be the table's top: kept, beside the part, near its level, and level."""
        near = self.level_mm is None or np.abs(points_mm[:, 2] - self.level_mm) < LEVEL_MM
        rows = np.flatnonzero(placed.kept & near & (np.hypot(points_mm[:, 0], points_mm[:, 1]) > self.beside_mm))
        return np.asarray(points_mm[rows[placed.normals(rows) @ UP > STEEPEST_COSINE]])


def exclude_surroundings(
    views: Sequence[ViewResult], nominal: Mesh, pose: PartPose | None, calibration: RigCalibration, rig: RigDescription
) -> tuple[list[ViewResult], Surroundings]:
    """Return the views without points of table, fixtures and background, and what was excluded.

    Background is what lies outside of a generous room around the part as it should stand. The plane of the table's top is found where
    points beside the part show it; at any height where the rig describes no table, provided that nearly nothing lies below it. Only where
    the surroundings are in the picture, points far from the nominal are excluded too, after a best fit: on a part by itself they are
    deviations. Where nothing would be left, the part is not where it was assumed, and nothing is excluded.

    Parameters
    ----------
    pose : of the part as planned; None: upright in the middle of the table
    """
    assumed = assumed_pose(nominal, pose, calibration, rig)
    room = PartRoom.of(assumed.apply(nominal.vertices_mm[np.unique(nominal.triangles)]), table_level_mm(calibration, rig), rig)
    placed = [PlacedView.of(view) for view in views]
    background, level = 0, []
    for view in placed:
        at = view.points_mm()
        background += view.remove(room.is_background(at))
        level.append(room.level_points(view, at))
    top = room.table_top(np.vstack(level))
    if top is not None and room.level_mm is None and _share_below(placed, top) > BELOW_SHARE:
        top = None
    found = {"background": background, **({} if top is None else {"table": 0}), "fixtures": 0}
    for view in placed if top is not None or room.fixtures else ():
        at = view.points_mm()
        if top is not None:
            found["table"] += view.remove(at @ [-top[1], -top[2], 1.0] - top[0] < ABOVE_TABLE_MM)
        found["fixtures"] += view.remove(room.is_fixture(at))
    points = sum(len(view.kept) for view in placed)
    if points - sum(found.values()) < min(points, LEAST_PART_POINTS):
        return list(views), Surroundings(points, nothing_of_part=True)
    if sum(found.values()) > SEEN_SHARE * points:
        found["far"] = _remove_far(placed, nominal)
    if not any(found.values()):
        return list(views), Surroundings()
    return [view.result() for view in placed], Surroundings(points, tuple(found.items()))


def _share_below(placed: Sequence[PlacedView], top: FloatArray) -> float:
    """Return the share of the points that are kept which lies clearly below a plane as of `PartRoom.table_top`."""
    below = kept = 0
    for view in placed:
        at = view.points_mm(np.flatnonzero(view.kept))
        below += int(np.count_nonzero(at @ [-top[1], -top[2], 1.0] - top[0] < -NEAR_LEVEL_MM))
        kept += len(at)
    return below / max(kept, 1)


def _remove_far(placed: Sequence[PlacedView], nominal: Mesh) -> int:
    """Take points far from the nominal out of what is kept, and return how many were; none where the nominal does not fit."""
    surface = NominalSurface(nominal)
    try:
        fitted = best_fit(_evenly_spread(placed), surface)
    except InspectionError:
        return 0  # said by the inspection, in its words
    limit = max(FAR_MM, FAR_SHARE * surface.diagonal_mm)
    removed = 0
    for view in placed:
        rows = np.flatnonzero(view.kept)
        foreign = np.zeros(len(view.kept), np.bool_)
        foreign[rows] = np.abs(signed_distances(fitted.nominal_from_part.apply(view.points_mm(rows)), surface)) > limit
        removed += view.remove(foreign)
    return removed


def _evenly_spread(placed: Sequence[PlacedView]) -> MeasuredPoints:
    """Return some of the points that are kept, evenly spread over their surface."""
    rows = [np.flatnonzero(view.kept) for view in placed]
    starts = np.cumsum([0, *map(len, rows)])

    def gather(chosen: IntArray, of_view: Callable[[PlacedView, IntArray], FloatArray]) -> FloatArray:
        found = np.empty((len(chosen), 3))
        for view, own, start, stop in zip(placed, rows, starts[:-1], starts[1:], strict=True):
            here = (chosen >= start) & (chosen < stop)
            found[here] = of_view(view, own[chosen[here] - start])
        return found

    lowest = [view.points_mm(own).min(axis=0) for view, own in zip(placed, rows, strict=True) if len(own)]
    if not lowest:
        return MeasuredPoints(np.empty((0, 3)), np.empty((0, 3)))
    chosen = thin_candidates(int(starts[-1]), np.min(lowest, axis=0), lambda lots: gather(lots, PlacedView.points_mm), ALIGNED_POINTS)
    return MeasuredPoints(gather(chosen, PlacedView.points_mm), gather(chosen, PlacedView.normals))
