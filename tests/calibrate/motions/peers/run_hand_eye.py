"""Solve hand-eye sets with OpenCV 4; runs in the peers' own environment and prints one JSON document.

Usage: ``python run_hand_eye.py SETS.npz`` with ``robot`` and ``board`` (S, N, 4, 4): base_from_flange and camera_from_board.
"""

import json
import sys

import cv2
import numpy as np

HAND_EYE = {
    "tsai_lenz": cv2.CALIB_HAND_EYE_TSAI,
    "park_martin": cv2.CALIB_HAND_EYE_PARK,
    "horaud": cv2.CALIB_HAND_EYE_HORAUD,
    "daniilidis": cv2.CALIB_HAND_EYE_DANIILIDIS,
    "andreff": cv2.CALIB_HAND_EYE_ANDREFF,
}
ROBOT_WORLD = {"shah": cv2.CALIB_ROBOT_WORLD_HAND_EYE_SHAH, "li_wang_wu": cv2.CALIB_ROBOT_WORLD_HAND_EYE_LI}


def joined(rotation, translation):
    """Return a 4×4 matrix as lists."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, np.ravel(translation)
    return matrix.tolist()


def solved(robot, board):
    """Return flange_from_camera by every method."""
    result = {}
    for name, method in HAND_EYE.items():
        parts = (list(robot[:, :3, :3]), list(robot[:, :3, 3]), list(board[:, :3, :3]), list(board[:, :3, 3]))
        result[name] = joined(*cv2.calibrateHandEye(*parts, method=method))
    back = np.linalg.inv(robot)  # OpenCV's robot-world form takes flange_from_base and gives base_from_board, flange_from_camera
    for name, method in ROBOT_WORLD.items():
        parts = (list(board[:, :3, :3]), list(board[:, :3, 3]), list(back[:, :3, :3]), list(back[:, :3, 3]))
        _, _, rotation, translation = cv2.calibrateRobotWorldHandEye(*parts, method=method)
        result[name] = np.linalg.inv(np.array(joined(rotation, translation))).tolist()
    return result


def main():
    """Solve all sets and print them."""
    sets = np.load(sys.argv[1])
    answers = [solved(robot, board) for robot, board in zip(sets["robot"], sets["board"], strict=True)]
    json.dump({"version": cv2.__version__, "sets": answers}, sys.stdout)


if __name__ == "__main__":
    main()
