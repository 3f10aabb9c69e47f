from __future__ import annotations

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.cloud import PointCloud, concatenate_clouds
from measureapp.register.clouds.quality import assess_cloud, point_spacing_mm
from measureapp.register.merge import merge
from measureapp.register.settings import QualitySettings

ABOVE = np.array([0.0, 0.0, 500.0])


def plane(count: int, sigma_mm: float, seed: int, *, height_mm: float = 0.0, up: float = 1.0, half_mm: float = 30.0) -> PointCloud:
    rng = np.random.default_rng(seed)
    points = np.column_stack([rng.uniform(-half_mm, half_mm, (count, 2)), height_mm + rng.normal(0, sigma_mm, count)])
    normals = np.column_stack([rng.normal(0, 0.03, (count, 2)), np.full(count, up)])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return PointCloud(
        points, normals, np.full(count, sigma_mm), np.full(count, 0.5), np.full((count, 2), -1), np.ones(count), "part", f"v{seed}"
    )


def test_merging_lowers_the_noise_as_predicted():
    views = [plane(15_000, 0.04, seed) for seed in range(6)]
    merged = merge(views, [ABOVE] * 6, 0.5)
    predicted = float(np.sqrt(np.mean(merged.sigma_mm.astype(float) ** 2)))
    assert merged.points_mm[:, 2].std() == pytest.approx(predicted, rel=0.1)
    assert predicted < 0.04 / 2
    assert abs(merged.points_mm[:, 2].mean()) < 4 * 0.04 / np.sqrt(90_000)


@pytest.mark.parametrize(("radius_mm", "outwards"), [(5.0, 1.0), (5.0, -1.0), (45.0, 1.0)])
def test_merged_points_lie_on_a_curved_surface_not_inside_it(radius_mm: float, outwards: float):
    """Means over columns of 0.5 mm would lie 0.5² / 24 R and more inside, 2.1 µm of a radius of 5 mm."""
    rng = np.random.default_rng(4)
    around, up = rng.uniform(-np.pi, np.pi, 200_000), rng.uniform(-6, 6, 200_000)
    normals = np.column_stack([np.cos(around), np.sin(around), np.zeros(len(around))])
    points = radius_mm * normals + np.column_stack([np.zeros((len(up), 2)), up]) + 0.005 * rng.normal(size=(len(up), 1)) * normals
    tilted = outwards * normals + rng.normal(0, 0.02, points.shape)
    tilted /= np.linalg.norm(tilted, axis=1, keepdims=True)
    same = np.full(len(up), 0.005)
    cloud = PointCloud(points, tilted, same, same, np.full((len(up), 2), -1), np.ones(len(up)), "part", "v")
    merged = merge([cloud], [np.array([0.0, 0.0, 500.0])], 0.5)
    radii = np.hypot(merged.points_mm[:, 0], merged.points_mm[:, 1])
    assert abs(np.median(radii) - radius_mm) < max(0.05 * 0.5**2 / 24 / radius_mm, 4 * 0.005 / np.sqrt(len(up)))


def test_the_better_view_weighs_more():
    merged = merge([plane(20_000, 0.01, 1, height_mm=0.1), plane(20_000, 0.1, 2)], [ABOVE] * 2, 1.0)
    assert merged.points_mm[:, 2].mean() == pytest.approx(0.1 * 100 / 101, abs=0.003)
    assert np.mean(merged.view == 0) > 0.99


def test_the_two_sides_of_a_thin_wall_never_mix():
    merged = merge([plane(20_000, 0.02, 1, height_mm=1.0), plane(20_000, 0.02, 2, up=-1.0)], [ABOVE, -ABOVE], 0.6)
    top = merged.normals[:, 2] > 0
    assert np.abs(merged.points_mm[top, 2] - 1).max() < 0.12
    assert np.abs(merged.points_mm[~top, 2]).max() < 0.12


def test_isolated_patches_and_single_points_are_removed():
    stray = plane(40, 0.02, 3, height_mm=60.0, half_mm=1.0)
    alone = plane(20, 0.02, 4, height_mm=-40.0)
    merged = merge([plane(20_000, 0.02, 1), stray, alone], [ABOVE] * 3, 0.6, island_mm2=15)
    assert np.abs(merged.points_mm[:, 2]).max() < 1


