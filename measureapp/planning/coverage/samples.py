"""Evenly spread samples of a surface, with normals and the area each stands for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.errors import PlanError
from measureapp.planning.coverage.outward import is_wound_consistently, outward
from measureapp.planning.coverage.scene import PartScene

DARTS_PER_SAMPLE = 8
PACKING = 0.54  # density of random discs relative to the densest packing
SAME_SIDE = 0.0  # cosine of normals; the two faces of a thin wall are sampled independently


@dataclass(frozen=True, slots=True, eq=False)
class SurfaceSamples:
    """N points of the surface in the frame `part`, which turns with the table."""

    points_mm: FloatArray  # (N, 3) float32, read-only
    normals: FloatArray  # (N, 3) float32, unit, out of the material
    areas_mm2: FloatArray  # (N,) float64, area that a sample stands for; the sum is the area of the surface

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float32, (None, 3)))
        object.__setattr__(self, "normals", read_only(self.normals, np.float32, (len(self.points_mm), 3)))
        object.__setattr__(self, "areas_mm2", read_only(self.areas_mm2, np.float64, (len(self.points_mm),)))

    def __len__(self) -> int:
        return len(self.points_mm)

    @property
    def area_mm2(self) -> float:
        """Area of the whole surface."""
        return float(self.areas_mm2.sum())

    def subset(self, chosen: BoolArray | IntArray) -> SurfaceSamples:
        """Return some of the samples, by mask or indices."""
        return SurfaceSamples(self.points_mm[chosen], self.normals[chosen], self.areas_mm2[chosen])


def sample_surface(scene: PartScene, count: int = 5000, seed: int = 1) -> SurfaceSamples:
    """Sample the part of ``scene`` by Poisson discs: evenly, with a least distance between samples of the same side.

    Normals point out of the material even where triangles are wound the wrong way, see `outward`.

    Parameters
    ----------
    count : approximate number of samples
    seed : the same seed gives the same samples

    Raises
    ------
    PlanError
        The mesh has no area.
    """
    corners = scene.part.vertices_mm[scene.part.triangles]
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crosses, axis=1) / 2.0
    total = float(areas.sum())
    if not (np.isfinite(total) and total > 0.0):
        raise PlanError("The nominal has no surface: all its triangles are degenerate.", "Export it again.")
    rng = np.random.default_rng(seed)
    triangles = np.searchsorted(np.cumsum(areas) / total, rng.random(DARTS_PER_SAMPLE * count), side="right").clip(max=len(areas) - 1)
    points = _in_triangles(corners[triangles], rng)
    normals = crosses[triangles] / (2.0 * areas[triangles, None])
    if not is_wound_consistently(scene.part.triangles):
        normals = outward(points, normals, scene, rng)  # before samples of one side are told from those of the other
    spacing = np.sqrt(total * PACKING / count * 2.0 / np.sqrt(3.0))
    kept = _poisson_discs(points, normals, spacing)
    share = _nearest_of_same_side(points, normals, points[kept], normals[kept])
    weights = np.bincount(share, minlength=len(kept)) * total / len(points)
    return SurfaceSamples(points[kept], outward(points[kept], normals[kept], scene, rng), weights)


def _in_triangles(corners_mm: FloatArray, rng: np.random.Generator) -> FloatArray:
    """Return one uniformly distributed point (N, 3) in each triangle (N, 3, 3)."""
    u, v = rng.random((2, len(corners_mm), 1))
    root = np.sqrt(u)
    return (1.0 - root) * corners_mm[:, 0] + root * (1.0 - v) * corners_mm[:, 1] + root * v * corners_mm[:, 2]


def _poisson_discs(points: FloatArray, normals: FloatArray, spacing_mm: float) -> IntArray:
    """Return the indices of a maximal subset whose points of the same side keep ``spacing_mm``; earlier points first."""
    pairs = cKDTree(points).query_pairs(spacing_mm, output_type="ndarray")
    pairs = pairs[np.einsum("ni,ni->n", normals[pairs[:, 0]], normals[pairs[:, 1]]) > SAME_SIDE]
    undecided, kept = np.ones(len(points), bool), np.zeros(len(points), bool)
    while undecided.any():
        pairs = pairs[undecided[pairs].all(axis=1)]
        beaten = np.zeros(len(points), bool)
        beaten[pairs.max(axis=1, initial=0)] = True  # by an undecided neighbour that came earlier
        winners = undecided & ~beaten
        kept |= winners
        undecided &= ~winners
        undecided[pairs[winners[pairs].any(axis=1)].ravel()] = False
    return np.flatnonzero(kept)


def _nearest_of_same_side(points: FloatArray, normals: FloatArray, kept: FloatArray, kept_normals: FloatArray) -> IntArray:
    """Return the index of the kept sample nearest to each point; of the 8 nearest, the first whose normal is within 90°."""
    _, near = cKDTree(kept).query(points, k=min(8, len(kept)))
    near = near.reshape(len(points), -1)
    same = np.einsum("nki,ni->nk", kept_normals[near], normals) > SAME_SIDE
    return np.take_along_axis(near, same.argmax(axis=1)[:, None], axis=1)[:, 0]
