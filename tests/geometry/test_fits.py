from __future__ import annotations

from dataclasses import replace

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
        *[(shape, np.ones((9, 3))) for shape in ("plane", "circle", "sphere", "cylinder", "cone", "torus")],
        *[(shape, np.zeros((1, 3))) for shape in ("line", "plane", "circle", "sphere", "cylinder", "cone", "torus")],
        *[(shape, STRAIGHT) for shape in ("sphere", "cylinder", "cone", "torus")],
        ("plane", np.array([[0, 0, 0], [1.0, 0, 0]])),
        ("circle", np.full((9, 3), np.inf)),
        ("sphere", np.eye(3)),
        ("plane", np.array([[0, 0, np.nan], [1, 0, 0], [0, 1, 0]])),
        ("cylinder", np.random.default_rng(0).normal(size=(200, 3))),
    ],
)
@pytest.mark.parametrize("kind", [fit, fit_minimum_zone])
def test_points_that_do_not_determine_the_shape_are_refused_in_words(kind, shape, points):
    with pytest.raises(FitError) as refusal:
        kind(shape, points)
    assert refusal.value.hint


SHAPES = ("plane", "line", "circle", "sphere", "cylinder", "cone", "torus")


def sizes_of(feature: Feature) -> list[float]:
    return [size for size in (feature.radius_mm, feature.half_angle_rad, feature.minor_radius_mm) if size is not None]


def reported(feature: Feature, like: Feature) -> np.ndarray:
    """What the covariance speaks of, the direction on the same side as that of ``like``; a direction of a sphere is none.

    A cone is read where ``like`` is, not at the centroid of its own points, which noise moves along the axis too.
    """
    direction = np.array([0.0, 0.0, 1.0]) if feature.direction is None else feature.direction
    turned = -1 if like.direction is not None and direction @ like.direction < 0 else 1
    point, sizes = feature.point_mm, sizes_of(feature)
    if feature.shape == "cone":
        along = (like.point_mm - point) @ direction
        point, sizes = point + along * direction, [sizes[0] - along * np.tan(sizes[1]), sizes[1]]
    return np.concatenate([point, turned * direction, sizes])


@pytest.mark.parametrize("shape", SHAPES)
def test_the_covariance_is_that_of_repeated_fits(shape):
    """The Mahalanobis distance of a repeated fit follows a χ² law of as many degrees as the shape has free parameters.

    The points move along the surface's normal only: along the surface noise changes nothing but where the centroid lies.
    """
    base = Sample(shape, 2.5, 100.0, count=150, seed=3)
    exact = fit(shape, base.points)
    normals, rng, runs = _normals(base, shape), np.random.default_rng(7), 200
    free = {"plane": 3, "line": 4, "circle": 6, "sphere": 4, "cylinder": 5, "cone": 6, "torus": 7}[shape]
    distances = []
    for _ in range(runs):
        noise = np.einsum("nkd,nk->nd", normals, rng.normal(0, 0.02, normals.shape[:2]))
        found = fit(shape, base.points + noise, start=exact)
        values, vectors = np.linalg.eigh(found.covariance)
        assert values[-free - 1 :][0] < 1e-9 * values[-free] or len(values) == free  # exactly as many directions are uncertain
        within = vectors[:, -free:].T @ (reported(found, exact) - reported(exact, exact))
        distances.append(float(np.sum(within**2 / values[-free:])))
    assert np.mean(distances) == pytest.approx(free, abs=5 * np.sqrt(2 * free / runs) + 0.05 * free)


def _normals(sample: Sample, shape: str) -> np.ndarray:
    """The directions (N, K, 3) in which the distance of each point from the shape changes, along no axis."""
    away = sample.points - sample.centre
    along = (away @ sample.axis)[:, None] * sample.axis
    radial = (away - along) / np.maximum(np.linalg.norm(away - along, axis=1, keepdims=True), 1e-12)
    axis = np.broadcast_to(sample.axis, away.shape)
    if shape == "plane":
        return axis[:, None]
    if shape == "line":
        first = np.cross(sample.axis, [1.0, 0.0, 0.0])
        first /= np.linalg.norm(first)
        return np.broadcast_to(np.stack([first, np.cross(sample.axis, first)]), (len(away), 2, 3))
    if shape == "circle":
        return np.stack([radial, axis], axis=1)
    ring = away - RADIUS * radial
    normal = {"sphere": away, "torus": ring, "cone": radial * np.cos(HALF_ANGLE) + axis * np.sin(HALF_ANGLE)}.get(shape, radial)
    return (normal / np.linalg.norm(normal, axis=1, keepdims=True))[:, None]


