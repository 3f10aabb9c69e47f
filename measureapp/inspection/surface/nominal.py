"""Nominal surface: closest points, ray casting and sharp edges of a triangle mesh."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.open3d_library import open3d

if TYPE_CHECKING:
    from measureapp.inspection.surface.closest.hierarchy import TriangleHierarchy

SHARP_DEG = 25.0
STEEP = 1e-3  # cosine between ray and normal above which the plane of a triangle tells where a ray meets it
ON_EDGE = 1e-4
WELD_MM = 1e-4
EDGE_SPACING_MM = 0.5  # of the points along sharp edges


@dataclass(frozen=True, slots=True)
class Closest:
    """Closest points of a surface, with outward normals."""

    points_mm: FloatArray  # (N, 3)
    normals: FloatArray  # (N, 3) unit normal of the nearest triangle; on edges and corners the angle-weighted pseudo-normal
    triangles: IntArray  # (N,)


@dataclass(frozen=True, slots=True)
class Hits:
    """First hits of rays on a surface."""

    distances_mm: FloatArray  # (N,), inf where a ray misses
    triangles: IntArray  # (N,), undefined where it misses


class NominalSurface:
    """A nominal mesh prepared for queries; welded, without degenerate triangles.

    Raises InspectionError for a mesh without area.
    """

    def __init__(self, mesh: Mesh) -> None:
        self.vertices_mm, self.triangles = _weld(mesh)
        if len(self.triangles) == 0:
            raise InspectionError("The nominal mesh has no surface.", "Export the nominal again as STL, PLY or OBJ with triangles.")
        corners = self.vertices_mm[self.triangles]
        cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        doubled = np.linalg.norm(cross, axis=1, keepdims=True)
        self.normals = cross / doubled
        self.area_mm2 = float(doubled.sum() / 2)
        self.low_mm, self.high_mm = self.vertices_mm.min(axis=0), self.vertices_mm.max(axis=0)
        self.diagonal_mm = float(np.linalg.norm(self.high_mm - self.low_mm))
        self._offset = (self.low_mm + self.high_mm) / 2
        self._vertex_normals = _angle_weighted_normals(corners, self.triangles, self.normals, len(self.vertices_mm))

    @cached_property
    def _hierarchy(self) -> TriangleHierarchy:
        """The search structure for closest points."""
        from measureapp.inspection.surface.closest.hierarchy import TriangleHierarchy

        return TriangleHierarchy(self.vertices_mm[self.triangles])

    @cached_property
    def _ray_scene(self) -> Any:
        """The search structure for rays, in single precision."""
        o3d = open3d()
        scene = o3d.t.geometry.RaycastingScene()
        single = (self.vertices_mm - self._offset).astype(np.float32)
        scene.add_triangles(o3d.core.Tensor.from_numpy(single), o3d.core.Tensor.from_numpy(self.triangles.astype(np.uint32)))
        return scene

    def closest(self, points_mm: FloatArray, near: IntArray | None = None) -> Closest:
        """Return the closest surface points to ``points_mm`` (N, 3), in double precision.

        The pseudo-normals of J. A. Bærentzen and H. Aanæs, IEEE TVCG 11(3), 2005, give the correct sign of a distance.

        Parameters
        ----------
        near : (N,), triangles that were closest before the points moved a little
        """
        triangles, weights = self._hierarchy.closest(points_mm, near)
        points = np.einsum("nk,nkd->nd", weights, self.vertices_mm[self.triangles[triangles]])
        normals = self.normals[triangles]
        border = np.flatnonzero(weights.min(axis=1) < ON_EDGE)
        if len(border):
            normals = normals.copy()
            normals[border] = self._pseudo_normals(triangles[border], weights[border])
        return Closest(points, normals, triangles)

    def hits(self, points_mm: FloatArray, directions: FloatArray) -> Hits:
        """Return the first hits of rays from ``points_mm`` (N, 3) along unit ``directions`` (N, 3).

        Which triangle is hit is found in single precision, how far it is along the ray in double precision.
        """
        found = self.rough_hits(points_mm, directions)
        normals = self.normals[found.triangles]
        slope = np.einsum("nd,nd->n", normals, directions)
        away = np.einsum("nd,nd->n", normals, self.vertices_mm[self.triangles[found.triangles, 0]] - points_mm)
        steep = np.isfinite(found.distances_mm) & (np.abs(slope) > STEEP)
        found.distances_mm[steep] = away[steep] / slope[steep]
        return found

    def rough_hits(self, points_mm: FloatArray, directions: FloatArray) -> Hits:
        """Return `hits` with their distances in single precision, too."""
        answer = self._ray_scene.cast_rays(self._rays(points_mm, directions))
        last = len(self.triangles) - 1  # a miss has an invalid id
        return Hits(answer["t_hit"].numpy().astype(np.float64), np.minimum(answer["primitive_ids"].numpy().astype(np.int64), last))

    def has_hits(self, points_mm: FloatArray, directions: FloatArray, reach_mm: float) -> BoolArray:
        """Return whether rays hit the surface within ``reach_mm`` (N,), in single precision: many times faster than where they do."""
        answer: BoolArray = self._ray_scene.test_occlusions(self._rays(points_mm, directions), 0.0, reach_mm).numpy()
        return answer

    def _rays(self, points_mm: FloatArray, directions: FloatArray) -> Any:
        rays = np.empty((len(points_mm), 6), np.float32)
        rays[:, :3], rays[:, 3:] = points_mm - self._offset, directions
        return open3d().core.Tensor.from_numpy(rays)

    def _pseudo_normals(self, triangles: IntArray, weights: FloatArray) -> FloatArray:
        """Return the normals on edges (mean of both sides) and corners (angle-weighted)."""
        at_corner = weights.max(axis=1) > 1 - ON_EDGE
        corner = self.triangles[triangles, weights.argmax(axis=1)]
        opposite = weights.argmin(axis=1)
        edge = self._edge_normals[triangles, opposite]
        mixed = np.where(at_corner[:, None], self._vertex_normals[corner], edge)
        length = np.linalg.norm(mixed, axis=1, keepdims=True)
        return np.where(length > 1e-9, mixed / np.maximum(length, 1e-9), self.normals[triangles])

    @cached_property
    def _edge_normals(self) -> FloatArray:
        """Return the sum (T, 3, 3) of the normals of both triangles at the edge opposite each corner."""
        return _edge_normal_sums(self.triangles, self.normals)

    @cached_property
    def face_neighbours(self) -> tuple[IntArray, FloatArray]:
        """Pairs (E, 2) of triangles with a common edge, and the cosine (E,) of the angle between their normals."""
        pairs = _adjacent_triangles(self.triangles)
        return pairs, np.einsum("nd,nd->n", self.normals[pairs[:, 0]], self.normals[pairs[:, 1]])

    @cached_property
    def sharp_edges(self) -> cKDTree | None:
        """Search tree of points along the edges with a dihedral angle above `SHARP_DEG`; None without such edges."""
        pairs, normal_pairs = _inner_edges(self.triangles, self.normals)
        sharp = np.einsum("nd,nd->n", normal_pairs[:, 0], normal_pairs[:, 1]) < np.cos(np.radians(SHARP_DEG))
        if not sharp.any():
            return None
        start, end = self.vertices_mm[pairs[sharp, 0]], self.vertices_mm[pairs[sharp, 1]]
        counts = np.maximum(2, np.ceil(np.linalg.norm(end - start, axis=1) / EDGE_SPACING_MM).astype(int) + 1)
        which = np.repeat(np.arange(len(counts)), counts)
        step = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        share = (step / (counts[which] - 1))[:, None]
        return cKDTree(start[which] + share * (end[which] - start[which]))


def _adjacent_triangles(triangles: IntArray) -> IntArray:
    """Return the pairs (E, 2) of triangles that share an edge with no third one."""
    _, number = _sorted_edges(triangles)
    order = np.argsort(number, kind="stable")
    counts = np.bincount(number)
    first = np.cumsum(counts) - counts
    first = first[counts == 2]
    return np.stack([order[first] // 3, order[first + 1] // 3], axis=1)


def _weld(mesh: Mesh) -> tuple[FloatArray, IntArray]:
    """Merge equal vertices and drop triangles without area."""
    keys = np.round(mesh.vertices_mm / WELD_MM).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    vertices, triangles = mesh.vertices_mm[first], inverse.ravel()[np.asarray(mesh.triangles)].reshape(-1, 3)
    corners = vertices[triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return vertices, triangles[area > 1e-12]


def _angle_weighted_normals(corners: FloatArray, triangles: IntArray, normals: FloatArray, vertices: int) -> FloatArray:
    sums = np.zeros((vertices, 3))
    for k in range(3):
        one, other = corners[:, (k + 1) % 3] - corners[:, k], corners[:, (k + 2) % 3] - corners[:, k]
        cosine = np.einsum("nd,nd->n", one, other) / (np.linalg.norm(one, axis=1) * np.linalg.norm(other, axis=1))
        np.add.at(sums, triangles[:, k], np.arccos(np.clip(cosine, -1, 1))[:, None] * normals)
    return sums


def _sorted_edges(triangles: IntArray) -> tuple[IntArray, IntArray]:
    """Return all edges (3T, 2), smaller vertex first, edge k opposite corner k; and an index (3T,) of the distinct edges."""
    edges = np.stack([triangles[:, [1, 2]], triangles[:, [2, 0]], triangles[:, [0, 1]]], axis=1).reshape(-1, 2)
    edges = np.sort(edges, axis=1)
    keys = edges[:, 0].astype(np.int64) * (int(triangles.max()) + 1) + edges[:, 1]
    return edges, np.unique(keys, return_inverse=True)[1].ravel()


def _edge_normal_sums(triangles: IntArray, normals: FloatArray) -> FloatArray:
    _, number = _sorted_edges(triangles)
    sums = np.zeros((number.max() + 1, 3))
    np.add.at(sums, number, np.repeat(normals, 3, axis=0))
    return sums[number].reshape(-1, 3, 3)


def _inner_edges(triangles: IntArray, normals: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the edges (E, 2) shared by exactly two triangles, and the normals of both (E, 2, 3)."""
    edges, number = _sorted_edges(triangles)
    order = np.argsort(number, kind="stable")
    counts = np.bincount(number)
    first = np.cumsum(counts) - counts
    first = first[counts == 2]
    one, other = order[first], order[first + 1]
    return edges[one], np.stack([normals[one // 3], normals[other // 3]], axis=1)
