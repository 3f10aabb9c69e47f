from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.errors import FitError
from measureapp.geometry.feature import Feature
from measureapp.geometry.fits import distances_mm, fit
from measureapp.geometry.minimum_zone import fit_minimum_zone

RADIUS, MINOR, HALF_ANGLE = 50.0, 9.0, 0.3
EXACT = 1e-7


class Sample:
    """Points on a known shape, turned and moved."""

    def __init__(self, shape: str, arc: float, offset: float, *, noise_mm: float = 0.0, count: int = 400, seed: int = 0) -> None:
        rng = np.random.default_rng(seed)
        a, h, zero = rng.uniform(0, arc, count), rng.uniform(-20, 20, count), np.zeros(count)
        b = rng.uniform(0, max(arc, 1.0) if shape == "torus" else min(arc, 3.0), count)
        radius = RADIUS - h * np.tan(HALF_ANGLE)
        points = {
            "plane": (rng.uniform(-40, 40, count), h, zero),
            "line": (zero, zero, h),
            "circle": (RADIUS * np.cos(a), RADIUS * np.sin(a), zero),
            "sphere": (RADIUS * np.cos(a) * np.sin(b), RADIUS * np.sin(a) * np.sin(b), RADIUS * np.cos(b)),
            "cylinder": (RADIUS * np.cos(a), RADIUS * np.sin(a), h),
            "cone": (radius * np.cos(a), radius * np.sin(a), h),
            "torus": ((RADIUS + MINOR * np.cos(b)) * np.cos(a), (RADIUS + MINOR * np.cos(b)) * np.sin(a), MINOR * np.sin(b)),
        }[shape]
        turn = Rotation.random(random_state=seed).as_matrix()
        self.centre = np.array([offset, -offset, offset / 2])
        self.axis = turn[:, 2]
        self.points = (np.column_stack(points) + rng.normal(0, noise_mm, (count, 3))) @ turn.T + self.centre

    def direction_error(self, feature: Feature) -> float:
        return 0.0 if feature.direction is None else float(np.linalg.norm(np.cross(feature.direction, self.axis)))

    def position_error(self, feature: Feature) -> float:
        away = feature.point_mm - self.centre
        if feature.shape == "plane":
            return abs(float(away @ self.axis))
        if feature.shape in ("line", "cylinder", "cone"):
            return float(np.linalg.norm(np.cross(away, self.axis)))
        return float(np.linalg.norm(away))


CASES = [
    (shape, arc, offset)
    for shape in ("plane", "line", "circle", "sphere", "cylinder", "cone", "torus")
    for arc in (2 * np.pi, 1.0, np.radians(5))
    for offset in (0.0, 1000.0)
    if not (shape == "torus" and arc < 0.5)
]


@pytest.mark.parametrize(("shape", "arc", "offset"), CASES)
def test_exact_points_give_the_exact_shape_far_from_the_origin_and_on_short_arcs(shape, arc, offset):
    sample = Sample(shape, arc, offset)
    found = fit(shape, sample.points)
    assert sample.direction_error(found) < EXACT
    assert sample.position_error(found) < EXACT
    assert found.rms_mm < EXACT and found.form_error_mm < 1e-6
    if shape in ("circle", "sphere", "cylinder", "torus"):
        assert found.radius_mm == pytest.approx(RADIUS, abs=EXACT)
    if shape == "cone":
        height = float((found.point_mm - sample.centre) @ found.direction) * np.sign(found.direction @ sample.axis)
        assert found.half_angle_rad == pytest.approx(HALF_ANGLE, abs=EXACT)
        assert found.radius_mm == pytest.approx(RADIUS - height * np.tan(HALF_ANGLE), abs=EXACT)
        assert found.direction @ sample.axis > 0  # towards the apex
    if shape == "torus":
        assert found.minor_radius_mm == pytest.approx(MINOR, abs=EXACT)


@pytest.mark.parametrize("shape", ["plane", "circle", "sphere", "cylinder", "cone"])
def test_the_scatter_of_repeated_fits_is_the_predicted_one(shape):
    base = Sample(shape, 2.0, 10.0, count=150, seed=3)
    rng = np.random.default_rng(7)
    fits = [fit(shape, base.points + rng.normal(0, 0.03, base.points.shape)) for _ in range(40)]
    predicted = fits[0].standard_deviations
    if shape == "plane":
        errors = [base.position_error(found) for found in fits]
        assert np.sqrt(np.mean(np.square(errors))) == pytest.approx(predicted["position_mm"], rel=0.35)
    else:
        own = "half_angle_rad" if shape == "cone" else "radius_mm"
        assert np.std([getattr(found, own) for found in fits]) == pytest.approx(predicted[own], rel=0.35)


