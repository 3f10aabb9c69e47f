"""The part of a project on the table: as a body for collision checks, and where it should stand in the frame of the clouds."""

from __future__ import annotations

import numpy as np

from measureapp.data.calibration import RigCalibration
from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.coverage.extent import standing
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh


def part_on_table(project: ProjectFolder) -> PartSolid | None:
    """Return the nominal of a project, standing as its plan states; None where there is no nominal.

    Raises
    ------
    InputError
        The nominal cannot be read.
    """
    if project.nominal is None:
        return None
    plan = project.plan()
    return solid_of(read_mesh(project.nominal), None if plan is None else plan.part_pose)


def solid_of(nominal: Mesh, pose: PartPose | None = None) -> PartSolid:
    """Return a nominal as a body; without a pose it stands upright in the middle of the table."""
    place = standing(nominal, pose)
    return PartSolid.of_points(place.apply(nominal.vertices_mm[np.unique(nominal.triangles)]))


def assumed_pose(nominal: Mesh, pose: PartPose | None, calibration: RigCalibration, rig: RigDescription) -> RigidTransform:
    """Return ``part_from_nominal`` in the frame of the clouds, whose origin lies on the table's axis, but not on its top.

    Where the rig does not describe its table, the height is unknown, and that of the origin.
    """
    placed = standing(nominal, pose)
    lifted = placed.translation_mm + np.array([0.0, 0.0, table_level_mm(calibration, rig) or 0.0])
    return RigidTransform.from_parts(placed.rotation, lifted, "part", "nominal")


def table_level_mm(calibration: RigCalibration, rig: RigDescription) -> float | None:
    """Return the height of the table's top in the frame of the clouds, by the description of the rig; None where it describes no table."""
    if not rig.table.is_described:
        return None
    return float(calibration.table_from_guide.apply(np.array(rig.table.centre_in_guide_mm))[2])
