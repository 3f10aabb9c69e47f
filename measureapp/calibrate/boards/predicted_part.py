"""Identification of the part of a board that one image shows, by the predicted pose of the board.

The pose is that of other calibrated cameras at the same position, or follows from other angles of the table: two sightings whose table
angles differ determine the axis of the table in the cameras' frame, since the motion between them is a rotation by the known angle. The
standard deviation of the prediction is propagated from the noise of the marks in those sightings by first derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.calibrate.boards.find import find_board
from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.boards.pose import pose_of
from measureapp.calibrate.poses import apply_changes
from measureapp.calibrate.sightings import Sighting, rms
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.transform import RigidTransform, orthonormalise, rotation_about

LEAST_TURN_RAD = float(np.deg2rad(2.0))  # between the two sightings
SAME_ANGLE_RAD = float(np.deg2rad(0.01))
MOST_OFF = 0.5  # of the distance of marks, by which a prediction may be wrong
MOST_SLIP = 0.25  # of the distance of marks, by which the two sightings may contradict their angles
SIGMAS = 3.0
STEP = 1e-5  # of derivatives, rad and mm
RANK = 1e-9  # of I − R, whose null space is the direction of the axis
TINY = 1e-300


def find_part_by_cameras(
    image: ImageArray, camera: str, seen: Mapping[str, Sighting], cameras: CameraArrayCalibration, board: BoardDescription
) -> Sighting:
    """Identify the part of the board in the image of ``camera`` by the pose from other calibrated cameras; else as `find_board`.

    Parameters
    ----------
    seen : other cameras -> their sightings of the same position, at least one

    Raises
    ------
    CalibrationError
        As `find_board`; also where the pose does not determine which part it is.
    """
    pose = pose_of(seen, cameras, board)
    own = cameras.cameras[camera]
    expected = own.pinhole.project(own.reference_from_camera.inverse().apply(pose.camera_from_board.apply(board.corners_mm)))
    return find_board(image, board, expected)


def find_part_by_table(
    image: ImageArray, camera: str, seen: Sequence[Observation], table_rad: float, cameras: CameraArrayCalibration, board: BoardDescription
) -> Sighting:
    """Identify the part of the board in the image of ``camera`` by its poses at other angles of the table; else as `find_board`.

    Parameters
    ----------
    seen : by the same stationary cameras, with pose and table angle; the prediction needs two, or one at the same angle
    table_rad : present angle of the table

    Raises
    ------
    CalibrationError
        As `find_board`; also where the sightings do not predict the board to half the distance of its marks.
    """
    return find_board(image, board, predict_marks(seen, table_rad, cameras.cameras[camera], board))


def predict_marks(seen: Sequence[Observation], table_rad: float, camera: CameraCalibration, board: BoardDescription) -> FloatArray | None:
    """Return where the marks of the board should be in the image of ``camera`` (all, 2); None where the prediction is too uncertain."""
    chosen = _choose_sightings(seen, table_rad)
    if chosen is None or not _is_consistent(chosen, board):
        return None
    points = _marks_in_camera(_predict_pose(chosen, table_rad, board), camera, board)
    if points[:, 2].min() <= 0:
        return None
    pixels = camera.pinhole.project(points)
    return pixels if SIGMAS * _sigma_px(chosen, table_rad, camera, board) < MOST_OFF * _spacing_px(pixels, board) else None


def _choose_sightings(seen: Sequence[Observation], table_rad: float) -> tuple[Observation, ...] | None:
    """One sighting at the same angle; else the pair that determines the axis best, then the sighting nearest in angle."""
    nearest = min(seen, key=lambda one: abs(_table_angle(one) - table_rad), default=None)
    if nearest is None or abs(_table_angle(nearest) - table_rad) < SAME_ANGLE_RAD:
        return None if nearest is None else (nearest,)
    turns = {pair: abs(np.sin(_table_angle(pair[1]) - _table_angle(pair[0]))) for pair in combinations(seen, 2)}
    best = max(turns, key=lambda pair: turns[pair], default=None)
    return None if best is None or turns[best] < np.sin(LEAST_TURN_RAD) else (*best, nearest)


def _is_consistent(chosen: Sequence[Observation], board: BoardDescription) -> bool:
    """Whether the motion of the pair agrees with its table angles; angles of another unit or a slipped board predict nothing."""
    if len(chosen) == 1:
        return True
    first, second, _ = chosen
    there = _predict_pose((first, second, first), _table_angle(second), board)
    seen = second.pose.camera_from_board.apply(board.corners_mm)
    return rms(RigidTransform(orthonormalise(there), "camera", "board").apply(board.corners_mm) - seen) < MOST_SLIP * board.neighbour_mm


def _predict_pose(chosen: Sequence[Observation], table_rad: float, board: BoardDescription) -> FloatArray:
    """Return camera_from_board (4, 4) at an angle: that of the last sighting, rotated about the axis that the first two determine."""
    last = chosen[-1].pose.camera_from_board
    if len(chosen) == 1:
        return last.matrix
    first, second = (one.pose.camera_from_board for one in chosen[:2])
    known = _table_angle(chosen[1]) - _table_angle(chosen[0])
    turned = second.rotation @ first.rotation.T
    skew = np.array([turned[2, 1] - turned[1, 2], turned[0, 2] - turned[2, 0], turned[1, 0] - turned[0, 1]]) * np.sign(np.sin(known))
    axis = skew / max(float(np.linalg.norm(skew)), TINY)
    turn = rotation_about(axis, known) if skew.any() else np.eye(3)
    offset = second.apply(board.middle_mm) - turn @ first.apply(board.middle_mm)
    point = np.linalg.pinv(np.eye(3) - turn, rcond=RANK) @ offset
    further = rotation_about(axis, table_rad - _table_angle(chosen[-1])) if skew.any() else np.eye(3)
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = further, point - further @ point
    return np.asarray(result @ last.matrix)


def _marks_in_camera(place: FloatArray, camera: CameraCalibration, board: BoardDescription) -> FloatArray:
    seen = RigidTransform(orthonormalise(place), "camera", "board").apply(board.corners_mm)
    return camera.reference_from_camera.inverse().apply(seen)


def _sigma_px(chosen: Sequence[Observation], table_rad: float, camera: CameraCalibration, board: BoardDescription) -> float:
    """The largest standard deviation of a predicted mark, from the noise of the poses it is predicted from."""
    variance = np.zeros((board.count, 2))
    for one in dict.fromkeys(chosen):
        for column in np.linalg.cholesky(np.linalg.inv(one.pose.information)).T:
            length = float(np.linalg.norm(column))
            ends = []
            for step in (STEP / length * column, -STEP / length * column):
                changed = [_change_pose(other, step) if other is one else other for other in chosen]
                ends.append(camera.pinhole.project(_marks_in_camera(_predict_pose(changed, table_rad, board), camera, board)))
            variance += ((ends[0] - ends[1]) * length / (2 * STEP)) ** 2
    return float(np.sqrt(variance.sum(axis=1).max()))


def _change_pose(one: Observation, step: FloatArray) -> Observation:
    pose = RigidTransform(orthonormalise(apply_changes(one.pose.camera_from_board.matrix, step)), "camera", "board")
    return replace(one, board=replace(one.pose, camera_from_board=pose))


def _table_angle(one: Observation) -> float:
    assert one.readback.table_rad is not None  # the caller chose those whose angle is known
    return one.readback.table_rad


def _spacing_px(pixels: FloatArray, board: BoardDescription) -> float:
    """The smallest distance of neighbouring marks in the image."""
    grid = pixels.reshape(board.rows, board.columns, 2)
    return float(min(np.linalg.norm(np.diff(grid, axis=axis), axis=2).min() for axis in (0, 1)))
