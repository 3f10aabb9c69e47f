"""2.5-D Delaunay triangulation of one open patch, such as a sheet or one side of a part; holes stay open.

The points are projected along their mean normal and triangulated there (C. B. Barber, D. P. Dobkin and H. Huhdanpaa, The Quickhull
algorithm for convex hulls, ACM TOMS 22(4), 1996). Poisson surfaces, meant for closed bodies, bulge at the border of such a patch and
close its holes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial import Delaunay, QhullError

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import StitchedCloud
from measureapp.data.mesh import Mesh
from measureapp.errors import RegistrationError
from measureapp.memory import available_bytes
from measureapp.progress import NoProgress, Progress
from measureapp.register.clouds.quality import point_spacing_mm
from measureapp.register.surface.closed import LEAST_POINTS

LONGEST_SPACINGS = 4.0  # a gap wider than this is a hole
STEEPEST_DEG = 75.0  # greatest angle to the mean normal of a point that counts as visible along it
TURNED_AWAY = 0.02  # greatest share of steeper points in an open patch
UNUSED = 0.1  # greatest share of points without triangles; above it, surfaces overlap in projection
BYTES_PER_POINT = 1200
CLOSED_HINT = "Make a closed surface (poisson), or divide the cloud into open patches."


def triangulate_open_patch(
    cloud: StitchedCloud, progress: Progress | None = None, *, free_bytes: Callable[[], int] = available_bytes
) -> Mesh:
    """Triangulate the points of an open patch, with no edge longer than four times the point spacing.

    Every vertex is a measured point: nothing is filled, and holes and the border stay open.

    Raises
    ------
    RegistrationError
        Too few points, a patch that is not completely visible from one side, or not enough memory (estimated beforehand).
    """
    progress = progress or NoProgress()
    if len(cloud) < LEAST_POINTS:
        raise RegistrationError(f"{len(cloud)} points are too few for a surface.", f"At least {LEAST_POINTS} are needed.")
    needed, free = BYTES_PER_POINT * len(cloud), free_bytes()
    if needed > free:
        raise RegistrationError(
            f"The surface needs about {needed / 2**30:.1f} GiB of memory, and {free / 2**30:.1f} GiB are free.",
            "Merge on a coarser grid, or close other programs.",
        )
    points, towards = np.asarray(cloud.points_mm), _viewing_direction(np.asarray(cloud.normals, np.float64))
    progress.report(0.1, 1, "triangulating the points")
    longest = LONGEST_SPACINGS * point_spacing_mm(points)
    triangles = _drop_long_triangles(points, _triangulate(points, towards), longest)
    progress.report(0.9, 1, "removing long triangles")
    used, index = np.unique(triangles, return_inverse=True)
    if len(used) < (1 - UNUSED) * len(points):
        raise RegistrationError(
            f"{1 - len(used) / len(points):.0%} of the points have no neighbours in the projection along the mean normal: "
            "surfaces overlap there, or the points are scattered.",
            CLOSED_HINT,
        )
    progress.report(1, 1, "surface complete")
    return Mesh(points[used], index.reshape(-1, 3), cloud.frame, np.ones(len(used), np.bool_))


def _viewing_direction(normals: FloatArray) -> FloatArray:
    """Return the unit mean normal; raises RegistrationError when some points face away from it."""
    mean = normals.mean(axis=0)
    length = float(np.linalg.norm(mean))
    towards = mean / max(length, 1e-12)
    away = float(np.mean(normals @ towards < np.cos(np.radians(STEEPEST_DEG))))
    if away > TURNED_AWAY or length == 0:
        raise RegistrationError(f"{away:.0%} of the points face away from the rest: this is not a single open patch.", CLOSED_HINT)
    return towards


def _triangulate(points_mm: FloatArray, towards: FloatArray) -> IntArray:
    """Return the Delaunay triangles (T, 3) in the plane normal to ``towards``, counter-clockwise as viewed from there."""
    axes = np.linalg.svd(towards[None])[2][1:]
    axes = axes if np.cross(axes[0], axes[1]) @ towards > 0 else axes[::-1]
    flat = (points_mm - points_mm.mean(axis=0)) @ axes.T
    try:
        triangles = Delaunay(flat).simplices
    except QhullError as error:
        raise RegistrationError("The points lie on one line.", "Check the unit and the frame of the cloud.") from error
    a, b, c = (flat[triangles[:, k]] for k in range(3))
    clockwise = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] < 0
    triangles[clockwise] = triangles[clockwise][:, ::-1]
    return np.asarray(triangles)


def _drop_long_triangles(points_mm: FloatArray, triangles: IntArray, longest_mm: float) -> IntArray:
    corners = points_mm[triangles]
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return np.asarray(triangles[edges.max(axis=1) <= longest_mm])
