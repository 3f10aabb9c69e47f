"""The part of a project as a body on the table, for collision checks."""

from __future__ import annotations

import numpy as np

from measureapp.data.mesh import Mesh
from measureapp.data.part_pose import PartPose
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
