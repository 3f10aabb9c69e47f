"""Regions grown from a seed on faces whose points are known: what they hold, where they end, and when they are refused."""

from __future__ import annotations

import re

import numpy as np
import pytest

from measureapp.data.inspection_program import InspectionProgram
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.find_features import find_features
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings

SPACING_MM, HALF_MM, FORM_MM = 0.5, 20.0, 0.02
BEND_DEG = 10.0
ALL_POINTS = InspectionSettings(fit_points=200_000)


class Faces:
    """Faces of even points with noise along their normals; ``face`` tells which one a point lies on."""

    def __init__(self, noise_mm: float, seed: int = 1) -> None:
        self.rng, self.noise_mm = np.random.default_rng(seed), noise_mm
        self.points: list[np.ndarray] = []
        self.normals: list[np.ndarray] = []

    def plane(self, corner, along, across, length_mm=2 * HALF_MM, width_mm=2 * HALF_MM) -> None:
        along, across = np.asarray(along, float), np.asarray(across, float)
        u, v = (
            axis.ravel() for axis in np.meshgrid(np.arange(0, length_mm, SPACING_MM), np.arange(0, width_mm, SPACING_MM), indexing="ij")
        )
        u, v = u + self.rng.uniform(-0.2, 0.2, u.shape), v + self.rng.uniform(-0.2, 0.2, u.shape)
        self._add(np.asarray(corner, float) + np.outer(u, along) + np.outer(v, across), np.cross(along, across))

    def cylinder(self, centre, radius_mm, length_mm, start=0.0, end=2 * np.pi) -> None:
        turn, height = (
            axis.ravel()
            for axis in np.meshgrid(np.arange(start, end, SPACING_MM / radius_mm), np.arange(0, length_mm, SPACING_MM), indexing="ij")
        )
        outward = np.column_stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)])
        self._add(np.asarray(centre, float) + radius_mm * outward + height[:, None] * np.array([0, 0, 1.0]), outward)

    def ball(self, centre, radius_mm) -> None:
        count = int(2 * np.pi * radius_mm**2 / SPACING_MM**2)
        outward = self.rng.standard_normal((count, 3))
        outward[:, 2] = np.abs(outward[:, 2])
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        self._add(np.asarray(centre, float) + radius_mm * outward, outward)

    def _add(self, points, normals) -> None:
        normals = np.broadcast_to(normals, points.shape)
        self.points.append(points + self.noise_mm * self.rng.standard_normal((len(points), 1)) * normals)
        self.normals.append(normals)

    def measured(self, normals: bool = True) -> MeasuredPoints:
        return MeasuredPoints(np.vstack(self.points), np.vstack(self.normals) if normals else None)


def bent(noise_mm: float, seed: int = 1) -> Faces:
    """A top (z = 0, |x|, |y| < 20), beyond x = 20 a face that falls by 10°, beyond x = -20 one by 90°, and a shaft beside them."""
    made = Faces(noise_mm, seed)
    fall = np.radians(BEND_DEG)
    made.plane([-HALF_MM, -HALF_MM, 0], [1, 0, 0], [0, 1, 0])
    made.plane([HALF_MM, -HALF_MM, 0], [np.cos(fall), 0, -np.sin(fall)], [0, 1, 0])
    made.plane([-HALF_MM, -HALF_MM, -2 * HALF_MM], [0, 0, 1], [0, 1, 0])
    made.cylinder([200, 0, -30], 8.0, 30.0)
    return made


def grown(points: MeasuredPoints, shape: str, seed_mm, cut=None, **more) -> FoundFeature:
    described = {"name": "f", "shape": shape, "grow": {"seed_mm": list(seed_mm), "form_mm": FORM_MM, **more}, "cut": cut or {}}
    program = InspectionProgram.model_validate({"name": "p", "alignment": "none", "features": [described]})
    return find_features(points, program, None, ALL_POINTS)["f"]


def members(found: FoundFeature, points: MeasuredPoints) -> np.ndarray:
    """Which points the region holds, those left out of the fit aside."""
    held = {tuple(point) for point in found.points_mm}
    return np.array([tuple(point) in held for point in points.points_mm])


@pytest.mark.parametrize("noise_mm", [0.005, 0.02, 0.06])
@pytest.mark.parametrize("normals", [True, False])
def test_a_plane_grows_to_its_edges_and_no_further_than_the_noise_hides_them(noise_mm: float, normals: bool) -> None:
    points = bent(noise_mm).measured(normals)
    found = grown(points, "plane", [3, 4, 0.5])
    assert found.feature is not None, found.reason
    limit = FORM_MM + 3.5 * noise_mm * 1.1  # the noise is estimated from 100 points: to 7 %
    inside = members(found, points)
    # a point of the face that falls by 10° lies x·sin 10° below the top, and its own noise lifts it by no more than 4 σ
    furthest = HALF_MM + (limit + 4 * noise_mm) / np.sin(np.radians(BEND_DEG))
    assert points.points_mm[inside, 0].max() < furthest
    assert points.points_mm[inside, 2].min() > -limit - 4 * noise_mm
    # the neighbours of a normal reach over the edge by a few spacings: only there may points of the top be missing
    held = np.abs(points.points_mm[:, :2]).max(axis=1) < HALF_MM - 6 * SPACING_MM
    held &= np.abs(points.points_mm[:, 2]) < 3.5 * noise_mm
    assert inside[held].mean() > 0.98
    # what leaks lies below by less than the limit: it turns the plane by no more than that over half its width
    off = np.linalg.norm(found.feature.direction[:2])
    leaked = np.mean(points.points_mm[inside, 0] > HALF_MM)
    assert off < 4 * noise_mm / (HALF_MM / np.sqrt(3) * np.sqrt(inside.sum())) + 3 * leaked * limit / HALF_MM
    assert abs(found.feature.point_mm[2]) < 4 * noise_mm / np.sqrt(inside.sum()) + leaked * limit + off * HALF_MM
    assert abs(found.feature.direction[2]) > 0.999 and (not normals or found.feature.direction[2] > 0)
    assert "grown from seed" in found.feature.how and "surface tilted" in found.feature.how


