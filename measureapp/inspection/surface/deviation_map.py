"""Deviation map: mean deviations at the vertices of the subdivided nominal mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, read_only
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.nominal import NominalSurface

NEIGHBOURS = 12
FINEST_SHARE = 0.008  # of the diagonal: longest edge of the subdivided mesh


@dataclass(frozen=True, slots=True, eq=False)
class DeviationMap:
    """The subdivided nominal with its deviations, and where it was measured."""

    mesh: Mesh
    distances_mm: FloatArray  # (V,), mean of the nearest points; 0 where nothing was measured
    measured: BoolArray  # (V,)

    def __post_init__(self) -> None:
        object.__setattr__(self, "distances_mm", read_only(self.distances_mm, np.float64, (len(self.mesh.vertices_mm),)))
        object.__setattr__(self, "measured", read_only(self.measured, np.bool_, (len(self.mesh.vertices_mm),)))


def map_deviation(found: Deviation, nominal: Mesh, reach_mm: float = 2.0, most_triangles: int | None = None) -> DeviationMap:
    """Average the deviations of the nearest points within ``reach_mm`` and of matching normal, at each vertex of the nominal.

    Vertices are duplicated at sharp edges, so that a face does not get the value of the opposite face of a thin wall.

    Parameters
    ----------
    most_triangles : longer edges are accepted for about this many triangles at most; None: no limit

    Raises
    ------
    InspectionError
        The nominal has no surface.
    """
    surface = NominalSurface(nominal)
    mesh, normals = _subdivide(surface, _longest_edge_mm(surface, most_triangles))
    tree = cKDTree(found.points_mm)
    count = min(NEIGHBOURS, len(found.points_mm))
    away, which = tree.query(mesh.vertices_mm, k=count, distance_upper_bound=reach_mm)
    away, which = away.reshape(-1, count), which.reshape(-1, count)
    near = np.isfinite(away)
    which = np.where(near, which, 0)
    near &= np.einsum("vkd,vd->vk", found.nominal_normals[which], normals) > 0.5
    held = near.sum(axis=1)
    means = np.where(near, found.distances_mm[which], 0.0).sum(axis=1) / np.maximum(held, 1)
    return DeviationMap(mesh, means, held > 0)


def _longest_edge_mm(surface: NominalSurface, most_triangles: int | None) -> float:
    """Return `FINEST_SHARE` of the diagonal, doubled until subdivision by halving all edges makes few enough triangles."""
    corners = surface.vertices_mm[surface.triangles]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    wanted = FINEST_SHARE * surface.diagonal_mm
    while most_triangles is not None and wanted < surface.diagonal_mm:
        halvings = np.ceil(np.log2(np.maximum(longest / wanted, 1.0)))
        if float((4.0**halvings).sum()) <= most_triangles:
            break
        wanted *= 2
    return wanted


def _subdivide(surface: NominalSurface, longest_mm: float) -> tuple[Mesh, FloatArray]:
    """Return triangles with edges up to ``longest_mm``, with separate corners per face, and the normals of the corners."""
    from trimesh.remesh import subdivide_to_size

    faces = np.arange(3 * len(surface.triangles)).reshape(-1, 3)
    vertices, triangles, parents = subdivide_to_size(  # type: ignore[no-untyped-call]
        surface.vertices_mm[surface.triangles].reshape(-1, 3), faces, longest_mm, max_iter=20, return_index=True
    )
    normals = np.zeros((len(vertices), 3))
    normals[triangles] = surface.normals[parents][:, None, :]
    return Mesh(vertices, triangles, "nominal"), normals
