"""Screened Poisson surface reconstruction from the merged points, trimmed to the measured area.

M. Kazhdan, H. Hoppe, Screened Poisson surface reconstruction, ACM Transactions on Graphics 32(3), 2013, as in Open3D.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cloud import StitchedCloud
from measureapp.data.mesh import Mesh
from measureapp.errors import RegistrationError
from measureapp.memory import available_bytes
from measureapp.progress import NoProgress, PartOf, Progress
from measureapp.register.clouds.quality import point_spacing_mm
from measureapp.register.surface.poisson import run_poisson

LEAST_POINTS = 200
LARGEST_DEPTH, LEAST_DEPTH = 10, 5
SPACINGS_PER_CELL = 2.0  # aimed at: the octree halves its cells, so a part's cells have 1.4 to 2.8 spacings
MOST_POINTS = 1_000_000
MEASURED_SPACINGS = 2.5  # a vertex further than this from every point is filled, not measured
TRIMMED_SPACINGS = 8.0  # surface further than this from every point is removed
BOX_SCALE = 1.1
BYTES_PER_POINT, BYTES_PER_LEAF = 600, 700


@dataclass(frozen=True, slots=True)
class SurfaceSettings:
    """Parameters of the reconstruction; lengths in point spacings."""

    spacings_per_cell: float = SPACINGS_PER_CELL
    trimmed_spacings: float = TRIMMED_SPACINGS
    most_points: int = MOST_POINTS


def reconstruct_surface(
    cloud: StitchedCloud,
    settings: SurfaceSettings | None = None,
    progress: Progress | None = None,
    *,
    free_bytes: Callable[[], int] | None = None,
) -> Mesh:
    """Screened Poisson reconstruction; vertices without points nearby are marked as not measured, those far from all points removed.

    Raises
    ------
    RegistrationError
        Too few points, or not enough memory (estimated before anything is allocated, or during the reconstruction).
    """
    settings, progress = settings or SurfaceSettings(), progress or NoProgress()
    if len(cloud) < LEAST_POINTS:
        raise RegistrationError(f"{len(cloud)} points are too few for a surface.", f"At least {LEAST_POINTS} are needed.")
    chosen = _subsample(len(cloud), settings.most_points)
    points, normals = np.asarray(cloud.points_mm)[chosen], np.asarray(cloud.normals, np.float64)[chosen]
    spacing, extent = point_spacing_mm(points), float(np.ptp(points, axis=0).max()) * BOX_SCALE
    if not extent > 0:
        raise RegistrationError("All points of the cloud coincide.", "Check the unit and the frame of the cloud.")
    depth = int(np.clip(np.rint(np.log2(extent / (settings.spacings_per_cell * spacing))), LEAST_DEPTH, LARGEST_DEPTH))
    _check_memory(points, spacing, (free_bytes or available_bytes)())
    vertices, triangles = run_poisson(points, normals, depth, BOX_SCALE, PartOf(progress, 0.1, 0.8))
    progress.report(0.8, 1, "trimming the surface")
    distance, _ = cKDTree(points).query(vertices, workers=-1)
    vertices, triangles, distance = _trim(vertices, triangles, distance, settings.trimmed_spacings * spacing)
    progress.report(1, 1, "surface complete")
    return Mesh(vertices, triangles, cloud.frame, distance <= MEASURED_SPACINGS * spacing)


def _subsample(count: int, most: int) -> IntArray | slice:
    return slice(None) if count <= most else np.sort(np.random.default_rng(0).choice(count, most, replace=False))


def _check_memory(points_mm: FloatArray, spacing_mm: float, free: int) -> None:
    cell = np.floor((points_mm - points_mm.min(axis=0)) / (SPACINGS_PER_CELL * spacing_mm)).astype(np.int64)
    counts = cell.max(axis=0) + 1
    cells = len(np.unique((cell[:, 0] * counts[1] + cell[:, 1]) * counts[2] + cell[:, 2]))
    needed = BYTES_PER_POINT * len(points_mm) + BYTES_PER_LEAF * 8 * cells
    if needed > free:
        raise RegistrationError(
            f"The surface needs about {needed / 2**30:.1f} GiB of memory, and {free / 2**30:.1f} GiB are free.",
            "Merge on a coarser grid, or close other programs.",
        )


def _trim(vertices: FloatArray, triangles: IntArray, distance: FloatArray, furthest: float) -> tuple[FloatArray, IntArray, FloatArray]:
    """Remove triangles with a corner further than ``furthest`` from every point, and vertices without triangles."""
    near: BoolArray = distance <= furthest
    kept = triangles[near[triangles].all(axis=1)]
    if len(kept) == 0:
        raise RegistrationError("The points do not form a surface.", "Check the normals and the density of the cloud.")
    used, index = np.unique(kept, return_inverse=True)
    return vertices[used], index.reshape(-1, 3), distance[used]
