"""What can hide a surface point: the part itself, the table below it, and fixtures that turn with the table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.mesh import Mesh
from measureapp.data.rig import RigDescription
from measureapp.open3d_library import open3d

RAY_OFFSET_MM = 0.05  # of the origin of a ray above the surface
TABLE_BELOW_MM = 0.2  # so that rays which start just below a part that stands on the table are above it
TABLE_CORNERS = 96


@dataclass(frozen=True, slots=True, eq=False)
class PartScene:
    """Part, table and fixtures for ray casting, in the frame `part`."""

    part: Mesh
    _all: Any  # Open3D's RaycastingScene of everything
    _part: Any  # the same of the part alone
    _support: Any  # the same of table and fixtures

    @classmethod
    def of(cls, part: Mesh, rig: RigDescription, fixtures: Sequence[Mesh] = ()) -> PartScene:
        """Build from meshes in the frame `part`."""
        support = (table_top(rig), *fixtures)
        return cls(part, _scene((part, *support)), _scene((part,)), _scene(support))

    def hidden(self, points_mm: FloatArray, eyes_mm: FloatArray) -> BoolArray:
        """Return whether anything lies between points (N, 3), already offset from the surface, and eyes (N, 3)."""
        rays = _tensor(np.concatenate([points_mm, eyes_mm - points_mm], axis=1))
        return np.asarray(self._all.test_occlusions(rays, tnear=0.0, tfar=1.0).numpy())

    def escapes(self, points_mm: FloatArray, directions: FloatArray) -> BoolArray:
        """Return whether rays (N, 3) leave the scene without hitting anything."""
        return _escape(self._all, points_mm, directions)

    def escapes_part(self, points_mm: FloatArray, directions: FloatArray) -> BoolArray:
        """Return whether rays (N, 3) do not hit the part; table and fixtures are disregarded."""
        return _escape(self._part, points_mm, directions)

    def gap_to_support_mm(self, points_mm: FloatArray, directions: FloatArray) -> FloatArray:
        """Return the distance (N,) along unit directions (N, 3) to table or fixtures; infinite where they are not hit."""
        rays = _tensor(np.concatenate([points_mm, directions], axis=1))
        return np.asarray(self._support.cast_rays(rays)["t_hit"].numpy())


def table_top(rig: RigDescription) -> Mesh:
    """Return the top of the table as a disc in the frame `part`."""
    angles = np.linspace(0.0, 2.0 * np.pi, TABLE_CORNERS, endpoint=False)
    radius = rig.table.diameter_mm / 2.0
    rim = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.zeros(TABLE_CORNERS)])
    vertices = np.vstack([rim, np.zeros(3)]) - [0.0, 0.0, TABLE_BELOW_MM]
    first = np.arange(TABLE_CORNERS)
    return Mesh(vertices, np.column_stack([first, np.roll(first, -1), np.full(TABLE_CORNERS, TABLE_CORNERS)]), "part")


def _scene(meshes: Sequence[Mesh]) -> Any:
    scene, tensor = open3d().t.geometry.RaycastingScene(), open3d().core.Tensor.from_numpy
    for mesh in meshes:
        scene.add_triangles(tensor(mesh.vertices_mm.astype(np.float32)), tensor(mesh.triangles.astype(np.uint32)))
    return scene


def _escape(scene: Any, points_mm: FloatArray, directions: FloatArray) -> BoolArray:
    return ~np.asarray(scene.test_occlusions(_tensor(np.concatenate([points_mm, directions], axis=1))).numpy())


def _tensor(rays: FloatArray) -> Any:
    return open3d().core.Tensor.from_numpy(np.ascontiguousarray(rays, np.float32))