@pytest.mark.parametrize(("radius_mm", "turn_deg", "noise_mm"), [(8.0, 360, 0.02), (40.0, 360, 0.02), (40.0, 90, 0.02), (40.0, 60, 0.05)])
def test_a_cylinder_is_grown_without_any_nominal(radius_mm: float, turn_deg: float, noise_mm: float) -> None:
    made = Faces(noise_mm)
    made.cylinder([0, 0, 0], radius_mm, 40.0, 0.0, np.radians(turn_deg))
    made.plane([-60, -60, -0.25], [0, 1, 0], [1, 0, 0], 120, 120)  # a floor that it stands on
    points = made.measured()
    middle = np.radians(turn_deg / 2)
    seed = [radius_mm * np.cos(middle), radius_mm * np.sin(middle), 20]
    found = grown(points, "cylinder", seed)
    assert found.feature is not None and found.feature.radius_mm is not None, found.reason
    assert abs(found.feature.radius_mm - radius_mm) < 4 * found.feature.standard_deviations["radius_mm"]
    assert abs(found.feature.direction[2]) > np.cos(4 * found.feature.standard_deviations["direction_rad"])
    assert len(found.points_mm) > 0.9 * len(made.points[0])
    assert np.hypot(*found.points_mm[:, :2].T).max() < radius_mm + FORM_MM + 8 * noise_mm


def test_a_ball_is_grown_and_measured_with_its_origin_in_words() -> None:
    made = bent(0.02)
    made.ball([100, 0, 20], 10.0)
    program = InspectionProgram.model_validate(
        {
            "name": "p",
            "alignment": "none",
            "features": [{"name": "ball", "shape": "sphere", "grow": {"seed_mm": [100, 0, 30.4]}}],
            "dimensions": [
                {"name": "d", "kind": "diameter", "features": ["ball"], "nominal": 20},
                {"name": "c", "kind": "position", "features": ["ball"], "datums": ["ball"], "nominal": 0},
            ],
        }
    )
    diameter, position = inspect(made.measured(), program).dimensions
    assert diameter.measured is not None and diameter.uncertainty is not None
    assert abs(diameter.measured - 20) < diameter.uncertainty
    assert "grown from seed to" in diameter.traceability and "border: " in diameter.traceability
    assert position.measured is None and "has no nominal position" in position.reason


def test_the_limits_of_the_cut_end_a_region() -> None:
    points = bent(0.02).measured()
    found = grown(points, "plane", [3, 4, 0], cut={"x_mm": [-5, 5]})
    assert found.feature is not None and np.abs(found.points_mm[:, 0]).max() <= 5


def test_copies_of_a_pattern_grow_from_turned_seeds() -> None:
    made = Faces(0.02)
    for angle in range(0, 360, 120):
        made.cylinder([50 * np.cos(np.radians(angle)), 50 * np.sin(np.radians(angle)), 0], 6.0, 15.0)
    described = {
        "name": "pin",
        "shape": "cylinder",
        "grow": {"seed_mm": [56, 0, 7]},
        "repeat": {"count": 3, "angle_deg": 120},
    }
    program = InspectionProgram.model_validate({"name": "p", "alignment": "none", "features": [described]})
    found = find_features(made.measured(), program, None, ALL_POINTS)
    assert set(found) == {"pin.1", "pin.2", "pin.3"}
    for one in found.values():
        assert one.feature is not None and one.feature.radius_mm is not None, one.reason
        assert abs(one.feature.radius_mm - 6) < 4 * one.feature.standard_deviations["radius_mm"]
        assert abs(np.hypot(*one.feature.point_mm[:2]) - 50) < 4 * one.feature.standard_deviations["position_mm"]


@pytest.mark.parametrize(
    ("shape", "seed_mm", "complaint"),
    [
        ("plane", [0, 0, 15], "no measured surface lies within 2 mm of its seed"),
        ("plane", [208, 0, -15], "is not a plane"),
        ("sphere", [208, 0, -15], "is not a sphere"),
        ("cylinder", [0, 0, 0], "is not a cylinder, or too small"),
    ],
)
def test_what_cannot_be_grown_is_refused_with_the_reason(shape: str, seed_mm: list[float], complaint: str) -> None:
    found = grown(bent(0.02).measured(), shape, seed_mm)
    assert found.feature is None and re.search(complaint, found.reason), found.reason


def test_a_region_over_the_whole_part_is_refused_and_a_limited_one_is_not() -> None:
    made = Faces(0.02)
    made.plane([-HALF_MM, -HALF_MM, 0], [1, 0, 0], [0, 1, 0])
    found = grown(made.measured(), "plane", [0, 0, 0])
    assert found.feature is None and "covers the whole part" in found.reason and "x_mm" in found.reason
    assert grown(made.measured(), "plane", [0, 0, 0], cut={"x_mm": [-15, 15]}).feature is not None


def test_a_stated_noise_is_taken_and_a_smaller_one_leaves_points_out() -> None:
    points = bent(0.05).measured()
    right, small = (grown(points, "plane", [3, 4, 0], noise_mm=noise) for noise in (0.05, 0.005))
    assert right.feature is not None and "noise 0.050 mm" in right.feature.how
    assert small.feature is None or small.feature.points < 0.7 * right.feature.points