def test_the_point_of_an_axis_is_the_one_nearest_the_points():
    sample = Sample("cylinder", 3.0, 500.0)
    found = fit("cylinder", sample.points)
    assert abs((sample.points.mean(axis=0) - found.point_mm) @ found.direction) < 1e-9


def test_the_robust_fit_leaves_out_the_outliers_and_says_how_many():
    sample = Sample("cylinder", 3.0, 100.0, noise_mm=0.02, count=2000)
    rng = np.random.default_rng(2)
    spoiled = np.array(sample.points)
    spoiled[:200] += rng.normal(0, 6, (200, 3))
    plain, robust = fit("cylinder", spoiled), fit("cylinder", spoiled, robust=True)
    assert 180 <= robust.left_out <= 225
    assert robust.points + robust.left_out == 2000
    assert abs(robust.radius_mm - RADIUS) < 0.005 < abs(plain.radius_mm - RADIUS)


def test_weights_count_as_inverse_variances():
    points = np.array([[0, 0, 0], [10, 0, 0], [0, 10, 0], [10, 10, 1.0], [10, 10, -0.5]])
    weighted = fit("plane", points, weights=np.array([1e6, 1e6, 1e6, 1.0, 1.0]))
    assert abs(weighted.direction[2]) == pytest.approx(1, abs=1e-6)
    assert np.abs(distances_mm(weighted, points[:3])).max() < 1e-4


def test_a_start_finds_a_short_piece_of_a_torus():
    sample = Sample("torus", np.radians(5), 0.0)
    near = Feature("t", "torus", sample.centre + 0.5, sample.axis, RADIUS + 1, minor_radius_mm=MINOR - 0.5)
    found = fit("torus", sample.points, start=near)
    assert found.radius_mm == pytest.approx(RADIUS, abs=1e-6)


FLAT = np.column_stack([np.random.default_rng(1).normal(size=(50, 2)), np.zeros(50)])
STRAIGHT = np.column_stack([np.arange(9.0), np.arange(9.0), np.arange(9.0)])


@pytest.mark.parametrize(
    ("shape", "points"),
    [
        ("plane", STRAIGHT),
        ("circle", STRAIGHT),
        ("sphere", FLAT),
        ("cylinder", FLAT),
        ("cone", FLAT),
        ("torus", FLAT),
        ("line", np.ones((4, 3))),
        ("sphere", np.eye(3)),
        ("plane", np.array([[0, 0, np.nan], [1, 0, 0], [0, 1, 0]])),
        ("cylinder", np.random.default_rng(0).normal(size=(200, 3))),
    ],
)
def test_points_that_do_not_determine_the_shape_are_refused_in_words(shape, points):
    with pytest.raises(FitError) as refusal:
        fit(shape, points)
    assert refusal.value.hint


@pytest.mark.parametrize("shape", ["plane", "sphere", "cylinder"])
def test_the_minimum_zone_is_no_wider_than_that_of_least_squares_nor_than_the_truth(shape):
    sample = Sample(shape, 3.0, 100.0, count=3000)
    exact = fit(shape, sample.points)
    rng = np.random.default_rng(4)
    outward = exact.direction if shape == "plane" else _outward(sample, shape)
    spoiled = sample.points + outward * rng.uniform(-0.05, 0.05, (3000, 1))
    zone, least = fit_minimum_zone(shape, spoiled), fit(shape, spoiled)
    assert zone.form_error_mm <= 0.1 + 1e-9
    assert zone.form_error_mm < least.form_error_mm
    signed = distances_mm(zone, spoiled)
    assert np.sum(np.abs(signed) > np.abs(signed).max() - 1e-7) >= 4  # contacts on both sides
    assert signed.max() == pytest.approx(-signed.min(), abs=1e-7)


def _outward(sample: Sample, shape: str) -> np.ndarray:
    away = sample.points - sample.centre
    if shape == "cylinder":
        away -= np.outer(away @ sample.axis, sample.axis)
    return away / np.linalg.norm(away, axis=1, keepdims=True)


def test_the_minimum_zone_of_four_points_is_the_known_one():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.1]])
    assert fit_minimum_zone("plane", points).form_error_mm == pytest.approx(0.05 / np.sqrt(1 + 2 * 0.05**2), abs=1e-10)


@pytest.mark.parametrize("shape", ["line", "circle"])
def test_zones_that_are_not_offered_are_refused(shape):
    with pytest.raises(FitError, match="not offered"):
        fit_minimum_zone(shape, Sample(shape, 3.0, 0.0).points)
