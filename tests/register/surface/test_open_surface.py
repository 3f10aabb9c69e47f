"""Open patches: the rim and holes stay open, corners are measured points, and what is no open patch is refused."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.cloud import StitchedCloud
from measureapp.errors import RegistrationError
from measureapp.register.surface.open import LONGEST_SPACINGS, triangulate_open_patch

SPACING_MM, NOISE_MM, HALF_MM, SAGITTA_MM = 0.5, 0.02, 20.0, 4.0
HOLE_MM = 5.0


def sheet(hole_mm: float = HOLE_MM, seed: int = 1) -> StitchedCloud:
    """A bowl of 40 mm × 40 mm, jittered points 0.5 mm apart, with a round hole in the middle."""
    rng = np.random.default_rng(seed)
    axis = np.arange(-HALF_MM, HALF_MM + 1e-9, SPACING_MM)
    x, y = (values.ravel() for values in np.meshgrid(axis, axis))
    x, y = x + rng.uniform(-0.1, 0.1, x.size), y + rng.uniform(-0.1, 0.1, y.size)
    kept = np.hypot(x, y) > hole_mm
    x, y = x[kept], y[kept]
    z = SAGITTA_MM * (x * x + y * y) / HALF_MM**2
    normals = np.column_stack([-2 * SAGITTA_MM * x / HALF_MM**2, -2 * SAGITTA_MM * y / HALF_MM**2, np.ones_like(x)])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return cloud(np.column_stack([x, y, z]) + rng.normal(0, NOISE_MM, (len(x), 1)) * normals, normals)


def cloud(points: np.ndarray, normals: np.ndarray) -> StitchedCloud:
    count = len(points)
    return StitchedCloud(points, normals, np.full(count, NOISE_MM), np.full(count, 0.5), np.zeros(count), ())


def borders(triangles: np.ndarray) -> int:
    """How many closed curves the border of the mesh makes."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    sides, counts = np.unique(sides, axis=0, return_counts=True)
    assert counts.max() <= 2
    rim = sides[counts == 1]
    used, index = np.unique(rim, return_inverse=True)
    a, b = index.reshape(-1, 2).T
    return int(connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(len(used), len(used))), directed=False)[0])


def test_a_sheet_keeps_its_border_and_its_hole_and_every_corner_is_a_measured_point() -> None:
    points = sheet()
    mesh = triangulate_open_patch(points)
    assert mesh.measured is not None and mesh.measured.all()
    known = {tuple(point) for point in points.points_mm}
    assert all(tuple(vertex) in known for vertex in mesh.vertices_mm)
    assert len(mesh.vertices_mm) > 0.995 * len(points)
    corners = mesh.vertices_mm[mesh.triangles]
    middles = np.hypot(*corners.mean(axis=1)[:, :2].T)
    assert middles.min() > HOLE_MM - 0.1  # inside a chord of the hole's rim
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    assert edges.max() <= LONGEST_SPACINGS * SPACING_MM * 1.1
    assert borders(mesh.triangles) == 2  # the rim and the hole
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (cross[:, 2] > 0).all()  # outside is where the normals point
    x = np.linspace(-HALF_MM, HALF_MM, 400)
    slope = 2 * SAGITTA_MM / HALF_MM**2
    area = np.mean(np.sqrt(1 + slope**2 * (x[:, None] ** 2 + x[None] ** 2))) * (2 * HALF_MM) ** 2 - np.pi * HOLE_MM**2
    rim_mm2 = (8 * HALF_MM + 2 * np.pi * HOLE_MM) * SPACING_MM  # the outermost row may be missing
    # noise folds the triangles: an edge rises by √2 σ over a spacing, and area by half the square of the slope
    folded = 0.5 * 2 * (np.sqrt(2) * NOISE_MM / (SPACING_MM - 0.2)) ** 2
    assert area - rim_mm2 < np.linalg.norm(cross, axis=1).sum() / 2 < area * (1 + folded) + 0.2 * rim_mm2


def test_a_gap_of_a_few_points_is_no_hole() -> None:
    assert borders(triangulate_open_patch(sheet(hole_mm=0.7)).triangles) == 1


def test_a_body_seen_all_round_is_refused() -> None:
    rng = np.random.default_rng(2)
    normals = rng.standard_normal((5000, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    with pytest.raises(RegistrationError, match="not a single open patch") as caught:
        triangulate_open_patch(cloud(20 * normals, normals))
    assert "poisson" in caught.value.hint


def test_sheets_over_one_another_are_refused() -> None:
    one = sheet(0.0, 1)
    other = sheet(0.0, 2)
    lifted = np.asarray(other.points_mm) + np.array([0, 0, 10.0])
    both = np.vstack([one.points_mm, lifted])
    with pytest.raises(RegistrationError, match="surfaces overlap"):
        triangulate_open_patch(cloud(both, np.vstack([one.normals, other.normals])))


def test_memory_is_checked_before_anything_is_done() -> None:
    with pytest.raises(RegistrationError, match=r"of memory, and 0\.0 GiB are free"):
        triangulate_open_patch(sheet(), free_bytes=lambda: 1000)


def test_few_points_and_points_on_a_line_are_refused() -> None:
    line = np.column_stack([np.arange(300.0), np.zeros(300), np.zeros(300)])
    up = np.tile([0.0, 0.0, 1.0], (300, 1))
    with pytest.raises(RegistrationError, match="too few"):
        triangulate_open_patch(cloud(line[:50], up[:50]))
    with pytest.raises(RegistrationError, match="on one line"):
        triangulate_open_patch(cloud(line, up))
