"""Statistics, probes, smoothing and whiskers of deviations whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import no_alignment
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import UncertaintySettings
from measureapp.inspection.surface.cutting_surface import CuttingPlane
from measureapp.inspection.surface.deviation import compute_deviation
from measureapp.inspection.surface.deviation_index import DeviationIndex
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.probe import probe_deviation
from measureapp.inspection.surface.section import cut_section
from measureapp.inspection.surface.smoothing import smooth_for_eye
from measureapp.inspection.surface.statistics import _greatest, compute_statistics
from measureapp.inspection.surface.whiskers import section_whiskers

NOISE = 0.01
ONLY_NOISE = UncertaintySettings(placement_mm=0, systematic_mm=0)
FLAT = Mesh(np.array([[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]]), "nominal")


def bumps(xy):
    """A hill of 0.3 mm at (30, 30), a hollow of 0.2 mm at (70, 60)."""
    return 0.3 * np.exp(-np.sum((xy - [30, 30]) ** 2, axis=1) / 50) - 0.2 * np.exp(-np.sum((xy - [70, 60]) ** 2, axis=1) / 50)


def scanned(count=40_000, seed=1, stray=(), keep=None):
    rng = np.random.default_rng(seed)
    xy = rng.uniform(0, 100, (count, 2))
    if keep is not None:
        xy = xy[keep(xy)]
    points = np.column_stack([xy, bumps(xy) + NOISE * rng.standard_normal(len(xy))])
    if stray:
        points = np.vstack([points, stray])
    return MeasuredPoints(points, np.tile([0, 0, 1.0], (len(points), 1)))


def compared(points):
    return compute_deviation(points, FLAT, no_alignment())


@pytest.fixture(scope="module")
def index():
    return DeviationIndex(compared(scanned()))


def test_the_index_knows_spacing_and_noise(index):
    assert index.spacing_mm == pytest.approx(0.5, rel=0.1)  # 4 points per mm²
    assert index.noise_mm == pytest.approx(NOISE, rel=0.25)


def test_extremes_are_where_the_part_has_them_not_where_strays_are():
    stray = [[10.0, 90.0, 1.5], [90.0, 10.0, -1.2], [50, 50, 0.9]]
    found = compute_statistics(compared(scanned(stray=stray)), FLAT, tolerance_mm=(-0.1, 0.1))
    assert found.maximum.value_mm == pytest.approx(0.3, abs=4 * NOISE) and found.minimum.value_mm == pytest.approx(-0.2, abs=4 * NOISE)
    assert found.maximum.point_mm[:2] == pytest.approx([30, 30], abs=3) and found.minimum.point_mm[:2] == pytest.approx([70, 60], abs=3)
    assert found.maximum.neighbours >= 5


def test_the_default_range_covers_twice_the_tolerance_and_never_follows_extremes(index):
    found = index.found
    assert compute_statistics(found, FLAT, index=index).range_mm == (-0.5, 0.5)  # 99.5 % of the points are within 0.27 mm
    assert compute_statistics(found, FLAT, tolerance_mm=(-0.2, 0.4), index=index).range_mm == (-0.8, 0.8)
    with_stray = compute_statistics(compared(scanned(stray=[[50, 50, 1.9]])), FLAT)
    assert with_stray.range_mm == (-0.5, 0.5)


def test_the_shares_of_points_add_up(index):
    found = compute_statistics(index.found, FLAT, tolerance_mm=(-0.05, 0.05), index=index)
    assert found.below + found.inside + found.above == pytest.approx(1.0)
    xy = np.random.default_rng(3).uniform(0, 100, (200_000, 2))
    assert found.above == pytest.approx(np.mean(bumps(xy) > 0.05), abs=0.01)
    assert found.below == pytest.approx(np.mean(bumps(xy) < -0.05), abs=0.01)


def test_areas_without_data_have_their_reason():
    def keep(xy):
        return (xy[:, 0] < 80) | (xy[:, 1] > 50)  # a tenth of the plate was not seen

    points = scanned(keep=keep)
    rng = np.random.default_rng(2)
    high = np.column_stack([rng.uniform(0, 20, 2000), rng.uniform(0, 50, 2000), rng.normal(3.0, 0.01, 2000)])  # bent up by 3 mm
    low = ~((points.points_mm[:, 0] < 20) & (points.points_mm[:, 1] < 50))
    both = MeasuredPoints(np.vstack([points.points_mm[low], high]), np.tile([0, 0, 1.0], (int(low.sum()) + 2000, 1)))
    patch = np.array([[84, 4, 0], [96, 4, 0], [96, 46, 0], [84, 46, 0.0]])
    rows = [[x, y, 0.0] for x in np.arange(82, 100, 1.0) for y in np.arange(2, 25, 1.0)]
    filled = Mesh(np.vstack([patch, rows]), np.array([[0, 1, 2]]), "nominal", np.zeros(4 + len(rows), bool))
    found = compute_statistics(compared(both), FLAT, search_mm=1.5, surface=filled).no_data
    assert found.too_far == pytest.approx(0.09, abs=0.01)  # less the 1.5 mm along its border
    assert found.filled == pytest.approx(0.045, abs=0.01)
    assert found.not_seen == pytest.approx(0.045, abs=0.012)
    assert found.total == pytest.approx(0.19, abs=0.02)


def test_points_beyond_the_search_distance_are_counted_not_used():
    found = compute_statistics(compared(scanned(count=5000, stray=[[50, 50, 4.0]])), FLAT, search_mm=1.0)
    assert found.lost == 1 and found.points == 5000


def test_a_probe_states_value_points_and_uncertainty(index):
    found = probe_deviation(index, np.array([10.0, 80.0, 0.0]), 2.0, settings=ONLY_NOISE)
    assert found.points == pytest.approx(np.pi * 4 * 4, rel=0.4)
    assert found.uncertainty_mm == pytest.approx(2 * NOISE / np.sqrt(found.points), rel=0.5)
    assert abs(found.value_mm) <= 2 * found.uncertainty_mm


def test_the_intervals_of_probes_contain_the_truth_as_often_as_stated(index):
    places = np.random.default_rng(5).uniform([5, 75], [95, 95], (150, 2))  # where the plate is flat
    probes = [probe_deviation(index, np.array([*place, 0.0]), 1.5, settings=ONLY_NOISE) for place in places]
    assert np.mean([abs(one.value_mm) <= one.uncertainty_mm for one in probes]) >= 0.88


def test_a_probe_states_what_it_assumes_and_refuses_holes(index):
    assert "assumed" in probe_deviation(index, np.array([50.0, 50.0, 0.0])).assumed
    with pytest.raises(InspectionError, match="Only"):
        probe_deviation(index, np.array([50.0, 150.0, 0.0]), 2.0)


def test_smoothing_states_its_radius_and_changes_no_value(index):
    before = index.found.distances_mm.copy()
    smooth = smooth_for_eye(index)
    assert smooth.radius_mm == pytest.approx(2 * index.spacing_mm)
    truth = bumps(index.found.points_mm[:, :2])
    assert np.std(smooth.distances_mm - truth) < 0.45 * np.std(before - truth)
    assert np.array_equal(before, index.found.distances_mm)


def test_smoothing_does_not_mix_the_sides_of_a_thin_wall():
    box = np.array([[x, y, z] for z in (0.0, 0.4) for y in (0, 30.0) for x in (0, 30.0)])
    faces = np.array([[4, 5, 7], [4, 7, 6], [0, 3, 1], [0, 2, 3]])
    wall = Mesh(box, faces, "nominal")
    rng = np.random.default_rng(1)
    xy = rng.uniform(1, 29, (6000, 2))
    top = np.arange(6000) < 3000
    points = np.column_stack([xy, np.where(top, 0.45, 0.05)])  # 0.05 too high on both sides
    normals = np.where(top[:, None], [0, 0, 1.0], [0, 0, -1.0])
    found = compute_deviation(MeasuredPoints(points, normals), wall, no_alignment())
    smooth = smooth_for_eye(DeviationIndex(found), 2.0).distances_mm
    assert smooth[top] == pytest.approx(0.05, abs=1e-5) and smooth[~top] == pytest.approx(-0.05, abs=1e-5)


def test_whiskers_reach_from_the_nominal_by_their_gain(index):
    cut = CuttingPlane.through(np.array([0, 30.0, 0]), np.array([0, 1.0, 0]))
    section = cut_section("y=30", index.found, NominalSurface(FLAT), cut, 1.0)
    made = section_whiskers(section)
    assert made.gain in (10.0, 20.0, 50.0) and np.abs(made.feet_mm[:, 2]).max() < 1e-6
    assert made.tips_mm[:, 2] == pytest.approx(made.gain * made.deviations_mm)
    assert made.counts.sum() == len(section.deviations_mm)
    top = made.deviations_mm.argmax()
    assert made.feet_mm[top, 0] == pytest.approx(30, abs=3) and made.deviations_mm[top] == pytest.approx(0.3, abs=3 * NOISE)
    assert section_whiskers(section, gain=7.0, spacing_mm=5.0).gain == 7.0


@pytest.mark.parametrize("count", [1, 3, 40, 200, 205])
def test_the_greatest_values_are_those_of_a_complete_sort_also_where_many_are_equal(count):
    values = np.round(np.random.default_rng(1).normal(size=200), 1)
    values[::7] = -np.inf
    assert list(_greatest(values, count)) == list(np.argsort(-values, kind="stable")[:count])
