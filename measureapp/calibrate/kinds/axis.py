"""The table's rotation axis, from a board that the table turns in front of stationary cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Change, Comparison, changes_between, millimetres
from measureapp.calibrate.draft.draft import ALL_AXES, Draft, Effect, Kind, Known, Limits, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, axis_estimates
from measureapp.calibrate.draft.locate import Located, locate_board
from measureapp.calibrate.guidance.travel import advise_table, ghost_for_table
from measureapp.calibrate.kinds.fit import explain_by_rejected, name_poses, solved_axes
from measureapp.calibrate.kinds.on_part import RADIUS_MM, circle_about_axis_mm, half_turn_sigma_mm
from measureapp.calibrate.motions import inlier_solutions
from measureapp.calibrate.motions.propagation import axis_sigmas, propagate_robot_to_axis
from measureapp.calibrate.motions.rotation_axis import AxisOptions, AxisProblem, AxisSolution, problem_from_poses, shortfalls
from measureapp.calibrate.poses import invert_poses, mean_pose
from measureapp.calibrate.rig.stages import transform_axis
from measureapp.data.board import BoardDescription
from measureapp.data.calibration import RotationAxis
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.progress import Progress

NO_RIG = ("The rest of the rig is not calibrated yet.", "Calibrate the whole rig first.")


class Axis(Kind):
    """Direction and position of the rotation axis by maximum likelihood, and by two circle fits for comparison."""

    name = "axis"
    words = Words(
        subject="the rotation axis",
        title="Calibrate the table axis",
        action="Table axis",
        tip="Position and direction of the rotary table's axis",
        purpose="Determines the table's axis, with cameras and robot as calibrated. Fix the board on the table; the table turns it.",
        step="Take the views",
        hints=(
            "Fix the board on the table so that it cannot slip.",
            "Turn the table as far as the board stays in view: short arcs leave their centre uncertain.",
        ),
    )
    limits = Limits(0.05, 0.2, "views that are off by less than 0.05 mm need no registration, those up to 0.2 mm register safely")
    file = "axis.json"
    needs = "rig"
    readback_in_rig = ALL_AXES  # the axis is transformed into the rig, so the position of the head must be known
    motions = ("table",)
    uses_hand_eye = True

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        return solve_draft(draft, progress)

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        try:
            return shortfalls(problem_of(locate_board(draft), draft.setup.board))
        except CalibrationError as error:
            return (str(error),)

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        advise_table(draft, notes)
        return ghost_for_table(draft)

    @override
    def result(self, solved: Solved) -> RotationAxis:
        solution: AxisSolution = solved.solution
        return solution.best.axis

    @override
    def method(self, result: RotationAxis) -> str:
        return "maximum likelihood"

    @override
    def estimates(self, result: RotationAxis) -> Sequence[Estimate]:
        return axis_estimates(result)

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        solution: AxisSolution = solved.solution
        value = COVERAGE_FACTOR * half_turn_sigma_mm(solution.best.axis, solution.covariance)
        sentence = f"Moves a point {RADIUS_MM:.0f} mm from the axis by {millimetres(value)} (k = 2) between views half a turn apart"
        return Effect(value, sentence, robot_mm=_by_robot_mm(draft, solution))

    @override
    def previous(self, known: Known) -> RotationAxis | None:
        return None if known.rig is None else known.rig.axis

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        return compare_axes(previous, self.result(solved)) if isinstance(previous, RotationAxis) else None

    @override
    def compare_merged(self, draft: Draft, solved: Solved, known: Known, result: Known) -> Comparison | None:
        """Compare in the frame of the rig, since the axis in the camera frame depends on the pose of the cameras."""
        return None if known.rig is None or result.rig is None else compare_axes(known.rig.axis, result.rig.axis)

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        rig, setup = known.rig, draft.setup
        if rig is None:
            raise CalibrationError(*NO_RIG)
        seen = self.result(solved)
        first = next(one for one in draft.observations if one.id == solved.used[0])
        axis = propagate_robot_to_axis(transform_axis(seen, rig.guide_from_camera(first.axes)), seen, rig.hand_eye, setup.noise)
        return Known(rig.cameras, replace(rig, axis=axis))

    @override
    def shown(self, known: Known, result: Known) -> Sequence[Estimate]:
        if known.rig is None or result.rig is None:
            return ()
        return axis_at_height(known.rig.axis, float(result.rig.axis.point_mm[2]))


def solve_draft(draft: Draft, progress: Progress, options: AxisOptions | None = None) -> Solved:
    """Solve the rotation axis, positions in which the board had moved rejected. Raises CalibrationError."""
    seen = locate_board(draft)
    try:
        found = inlier_solutions.solve_axis(replace(problem_of(seen, draft.setup.board), options=options or AxisOptions()), progress)
    except CalibrationError as error:
        raise explain_by_rejected(error, seen) from error
    best, kept = found.solution.best, [seen.observations[index] for index in found.kept]
    motions = np.array([best.axis.turned(float(angle)).matrix for angle in best.angles_rad])
    first = mean_pose(invert_poses(motions) @ np.array([one.pose.camera_from_board.matrix for one in kept]))
    predicted = name_poses([one.id for one in kept], motions @ first)
    moved = {seen.observations[index].id: reason for index, reason in found.rejected.items()}
    return solved_axes(draft, seen, found.solution, predicted, moved)


def problem_of(seen: Located, board: BoardDescription) -> AxisProblem:
    """Return the problem of observations with the pose of the board; table angles count only where all of them are known."""
    observations: Sequence[Observation] = seen.observations
    poses, angles = [one.pose for one in observations], [one.readback.table_rad for one in observations]
    problem = problem_from_poses(poses, board, angles, names=[one.id for one in observations])
    return replace(problem, camera_jacobian=seen.camera_jacobian, camera_prior=seen.prior)


def axis_at_height(axis: RotationAxis, height_mm: float) -> tuple[Estimate, ...]:
    """Return direction and position of an axis where it passes ``height_mm`` of its frame: along itself its position is no estimate."""
    point = axis.point_mm + axis.direction * (height_mm - axis.point_mm[2]) / axis.direction[2]
    return tuple(one for one in axis_estimates(replace(axis, point_mm=point)) if one.label != "Position z")


def compare_axes(previous: RotationAxis, new: RotationAxis) -> Comparison:
    """Compare a rotation axis with an earlier one. Raises CalibrationError where they are given in different frames."""
    if previous.frame != new.frame:
        raise CalibrationError(
            f"The previous axis is given in frame {previous.frame}, the new one in {new.frame}.", "Compare axes in the same frame."
        )
    rim = circle_about_axis_mm(new, RADIUS_MM)
    moved = float(np.linalg.norm(new.turned(np.pi).apply(rim) - previous.turned(np.pi).apply(rim), axis=1).max())
    sigmas = [np.hypot(axis.point_sigma_mm, RADIUS_MM * axis.direction_sigma_rad) for axis in (previous, new)]
    return Comparison(
        tuple(axis_changes(previous, new)),
        moved,
        COVERAGE_FACTOR * 2.0 * float(np.hypot(*sigmas)),  # half a turn doubles an error of the axis
        f"a point {RADIUS_MM:.0f} mm from the axis, between views half a turn apart,",
    )


def axis_changes(previous: RotationAxis, new: RotationAxis) -> list[Change]:
    """Return the changes of the direction, and the distance of the new point from the previous axis."""
    away = new.point_mm - previous.point_mm
    gap = float(np.linalg.norm(away - previous.direction * float(previous.direction @ away)))
    changes = changes_between(axis_estimates(previous), axis_estimates(new))
    directions = [change for change in changes if change.name.startswith("axis direction")]
    return [*directions, Change("axis, across", 0.0, gap, float(np.hypot(previous.point_sigma_mm, new.point_sigma_mm)), "mm")]


def _by_robot_mm(draft: Draft, solution: AxisSolution) -> float:
    """Contribution (k = 2) of robot and hand-eye where the axis is used from another robot pose than that of the observations."""
    hand_eye = draft.setup.hand_eye
    if hand_eye is None:
        return 0.0
    turn_rad, shift_mm = axis_sigmas(solution.best.axis, hand_eye, draft.setup.noise)
    return COVERAGE_FACTOR * half_turn_sigma_mm(solution.best.axis, np.diag([turn_rad**2] * 2 + [shift_mm**2] * 2))
