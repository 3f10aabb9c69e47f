"""The joint calibration of the paper's rig knows how good it is, and what limits it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.camera_prior import cameras_moved
from measureapp.calibrate.limits import rig_limits
from measureapp.errors import CalibrationError
from tests.calibrate.paper_rig import NOISE, Run, calibrated, errors_of, figures_of


def pair(seed: int) -> tuple[Run, Run]:
    """Return a run, and one of the same robot with perfect images."""
    return calibrated(seed), calibrated(seed, corner_sigma_px=0.0, camera_errors=False)


def inside(runs: list[Run]) -> np.ndarray:
    """Return whether each parameter of each run lies in its predicted 95 % interval."""
    return np.array(
        [[abs(error) < 1.96 * run.solution.standard_deviations[name] for name, error in errors_of(run).items()] for run in runs]
    )


def test_most_parameters_lie_in_their_predicted_intervals():
    assert np.mean(inside([calibrated(seed) for seed in (1, 2, 3)])) > 0.80  # 57 values that are correlated within each run


@pytest.mark.slow
def test_the_predicted_95_percent_intervals_hold(record_property):
    runs = [calibrated(seed) for seed in range(1, 21)]
    share = float(np.mean(inside(runs)))
    ratios = [[error / run.solution.standard_deviations[name] for name, error in errors_of(run).items()] for run in runs]
    size = float(np.sqrt(np.mean(np.square(ratios))))
    record_property("inside the 95 % intervals", share)
    record_property("rms of error over sigma", size)
    assert 0.93 <= share <= 0.97
    assert 0.8 < size < 1.1
    assert not any(run.solution.rejected for run in runs)


@pytest.mark.slow
def test_figures_of_twenty_seeds(record_property):
    rows = [figures_of(*pair(seed)) for seed in range(1, 21)]
    middle = {name: float(np.median([row[name] for row in rows])) for name in rows[0]}
    worst = {name: float(np.max([row[name] for row in rows])) for name in rows[0]}
    for number, row in enumerate(rows, 1):
        record_property(f"seed {number}", row)
    record_property("median", middle)
    record_property("worst", worst)
    assert middle["hand-eye beyond, mm"] < middle["hand-eye the robot allows, mm"]


def test_the_covariance_grows_with_the_uncertainty_of_the_cameras():
    run = calibrated(4, stations=False)
    plain = calibrated(4, stations=False, camera_prior_used=False)
    larger = np.diag(run.solution.covariance) / np.diag(plain.solution.covariance)
    assert np.all(larger >= 1 - 1e-9)
    assert larger.max() > 1.05


def test_figures_are_stated_as_asked_and_as_the_axes_allow():
    run = calibrated(4, stations=False)
    limits = {one.name: one for one in rig_limits(run.solution, {})}
    assert set(limits) == {
        "hand-eye position",
        "hand-eye rotation",
        "axis direction",
        "axis position",
        "guide direction",
        "guide scale",
    }
    for one in limits.values():
        assert 0 < one.axes_allow < one.sigma
        assert one.sigma**2 == pytest.approx(one.axes_allow**2 + one.beyond**2)
        assert "asked" in one.sentence
    better = calibrated(4, stations=False, noise=replace(NOISE, robot_mm=NOISE.robot_mm / 10, robot_rad=NOISE.robot_rad / 10))
    assert next(iter(rig_limits(better.solution, {}))).axes_allow < limits["hand-eye position"].axes_allow


def test_freed_cameras_move_towards_the_truth_they_are_known_by():
    run = calibrated(5, stations=False, free_cameras=True)
    truth = run.cell.truth.calibration.cameras.cameras["right"]
    found = run.solution.calibration.cameras.cameras["right"]
    labels = list(run.prior.parameters)
    sigma = float(np.sqrt(run.prior.covariance[labels.index("right.fx"), labels.index("right.fx")]))
    assert abs(found.pinhole.matrix[0, 0] - truth.pinhole.matrix[0, 0]) < 3 * sigma
    index = run.solution.joint_parameters.index("right.fx")
    assert np.sqrt(run.solution.joint_covariance[index, index]) < sigma * (1 + 1e-9)
    moved = run.solution.state.camera_changes
    assert np.abs(moved / np.sqrt(np.diag(run.prior.covariance))).max() < 4
    again = cameras_moved(run.solution.calibration.cameras, run.prior.parameters, -moved)
    np.testing.assert_allclose(again.cameras["right"].pinhole.matrix, run.cameras.cameras["right"].pinhole.matrix, atol=1e-9)


def test_weak_directions_are_named_with_their_sigma():
    weak = calibrated(6, stations=False).solution.weak_directions
    assert weak[0].sigma_mm >= weak[1].sigma_mm > 0.02
    assert "at the part" in weak[0].sentence
    assert any(name.startswith(("hand_eye", "axis", "board")) for name in weak[0].parameters)


def test_a_board_pose_without_its_dependence_on_the_cameras_is_refused_with_a_prior():
    run = calibrated(6, stations=False)
    from measureapp.calibrate.joint import solve_rig

    bare = [replace(one, by_cameras=None) for one in run.observations]
    with pytest.raises(CalibrationError, match="depend on the cameras"):
        solve_rig(bare, run.cameras, camera_prior=run.prior)
