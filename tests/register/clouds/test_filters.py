"""Filters drop what they say, and what they drop depends neither on the points' order nor on the unit of length."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.errors import RegistrationError
from measureapp.progress import CallbackProgress, Cancelled
from measureapp.register.clouds import filters
from measureapp.register.clouds.filter_chain import Filter

SPACING = 0.5


@pytest.fixture(scope="module")
def cloud() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A plate of 40 x 40 mm², a patch of 2 x 2 mm² above it, and single points far from both; with masks of patch and single points."""
    rng = np.random.default_rng(1)
    u, v = np.meshgrid(np.arange(0, 40, SPACING), np.arange(0, 40, SPACING))
    plate = np.column_stack([u.ravel(), v.ravel(), np.zeros(u.size)])
    p, q = np.meshgrid(np.arange(0, 2, SPACING), np.arange(0, 2, SPACING))
    patch = np.column_stack([p.ravel() + 10, q.ravel() + 10, np.full(p.size, 15.0)])
    alone = np.column_stack([10.0 * np.arange(8), np.full(8, 20.0), np.full(8, 40.0)])
    points = np.vstack([plate + rng.normal(0, 0.02, plate.shape), patch, alone])
    number = np.arange(len(points))
    return points, (number >= len(plate)) & (number < len(plate) + len(patch)), number >= len(plate) + len(patch)


BY_NAME: dict[str, Callable[[np.ndarray, float], np.ndarray]] = {
    "statistical": lambda points, unit: filters.statistical_inliers(points, 8, 2.0),
    "crowded": lambda points, unit: filters.radius_inliers(points, 1.2 * unit, 3),
    "box": lambda points, unit: filters.in_box(points, np.array([5.0, 5, -1]) * unit, np.array([30.0, 30, 20]) * unit),
    "plane": lambda points, unit: filters.above_plane(points, np.array([0, 0, 7.0]), 5.0 * unit),
    "patches": lambda points, unit: filters.in_large_components(points, SPACING * unit, 10.0 * unit**2),
}


def test_single_points_go_and_the_surface_stays(cloud) -> None:
    points, patch, alone = cloud
    for name in ("statistical", "crowded"):
        kept = BY_NAME[name](points, 1.0)
        assert not kept[alone].any()
        assert kept[~alone & ~patch].mean() > 0.99


def test_a_patch_goes_by_its_area(cloud) -> None:
    points, patch, alone = cloud
    area = patch.sum() * SPACING**2
    small, large = filters.in_large_components(points, SPACING, area * 1.01), filters.in_large_components(points, SPACING, area * 0.99)
    assert not small[patch].any() and large[patch].all()
    assert not large[alone].any() and small[~patch & ~alone].all()


def test_cuts_keep_what_lies_inside(cloud) -> None:
    points, patch, alone = cloud
    assert np.array_equal(BY_NAME["plane"](points, 1.0), patch | alone)
    box = BY_NAME["box"](points, 1.0)
    assert box[patch].all() and not box[alone].any()
    assert (points[box][:, :2] >= 5).all() and (points[box][:, :2] <= 30).all()


@pytest.mark.parametrize("name", BY_NAME)
def test_neither_order_nor_unit_matters(cloud, name: str) -> None:
    points = cloud[0]
    order = np.random.default_rng(2).permutation(len(points))
    kept = BY_NAME[name](points, 1.0)
    assert np.array_equal(BY_NAME[name](points[order], 1.0), kept[order])
    assert np.array_equal(BY_NAME[name](points / 1000, 1 / 1000), kept)


@pytest.mark.parametrize("count", [0, 1])
def test_clouds_of_no_points_are_refused_or_stay_empty(count: int) -> None:
    points = np.zeros((count, 3))
    with pytest.raises(RegistrationError, match=f"A cloud of {count} points has no point with"):
        filters.statistical_inliers(points)
    with pytest.raises(RegistrationError, match=f"A cloud of {count} points has no point with"):
        filters.radius_inliers(points, 1.0, 3)
    assert len(filters.in_large_components(points, 1.0, 0.5)) == count


def test_a_plane_without_a_direction_is_refused() -> None:
    with pytest.raises(RegistrationError, match="normal is 0 0 0"):
        filters.above_plane(np.zeros((3, 3)), np.zeros(3), 0.0)


@pytest.mark.parametrize("kind", ["statistical", "radius"])
def test_a_filter_can_be_cancelled_in_the_middle_of_a_large_cloud(kind, monkeypatch):
    monkeypatch.setattr(filters, "CHUNK", 100)
    points = np.random.default_rng(1).uniform(0, 10, (1000, 3))
    heard = []

    def listen(done, total, _note):
        heard.append(done / total)
        if done / total > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        Filter(kind, (2.0, 5)).mask(points, CallbackProgress(listen))
    assert heard == pytest.approx([0.0, *np.arange(0, 0.61, 0.1)])


def test_pieces_of_a_large_cloud_are_filtered_as_the_whole(monkeypatch):
    points = np.random.default_rng(2).uniform(0, 10, (1000, 3))
    asked = (Filter("statistical", (1.0, 8)), Filter("radius", (1.5, 9)))
    whole = [one.mask(points) for one in asked]
    monkeypatch.setattr(filters, "CHUNK", 77)
    assert all(np.array_equal(one.mask(points), before) for one, before in zip(asked, whole, strict=True))
    assert all(0 < mask.sum() < len(points) for mask in whole)
