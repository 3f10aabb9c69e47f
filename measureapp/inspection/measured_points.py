"""Measured points of an inspection, from clouds, files or meshes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only
from measureapp.data.mesh import Mesh
from measureapp.data.view_errors import ViewErrors, remove_common_motion
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform

MESH_SAMPLES = 200_000
ALIGNING_POINTS = 20_000  # sufficient for the common motion of a part
SAMPLE_SEED = 20  # reproducible results
CANDIDATES_PER_POINT = 100  # candidates per retained point
LEAST_OF_A_CELL = 0.25  # of the median number of points


class HasPoints(Protocol):
    """Anything with points: a cloud of one view, a stitched cloud, points read from a file."""

    @property
    def points_mm(self) -> FloatArray:
        """The points, (N, 3)."""


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredPoints:
    """Points of a measured surface; unknown columns are None."""

    points_mm: FloatArray  # (N, 3) float64
    normals: FloatArray | None = None  # (N, 3), unit, outwards
    sigma_mm: FloatArray | None = None  # (N,)
    view: IntArray | None = None  # (N,), a view of each point, sampled by weight where that is known
    errors: ViewErrors | None = None  # of those views

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (None, 3)))

    def __len__(self) -> int:
        return len(self.points_mm)

    @classmethod
    def of(cls, source: MeasuredPoints | HasPoints | Mesh) -> MeasuredPoints:
        """Return the points of a cloud, or an even sample of the measured part of a mesh.

        Raises
        ------
        InspectionError
            There are no points, or some are not finite.
        """
        made = source if isinstance(source, MeasuredPoints) else sample_mesh(source) if isinstance(source, Mesh) else _from_cloud(source)
        if len(made) == 0:
            raise InspectionError("There are no measured points to inspect.", "Scan the part first, or check the file.")
        if not np.isfinite(made.points_mm).all():
            raise InspectionError("Some measured points are not finite numbers.", "Export the cloud again without invalid points.")
        return made

    def where(self, keep: BoolArray | IntArray) -> MeasuredPoints:
        """Return the points chosen by a mask or by indices."""
        chosen = {name: None if (values := getattr(self, name)) is None else values[keep] for name in ("normals", "sigma_mm", "view")}
        return replace(self, points_mm=self.points_mm[keep], **chosen)

    def seen_from(self, transform: RigidTransform) -> MeasuredPoints:
        """Return the same points in ``transform.to_frame``."""
        normals = None if self.normals is None else transform.rotate(np.asarray(self.normals, np.float64))
        errors = None if self.errors is None else self.errors.seen_from(transform)
        return replace(self, points_mm=transform.apply(self.points_mm), normals=normals, errors=errors)

    def remove_alignment_motion(self) -> MeasuredPoints:
        """Return the same points with errors reduced by the common motion that an alignment by the surface compensates."""
        if self.errors is None or self.view is None or self.normals is None:
            return self
        some = self.thin(ALIGNING_POINTS)
        assert some.normals is not None and some.view is not None
        errors = remove_common_motion(self.errors, some.points_mm, np.asarray(some.normals, np.float64), some.view)
        return replace(self, errors=errors)

    def with_scale_uncertainty(self, ppm: float, temperature: float = 0.0) -> MeasuredPoints:
        """Return the same points with relative standard uncertainties of scale and of temperature, if they have an error model."""
        return self if self.errors is None else replace(self, errors=replace(self.errors, scale=ppm * 1e-6, temperature=temperature))

    def thin(self, count: int) -> MeasuredPoints:
        """Return about ``count`` points, evenly distributed over the surface."""
        return self if len(self) <= count else self.where(thin_indices(self.points_mm, count))


def thin_indices(points_mm: FloatArray, count: int) -> IntArray:
    """Grid subsampling: return ascending indices of about ``count`` points, one random point per cell.

    The choice is random because points are sorted by position, so that the first of a cell would be biased to one side of the surface.
    Cells with few points are skipped: they contain noise from a neighbouring cell, or stray points.
    """
    if len(points_mm) <= count:
        return np.arange(len(points_mm))
    return thin_candidates(len(points_mm), points_mm.min(axis=0), lambda lots: points_mm[lots], count)


def thin_candidates(number: int, lowest_mm: FloatArray, points_of: Callable[[IntArray], FloatArray], count: int) -> IntArray:
    """As `thin_indices`, of points that are not in memory together.

    Parameters
    ----------
    number : of all points
    lowest_mm : smallest coordinates of all points, (3,)
    points_of : returns the points (M, 3) of some indices, which are not in order
    """
    if number <= count:
        return np.arange(number)
    lots = np.random.default_rng(SAMPLE_SEED).permutation(number)[: CANDIDATES_PER_POINT * count]
    offsets = points_of(lots) - lowest_mm
    size = float(offsets.max()) / np.sqrt(count)
    for _ in range(12):
        taken, points = _first_of_each_cell(offsets, size)
        taken = taken[points >= LEAST_OF_A_CELL * np.median(points)]
        if 0.8 * count <= len(taken) <= 1.2 * count:
            break
        size *= np.sqrt(len(taken) / count)
    return np.sort(lots[taken])


def _first_of_each_cell(offsets_mm: FloatArray, size_mm: float) -> tuple[IntArray, IntArray]:
    """Return the index of the first point of every cell, and the number of its points."""
    index = np.floor(offsets_mm / size_mm).astype(np.int64)
    key = (index[:, 0] << 42) + (index[:, 1] << 21) + index[:, 2]
    _, first, points = np.unique(key, return_index=True, return_counts=True)
    return first, points


def _from_cloud(source: HasPoints) -> MeasuredPoints:
    normals, sigma, view, sampled, errors = (
        getattr(source, name, None) for name in ("normals", "sigma_mm", "view", "sampled_view", "errors")
    )
    if sigma is not None and not bool(np.all(np.isfinite(sigma) & (np.asarray(sigma) > 0))):
        sigma = None
    if normals is not None and not bool(np.all(np.any(np.asarray(normals) != 0, axis=1))):
        normals = None  # normals missing for some points: use positions only
    return MeasuredPoints(source.points_mm, normals, sigma, view if sampled is None else sampled, None if view is None else errors)


def sample_mesh(mesh: Mesh, count: int = MESH_SAMPLES) -> MeasuredPoints:
    """Sample ``mesh`` evenly by area, without triangles that were filled."""
    triangles = np.asarray(mesh.triangles)
    if mesh.measured is not None:
        triangles = triangles[mesh.measured[triangles].all(axis=1)]
    corners = mesh.vertices_mm[triangles]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(cross, axis=1)
    if doubled.sum() <= 0:
        return MeasuredPoints(np.empty((0, 3)))
    rng = np.random.default_rng(SAMPLE_SEED)
    chosen = np.searchsorted(np.cumsum(doubled), (np.arange(count) + rng.random(count)) / count * doubled.sum())
    chosen = np.minimum(chosen, len(doubled) - 1)
    u, v = rng.random((2, count))
    folded = u + v > 1
    u, v = np.where(folded, 1 - u, u), np.where(folded, 1 - v, v)
    a, b, c = corners[chosen, 0], corners[chosen, 1], corners[chosen, 2]
    points = a + u[:, None] * (b - a) + v[:, None] * (c - a)
    return MeasuredPoints(points, cross[chosen] / doubled[chosen, None])
