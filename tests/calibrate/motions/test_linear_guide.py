"""Direction and scale of the guide are recovered from a standing board."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions.linear_guide import GuideProblem, shortfalls, solve
from measureapp.calibrate.poses import apply_changes
from measureapp.data.calibration import HandEye, LinearGuide
from measureapp.data.fringe import Readback
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

X = HandEye(RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera"))
GUIDE = LinearGuide(np.array([0.003, 1.0, -0.002]), 1.0004)
GUIDE_FROM_BOARD = RigidTransform.from_vector([2.0, 0.3, -0.4], [600, 50, 100], "guide", "board")
SIGMA_MM = 0.02


def observed(index, flange, position, camera_from_board) -> Observation:
    return Observation(str(index), Readback(flange, float(position)), stated_pose(camera_from_board, 1.0, 1.0))


def problem_of(generator, positions=range(-300, 301, 75), sigma_mm=SIGMA_MM) -> GuideProblem:
    """Return sightings from varying robot poses, the board's place with noise."""
    observations = []
    for index, position in enumerate(positions):
        flange = RigidTransform.from_vector([0.1 * (index % 3), 0.2, -0.1 * (index % 2)], [400, 20 * (index % 4), 500], "base", "flange")
        seen = (GUIDE.guide_from_base(position) @ flange @ X.flange_from_camera).inverse() @ GUIDE_FROM_BOARD
        change = np.concatenate([np.zeros(3), generator.normal(scale=sigma_mm, size=3)])
        seen = RigidTransform(apply_changes(seen.matrix, change), "camera", "board")
        observations.append(observed(index, flange, position, seen))
    return GuideProblem(tuple(observations), X)


def test_direction_and_scale_are_exact_without_noise(generator):
    solution = solve(problem_of(generator, sigma_mm=0.0))
    np.testing.assert_allclose(solution.guide.direction, GUIDE.direction, atol=1e-9)
    assert solution.guide.scale == pytest.approx(GUIDE.scale, abs=1e-9)
    assert solution.straightness_mm.max() < 1e-6
    assert solution.turn_rad.max() < 1e-6
    assert not solution.warnings


def test_errors_agree_with_the_predicted_standard_deviations():
    ratios = []
    for seed in range(40):
        guide = solve(problem_of(np.random.default_rng(seed))).guide
        across = (guide.direction - GUIDE.direction) @ np.linalg.svd(GUIDE.direction[None])[2][1:].T
        ratios.append([*(across / guide.direction_sigma_rad), (guide.scale - GUIDE.scale) / guide.scale_sigma])
    assert 0.8 < np.sqrt(np.mean(np.square(ratios))) < 1.25


def test_the_error_of_assuming_plus_y_is_stated(generator):
    solution = solve(problem_of(generator, sigma_mm=0.0))
    assert solution.paper_cost_mm == pytest.approx(600 * np.linalg.norm(GUIDE.direction * GUIDE.scale - [0, 1, 0]))
    assert solution.paper_mm[0] == 0
    assert solution.paper_mm[-1] == pytest.approx(solution.paper_cost_mm)
    assert np.all(np.diff(solution.paper_mm) > 0)


def test_straightness_shows_a_bent_guide(generator):
    problem = problem_of(generator, sigma_mm=0.0)
    bent = list(problem.observations)
    shifted = apply_changes(bent[4].pose.camera_from_board.matrix, np.array([0, 0, 0, 0.3, 0, 0.0]))
    bent[4] = replace(bent[4], board=stated_pose(RigidTransform(shifted, "camera", "board"), 1.0, 1.0))
    solution = solve(GuideProblem(tuple(bent), X))
    assert int(np.argmax(np.hypot(solution.straightness_mm, solution.along_mm))) == 4


def test_a_board_that_rotated_is_reported(generator):
    problem = problem_of(generator, sigma_mm=0.0)
    turned = list(problem.observations)
    pose = apply_changes(turned[0].pose.camera_from_board.matrix, np.array([0.05, 0, 0, 0, 0, 0.0]))
    turned[0] = replace(turned[0], board=stated_pose(RigidTransform(pose, "camera", "board"), 1.0, 1.0))
    assert "seems to turn" in solve(GuideProblem(tuple(turned), X)).warnings[0]


def test_two_positions_are_too_few(generator):
    with pytest.raises(CalibrationError, match="at least 3"):
        solve(problem_of(generator, positions=[-100.0, 100.0]))


def test_positions_in_metres_are_refused(generator):
    problem = problem_of(generator)
    metres = tuple(replace(one, readback=replace(one.readback, guide_mm=one.readback.guide_mm * 0.05)) for one in problem.observations)
    with pytest.raises(CalibrationError, match="per displayed millimetre"):
        solve(GuideProblem(metres, X))


def test_too_few_positions_over_too_short_a_stroke_are_said(generator):
    assert len(shortfalls(problem_of(generator, positions=[0.0, 20.0]).observations)) == 2
    assert len(shortfalls(problem_of(generator, positions=[0.0, 20.0, 40.0]).observations)) == 1
    assert shortfalls(problem_of(generator).observations) == ()
