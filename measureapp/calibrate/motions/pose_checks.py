"""Poses of robot and board that cannot belong together: in metres, the wrong way round, or in another order."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.motions.hand_eye_methods import park_martin
from measureapp.calibrate.motions.relative import Motions, motions_between
from measureapp.calibrate.poses import change_between, invert_poses, mean_pose
from measureapp.errors import CalibrationError

SWAPPED_SHARE = 0.3  # inverted poses that fit better than this share of the residual were given the wrong way round
LEAST_SWAPPED_MM = 1.0
METRE_SCALES = (100.0, 0.01)
SHORTEST_DISTANCE_MM = 5.0
LARGEST_SLIDE_IN_METRES, LEAST_SLIDE_IN_METRES = 10.0, 0.01
SIZE_TOLERANCE = 0.02  # of the length of a square; below it the residuals decide
LARGEST_ANGLE_GAP_RAD = np.deg2rad(2.0)


def board_deviations(x: FloatArray, robot: FloatArray, camera: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return how far the board is from its mean place (N,) mm, and how far it is turned against it (N,) rad, with a hand-eye transform."""
    boards = robot @ x @ camera
    change = change_between(np.broadcast_to(mean_pose(boards), boards.shape), boards)
    return np.linalg.norm(change[:, 3:], axis=1), np.linalg.norm(change[:, :3], axis=1)


def check_units(camera: FloatArray, motions: Motions) -> None:
    """Refuse robot or board poses that are in metres. Raises CalibrationError."""
    distance = float(np.median(np.linalg.norm(camera[:, :3, 3], axis=1)))
    if distance < SHORTEST_DISTANCE_MM:
        raise CalibrationError(f"The board poses put the board {distance:.3f} mm from the camera.", "They seem to be in metres: give mm.")
    scale = _scale(motions)
    if scale > METRE_SCALES[0] or 0 < scale < METRE_SCALES[1]:
        which = "robot" if scale > 1 else "board"
        raise CalibrationError(
            f"The translations of the {which} poses are about {max(scale, 1 / scale):.0f} times too small for those of the others.",
            f"The {which} poses seem to be in metres: give mm.",
        )


def check_direction(robot: FloatArray, camera: FloatArray, shift_mm: FloatArray | None = None) -> None:
    """Refuse poses given as their inverses. Raises CalibrationError.

    Inverting the robot poses or the board poses spoils A X = X B in the same way; only the board's place in front of the camera
    tells which. Inverting both leaves an equation of the same form. ``shift_mm`` (N, 3) is displacement of the robot by a guide.
    """
    hint = "Give base_from_flange for the robot and camera_from_board for the board."
    distance = camera[:, 2, 3]
    shift = np.zeros((len(robot), 3)) if shift_mm is None else shift_mm
    carried = _shift(robot, shift)
    own = _misfit(carried, camera)
    spoiled = own > LEAST_SWAPPED_MM and SWAPPED_SHARE * own > min(
        _misfit(_shift(invert_poses(robot), shift), camera), _misfit(carried, invert_poses(camera))
    )
    if np.all(distance <= 0) or (spoiled and np.median(distance) <= 0):
        raise CalibrationError("The board lies behind the camera: the board poses seem to be board_from_camera.", hint)
    if spoiled:
        raise CalibrationError("The robot poses seem to be flange_from_base (or the board poses board_from_camera).", hint)


def check_board_size(robot: FloatArray, camera: FloatArray, motions: Motions, shift_mm: FloatArray | None = None) -> None:
    """Refuse board poses that scatter less if its squares are scaled. Raises CalibrationError.

    Parameters
    ----------
    shift_mm : (N, 3), displacement of the robot by a guide
    """
    scale = _scale(motions)
    if abs(scale - 1) <= SIZE_TOLERANCE:
        return
    carried, resized = _shift(robot, np.zeros((len(robot), 3)) if shift_mm is None else shift_mm), np.array(camera)
    resized[:, :3, 3] /= scale
    own = _misfit(carried, camera)
    if own > LEAST_SWAPPED_MM and _misfit(carried, resized) < SWAPPED_SHARE * own:
        raise CalibrationError(
            f"The board moved {scale:.3f} times as far as the robot.",
            f"Check the size of the board: its squares seem to be {1 / scale:.3f} times as large as stated.",
        )


def _scale(motions: Motions) -> float:
    """Return the ratio of the robot's travel by the board poses to that by its read-backs."""
    rotation = park_martin(motions)[:3, :3]
    rows = np.concatenate([motions.flange[:, :3, :3] - np.eye(3), motions.flange[:, :3, 3:]], axis=2).reshape(-1, 4)
    right = (motions.camera[:, :3, 3] @ rotation.T).ravel()
    return float(np.linalg.lstsq(rows, right, rcond=None)[0][3])


def _misfit(robot: FloatArray, camera: FloatArray) -> float:
    """Return how much the board moves in the base frame with Park's solution, mm; infinite without one."""
    try:
        motions, _ = motions_between(robot, camera)
    except CalibrationError:
        return float("inf")
    return float(np.mean(board_deviations(park_martin(motions), robot, camera)[0]))


def _shift(poses: FloatArray, shift_mm: FloatArray) -> FloatArray:
    result = np.array(poses)
    result[:, :3, 3] += shift_mm
    return result


def check_robot_unit(base_from_flange: FloatArray) -> None:
    """Refuse robot poses (N, 4, 4) that all lie within millimetres of the base. Raises CalibrationError."""
    farthest = float(np.max(np.linalg.norm(base_from_flange[:, :3, 3], axis=1)))
    if farthest < SHORTEST_DISTANCE_MM:
        raise CalibrationError(
            f"No pose of the robot is further than {farthest:.3g} mm from its base.", "The robot poses seem to be in metres: give mm."
        )


def check_guide_unit(base_from_flange: FloatArray, slide_mm: FloatArray, camera_from_board: FloatArray, along: FloatArray) -> None:
    """Refuse slide positions (N,) that fit better as metres. Raises CalibrationError."""
    travel = float(np.ptp(slide_mm))
    if not LEAST_SLIDE_IN_METRES < travel < LARGEST_SLIDE_IN_METRES:
        return

    def misfit(unit: float) -> float:
        return _misfit(_shift(base_from_flange, unit * slide_mm[:, None] * along), camera_from_board)

    own = misfit(1.0)
    if own > LEAST_SWAPPED_MM and misfit(1000.0) < SWAPPED_SHARE * own:
        raise CalibrationError(
            f"The guide travelled {travel:.3g} mm, but the board moved 1000 times as far.", "Give guide positions in mm."
        )


def check_table_angles(given_rad: FloatArray, seen_rad: FloatArray) -> None:
    """Refuse table angles (K,) that contradict the observed rotation of the board. Raises CalibrationError."""
    gaps = np.abs(np.angle(np.exp(1j * ((given_rad - given_rad[0]) - (seen_rad - seen_rad[0])))))
    if np.median(gaps[1:]) > LARGEST_ANGLE_GAP_RAD:
        worst = int(np.argmax(gaps))
        raise CalibrationError(
            f"According to its angles the table turned by {np.rad2deg(given_rad[worst] - given_rad[0]):.2f}°, "
            f"but the board turned by {np.rad2deg(seen_rad[worst] - seen_rad[0]):.2f}°.",
            "Check the unit (degrees) and the order of the table angles, and that the board did not move on the table.",
        )
