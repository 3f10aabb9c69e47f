"""Every hand-eye method agrees with OpenCV 4's on sets without noise; run with ``-m slow``."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.calibrate.boards.pose import stated_pose
from measureapp.calibrate.motions.hand_eye import HandEyeProblem, solve
from measureapp.geometry.transform import RigidTransform
from tests.peer_environment import peer_python

pytestmark = pytest.mark.slow
PEERS = Path(__file__).parent / "peers"
SETS, POSES = 12, 10


def noise_free(generator: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return base_from_flange and camera_from_board (N, 4, 4) of a random rig."""
    x = RigidTransform.from_vector(generator.uniform(-1.5, 1.5, 3), generator.uniform(-200, 200, 3), "flange", "camera")
    base_from_board = RigidTransform.from_vector(generator.uniform(-2, 2, 3), generator.uniform(-800, 800, 3), "base", "board")
    robot, boards = [], []
    for _ in range(POSES):
        turn = Rotation.from_rotvec(generator.uniform(-0.7, 0.7, 3))
        seen = RigidTransform.from_parts(turn.as_matrix(), [*generator.uniform(-80, 80, 2), generator.uniform(450, 650)], "camera", "board")
        robot.append((base_from_board @ seen.inverse() @ x.inverse()).matrix)
        boards.append(seen.matrix)
    return np.array(robot), np.array(boards)


def test_every_method_agrees_with_opencv_to_a_millionth(tmp_path):
    python = peer_python("opencv4", PEERS / "requirements.lock")
    sets = [noise_free(np.random.default_rng(seed)) for seed in range(SETS)]
    np.savez(tmp_path / "sets.npz", robot=np.array([robot for robot, _ in sets]), board=np.array([board for _, board in sets]))
    command = [str(python), str(PEERS / "run_hand_eye.py"), str(tmp_path / "sets.npz")]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    assert answer["version"].startswith("4.")
    for (robot, board), peers in zip(sets, answer["sets"], strict=True):
        flanges = tuple(RigidTransform(pose, "base", "flange") for pose in robot)
        boards = tuple(stated_pose(RigidTransform(pose, "camera", "board"), 1e-4, 0.03) for pose in board)
        solution = solve(HandEyeProblem(flanges, boards))
        assert set(solution.methods) == set(peers)
        for name, matrix in peers.items():
            np.testing.assert_allclose(solution.methods[name].flange_from_camera.matrix, matrix, atol=1e-6, err_msg=name)
