"""The part on the table: its pose, its enclosing cylinder, and whether the rig can hold it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError
from measureapp.geometry.transform import RigidTransform

SMALLEST_MM = 1.0
TOUCHING_MM = 1e-3
BELOW_TABLE_MM = 1.0  # rounding and a slightly tilted pose


@dataclass(frozen=True, slots=True)
class Extent:
    """Cylinder about the table's axis that encloses the part."""

    radius_mm: float
    low_mm: float
    high_mm: float


def standing(nominal: Mesh, pose: PartPose | None = None) -> RigidTransform:
    """Return ``part_from_nominal`` of a part; without a pose it stands in the middle of the table as its nominal is oriented."""
    return (pose or PartPose()).transform(nominal.vertices_mm[np.unique(nominal.triangles)], nominal.frame)


def extent_on_table(part: Mesh, rig: RigDescription) -> Extent:
    """Return the enclosing cylinder of a part, given in the frame `part`.

    Raises
    ------
    PlanError
        The part is not finite, smaller than 1 mm, wider than the table, or reaches below it; or so high or wide that the head has no room.
    """
    points = part.vertices_mm[part.triangles].reshape(-1, 3)
    if not len(points) or not np.isfinite(points).all():
        raise PlanError("The nominal has no triangles, or corners that are not finite.", "Export it again.")
    size = float(np.ptp(points, axis=0).max())
    if size < SMALLEST_MM:
        raise PlanError(f"The nominal is {size:.3g} mm long, too small to be measured.", "State its unit if it is not in millimetres.")
    found = Extent(float(np.hypot(points[:, 0], points[:, 1]).max()), float(points[:, 2].min()), float(points[:, 2].max()))
    _refuse_too_large(found, rig)
    return found


def _refuse_too_large(found: Extent, rig: RigDescription) -> None:
    table = rig.table
    largest = table.diameter_mm if rig.cell.largest_part_mm is None else rig.cell.largest_part_mm
    if 2.0 * found.radius_mm > largest + TOUCHING_MM:
        raise PlanError(
            f"The part is too large for {rig.name}: turning with the table it needs {2.0 * found.radius_mm:.0f} mm; {largest:g} mm are allowed.",
            "State the unit of the nominal if it is not in millimetres, or move the part to the middle of the table.",
        )
    if found.low_mm < -BELOW_TABLE_MM:
        raise PlanError(f"The part reaches {-found.low_mm:.1f} mm below the top of the table.", "Correct its pose on the table.")
    room = rig.robot.shoulder_mm[2] + rig.robot.max_reach_mm - table.centre_in_guide_mm[2]
    if found.high_mm > room:
        raise PlanError(
            f"The part is {found.high_mm:.0f} mm high; the robot of {rig.name} reaches {room:.0f} mm above the table.",
            "State the unit of the nominal if it is not in millimetres, or lay the part down.",
        )
