from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import no_alignment
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.surface.deviation import compute_deviation, distances_and_normals, signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.ray_distances import REACH_MM, distances_along_normals


def box_distance(points: np.ndarray, half: np.ndarray) -> np.ndarray:
    """Signed distance from a box, in closed form."""
    q = np.abs(points) - half
    return np.linalg.norm(np.maximum(q, 0), axis=1) + np.minimum(q.max(axis=1), 0)


def box(half: np.ndarray) -> Mesh:
    import trimesh

    made = trimesh.creation.box(2 * half)
    return Mesh(made.vertices, made.faces, "nominal")


def test_signed_distances_from_a_box_are_those_of_the_closed_form_at_faces_edges_and_corners() -> None:
    half, rng = np.array([50.0, 30.0, 20.0]), np.random.default_rng(1)
    points = rng.uniform(-1.3, 1.3, (4000, 3)) * half
    found = signed_distances(points, NominalSurface(box(half)))
    assert np.allclose(found, box_distance(points, half), atol=1e-9)


def test_an_open_surface_has_signs_on_both_sides(samples) -> None:
    sheet = Mesh([[0, 0, 0], [40, 0, 0], [40, 40, 0], [0, 40, 0]], [[0, 1, 2], [0, 2, 3]], "nominal")
    above = np.array([[10, 10, 0.5], [20, 20, -0.25]])
    assert np.allclose(signed_distances(above, NominalSurface(sheet)), [0.5, -0.25], atol=1e-6)


def test_noise_and_offset_of_a_cloud_come_back_as_rms_and_mean(samples) -> None:
    nominal, rng = samples("gypsum").nominal, np.random.default_rng(3)
    points = sample_mesh(nominal, 50_000)
    assert points.normals is not None
    moved = points.points_mm + (0.1 + 0.03 * rng.standard_normal(len(points)))[:, None] * points.normals
    found = compute_deviation(MeasuredPoints(moved), nominal, no_alignment())
    assert found.mean_mm == pytest.approx(0.1, abs=0.002)
    assert found.rms_mm == pytest.approx(np.hypot(0.1, 0.03), abs=0.002)
    assert found.min_mm < found.mean_mm < found.p95_mm < found.max_mm
    assert found.unmeasured_share == pytest.approx(0.0, abs=0.001)


def test_the_unmeasured_share_is_the_area_without_points() -> None:
    half = np.array([50.0, 30.0, 20.0])
    points = sample_mesh(box(half), 60_000)
    seen = points.points_mm[points.points_mm[:, 2] > -19.99]  # all but the underside and what lies near it
    share = 60 * 100 / (2 * (100 * 60 + 100 * 40 + 60 * 40))
    border = 2 * (100 + 60) * 2.0 / (2 * (100 * 60 + 100 * 40 + 60 * 40))  # a strip 2 mm wide counts as near
    found = compute_deviation(MeasuredPoints(seen), box(half), no_alignment())
    assert share - border - 0.01 < found.unmeasured_share < share


def test_a_nominal_without_area_is_refused() -> None:
    line = Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], "nominal")
    with pytest.raises(InspectionError, match="no surface"):
        compute_deviation(MeasuredPoints(np.zeros((3, 3))), line, no_alignment())


def test_points_with_normals_are_measured_as_those_without() -> None:
    """Rays along noisy normals and closest points agree on a wavy surface of facets that meet at a few degrees."""
    import trimesh

    made, rng = trimesh.creation.icosphere(5, 50.0), np.random.default_rng(5)
    vertices = np.array(made.vertices)
    vertices[:, 2] += 2 * np.sin(vertices[:, 0] / 10)
    nominal = Mesh(vertices, made.faces, "nominal")
    points = sample_mesh(nominal, 40_000)
    assert points.normals is not None
    lifted = points.points_mm + rng.normal(0, 0.2, (40_000, 1)) * points.normals
    leaning = points.normals + rng.normal(0, 0.04, (40_000, 3))
    leaning /= np.linalg.norm(leaning, axis=1, keepdims=True)
    surface = NominalSurface(nominal)
    by_rays, _ = distances_and_normals(lifted, leaning, surface)
    # 0.02 mm between hit and foot, over facets that meet at less than 10°
    assert np.abs(by_rays - signed_distances(lifted, surface)).max() < 0.02 * np.sin(np.radians(10))


