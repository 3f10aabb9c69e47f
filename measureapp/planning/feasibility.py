"""What the generator asks about the cell: reach, what touches at a viewpoint, and what a move would touch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell

PLACES_KEPT = 10_000
LEAST_HEIGHT_MM = 1.0
FLAT = 1e-6  # thickness over size below which a hull has no volume
THICKNESS_MM = 0.2


@dataclass(frozen=True, slots=True, eq=False)
class Feasibility:
    """A rig with the checks that decide which viewpoints and moves are feasible."""

    rig: RigDescription
    arm: ArmModel | None = None  # None: reach of the flange only
    is_free: Callable[[Viewpoint], bool] | None = None  # whether nothing touches at a viewpoint; None: not checked
    problem_between: Callable[[Viewpoint, Viewpoint], str] | None = (
        None  # what a direct move would touch, empty if nothing; None: not checked
    )

    @classmethod
    def checked(cls, rig: RigDescription, arm: ArmModel | None, part: Mesh) -> Feasibility:
        """Return a rig with collision checks of head, arm, guide, table, fixtures, keep-out boxes and the part's convex hull.

        Parameters
        ----------
        part : nominal in its place on the table, frame `part`. Where its enclosing cylinder about the table's axis is free, all table angles
            are; where the empty table is not, none is

        Raises
        ------
        PlanError
            The part is larger than the table.
        """
        points = _with_thickness(part.vertices_mm[np.unique(part.triangles)])
        cell = Cell.of(rig, arm, PartSolid.of_points(points))
        if any(fixture.on_table for fixture in rig.cell.fixtures):
            return cls(rig, arm, lambda viewpoint: not cell.problem_at(viewpoint), cell.problem_between)
        turned = PartSolid.enclosing(float(np.hypot(points[:, 0], points[:, 1]).max()), max(float(points[:, 2].max()), LEAST_HEIGHT_MM))
        largest, smallest = Cell.of(rig, arm, turned), Cell.of(rig, arm)

        @lru_cache(maxsize=PLACES_KEPT)
        def at_all_angles(flange: FlangePose, guide_mm: float) -> bool | None:
            """Whether all table angles are free, or none; None: they differ."""
            anywhere = Viewpoint(id="all", flange=flange, guide_mm=guide_mm, table_deg=rig.table.limits_deg[0])
            if smallest.problem_at(anywhere):
                return False
            return None if largest.problem_at(anywhere) else True

        def is_free(viewpoint: Viewpoint) -> bool:
            known = at_all_angles(viewpoint.flange, viewpoint.guide_mm)
            return not cell.problem_at(viewpoint) if known is None else known

        return cls(rig, arm, is_free, cell.problem_between)


def _with_thickness(points_mm: FloatArray) -> FloatArray:
    """Return points (N, 3), doubled to either side where they all lie in one plane or line, for their hull to have a volume."""
    values = np.linalg.svd(points_mm - points_mm.mean(axis=0), compute_uv=False)
    if len(points_mm) > 3 and values[-1] > FLAT * values[0]:
        return points_mm
    return np.concatenate([points_mm + THICKNESS_MM / 2.0 * side for side in (*np.eye(3), *-np.eye(3))])
