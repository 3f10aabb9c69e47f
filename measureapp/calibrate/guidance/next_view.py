"""D-optimal design of views: the next view of the board that adds most information on cameras or projector."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from measureapp.arrays import IntArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.prior import derivatives
from measureapp.calibrate.draft.advice import outlines_px
from measureapp.data.board import BoardDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about

MARKS = 25  # of the board stand for all of them
PLACES = (0.25, 0.5, 0.75)  # of the board's middle, over width and height of the image
TILT_RAD = np.deg2rad(30.0)
TILT_WAYS = ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))  # of the board's normal, in x and y of the camera
BOARD = "board"  # owner of the labels of its bow
NEARER, FARTHER = 0.9, 1.1  # of the median distance


def board_before(
    pinhole: PinholeCamera, board: BoardDescription, at: tuple[float, float], way: tuple[float, float], distance_mm: float
) -> RigidTransform:
    """Return camera_from_board with the board's middle at a place of the image and its normal tilted by 30°.

    Parameters
    ----------
    at : shares of width and height
    way : components of the normal in x and y of the camera, each -1, 0 or 1; (0, 0) is square to the line of sight
    """
    pixel = np.array([[at[0] * (pinhole.width_px - 1), at[1] * (pinhole.height_px - 1)]])
    ray = np.array([*pinhole.normalise(pixel)[0], 1.0])
    turn = np.eye(3) if way == (0.0, 0.0) else rotation_about([-way[1], way[0], 0.0], TILT_RAD)
    return RigidTransform.from_parts(turn, ray * distance_mm - turn @ board.middle_mm, "camera", "board")


def best_view(solution: CameraArraySolution, distance_mm: float, lenses: Sequence[str]) -> RigidTransform | None:
    """Return camera_from_board of the candidate that adds most to the Fisher information of ``lenses``; None where none is completely visible.

    Candidates are a grid of places, tilts and distances before every camera. A view adds ΔI = Σ Jᵀ J / σ², the board's own pose taken
    out by the Schur complement; cameras that are known tell only that pose. The gain is ln det(I + Σ ΔI), the shrinking of the confidence ellipsoid of all parameters [1]_.

    References
    ----------
    .. [1] V. V. Fedorov, Theory of Optimal Experiments, Academic Press 1972, chapter 2.
    """
    best, most = None, 0.0
    for place in candidates(solution, distance_mm, lenses):
        gain = gain_of(solution, place, lenses)
        if gain > most:
            best, most = place, gain
    return best


def candidates(solution: CameraArraySolution, distance_mm: float, lenses: Sequence[str]) -> Iterator[RigidTransform]:
    """Give camera_from_board of all candidates before ``lenses``, in the reference camera's frame."""
    for camera in (solution.calibration.cameras[name] for name in lenses):
        for at in ((x, y) for x in PLACES for y in PLACES):
            for way in TILT_WAYS:
                for share in (NEARER, FARTHER):
                    own = board_before(camera.pinhole, solution.board, at, way, share * distance_mm)
                    place = camera.reference_from_camera.matrix @ own.matrix
                    yield RigidTransform(place, "camera", "board")


def gain_of(solution: CameraArraySolution, place: RigidTransform, lenses: Sequence[str]) -> float:
    """Return ln det(I + Σ ΔI) for ``lenses`` of a view with the board at ``place``; 0 where none of them sees it whole, or nobody else where others are known."""
    owners = (*lenses, BOARD)
    rows = [index for index, label in enumerate(solution.parameters) if label.rpartition(".")[0] in owners]
    column = {solution.parameters[row]: index for index, row in enumerate(rows)}
    seen_by = outlines_px(solution.calibration, place, solution.board)
    if len(lenses) < len(solution.calibration.cameras) and not set(seen_by) - set(lenses):
        return 0.0
    ids = _few(solution.board)
    weight = solution.board.count / len(ids)
    by_board, own = np.zeros((6, 6)), np.zeros((len(column), len(column)))
    mixed = np.zeros((6, len(column)))
    for name in seen_by:
        by_pose, by_own, labels = derivatives(BoardPose(place, np.eye(6)), solution.calibration.cameras[name], solution.board, ids)
        known = [index for index, label in enumerate(labels) if label in column]
        at, part = [column[labels[index]] for index in known], by_own[:, known]
        scale = weight / solution.sigmas_px[name] ** 2
        by_board += scale * by_pose.T @ by_pose
        mixed[:, at] += scale * by_pose.T @ part
        own[np.ix_(at, at)] += scale * part.T @ part
    if not by_board.any():
        return 0.0
    added = own - mixed.T @ np.linalg.solve(by_board, mixed)
    return float(np.linalg.slogdet(np.eye(len(column)) + solution.covariance[np.ix_(rows, rows)] @ added)[1])


def _few(board: BoardDescription) -> IntArray:
    grid = np.arange(board.count).reshape(board.rows, board.columns)
    side = int(np.sqrt(MARKS))
    rows, columns = (_spread(count, side) for count in grid.shape)
    return np.asarray(np.sort(grid[np.ix_(rows, columns)].ravel()))


def _spread(count: int, wanted: int) -> IntArray:
    return np.unique(np.round(np.linspace(0, count - 1, min(count, wanted))).astype(int))
