"""The proposed pose makes the hand-eye transform better than one taken at random."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.hand_eye import HandEyeProblem, solve
from measureapp.calibrate.motions.next_pose import propose
from measureapp.calibrate.poses import apply_changes
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise

X = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
BASE_FROM_BOARD = RigidTransform.from_vector([2.0, 0.3, -0.4], [600, 50, 100], "base", "board")
NOISE = AxisNoise(robot_mm=0.05, robot_rad=2e-4)
BOARD_MM, BOARD_RAD = 0.03, 1e-4
ADDED = 3


def reachable(generator, count, largest_rad):
    """Return poses that look at the board, turned by up to ``largest_rad`` about each axis."""
    poses = []
    for _ in range(count):
        turn = Rotation.from_rotvec(generator.uniform(-largest_rad, largest_rad, 3)) * Rotation.from_rotvec([0.2, 0.1, 0.4])
        seen = RigidTransform.from_parts(turn.as_matrix(), [*generator.uniform(-80, 80, 2), generator.uniform(500, 600)], "camera", "board")
        poses.append(BASE_FROM_BOARD @ seen.inverse() @ X.inverse())
    return poses


def seen_from(flange, generator):
    """Return the board pose seen when the robot, told to stand at ``flange``, stands beside it."""
    error = generator.normal(size=6) * [*[NOISE.robot_rad] * 3, *[NOISE.robot_mm] * 3]
    true = RigidTransform(orthonormalise(flange.matrix @ apply_changes(np.eye(4), error)), "base", "flange")
    seen = (true @ X).inverse() @ BASE_FROM_BOARD
    change = generator.normal(size=6) * [*[BOARD_RAD] * 3, *[BOARD_MM] * 3]
    return stated_pose(RigidTransform(apply_changes(seen.matrix, change), "camera", "board"), BOARD_RAD, BOARD_MM)


def error_at_part(solution):
    part = solution.part_in_camera_mm
    return float(np.linalg.norm(solution.refined.flange_from_camera.apply(part) - X.apply(part)))


def series(seed, choose):
    """Return the error at the part after ``choose`` picked further poses for a weak start."""
    generator = np.random.default_rng(seed)
    flanges = reachable(generator, 4, 0.25)
    candidates = reachable(generator, 24, 0.8)
    boards = [seen_from(flange, generator) for flange in flanges]
    for _ in range(ADDED):
        solution = solve(HandEyeProblem(tuple(flanges), tuple(boards), NOISE))
        chosen = candidates.pop(choose(solution, candidates, generator))
        flanges.append(chosen)
        boards.append(seen_from(chosen, generator))
    return error_at_part(solve(HandEyeProblem(tuple(flanges), tuple(boards), NOISE)))


def by_chance(solution, candidates, generator):
    return int(generator.integers(len(candidates)))


def by(criterion):
    return lambda solution, candidates, generator: propose(solution, candidates, criterion=criterion)[0].candidate


def test_proposed_poses_leave_a_smaller_error_than_random_ones():
    random, proposed = (np.array([series(seed, choose) for seed in range(16)]) for choose in (by_chance, by("part")))
    assert np.sqrt(np.mean(proposed**2)) < 0.9 * np.sqrt(np.mean(random**2))


@pytest.fixture(scope="module")
def random_100():
    return np.array([series(seed, by_chance) for seed in range(100)])


@pytest.mark.slow
@pytest.mark.parametrize("criterion", ["part", "A", "D"])
def test_proposed_poses_beat_random_ones_with_confidence(criterion, random_100, record_property):
    gain = random_100**2 - np.array([series(seed, by(criterion)) for seed in range(100)]) ** 2
    record_property(
        "rms at the part, by chance and proposed, mm", np.sqrt([np.mean(random_100**2), np.mean(random_100**2 - gain)]).tolist()
    )
    assert gain.mean() > 1.96 * gain.std(ddof=1) / np.sqrt(len(gain))


def test_the_predicted_sigma_is_that_of_the_series_with_the_pose():
    generator = np.random.default_rng(3)
    flanges = reachable(generator, 5, 0.4)
    boards = [seen_from(flange, generator) for flange in flanges]
    solution = solve(HandEyeProblem(tuple(flanges), tuple(boards), NOISE))
    best = propose(solution, reachable(generator, 10, 0.8))[0]
    boards.append(seen_from(best.base_from_flange, generator))
    after = solve(HandEyeProblem((*flanges, best.base_from_flange), tuple(boards), NOISE))
    from measureapp.calibrate.motions.next_pose import lever_at

    carry = lever_at(solution.part_in_camera_mm, after.minimum.state)
    own = after.minimum.covariance()[:6, :6]
    assert best.sigma_at_part_mm == pytest.approx(np.sqrt(np.linalg.eigvalsh(carry @ own @ carry.T)[-1]), rel=0.05)


def test_a_further_pose_never_takes_information_away():
    generator = np.random.default_rng(4)
    flanges = reachable(generator, 5, 0.4)
    solution = solve(HandEyeProblem(tuple(flanges), tuple(seen_from(flange, generator) for flange in flanges), NOISE))
    gains = [proposal.gain for proposal in propose(solution, reachable(generator, 10, 0.8), criterion="D")]
    assert gains == sorted(gains, reverse=True)
    assert 0 < min(gains) <= max(gains) < 1


def test_no_candidates_are_refused():
    generator = np.random.default_rng(4)
    flanges = reachable(generator, 5, 0.4)
    solution = solve(HandEyeProblem(tuple(flanges), tuple(seen_from(flange, generator) for flange in flanges), NOISE))
    with pytest.raises(CalibrationError, match="no candidate poses"):
        propose(solution, [])
