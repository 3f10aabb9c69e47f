"""The diagnostics of the axis say what is wrong with it, and when weighting by distance helps."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.motions.axis_circles import axis_through_centres, fit_arcs
from measureapp.calibrate.motions.axis_diagnostics import arc_conditioning, closure_of
from measureapp.calibrate.motions.rotation_axis import AxisProblem, solve
from measureapp.data.calibration import RotationAxis
from measureapp.geometry.transform import rotation_about

AXIS = RotationAxis(np.zeros(3), np.array([0.0, 0, 1]), "camera")
WIDTH_MM, HEIGHT_MM = 156.0, 120.0


def steep_board(inner_mm):
    """Return corners on a board that stands upright, its columns from ``inner_mm`` off the axis outwards."""
    columns, rows = np.linspace(inner_mm, inner_mm + WIDTH_MM, 14), np.linspace(0, HEIGHT_MM, 11)
    return np.array([[column, 0.0, row] for row in rows for column in columns])


def turned(points, angles_rad):
    return np.array([AXIS.turned(angle).apply(points) for angle in angles_rad])


def test_the_predicted_sigma_of_a_centre_is_its_scatter():
    angles, sigma = np.deg2rad(np.linspace(-40, 40, 9)), 0.02
    points = steep_board(100.0)
    centres, predicted = [], []
    for seed in range(40):
        noisy = turned(points, angles) + np.random.default_rng(seed).normal(scale=sigma, size=(9, len(points), 3))
        centres.append(fit_arcs(noisy).centres_mm)
        predicted.append(arc_conditioning(noisy, angles))
    along_x = np.std(np.array(centres)[:, :, 0], axis=0)
    assert np.mean([one.point_sigma_mm for one in predicted]) == pytest.approx(sigma, rel=0.05)
    assert np.mean(along_x) == pytest.approx(np.mean(predicted[0].centre_sigma_mm), rel=0.1)


def test_centres_from_short_arcs_are_reported_with_their_sigma():
    angles = np.deg2rad([-8.0, -4, 0, 4, 8])
    noisy = turned(steep_board(10.0), angles) + np.random.default_rng(1).normal(scale=0.03, size=(5, 154, 3))
    solution = solve(AxisProblem(noisy, angles))
    assert solution.diagnostics.arcs.centre_sigma_mm.min() > 0.5
    assert any("154 of 154 centres" in warning for warning in solution.warnings)


def test_the_closure_of_a_perfect_table_is_the_noise():
    angles, sigma = np.deg2rad(np.arange(0, 360, 30.0)), 0.02
    noisy = turned(steep_board(10.0), angles) + np.random.default_rng(2).normal(scale=sigma, size=(12, 154, 3))
    closure = solve(AxisProblem(noisy, angles)).diagnostics.closure
    assert closure.board_mm == pytest.approx(sigma * np.sqrt(3 * 11 / 12), rel=0.05)
    assert closure.at_radius_mm < 0.02
    assert closure.angles_were_read


def test_a_false_angle_shows_at_the_radius_in_proportion():
    angles = np.deg2rad(np.arange(-60, 61, 15.0))
    said = angles + np.deg2rad([0, 0, 0, 0.1, 0, 0, 0, 0, 0])
    closure = closure_of(AXIS, turned(steep_board(10.0), angles), said, True, 300.0)
    assert int(np.argmax(np.abs(closure.angle_error_rad))) == 3
    np.testing.assert_allclose(closure.angle_error_rad[3] - closure.angle_error_rad[0], np.deg2rad(-0.1), rtol=1e-6)
    share = np.array([8 / 9 if index == 3 else -1 / 9 for index in range(9)]) * np.deg2rad(0.1)
    assert closure.at_radius_mm == pytest.approx(300 * np.sqrt(np.mean(share**2)), rel=1e-3)
    assert closure.wobble_rad.max() < 1e-9


def test_a_wobbling_table_shows_as_wobble_and_not_as_angle():
    angles = np.deg2rad(np.arange(0, 360, 30.0))
    tilts = [rotation_about([np.cos(2 * angle), np.sin(2 * angle), 0], 1e-3) for angle in angles]
    corners = np.array([position @ tilt.T for position, tilt in zip(turned(steep_board(10.0), angles), tilts, strict=True)])
    closure = closure_of(AXIS, corners, angles, True, 250.0)
    assert np.sqrt(np.mean(closure.wobble_rad**2)) == pytest.approx(1e-3, rel=0.01)
    assert np.abs(closure.angle_error_rad).max() < 1e-5


def gains(inner_mm, sweep_deg, positions, sigma_mm, runs):
    """Return mean and half 95 % confidence interval of what weighting takes from the squared error, relative, of point and direction."""
    angles = np.deg2rad(np.linspace(-sweep_deg / 2, sweep_deg / 2, positions))
    points = steep_board(inner_mm)
    truth, errors = turned(points, angles), []
    for seed in range(runs):
        noisy = truth + np.random.default_rng(seed).normal(scale=sigma_mm, size=truth.shape)
        row = []
        for power in (0.0, 2.0):
            point, direction = axis_through_centres(noisy, power)
            foot = point + direction * float(direction @ (points.mean(axis=0) - point))
            row += [foot[0] ** 2 + foot[1] ** 2, direction[0] ** 2 + direction[1] ** 2]
        errors.append(row)
    plain, weighted = np.array(errors)[:, :2], np.array(errors)[:, 2:]
    share = (plain - weighted) / plain.mean(axis=0)
    return share.mean(axis=0), 1.96 * share.std(axis=0, ddof=1) / np.sqrt(runs)


RUNS = [15, pytest.param(100, marks=pytest.mark.slow)]


@pytest.mark.parametrize("runs", RUNS)
def test_weighting_places_the_axis_better_where_noise_shortens_the_radii_of_small_arcs(runs):
    (point, direction), (point_half, direction_half) = gains(2.0, 30.0, 9, 0.3, runs)
    assert point - point_half > 0.3  # Kåsa's centre is drawn towards an arc that is no longer than a few times its noise
    assert direction + direction_half < 0.2  # but fewer centres count, so that its direction is no better


@pytest.mark.parametrize("runs", RUNS)
def test_weighting_does_not_help_where_radii_are_nearly_equal(runs):
    (point, direction), (point_half, direction_half) = gains(300.0, 60.0, 7, 0.05, runs)
    assert abs(point) < point_half + 0.05
    assert abs(direction) < direction_half + 0.05


@pytest.mark.parametrize("runs", RUNS)
def test_weighting_costs_accuracy_where_all_arcs_are_long(runs):
    (point, direction), (point_half, direction_half) = gains(2.0, 120.0, 9, 0.03, runs)
    assert point - point_half < 0
    assert direction - direction_half < 0
    if runs >= 100:  # fewer do not show it with confidence
        assert point + point_half < 0
        assert direction + direction_half < 0