def test_spacing_density_and_noise_are_those_the_cloud_was_made_with():
    cloud = plane(18_000, 0.04, 1)
    quality = assess_cloud(cloud)
    assert quality.density_per_mm2 == pytest.approx(5.0, rel=0.1)
    assert point_spacing_mm(np.asarray(cloud.points_mm)) == pytest.approx(1 / np.sqrt(5), rel=0.05)
    assert quality.noise_mm == pytest.approx(0.04, rel=0.1)
    assert quality.outlier_ratio < 0.01
    assert quality.accepted and quality.reason == ""


def test_a_large_cloud_is_assessed_by_a_sample_to_the_same_figures():
    quality = assess_cloud(plane(400_000, 0.04, 2, half_mm=140.0))
    assert quality.density_per_mm2 == pytest.approx(400_000 / 280**2, rel=0.1)
    assert quality.noise_mm == pytest.approx(0.04, rel=0.1)


def test_a_poor_cloud_is_refused_with_every_reason():
    quality = assess_cloud(plane(3_000, 0.3, 1, half_mm=60), QualitySettings(plane_radius_mm=6.0), completeness=0.01)
    assert not quality.accepted
    assert "per mm²" in quality.reason and "noise" in quality.reason and "visible surface" in quality.reason


def test_outliers_are_counted():
    rng = np.random.default_rng(5)
    clean = plane(10_000, 0.02, 1)
    points = np.array(clean.points_mm)
    wrong = rng.choice(len(points), 1000, replace=False)
    points[wrong, 2] += rng.uniform(5, 40, 1000) * rng.choice([-1, 1], 1000)
    spoiled = PointCloud(points, clean.normals, clean.sigma_mm, clean.grey, clean.pixel, clean.cameras, "part", "v")
    assert assess_cloud(spoiled).outlier_ratio == pytest.approx(0.1, abs=0.03)


def test_a_cloud_of_a_few_points_is_refused():
    assert assess_cloud(plane(20, 0.02, 1)).reason == "only 20 points"


def waving(cloud: PointCloud, height_mm: float, period_mm: float) -> PointCloud:
    points = np.array(cloud.points_mm)
    phase = 2 * np.pi * points[:, 0] / period_mm
    points[:, 2] += height_mm * np.sin(phase)
    slope = 2 * np.pi / period_mm * height_mm * np.cos(phase)
    normals = np.column_stack([-slope, np.zeros(len(slope)), np.ones(len(slope))]) / np.sqrt(1 + slope**2)[:, None]
    return replace(cloud, points_mm=points, normals=normals)


def test_waviness_is_separated_from_noise_and_excluded():
    clean = assess_cloud(plane(18_000, 0.04, 1))
    wavy = assess_cloud(waving(plane(18_000, 0.04, 1), 0.25, 8.0))
    # a cell of 4 mm² holds 18 points, whose median has σ √(π/36); the variance of 28 such medians about six terms is known to √(2/22), and
    # the worst tenth of 200 patches lies 1.3 of these deviations above the mean; twice that for cells that are not whole
    assert clean.distortion_mm < 0.04 * np.sqrt(np.pi / 36) * np.sqrt(2 * 1.3 * np.sqrt(2 / 22))
    assert clean.accepted
    # the quadric follows the wave in part, the worst patches least: no more than the wave itself, and not far less
    assert 0.6 * 0.25 / np.sqrt(2) < wavy.distortion_mm < 1.15 * 0.25
    assert not wavy.accepted and "surface distortion of" in wavy.reason


def test_curvature_and_edges_are_no_distortion():
    rng = np.random.default_rng(3)
    direction = rng.normal(size=(60_000, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    ball = plane(60_000, 0.02, 1)
    ball = replace(ball, points_mm=direction * (25 + rng.normal(0, 0.02, 60_000))[:, None], normals=direction)
    upright = plane(18_000, 0.02, 2)
    turned = replace(upright, points_mm=np.asarray(upright.points_mm)[:, [2, 1, 0]], normals=np.asarray(upright.normals)[:, [2, 1, 0]])
    for cloud in (ball, concatenate_clouds([plane(18_000, 0.02, 1), turned])):
        assert assess_cloud(cloud).distortion_mm < 0.05


def test_merging_needs_less_than_twice_the_memory_of_the_clouds() -> None:
    """Measured 75 bytes of a point, three quarters of which are the clouds of two threads being added up."""
    views = [plane(60_000, 0.04, seed) for seed in range(12)]
    merge(views[:2], [ABOVE] * 2, 0.25)
    tracemalloc.start()
    merged = merge(views, [ABOVE] * 12, 0.25)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(merged.points_mm) > 50_000
    assert peak / sum(len(view) for view in views) < 2 * 53
