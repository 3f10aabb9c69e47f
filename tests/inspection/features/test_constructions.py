"""Constructed features: exact on exact parents, and with the covariance of repeated measurements, shared parents included."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.data.feature_program import ConstructedFeature
from measureapp.data.inspection_program import InspectionProgram
from measureapp.geometry.feature import Feature
from measureapp.geometry.fits import fit as fit_shape
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.features.construct import construct
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

ONLY_SCATTER = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
NOISE = 0.05


def plane(name, point, normal):
    normal = np.asarray(normal, float)
    return Feature(name, "plane", np.asarray(point, float), normal / np.linalg.norm(normal))


def axis(name, point, direction):
    direction = np.asarray(direction, float)
    return Feature(name, "cylinder", np.asarray(point, float), direction / np.linalg.norm(direction), 5.0)


def centre(name, point):
    return Feature(name, "sphere", np.asarray(point, float), None, 3.0)


def made(shape, *parents, **more):
    described = ConstructedFeature(name="new", shape=shape, of=tuple(one.name for one in parents), **more)
    return construct(described, {one.name: FoundFeature(one.name, one, nominal=one) for one in parents})["new"]


TOP, FRONT, SIDE = plane("top", [1, 2, 30], [0, 0, 1]), plane("front", [0, -20, 5], [0, -1, 0]), plane("side", [40, 1, 7], [1, 0, 0])


def test_three_planes_meet_in_a_point():
    assert made("intersection", TOP, FRONT, SIDE).feature.point_mm == pytest.approx([40, -20, 30])
    again = made("intersection", TOP, FRONT, plane("low", [0, 0, 0], [0, 0, -1]))
    assert again.feature is None and "parallel" in again.reason


def test_symmetry_of_inclined_planes_bisects_their_angle():
    one, other = plane("one", [0, 0, 0], [-np.sin(0.2), 0, np.cos(0.2)]), plane("other", [0, 0, 0], [-np.sin(0.2), 0, -np.cos(0.2)])
    found = made("symmetry", one, other).feature
    assert abs(found.direction[2]) == pytest.approx(1.0) and found.point_mm[2] == pytest.approx(0.0)


def test_symmetry_of_two_axes_lies_midway_and_skew_ones_are_refused():
    found = made("symmetry", axis("a", [0, 0, 0], [0, 0, 1]), axis("b", [10, 4, 3], [0, 0, -1])).feature
    assert found.shape == "line" and found.point_mm[:2] == pytest.approx([5, 2])
    assert "parallel" in made("symmetry", axis("a", [0, 0, 0], [0, 0, 1]), axis("b", [10, 4, 3], [0, 1, 0])).reason


def test_a_mid_plane_lies_between_faces_and_never_across_axes():
    assert made("midplane", TOP, plane("low", [0, 0, 10], [0, 0, -1])).feature.point_mm[2] == pytest.approx(20.0)
    refused = made("midplane", axis("hub", [0, 0, 0], [0, 0, 1]), axis("bore", [0, 0, 20], [0, 0, 1]))
    assert refused.feature is None and "two planes" in refused.reason


def test_an_offset_plane_and_a_point_on_an_axis_lie_at_their_distance():
    assert made("offset", TOP, distance_mm=-2.5).feature.point_mm == pytest.approx([1, 2, 27.5])
    bore = axis("bore", [3, 4, 0], [0, 0, -1])
    assert made("point_on_axis", bore, TOP, distance_mm=-10).feature.point_mm == pytest.approx([3, 4, 20])


def test_lines_planes_and_circles_go_through_their_points():
    corners = [centre(f"p{k}", [20 * np.cos(k), 20 * np.sin(k), 4]) for k in range(5)]
    found = made("best_fit_circle", *corners).feature
    assert found.radius_mm == pytest.approx(20) and found.point_mm == pytest.approx([0, 0, 4], abs=1e-9)
    assert abs(made("best_fit_plane", *corners).feature.direction[2]) == pytest.approx(1)
    row = [centre(f"r{k}", [10 * k, 3, 0]) for k in range(3)]
    assert made("best_fit_line", *row).feature.direction == pytest.approx([1, 0, 0])
    assert "one line" in made("best_fit_plane", *row).reason
    assert "no point" in made("best_fit_line", TOP, row[0]).reason


def test_a_pitch_circle_goes_through_the_axes_of_its_holes():
    holes = [axis(f"h{k}", [30 * np.cos(k) + 1, 30 * np.sin(k) - 2, 5 * k], [0, 0, (-1) ** k]) for k in range(6)]
    found = made("pitch_circle", *holes).feature
    assert found.radius_mm == pytest.approx(30) and found.point_mm[:2] == pytest.approx([1, -2]) and found.shape == "circle"


def test_wrong_numbers_of_parents_are_refused():
    with pytest.raises(ValidationError, match="needs 2 to 3"):
        ConstructedFeature(name="n", shape="intersection", of=("a",))
    with pytest.raises(ValidationError, match="distance_mm"):
        ConstructedFeature(name="n", shape="offset", of=("a",))
    with pytest.raises(ValidationError, match="at least 3"):
        ConstructedFeature(name="n", shape="pitch_circle", of=("a", "b"))


def test_a_missing_parent_is_named():
    described = ConstructedFeature(name="n", shape="midpoint", of=("a", "b"))
    known = {"a": FoundFeature("a", None, "a: only 3 points"), "b": FoundFeature("b", centre("b", [0, 0, 0]))}
    found = construct(described, known)["n"]
    assert found.feature is None and found.reason == "a: only 3 points"


def patch(rng, point, normal, along, half, count):
    normal, along = np.asarray(normal, float), np.asarray(along, float)
    u, v = rng.uniform(-half, half, (2, count))
    points = np.asarray(point, float) + u[:, None] * along + v[:, None] * np.cross(normal, along)
    return points + NOISE * rng.standard_normal((count, 1)) * normal, np.tile(normal, (count, 1))


def holes(rng, count=4, radius=30.0):
    points, normals = [], []
    for k in range(count):
        turn, z = rng.uniform(0, 2 * np.pi, 200), rng.uniform(-5, 5, 200)
        out = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(200)])
        angle = 2 * np.pi * k / count
        wall = 4 * out + np.column_stack([np.zeros((200, 2)), z]) + radius * np.array([np.cos(angle), np.sin(angle), 0])
        points.append(wall + NOISE * rng.standard_normal((200, 1)) * out)
        normals.append(-out)
    return np.vstack(points), np.vstack(normals)


PROGRAM = {
    "name": "p",
    "alignment": "none",
    "features": [
        {"name": "top", "shape": "plane", "point_mm": [0, 0, 20], "direction": [0, 0, 1], "cut": {"radial_mm": [0, 20]}},
        {"name": "front", "shape": "plane", "point_mm": [0, -60, 0], "direction": [0, -1, 0], "cut": {"radial_mm": [0, 20]}},
        {"name": "side", "shape": "plane", "point_mm": [60, 0, 0], "direction": [1, 0, 0], "cut": {"radial_mm": [0, 20]}},
        {
            "name": "hole",
            "shape": "cylinder",
            "point_mm": [30, 0, 0],
            "direction": [0, 0, 1],
            "radius_mm": 4,
            "hole": True,
            "cut": {"along_mm": [-6, 6]},
            "repeat": {"count": 4, "angle_deg": 90},
        },
        {"name": "corner", "shape": "intersection", "of": ["top", "front", "side"]},
        {"name": "ring", "shape": "pitch_circle", "of": ["hole.{k}"], "count": 4},
        {"name": "raised", "shape": "offset", "of": ["top"], "distance_mm": 5},
        {"name": "on axis", "shape": "point_on_axis", "of": ["hole.1", "top"], "distance_mm": -10},
    ],
    "dimensions": [
        {"name": "pitch", "kind": "diameter", "features": ["ring"], "nominal": 60},
        {"name": "spacing", "kind": "distance", "features": ["hole.{k}", "hole.{k+1}"], "count": 4, "nominal": 42.426},
        {"name": "corner to hole", "kind": "distance", "features": ["corner", "on axis"], "nominal": 67.823},
        {"name": "shared", "kind": "distance", "features": ["raised", "top"], "nominal": 5},
    ],
}
TRUTH = {"pitch": 60.0, "spacing": 30 * np.sqrt(2), "corner to hole": float(np.linalg.norm([30, -60, 10])), "shared": 5.0}


def measured(seed):
    rng = np.random.default_rng(seed)
    faces = [
        patch(rng, [0, 0, 20], [0, 0, 1], [1, 0, 0], 12, 300),
        patch(rng, [0, -60, 0], [0, -1, 0], [1, 0, 0], 12, 300),
        patch(rng, [60, 0, 0], [1, 0, 0], [0, 1, 0], 12, 300),
        holes(rng),
    ]
    points = MeasuredPoints(np.vstack([one[0] for one in faces]), np.vstack([one[1] for one in faces]))
    program = InspectionProgram.model_validate(PROGRAM)
    return {one.name: one for one in inspect(points, program, settings=ONLY_SCATTER).dimensions}


@pytest.mark.parametrize("count", [16, pytest.param(40, marks=pytest.mark.slow)])
def test_stated_uncertainties_are_those_of_repeated_measurements(count):
    draws = [measured(seed) for seed in range(count)]
    for name, true in TRUTH.items():
        errors = np.array([draw[name].measured - true for draw in draws])
        stated = np.median([draw[name].uncertainty for draw in draws])
        if name == "shared":  # the error of the parent cancels completely
            assert np.abs(errors).max() < 1e-9 and stated < 1e-4
            continue
        assert np.mean(np.abs(errors) <= [draw[name].uncertainty for draw in draws]) >= 0.954 - 3.1 * np.sqrt(0.954 * 0.046 / count)
        assert stated == pytest.approx(2 * errors.std(), rel=4 / np.sqrt(2 * count))  # four standard deviations of a sampled one


def test_a_common_datum_of_two_seats_is_the_axis_through_both():
    found = made("common_datum", axis("left", [0, 0.02, 0], [1, 0, 0]), axis("right", [200, -0.02, 0], [-1, 0, 0])).feature
    assert found.shape == "line" and found.point_mm == pytest.approx([100, 0, 0])
    assert found.direction == pytest.approx([1, -0.0002, 0], abs=1e-7)  # not along the seats, but from one to the other
    assert "5.000 mm from one line" in made("common_datum", axis("left", [0, 0, 0], [1, 0, 0]), axis("off", [20, 5, 0], [1, 0, 0])).reason
    assert "90.0° from parallel" in made("common_datum", axis("left", [0, 0, 0], [1, 0, 0]), axis("up", [20, 0, 0], [0, 0, 1])).reason


def test_a_common_datum_is_the_fit_to_the_points_of_both_faces():
    rng = np.random.default_rng(4)
    parts = []
    for x, size, lean in ((0, 10, 2e-4), (70, 25, -1e-4)):
        flat = rng.uniform(-size, size, (400 * size, 2)) + np.array([x, 0])
        parts.append(np.column_stack([flat, 0.01 * rng.normal(size=len(flat)) + lean * (flat[:, 0] - x)]))
    fits = [replace(fit_shape("plane", points), name=f"face {number}") for number, points in enumerate(parts)]
    both = fit_shape("plane", np.vstack(parts))
    found = made("common_datum", *fits).feature
    assert found.shape == "plane"
    assert np.cross(found.direction, both.direction) == pytest.approx(np.zeros(3), abs=2e-6)  # the faces lean by a hundred times that
    assert abs((found.point_mm - both.point_mm) @ both.direction) < 2e-4