@pytest.mark.parametrize("shape", SHAPES)
def test_every_shape_can_be_fitted_without_its_outliers(shape):
    sample = Sample(shape, 2 * np.pi, 0.0, noise_mm=0.01, count=600)
    spoiled = np.array(sample.points)
    spoiled[:60] += np.random.default_rng(1).normal(0, 5, (60, 3))
    robust = fit(shape, spoiled, robust=True)
    assert 50 <= robust.left_out <= 75 and robust.points + robust.left_out == 600
    assert np.allclose(sizes_of(robust), sizes_of(fit(shape, sample.points[60:])), atol=0.005)


@pytest.mark.parametrize("count", [15, 400])
@pytest.mark.parametrize("shape", SHAPES)
def test_the_minimum_zone_is_narrower_than_that_of_least_squares_and_its_certificate_holds(shape, count):
    sample = Sample(shape, 3.0, 100.0, noise_mm=0.02, count=count, seed=4)
    zone, least = fit_minimum_zone(shape, sample.points), fit(shape, sample.points)
    assert zone.feature.form_error_mm < least.form_error_mm
    assert zone.imbalance < 1e-7 and zone.multipliers.sum() == pytest.approx(1) and (zone.multipliers > 0).all()
    if shape == "circle":
        return  # its zone lies within a plane, and has its own test
    signed = distances_mm(zone.feature, sample.points)
    half = zone.feature.form_error_mm / 2
    assert np.allclose(np.abs(signed[zone.contacts]), half, atol=1e-7)
    assert np.abs(signed).max() < half + 1e-7


@pytest.mark.parametrize("shape", SHAPES)
def test_no_small_change_narrows_a_minimum_zone(shape):
    """Tried by hand: thousands of random changes of the found feature, large and small."""
    sample = Sample(shape, 3.0, 0.0, noise_mm=0.02, count=60, seed=5)
    zone = fit_minimum_zone(shape, sample.points).feature
    rng = np.random.default_rng(0)
    for size_mm in (1e-2, 1e-3, 1e-4, 1e-5):
        for _ in range(300):
            assert width_of(changed(zone, size_mm * rng.normal(size=8)), sample.points) > zone.form_error_mm - 1e-7


def changed(feature: Feature, by_mm: np.ndarray) -> Feature:
    if feature.direction is None:
        return replace(feature, point_mm=feature.point_mm + by_mm[:3], radius_mm=feature.radius_mm + by_mm[6])
    across = by_mm[:3] - (by_mm[:3] @ feature.direction) * feature.direction
    leaning = feature.direction + (0 if feature.shape == "circle" else 1) * by_mm[3:6] / 50
    return replace(
        feature,
        point_mm=feature.point_mm + (across if feature.shape == "circle" else by_mm[:3]),
        direction=leaning / np.linalg.norm(leaning),
        radius_mm=None if feature.radius_mm is None else feature.radius_mm + by_mm[6],
        half_angle_rad=None if feature.half_angle_rad is None else feature.half_angle_rad + by_mm[7] / 50,
        minor_radius_mm=None if feature.minor_radius_mm is None else feature.minor_radius_mm + by_mm[7],
    )


def width_of(feature: Feature, points: np.ndarray) -> float:
    if feature.shape == "circle":
        away = points - feature.point_mm
        across = away - (away @ feature.direction)[:, None] * feature.direction
        return 2 * float(np.abs(np.linalg.norm(across, axis=1) - feature.radius_mm).max())
    return 2 * float(np.abs(distances_mm(feature, points)).max())


def test_the_narrowest_ring_about_known_contacts_is_found():
    """Two points outside and two inside, alternating: the ring is the known one whatever lies between."""
    angles = np.linspace(0, 2 * np.pi, 60, endpoint=False)
    radii = np.full(60, 30.0)
    radii[[0, 30]], radii[[15, 45]] = 30.02, 29.98
    centre = np.array([700.0, -300.0, 5.0])
    ring = centre + np.column_stack([radii * np.cos(angles), radii * np.sin(angles), np.zeros(60)])
    zone = fit_minimum_zone("circle", ring)
    assert zone.feature.form_error_mm == pytest.approx(0.04, abs=1e-9)
    assert np.allclose(zone.feature.point_mm, centre, atol=1e-9)
    assert set(zone.contacts) == {0, 15, 30, 45}


def test_the_narrowest_cylinder_about_a_triangle_on_a_stick_is_its_circumscribed_one():
    corners = 0.02 * np.column_stack([np.cos([0, 2.1, 4.2]), np.sin([0, 2.1, 4.2])])
    points = np.vstack([np.column_stack([corners, np.full(3, z)]) for z in (-40.0, 0.0, 40.0)])
    zone = fit_minimum_zone("line", points)
    assert zone.feature.form_error_mm == pytest.approx(0.04, abs=1e-9)
    assert np.abs(zone.feature.direction[2]) == pytest.approx(1, abs=1e-12)


def test_the_minimum_zone_of_four_points_is_the_known_one():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.1]])
    assert fit_minimum_zone("plane", points).feature.form_error_mm == pytest.approx(0.05 / np.sqrt(1 + 2 * 0.05**2), abs=1e-10)
