"""Every hand-eye method agrees with OpenCV 4's on sets without noise, and where OpenCV's miss; run with ``-m slow``."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions.hand_eye import HandEyeProblem, solve
from measureapp.calibrate.poses import apply_changes
from measureapp.geometry.transform import RigidTransform
from tests.peer_environment import peer_python

pytestmark = pytest.mark.slow
PEERS = Path(__file__).parent / "peers"
SETS, POSES = 12, 10


def poses(
    generator: np.random.Generator, x: RigidTransform | None = None, noise: tuple[float, float] = (0.0, 0.0), half_turn: bool = False
) -> tuple[np.ndarray, np.ndarray]:
    """Return base_from_flange and camera_from_board (N, 4, 4) of a random rig.

    Parameters
    ----------
    x : flange_from_camera; without it a random one
    noise : standard deviations of the robot's poses, rad and mm
    half_turn : whether the last pose is the first one turned by half a turn about the camera's axis
    """
    x = x or RigidTransform.from_vector(generator.uniform(-1.5, 1.5, 3), generator.uniform(-200, 200, 3), "flange", "camera")
    base_from_board = RigidTransform.from_vector(generator.uniform(-2, 2, 3), generator.uniform(-800, 800, 3), "base", "board")
    robot, boards = [], []
    for number in range(POSES):
        turn = Rotation.from_rotvec(generator.uniform(-0.7, 0.7, 3))
        place = [*generator.uniform(-80, 80, 2), generator.uniform(450, 650)]
        seen = np.array(RigidTransform.from_parts(turn.as_matrix(), place, "camera", "board").matrix)
        if half_turn and number == POSES - 1:
            seen = np.diag([-1.0, -1.0, 1.0, 1.0]) @ boards[0]
        robot.append(apply_changes(base_from_board.matrix @ np.linalg.inv(x.matrix @ seen), generator.normal(size=6) * np.repeat(noise, 3)))
        boards.append(seen)
    return np.array(robot), np.array(boards)


def by_opencv(folder: Path, sets: list[tuple[np.ndarray, np.ndarray]]) -> list[dict[str, np.ndarray]]:
    """Return flange_from_camera of every set by every method of OpenCV 4."""
    python = peer_python("opencv4", PEERS / "requirements.lock")
    np.savez(folder / "sets.npz", robot=np.array([robot for robot, _ in sets]), board=np.array([board for _, board in sets]))
    command = [str(python), str(PEERS / "run_hand_eye.py"), str(folder / "sets.npz")]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    assert answer["version"].startswith("4.")
    return [{name: np.array(matrix) for name, matrix in peers.items()} for peers in answer["sets"]]


def by_us(robot: np.ndarray, board: np.ndarray) -> dict[str, np.ndarray]:
    flanges = tuple(RigidTransform(pose, "base", "flange") for pose in robot)
    boards = tuple(stated_pose(RigidTransform(pose, "camera", "board"), 1e-4, 0.03) for pose in board)
    return {name: estimate.flange_from_camera.matrix for name, estimate in solve(HandEyeProblem(flanges, boards)).methods.items()}


def test_every_method_agrees_with_opencv_to_a_millionth(tmp_path):
    sets = [poses(np.random.default_rng(seed)) for seed in range(SETS)]
    for one, peers in zip(sets, by_opencv(tmp_path, sets), strict=True):
        own = by_us(*one)
        assert set(own) == set(peers)
        for name, matrix in peers.items():
            np.testing.assert_allclose(own[name], matrix, atol=1e-6, err_msg=name)


def test_tsai_of_opencv_misses_a_camera_turned_by_half_a_turn_and_ours_does_not(tmp_path):
    x = RigidTransform.from_vector([np.pi, 0, 0], [100, -150, 80], "flange", "camera")
    one = poses(np.random.default_rng(1), x)
    (peers,) = by_opencv(tmp_path, [one])
    assert np.linalg.norm(peers["tsai_lenz"][:3, 3] - x.translation_mm) > 1.0
    np.testing.assert_allclose(by_us(*one)["tsai_lenz"], x.matrix, atol=1e-6)


def test_daniilidis_of_opencv_misses_where_two_poses_are_half_a_turn_apart_and_ours_does_not(tmp_path):
    x = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
    sets = [poses(np.random.default_rng(seed), x, half_turn=True) for seed in range(SETS)]
    off = [np.linalg.norm(peers["daniilidis"][:3, 3] - x.translation_mm) for peers in by_opencv(tmp_path, sets)]
    assert max(off) > 1.0
    for one in sets:
        np.testing.assert_allclose(by_us(*one)["daniilidis"], x.matrix, atol=1e-6)


def test_andreff_shah_and_li_of_opencv_err_more_than_ours(tmp_path):
    x = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
    sets = [poses(np.random.default_rng(seed), x, noise=(2e-4, 0.05)) for seed in range(SETS)]
    theirs, own = by_opencv(tmp_path, sets), [by_us(*one) for one in sets]
    for name in ("andreff", "shah", "li_wang_wu"):
        errors = [np.sqrt(np.mean([np.sum((one[name][:3, 3] - x.translation_mm) ** 2) for one in each])) for each in (theirs, own)]
        assert errors[0] > 1.5 * errors[1], name
