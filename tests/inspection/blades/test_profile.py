"""Mean line, thickness, chord and edges of sections whose values are known in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.errors import FitError
from measureapp.inspection.blades.profile import Profile, Shape, fit_profile
from tests.inspection.blade_shapes import RoundBlade, naca, scattered

NOISE_MM = 0.02
POINTS = 4000
BLADE = RoundBlade()
SEEDS = range(8)


def values(found: Profile) -> dict[str, float]:
    return {
        "chord": float(np.linalg.norm(found.chord)),
        "thickness": found.thickness_mm,
        "camber": found.camber_mm,
        "leading": found.leading.radius_mm,
        "trailing": found.trailing.radius_mm,
    }


TRUTH = {
    "chord": BLADE.chord_mm,
    "thickness": BLADE.thickness_mm,
    "camber": BLADE.camber_mm,
    "leading": BLADE.leading_mm,
    "trailing": BLADE.trailing_mm,
}
# Edges: about 35 points a mm; a radius from a cap of 1.3 rad to both sides is known about 3 times worse than a mean.
# leading: 100 points, 0.02 / 10 * 3 = 0.006 mm; trailing: 50 points, 0.009 mm; an end has half of that; sides: ten unknowns over 2000 points.
SIGMA = {"chord": 0.006, "thickness": 0.003, "camber": 0.003, "leading": 0.006, "trailing": 0.012}
MODEL = {"chord": 0.004, "thickness": 0.002, "camber": 0.004, "leading": 0.002, "trailing": 0.002}  # of the polynomials, seen without noise


def test_a_round_blade_without_noise_gives_back_its_values() -> None:
    found = values(fit_profile(scattered(BLADE.contour(), POINTS, 0.0, np.random.default_rng(0)), Shape(BLADE.chord_mm)))
    for name, truth in TRUTH.items():
        assert found[name] == pytest.approx(truth, abs=MODEL[name]), name


def test_a_noisy_round_blade_gives_back_its_values() -> None:
    rng = np.random.default_rng(1)
    found = [values(fit_profile(scattered(BLADE.contour(), POINTS, NOISE_MM, rng), Shape(BLADE.chord_mm))) for _ in SEEDS]
    for name, truth in TRUTH.items():
        errors = np.array([one[name] for one in found]) - truth
        assert np.abs(errors).max() < 3.5 * SIGMA[name] + MODEL[name], name
        assert abs(errors.mean()) < 3 * SIGMA[name] / np.sqrt(len(SEEDS)) + MODEL[name], name


@pytest.mark.parametrize("turn_deg", [-10.0, 15.0])
def test_a_tilted_blade_keeps_its_values(turn_deg: float) -> None:
    turn = np.radians(turn_deg)
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    points = scattered(BLADE.contour(), POINTS, NOISE_MM, np.random.default_rng(2)) @ rotation.T
    found = fit_profile(points, Shape(BLADE.chord_mm))
    for name, truth in TRUTH.items():
        assert values(found)[name] == pytest.approx(truth, abs=4 * SIGMA[name] + MODEL[name]), name
    assert np.degrees(np.arctan2(found.chord[1], found.chord[0])) == pytest.approx(turn_deg, abs=0.05)


def test_a_naca_2412_has_its_thickness_and_camber_where_the_formula_has_them() -> None:
    points = scattered(naca(60.0, 0.12, 0.02, 0.4), POINTS, NOISE_MM, np.random.default_rng(3))
    found = fit_profile(points, Shape(60.0))
    assert found.thickness_mm == pytest.approx(7.2, abs=0.012)
    assert found.thickness_at_mm == pytest.approx(18.0, abs=0.6)  # flat there: 0.01 mm of thickness over 1 mm
    assert found.camber_mm == pytest.approx(1.2, abs=0.03)
    assert found.trailing.apex_mm is None  # 0.15 mm thin: nothing to fit a circle to
    # the circle within three quarters of its radius of the nose: wider than the osculating one of 1.1019 t² c
    assert 1.0 < found.leading.radius_mm / (1.1019 * 0.12**2 * 60) < 1.4


def test_an_edge_that_was_not_measured_is_refused_and_the_sides_are_kept() -> None:
    points = scattered(BLADE.contour(), POINTS, NOISE_MM, np.random.default_rng(4))
    found = fit_profile(points[points[:, 0] > 4.0], Shape(BLADE.chord_mm))
    assert found.leading.apex_mm is None and found.leading.reason
    assert found.trailing.apex_mm is not None
    assert found.thickness_mm == pytest.approx(TRUTH["thickness"], abs=0.015)


def test_a_square_end_has_no_edge_radius() -> None:
    corners = np.array([[0.0, 2], [0, -2], [60, -2], [60, 2], [0, 2]])
    found = fit_profile(scattered(corners, POINTS, NOISE_MM, np.random.default_rng(5)), Shape(60.0))
    assert found.leading.apex_mm is None and "edge" in found.leading.reason
    assert found.thickness_mm == pytest.approx(4.0, abs=0.03)


def test_one_side_alone_is_refused() -> None:
    points = scattered(BLADE.contour(), POINTS, NOISE_MM, np.random.default_rng(6))
    middle = np.interp(points[:, 0], [0, 30, 60], [0, BLADE.camber_mm, 0])
    with pytest.raises(FitError, match="one side"):
        fit_profile(points[points[:, 1] > middle], Shape(BLADE.chord_mm))


def test_a_few_points_at_one_end_are_refused() -> None:
    points = scattered(BLADE.contour(), POINTS, NOISE_MM, np.random.default_rng(7))
    with pytest.raises(FitError, match="cover the section"):
        fit_profile(np.vstack([points[points[:, 0] < 3], points[points[:, 0] > 58]]), Shape(BLADE.chord_mm))
