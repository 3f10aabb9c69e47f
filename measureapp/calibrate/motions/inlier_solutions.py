"""Rotation axis, hand-eye transform and linear guide with rejection of outliers: views in which the board had moved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.observation import Observation, flanges_of, slides_of
from measureapp.calibrate.motions import hand_eye, linear_guide, rotation_axis
from measureapp.calibrate.motions.axis_circles import LEAST_POSITIONS
from measureapp.calibrate.motions.chain import poses_of
from measureapp.calibrate.motions.hand_eye import LEAST_POSES, HandEyeProblem, HandEyeSolution
from measureapp.calibrate.motions.linear_guide import GuideProblem, GuideSolution
from measureapp.calibrate.motions.outlier_rejection import reject_outliers
from measureapp.calibrate.motions.rotation_axis import AxisProblem, AxisSolution
from measureapp.calibrate.poses import invert_poses, mean_pose, stack_matrices
from measureapp.data.calibration import HandEye, LinearGuide
from measureapp.progress import Progress

Solution = TypeVar("Solution")


@dataclass(frozen=True, slots=True, eq=False)
class InlierSolution(Generic[Solution]):
    """A solution from the views in which the board did not move."""

    solution: Solution
    kept: tuple[int, ...]  # the views used
    rejected: Mapping[int, str]  # view -> reason


def solve_axis(problem: AxisProblem, progress: Progress | None = None) -> InlierSolution[AxisSolution]:
    """Solve an axis as `rotation_axis.solve`, rejecting positions in which the board had moved. Raises CalibrationError as that."""
    corners = np.asarray(problem.corners_mm, float)

    def solve(kept: Sequence[int]) -> tuple[AxisSolution, dict[int, FloatArray]]:
        solution = rotation_axis.solve(_positions(problem, kept), progress)
        axis, angles = solution.best.axis, solution.best.angles_rad
        first = np.mean([axis.turned(-float(angle)).apply(corners[index]) for index, angle in zip(kept, angles, strict=True)], axis=0)
        return solution, {index: axis.turned(float(angle)).apply(first) for index, angle in zip(kept, angles, strict=True)}

    return _inlier_solution(*reject_outliers(range(len(corners)), solve, dict(enumerate(corners)), LEAST_POSITIONS), len(corners))


def solve_hand_eye(problem: HandEyeProblem, marks_mm: FloatArray, progress: Progress | None = None) -> InlierSolution[HandEyeSolution]:
    """Solve hand-eye as `hand_eye.solve`, rejecting poses at which the board had moved.

    Parameters
    ----------
    marks_mm : (M, 3) of the board

    Raises
    ------
    CalibrationError
        As `hand_eye.solve`.
    """

    def solve(kept: Sequence[int]) -> tuple[HandEyeSolution, dict[int, FloatArray]]:
        part = HandEyeProblem(
            tuple(problem.base_from_flange[index] for index in kept),
            tuple(problem.boards[index] for index in kept),
            problem.noise,
            None if problem.camera_jacobian is None else problem.camera_jacobian[list(kept)],
            problem.camera_prior,
        )
        solution = hand_eye.solve(part, progress)
        return solution, dict(
            zip(kept, _marks_at(predict_hand_eye_boards(solution, stack_matrices(part.base_from_flange)), marks_mm), strict=True)
        )

    seen = dict(enumerate(_marks_at(poses_of(problem.boards), marks_mm)))
    return _inlier_solution(*reject_outliers(range(len(seen)), solve, seen, LEAST_POSES), len(seen))


def solve_guide(problem: GuideProblem, marks_mm: FloatArray) -> InlierSolution[GuideSolution]:
    """Solve a guide as `linear_guide.solve`, rejecting positions in which the board had moved; ``marks_mm`` (M, 3) are the board's."""

    def solve(kept: Sequence[int]) -> tuple[GuideSolution, dict[int, FloatArray]]:
        chosen = tuple(problem.observations[index] for index in kept)
        solution = linear_guide.solve(replace(problem, observations=chosen))
        return solution, dict(zip(kept, _marks_at(predict_guide_boards(solution.guide, problem.hand_eye, chosen), marks_mm), strict=True))

    boards = poses_of([one.pose for one in problem.observations])
    seen = dict(enumerate(_marks_at(boards, marks_mm)))
    return _inlier_solution(*reject_outliers(range(len(seen)), solve, seen, linear_guide.LEAST_POSITIONS), len(seen))


def predict_hand_eye_boards(solution: HandEyeSolution, flanges: FloatArray) -> FloatArray:
    """Predict camera_from_board (N, 4, 4) by a hand-eye solution at base_from_flange (N, 4, 4)."""
    return invert_poses(flanges @ solution.refined.flange_from_camera.matrix) @ solution.base_from_board.matrix


def predict_guide_boards(guide: LinearGuide, hand_eye: HandEye, seen: Sequence[Observation]) -> FloatArray:
    """Predict camera_from_board (N, 4, 4) by a guide; the board is fixed at the mean of its observed poses."""
    shifts = np.array([guide.guide_from_base(float(position)).matrix for position in slides_of(seen)])
    cameras = shifts @ flanges_of(seen) @ hand_eye.flange_from_camera.matrix
    return invert_poses(cameras) @ mean_pose(cameras @ poses_of([one.pose for one in seen]))


def _positions(problem: AxisProblem, kept: Sequence[int]) -> AxisProblem:
    index = list(kept)
    return replace(
        problem,
        corners_mm=np.asarray(problem.corners_mm)[index],
        angles_rad=None if problem.angles_rad is None else np.asarray(problem.angles_rad)[index],
        poses=tuple(problem.poses[one] for one in index) if problem.poses else (),
        camera_jacobian=None if problem.camera_jacobian is None else problem.camera_jacobian[index],
        names=tuple(problem.names[one] for one in index) if problem.names else tuple(map(str, index)),
    )


def _marks_at(poses: FloatArray, marks_mm: FloatArray) -> FloatArray:
    return np.asarray(marks_mm @ np.swapaxes(poses[:, :3, :3], 1, 2) + poses[:, None, :3, 3])


def _inlier_solution(solution: Solution, rejected: Mapping[int, str], count: int) -> InlierSolution[Solution]:
    return InlierSolution(solution, tuple(index for index in range(count) if index not in rejected), rejected)
