"""What sharp edges do to narrow faces: found where it is, not where noise looks like it, and shared by all features."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial import cKDTree

from measureapp.data.cut import Cut
from measureapp.data.inspection_program import MeasuredFeature
from measureapp.inspection.features.edge_effects import REST, estimate_edge_effects
from measureapp.inspection.features.feature_errors import EDGES, ErrorSource
from measureapp.inspection.features.found_feature import find_feature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.propagation import propagate
from measureapp.inspection.settings import InspectionSettings

LENGTH_MM, SPACING_MM, CUT_MM, NOISE_MM = 60.0, 0.5, 1.0, 0.005
SETTINGS = InspectionSettings()


def edges_of(width_mm):
    along = np.arange(-LENGTH_MM / 2, LENGTH_MM / 2, 0.25)
    return cKDTree(np.vstack([np.column_stack([along, np.full_like(along, side * width_mm / 2), 0 * along]) for side in (-1, 1)]))


def strip(width_mm, lift_mm, seed, reach_mm=0.6, turned=1.0):
    """Return the points of a strip about y = 0 that are lifted along its normal by the blur of its two edges."""
    generator = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(-LENGTH_MM / 2, LENGTH_MM / 2, SPACING_MM), np.arange(-width_mm / 2, width_mm / 2, SPACING_MM) + 0.1)
    x, y = x.ravel(), y.ravel()
    z = lift_mm * np.exp(-(width_mm / 2 - np.abs(y) - CUT_MM) / reach_mm) + generator.normal(0, NOISE_MM, len(x))
    normals = np.tile([0.0, 0.0, turned], (len(x), 1))
    return MeasuredPoints(np.column_stack([x, y, turned * z]), normals)


def found_on(points, width_mm, name="top", turned=1.0):
    described = MeasuredFeature(
        name=name, shape="plane", point_mm=(0, 0, 0), direction=(0, 0, turned), cut=Cut(band_mm=1.0, edge_mm=CUT_MM)
    )
    edges = edges_of(width_mm)
    return estimate_edge_effects(find_feature(described, points, edges, SETTINGS), described, edges)[name]


def height(features):
    return float(features[0].point_mm @ np.array([0.0, 0.0, 1.0]))


@pytest.mark.parametrize("lift_mm", [0.03, -0.03])
def test_a_narrow_face_that_its_edges_lift_has_an_interval_that_holds_the_truth(lift_mm):
    errors = []
    for seed in range(10):
        found = found_on(strip(5.0, lift_mm, seed), 5.0)
        value, budget = propagate(height, [found])
        errors.append(value / (2 * budget["edges"]))
        assert 2 * budget["noise"] < abs(value)  # which is all that was stated before
    assert max(np.abs(errors)) < 1.0 and np.std(errors) < 0.1


@pytest.mark.parametrize("lift_mm", [0.0, 0.002, 0.004, 0.006])
def test_a_lift_that_noise_hides_is_in_the_interval_too(lift_mm):
    """Of two standard deviations of its estimate and less; without that of the estimate, half of the intervals missed the truth."""
    scores = []
    for seed in range(20):
        value, budget = propagate(height, [found_on(strip(5.0, lift_mm, seed), 5.0)])
        scores.append(value / (2 * np.hypot(budget["noise"], budget["edges"])))
        assert budget["edges"] < 0.005  # nothing beside what a lift of 0.03 mm adds
    assert np.mean(np.abs(scores) <= 1.0) >= 0.9 and np.sqrt(np.mean(np.square(scores))) < 0.75


def test_a_wide_face_is_hardly_moved_by_its_edges():
    value, budget = propagate(height, [found_on(strip(60.0, 0.03, 1), 60.0)])
    assert budget.get("edges", 0.0) < 0.001 and abs(value) < 0.002


def test_the_errors_of_two_faces_by_edges_add_up_in_their_thickness_and_cancel_in_a_step():
    one, other = found_on(strip(5.0, 0.03, 1), 5.0), found_on(strip(5.0, 0.03, 2), 5.0, "below")
    under = found_on(strip(5.0, 0.03, 3, turned=-1.0), 5.0, "under", turned=-1.0)
    single = propagate(height, [one])[1]["edges"]
    thickness = propagate(lambda features: height(features[:1]) - height(features[1:]), [one, under])[1]["edges"]
    step = propagate(lambda features: height(features[:1]) - height(features[1:]), [one, other])[1]["edges"]
    assert thickness == pytest.approx(2 * single, rel=0.1) and step < 0.15 * single  # which is what each knows of its own


def test_the_shift_of_a_cylinder_is_that_of_its_radius():
    generator, width_mm, radius_mm = np.random.default_rng(4), 5.0, 40.0
    z, turn = np.meshgrid(np.arange(-2.35, 2.4, 0.3), np.linspace(0, 2 * np.pi, 500, endpoint=False))
    z, turn = z.ravel(), turn.ravel()
    lift = 0.03 * np.exp(-(width_mm / 2 - np.abs(z) - CUT_MM) / 0.6)
    away = np.column_stack([np.cos(turn), np.sin(turn), 0 * z])
    points = MeasuredPoints((radius_mm + lift + generator.normal(0, NOISE_MM, len(z)))[:, None] * away + z[:, None] * [0, 0, 1], away)
    rings = [np.column_stack([radius_mm * away[:, :2], np.full(len(z), side * width_mm / 2)]) for side in (-1, 1)]
    edges, cut = cKDTree(np.vstack(rings)), Cut(band_mm=1.0, edge_mm=CUT_MM)
    described = MeasuredFeature(name="tip", shape="cylinder", point_mm=(0, 0, 0), direction=(0, 0, 1), radius_mm=radius_mm, cut=cut)
    found = estimate_edge_effects(find_feature(described, points, edges, SETTINGS), described, edges)["tip"]
    columns = found.errors[ErrorSource(EDGES)]
    kept = np.abs(z) < width_mm / 2 - CUT_MM
    far = kept & (np.abs(z) <= np.quantile(np.abs(z[kept]), 0.25))
    expected = REST * float(np.mean(lift[far]) - np.mean(lift[kept]))
    assert columns[6, 0] == pytest.approx(expected, rel=0.2) and np.abs(columns[:3, 0]).max() < 0.2 * abs(expected)
    value, budget = propagate(lambda features: features[0].radius_mm, [found])
    assert abs(value - radius_mm) < 2 * budget["edges"]


def test_without_edges_nothing_is_added():
    described = MeasuredFeature(name="top", shape="plane", point_mm=(0, 0, 0), direction=(0, 0, 1), cut=Cut(band_mm=1.0, edge_mm=CUT_MM))
    found = find_feature(described, strip(5.0, 0.03, 1), None, SETTINGS)
    assert estimate_edge_effects(found, described, None) is found
