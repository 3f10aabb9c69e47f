"""The part of a project as a body on the table, for collision checks."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.mesh import Mesh
from measureapp.planning.collision.build import PartSolid
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh


def part_on_table(project: ProjectFolder) -> PartSolid | None:
    """Return the nominal of a project, standing in the middle of the table as it is oriented; None where there is no nominal.

    Raises
    ------
    InputError
        The nominal cannot be read.
    """
    return None if project.nominal is None else solid_of(read_mesh(project.nominal))


def solid_of(nominal: Mesh, part_from_nominal: FloatArray | None = None) -> PartSolid:
    """Return a nominal as a body.

    Parameters
    ----------
    part_from_nominal : (4, 4) its pose on the table; None: upright in the middle
    """
    points = nominal.vertices_mm[np.unique(nominal.triangles)]
    if part_from_nominal is not None:
        return PartSolid.of_points(points @ part_from_nominal[:3, :3].T + part_from_nominal[:3, 3])
    low, high = points.min(axis=0), points.max(axis=0)
    return PartSolid.of_points(points - [*((low + high) / 2.0)[:2], low[2]])