def foot_distances(points: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Distances (N,) of points from the nearest of a few triangles (T, 3, 3), in double precision."""
    nearest = np.full(len(points), np.inf)
    for a, b, c in corners:
        edges = []
        for start, end in ((a, b), (b, c), (c, a)):
            along = end - start
            share = np.clip((points - start) @ along / (along @ along), 0, 1)
            edges.append(np.linalg.norm(points - start - share[:, None] * along, axis=1))
        normal = np.cross(b - a, c - a)
        inside = np.all([np.cross(end - start, points - start) @ normal >= 0 for start, end in ((a, b), (b, c), (c, a))], axis=0)
        above = np.abs((points - a) @ normal) / np.linalg.norm(normal)
        nearest = np.minimum(nearest, np.where(inside, above, np.min(edges, axis=0)))
    return nearest


def test_rays_stop_at_the_nearest_face_on_either_side_also_in_thin_walls_and_narrow_slots() -> None:
    """Rays inwards are followed only where they may meet a nearer face; the answer is that of all rays in both directions."""
    import trimesh

    slabs = [trimesh.creation.box((40.0, 40.0, thick)).apply_translation((0, 0, up)) for thick, up in ((0.6, 0.0), (8.0, 5.0), (0.3, 9.6))]
    made = trimesh.util.concatenate(slabs)
    surface = NominalSurface(Mesh(made.vertices, made.faces, "nominal"))
    rng = np.random.default_rng(5)
    points = rng.uniform((-19.0, -19.0, -1.5), (19.0, 19.0, 11.5), (4000, 3))
    normals = np.where(rng.random((4000, 1)) < 0.5, 1.0, -1.0) * np.array([0.0, 0.0, 1.0])
    out, back = surface.hits(points, normals), surface.hits(points, -normals)
    triangles = np.where(out.distances_mm < back.distances_mm, out.triangles, back.triangles)
    away = np.minimum(out.distances_mm, back.distances_mm)
    distances, found, sure = distances_along_normals(points, normals, surface)
    near = away < REACH_MM
    assert 0.3 < near.mean() < 0.7
    np.testing.assert_array_equal(found[near], triangles[near])
    np.testing.assert_allclose(np.abs(distances[near]), away[near], atol=1e-9)
    np.testing.assert_array_equal(sure, near & (np.einsum("nd,nd->n", surface.normals[triangles], normals) > 0))


def test_closest_points_on_long_narrow_triangles_are_as_near_as_in_double_precision() -> None:
    """A fan of facets 120 mm long and up to 1.5 mm wide, as CAD programs divide a disc."""
    turn = np.radians(np.linspace(0, 5, 8))
    rim = np.column_stack([120 * np.cos(turn), 120 * np.sin(turn), 0.3 * np.cos(9 * turn)])
    vertices = np.vstack([[0.0, 0.0, 0.0], rim])
    triangles = np.array([[0, k, k + 1] for k in range(1, len(rim))])
    rng = np.random.default_rng(2)
    nominal = Mesh(vertices, triangles, "nominal")
    points = sample_mesh(nominal, 4000).points_mm + rng.normal(0, 0.05, (4000, 3))
    exact = foot_distances(points, vertices[triangles])
    assert np.abs(np.abs(signed_distances(points, NominalSurface(nominal))) - exact).max() < 1e-9


def test_no_place_of_the_impeller_is_nearer_along_a_ray_than_its_closest_point(samples) -> None:
    """They differ only in a corner, where the closest point may lie on the other face."""
    surface, rng = samples("impeller").surface, np.random.default_rng(5)
    points = sample_mesh(samples("impeller").nominal, 60_000)
    assert points.normals is not None
    lifted = points.points_mm + rng.normal(0, 0.03, (len(points), 1)) * points.normals
    by_rays = np.abs(distances_and_normals(lifted, np.array(points.normals), surface)[0])
    closest = np.abs(signed_distances(lifted, surface))
    assert (closest - by_rays).max() < 1e-4
    assert np.mean(by_rays - closest > 1e-3) < 0.002


def test_points_far_from_the_nominal_are_measured_to_the_closest_point() -> None:
    half, rng = np.array([50.0, 30.0, 20.0]), np.random.default_rng(1)
    points = rng.uniform(-1.5, 1.5, (4000, 3)) * half
    far = points[np.abs(box_distance(points, half)) > 1.01]
    normals = rng.standard_normal(far.shape)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    found, _ = distances_and_normals(far, normals, NominalSurface(box(half)))
    assert np.allclose(found, box_distance(far, half), atol=2e-4)
