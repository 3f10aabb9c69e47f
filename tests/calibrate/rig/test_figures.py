"""The joint calibration of the paper's rig knows how good it is, and what limits it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest

from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.cameras.prior import perturb_cameras
from measureapp.calibrate.rig.limits import rig_limits
from measureapp.errors import CalibrationError
from tests.calibrate.paper_rig import CORNER_SIGMA_PX, IMAGE_SIGMA_PX, NOISE, Run, calibrated, errors_of, figures_of
from tests.calibrate.virtual_board import CHECKER, FULL, shot

# What is asked. Rail and slide are in the guide's figures as they are, the table in those of the axis.
ASKED = {
    "axis direction against the board, deg": 0.002,
    "axis place against the board, mm": 0.005,
    "hand-eye beyond, mm": 0.05,
    "hand-eye beyond, deg": 0.005,
    "guide direction against the board, deg": 0.002,
    "guide scale": 1e-5,
}
SEEDS = range(1, 21)


def pair(seed: int, corner_sigma_px: float) -> tuple[Run, Run]:
    """Return a run, and one of the same robot with perfect images."""
    perfect = calibrated(seed, corner_sigma_px=corner_sigma_px, corner_errors=False, camera_errors=False)
    return calibrated(seed, corner_sigma_px=corner_sigma_px), perfect


def inside(runs: list[Run]) -> np.ndarray:
    """Return whether each parameter of each run lies in its predicted 95 % interval."""
    return np.array(
        [[abs(error) < 1.96 * run.solution.standard_deviations[name] for name, error in errors_of(run).items()] for run in runs]
    )


quick = cache(partial(calibrated, stations=False))


def test_most_parameters_lie_in_their_predicted_intervals():
    assert np.mean(inside([calibrated(seed) for seed in (1, 2)])) > 0.80  # 38 values that are correlated within each run


@pytest.mark.slow
def test_the_predicted_95_percent_intervals_hold(record_property):
    runs = [calibrated(seed) for seed in SEEDS]
    share = float(np.mean(inside(runs)))
    ratios = [[error / run.solution.standard_deviations[name] for name, error in errors_of(run).items()] for run in runs]
    size = float(np.sqrt(np.mean(np.square(ratios))))
    record_property("inside the 95 % intervals", share)
    record_property("rms of error over sigma", size)
    assert 0.93 <= share <= 0.97
    assert 0.8 < size < 1.1
    assert not any(run.solution.rejected for run in runs)


@pytest.mark.slow
def test_corners_of_full_images_are_as_good_as_the_figures_take_them_to_be():
    off = []
    for tilt_deg, towards, roll in ((0, 10, 5), (24, 100, 40), (42, 10, 5), (55, 250, 130)):
        seen = shot(CHECKER, tilt_deg, towards, roll, FULL)
        found = find_board(seen.image, CHECKER)
        off.append(found.corners_px - seen.marks_px[found.ids])
    assert np.sqrt(np.mean(np.concatenate(off) ** 2)) < IMAGE_SIGMA_PX


@pytest.mark.slow
@pytest.mark.parametrize("corner_sigma_px", [IMAGE_SIGMA_PX, CORNER_SIGMA_PX])
def test_figures_of_twenty_seeds(record_property, corner_sigma_px):
    """With the corners of the virtual rig's images every rig stays within all that is asked.

    With those of real boards 95 % are predicted to, so that nine of ten must, but for the rotation of the hand-eye transform: the lens'
    centre is known to 0.25 px from so many views, which is 0.004°, and 0.0083° in 95 %. It moves board and part alike.
    """
    rows = [figures_of(*pair(seed, corner_sigma_px)) for seed in SEEDS]
    middle = {name: float(np.median([row[name] for row in rows])) for name in rows[0]}
    worst = {name: float(np.max([row[name] for row in rows])) for name in rows[0]}
    for number, row in enumerate(rows, 1):
        record_property(f"seed {number}", row)
    record_property("median", middle)
    record_property("worst", worst)
    least = 1.0 if corner_sigma_px == IMAGE_SIGMA_PX else 0.9
    short = {} if corner_sigma_px == IMAGE_SIGMA_PX else {"hand-eye beyond, deg": 0.0083}
    for name, asked in (ASKED | short).items():
        assert np.mean([row[name] <= asked for row in rows]) >= least, name
        assert middle[name] <= ASKED[name], name
    assert worst["hand-eye beyond at the points, mm"] < ASKED["hand-eye beyond, mm"]
    assert worst["hand-eye beyond at the points, deg"] < ASKED["hand-eye beyond, deg"]
    assert middle["hand-eye beyond, mm"] < middle["hand-eye the robot allows, mm"]


def test_the_covariance_grows_with_the_uncertainty_of_the_cameras():
    run = quick(4)
    plain = calibrated(4, stations=False, camera_prior_used=False)
    larger = np.diag(run.solution.covariance) / np.diag(plain.solution.covariance)
    assert np.all(larger >= 1 - 1e-3)  # the sizes of the axes' error motions follow from the residuals, which differ a little
    assert larger.max() > 1.05


def test_figures_are_stated_with_their_requirement_and_as_the_axes_allow():
    run = quick(4)
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
        assert "requested" in one.sentence
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
    again = perturb_cameras(run.solution.calibration.cameras, run.prior.parameters, -moved)
    np.testing.assert_allclose(again.cameras["right"].pinhole.matrix, run.cameras.cameras["right"].pinhole.matrix, atol=1e-9)


def test_weak_directions_are_named_with_their_sigma():
    weak = quick(6).solution.weak_directions
    assert weak[0].sigma_mm >= weak[1].sigma_mm > 0.02
    assert "at the part" in weak[0].sentence
    assert any(name.startswith(("hand_eye", "axis", "board")) for name in weak[0].parameters)


def test_a_board_pose_without_its_dependence_on_the_cameras_is_refused_with_a_prior():
    run = quick(6)
    from measureapp.calibrate.rig.joint import solve_rig

    bare = [replace(one, camera_jacobian=None) for one in run.observations]
    with pytest.raises(CalibrationError, match="derivatives of the board poses"):
        solve_rig(bare, run.cameras, camera_prior=run.prior)
