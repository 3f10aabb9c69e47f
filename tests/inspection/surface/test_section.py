from __future__ import annotations

import numpy as np
import pytest

from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import no_alignment
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.surface.cutting_surface import CuttingCylinder, CuttingPlane
from measureapp.inspection.surface.deviation import compute_deviation
from measureapp.inspection.surface.deviation_map import map_deviation
from measureapp.inspection.surface.histogram import bin_deviations
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.section import cut_section, intersect_mesh
from tests.inspection.surface.test_deviation import box

HALF = np.array([50.0, 30.0, 20.0])
UP = np.array([0.0, 0.0, 1.0])


def length(curve: np.ndarray) -> float:
    return float(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum())


def test_a_plane_cuts_a_box_in_one_closed_rectangle() -> None:
    surface = NominalSurface(box(HALF))
    (curve,) = intersect_mesh(surface.vertices_mm, surface.triangles, CuttingPlane.through(np.array([0, 0, 7.0]), UP))
    assert np.allclose(curve[0], curve[-1]) and np.allclose(curve[:, 2], 7.0)
    assert length(curve) == pytest.approx(2 * (100 + 60), abs=1e-6)


def test_a_plane_through_faces_and_corners_still_gives_whole_curves() -> None:
    surface = NominalSurface(box(HALF))
    for height in (-20.0, 0.0, 20.0):
        curves = intersect_mesh(surface.vertices_mm, surface.triangles, CuttingPlane.through(np.array([0, 0, height]), UP))
        assert all(np.allclose(curve[0], curve[-1]) for curve in curves)


def test_a_plane_cuts_an_open_sheet_in_an_open_curve() -> None:
    sheet = box(HALF)
    kept = sheet.triangles[(sheet.vertices_mm[sheet.triangles][..., 2] > 0).all(axis=1)]
    (curve,) = intersect_mesh(sheet.vertices_mm, kept, CuttingPlane.through(np.zeros(3), np.array([1.0, 0, 0])))
    assert length(curve) == pytest.approx(60, abs=1e-6) and not np.allclose(curve[0], curve[-1])


def test_a_cylinder_cuts_a_box_in_curves_that_lie_on_it_and_unroll() -> None:
    surface = NominalSurface(box(HALF))
    cut = CuttingCylinder.about(np.zeros(3), UP, 25.0)
    curves = intersect_mesh(*_divided(surface), cut)
    assert len(curves) == 2  # top and bottom
    for curve in curves:
        assert np.allclose(np.hypot(curve[:, 0], curve[:, 1]), 25.0, atol=1e-9)
        assert length(curve) == pytest.approx(2 * np.pi * 25, rel=0.01)
        assert np.allclose(np.abs(cut.flatten(curve)[:, 1]), 20)


def _divided(surface: NominalSurface):
    from trimesh.remesh import subdivide_to_size

    return subdivide_to_size(surface.vertices_mm, surface.triangles, 3.0)


def test_the_points_of_a_section_follow_its_curve_and_carry_their_deviations() -> None:
    """Points of a box lifted by 0.1 mm everywhere: every point of the section says so, and they run once around it."""
    nominal = box(HALF)
    points = sample_mesh(nominal, 100_000)
    lifted = MeasuredPoints(points.points_mm + 0.1 * points.normals, points.normals)
    found = compute_deviation(lifted, nominal, no_alignment())
    cut = CuttingPlane.through(np.array([0, 0, 7.0]), UP)
    made = cut_section("z=7", found, NominalSurface(nominal), cut, 0.5)
    expected = 100_000 * 320 * 1.0 / (2 * (100 * 60 + 100 * 40 + 60 * 40))
    assert len(made.measured_mm) == pytest.approx(expected, rel=5 / np.sqrt(expected))
    assert np.allclose(made.deviations_mm, 0.1, atol=1e-4)
    assert np.allclose(made.measured_mm[:, 2], 7.0)
    steps = np.linalg.norm(np.diff(made.measured_mm, axis=0), axis=1)
    assert steps.max() < 5  # 4.2 points a mm: neighbours in the table are neighbours on the part


def test_a_section_beside_the_part_is_refused() -> None:
    found = compute_deviation(sample_mesh(box(HALF), 1000), box(HALF), no_alignment())
    with pytest.raises(InspectionError, match="z=90 intersects neither"):
        cut_section("z=90", found, NominalSurface(box(HALF)), CuttingPlane.through(90 * UP, UP), 0.5)


def test_a_histogram_counts_every_point_once_and_states_fractions() -> None:
    values = np.random.default_rng(0).normal(0, 0.1, 50_000)
    found = bin_deviations(values, -0.1, 0.2)
    assert found.counts.sum() == 50_000
    assert (found.below, found.above) == (pytest.approx(0.1587, abs=0.006), pytest.approx(0.0228, abs=0.003))
    assert found.below + found.within + found.above == pytest.approx(1)
    with pytest.raises(InspectionError, match="empty"):
        bin_deviations(values, 0.1, 0.1)


def test_the_nominal_is_coloured_only_where_it_was_measured() -> None:
    """Only the upper side of a 2 mm sheet was measured, lifted by 0.1: the lower side stays without colour."""
    sheet = box(np.array([50.0, 30.0, 1.0]))
    points = sample_mesh(sheet, 100_000)
    upper = points.where(points.normals[:, 2] > 0.5)
    upper = upper.where(upper.points_mm[:, 0] > -10)
    lifted = MeasuredPoints(upper.points_mm + 0.1 * upper.normals, upper.normals)
    made = map_deviation(compute_deviation(lifted, sheet, no_alignment()), sheet, reach_mm=2.5)
    places = made.mesh.vertices_mm
    inside = (np.abs(places[:, 0]) < 49) & (np.abs(places[:, 1]) < 29)
    lower, left, seen = inside & (places[:, 2] < 0), inside & (places[:, 0] < -13), inside & (places[:, 2] > 0) & (places[:, 0] > -9)
    assert not made.measured[lower].any() and not made.measured[left].any()
    assert made.measured[seen].all() and np.allclose(made.distances_mm[seen], 0.1, atol=1e-3)
    assert np.all(made.distances_mm[~made.measured] == 0)
