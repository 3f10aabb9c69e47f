"""Samples are even, stand for the whole area, and have normals out of the material whatever the winding."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from measureapp.data.mesh import Mesh
from measureapp.errors import PlanError
from measureapp.planning.coverage.samples import SurfaceSamples, sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.project.rig_file import read_rig
from tests.planning.coverage.parts import casting, torus

RIG = read_rig("paper")
TUBE_CENTRE_MM, TUBE_MM = 70.0, 25.0


def raised(mesh: Mesh, by_mm: float = 0.0) -> Mesh:
    return Mesh(mesh.vertices_mm - [0, 0, mesh.vertices_mm[:, 2].min() - by_mm], mesh.triangles, "part")


def samples_of(mesh: Mesh, count: int = 800) -> SurfaceSamples:
    return sample_surface(PartScene.of(mesh, RIG), count)


def outward_share(samples: SurfaceSamples) -> float:
    """Share of the samples on a torus whose normals point out of its tube."""
    points = samples.points_mm - [0, 0, samples.points_mm[:, 2].mean()]
    level = np.hypot(points[:, 0], points[:, 1])[:, None]
    ring = np.column_stack([points[:, :2] * TUBE_CENTRE_MM / level, np.zeros(len(points))])
    return float((np.einsum("ni,ni->n", points - ring, samples.normals) > 0).mean())


def test_samples_stand_for_the_whole_area_and_are_about_as_many_as_requested() -> None:
    samples = samples_of(raised(torus()), 1000)
    exact = 4 * np.pi**2 * TUBE_CENTRE_MM * TUBE_MM
    assert samples.area_mm2 == pytest.approx(exact, rel=0.01)
    assert 850 < len(samples) < 1150
    assert np.percentile(samples.areas_mm2, 99) < 3 * np.median(samples.areas_mm2)


def test_samples_keep_their_distance() -> None:
    samples = samples_of(raised(torus()), 1000)
    nearest = cKDTree(samples.points_mm).query(samples.points_mm, k=2)[0][:, 1]
    spacing = np.sqrt(samples.area_mm2 / len(samples))
    assert nearest.min() > 0.7 * spacing


def test_both_sides_of_a_thin_wall_are_sampled() -> None:
    corners = np.array([[x, y, z] for z in (0.0, 100.0) for y in (-0.2, 0.2) for x in (-60.0, 60.0)])
    import trimesh

    wall = trimesh.convex.convex_hull(corners)
    samples = samples_of(Mesh(np.asarray(wall.vertices), np.asarray(wall.faces), "part"), 300)
    front = samples.normals[:, 1] > 0.9
    assert samples.areas_mm2[front].sum() == pytest.approx(12_000, rel=0.05)


def test_the_same_seed_gives_the_same_samples_and_another_one_others() -> None:
    scene = PartScene.of(raised(casting()), RIG)
    first, again, other = sample_surface(scene, 300, 1), sample_surface(scene, 300, 1), sample_surface(scene, 300, 2)
    assert np.array_equal(first.points_mm, again.points_mm)
    assert np.array_equal(first.normals, again.normals)
    assert not np.array_equal(first.points_mm[:50], other.points_mm[:50])


def test_normals_point_outwards_for_an_inverted_mesh() -> None:
    mesh = raised(torus())
    inverted = Mesh(mesh.vertices_mm, mesh.triangles[:, [0, 2, 1]], "part")
    assert outward_share(samples_of(mesh)) > 0.995
    assert outward_share(samples_of(inverted)) > 0.995


def test_normals_point_outwards_where_triangles_are_wound_at_random_and_some_are_missing() -> None:
    mesh, rng = raised(torus()), np.random.default_rng(1)
    triangles = np.where(rng.random((len(mesh.triangles), 1)) < 0.5, mesh.triangles, mesh.triangles[:, [0, 2, 1]])
    holes = rng.random(len(triangles)) < 0.02
    assert outward_share(samples_of(Mesh(mesh.vertices_mm, triangles[~holes], "part"))) > 0.98


def test_an_open_sheet_keeps_the_side_that_its_triangles_state() -> None:
    sheet = Mesh(np.array([[-50.0, -50, 40], [50, -50, 40], [50, 50, 40], [-50, 50, 40]]), np.array([[0, 1, 2], [0, 2, 3]]), "part")
    assert (samples_of(sheet, 100).normals[:, 2] > 0.99).all()


def test_a_mesh_without_area_is_refused() -> None:
    line = Mesh(np.array([[0.0, 0, 0], [10, 0, 0], [20, 0, 0]]), np.array([[0, 1, 2]]), "part")
    with pytest.raises(PlanError, match="no surface"):
        samples_of(line)
