"""Closest points of needles and stout triangles are as exact as double precision, whatever the hierarchy."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.inspection.surface.closest.boxes import MOST_PER_TRIANGLE, box_references
from measureapp.inspection.surface.closest.hierarchy import LEAF, TriangleHierarchy
from measureapp.inspection.surface.closest.reference import closest_on_triangles


def slender(count: int, foot: float, rng: np.random.Generator) -> np.ndarray:
    """Triangles up to 200 mm long and 0.02 to 2 mm high, with the foot of their height at a share of their length, turned anyhow."""
    length, height = rng.uniform(20, 200, count), rng.uniform(0.02, 2, count)
    flat = np.zeros((count, 3, 3))
    flat[:, 1, 0] = length
    flat[:, 2, 0], flat[:, 2, 1] = foot * length, height
    turn = np.linalg.qr(rng.standard_normal((count, 3, 3)))[0]
    shuffled = np.stack([flat[k, rng.permutation(3)] for k in range(count)])
    return np.asarray(shuffled @ turn + rng.uniform(-300, 300, (count, 1, 3)))


def some_triangles(kind: str, rng: np.random.Generator) -> np.ndarray:
    if kind == "stout":
        return rng.uniform(-100, 100, (90, 1, 3)) + rng.uniform(-20, 20, (90, 3, 3))
    return slender(90, float(kind), rng)


def near(corners: np.ndarray, count: int, spread_mm: float, rng: np.random.Generator) -> np.ndarray:
    """Points around random places of the triangles, many of them at corners and edges."""
    weights = rng.dirichlet([0.2, 0.2, 0.2], count)
    places = np.einsum("nk,nkd->nd", weights, corners[rng.integers(len(corners), size=count)])
    return np.asarray(places + rng.normal(0, spread_mm, (count, 3)))


def distances(points: np.ndarray, corners: np.ndarray, found: tuple[np.ndarray, np.ndarray]) -> np.ndarray:
    return np.asarray(np.linalg.norm(np.einsum("nk,nkd->nd", found[1], corners[found[0]]) - points, axis=1))


@pytest.mark.parametrize("kind", ["stout", "0.0", "0.001", "0.3", "1.0"])
@pytest.mark.parametrize("spread_mm", [0.01, 30.0])
def test_the_closest_point_is_that_of_every_triangle_tried(kind: str, spread_mm: float) -> None:
    rng = np.random.default_rng(4)
    corners = some_triangles(kind, rng)
    points = near(corners, 600, spread_mm, rng)
    found = TriangleHierarchy(corners).closest(points)
    shapes = np.stack([corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=1)
    exact = distances(points, corners, closest_on_triangles(points, shapes))
    assert np.abs(distances(points, corners, found) - exact).max() < 1e-8  # (length / height)² · 1e-16 · length
    assert found[1].min() > -1e-9
    assert np.allclose(found[1].sum(axis=1), 1)


@pytest.mark.parametrize("kind", ["stout", "0.001", "1.0"])
def test_a_triangle_that_was_near_before_changes_no_answer(kind: str) -> None:
    """Whether it is the closest still, or far away."""
    rng = np.random.default_rng(6)
    corners = some_triangles(kind, rng)
    points = near(corners, 400, 5.0, rng)
    hierarchy = TriangleHierarchy(corners)
    plain = hierarchy.closest(points)
    for likely in (plain[0], rng.integers(len(corners), size=len(points)), np.full(len(points), -1)):
        found = hierarchy.closest(points, likely)
        np.testing.assert_allclose(distances(points, corners, found), distances(points, corners, plain), rtol=0, atol=1e-9)
        assert (found[0] == plain[0]).mean() > 0.99  # on an edge both of its triangles are as near


@pytest.mark.parametrize("kind", ["stout", "0.0", "0.001", "0.3", "0.5", "1.0"])
def test_each_place_of_a_triangle_lies_in_one_of_its_boxes(kind: str) -> None:
    rng = np.random.default_rng(6)
    corners = some_triangles(kind, rng)
    boxes = box_references(corners)
    assert set(boxes.triangles) == set(range(len(corners)))
    assert len(boxes.triangles) <= (MOST_PER_TRIANGLE + 1) * len(corners)
    for k, triangle in enumerate(corners):
        places = rng.dirichlet([0.5, 0.5, 0.5], 200) @ triangle
        own = boxes.triangles == k
        inside = (places[:, None] >= boxes.low_mm[own]) & (places[:, None] <= boxes.high_mm[own])
        assert inside.all(axis=2).any(axis=1).all()


def test_stout_triangles_have_one_box_and_needles_have_smaller_ones() -> None:
    rng = np.random.default_rng(7)
    assert len(box_references(some_triangles("stout", rng)).triangles) < 120
    needles = box_references(slender(90, 0.2, rng))
    size = np.linalg.norm(needles.high_mm - needles.low_mm, axis=1)
    assert np.median(size) < 60  # whole ones are 110 mm long on average


@pytest.mark.parametrize("count", [1, LEAF, 5])
def test_few_triangles_make_a_hierarchy_as_well(count: int) -> None:
    rng = np.random.default_rng(8)
    corners = some_triangles("stout", rng)[:count]
    points = near(corners, 50, 5.0, rng)
    found = TriangleHierarchy(corners).closest(points)
    assert set(found[0]) <= set(range(count))
    assert len(TriangleHierarchy(corners).closest(np.empty((0, 3)))[0]) == 0


def test_the_reference_can_be_selected(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(9)
    corners = some_triangles("0.3", rng)
    points = near(corners, 50, 1.0, rng)
    compiled = distances(points, corners, TriangleHierarchy(corners).closest(points))
    monkeypatch.setenv("MEASUREAPP_KERNELS", "reference")
    assert np.allclose(distances(points, corners, TriangleHierarchy(corners).closest(points)), compiled, atol=1e-8)
