"""The linear guide: direction and scale of its travel in the robot's base frame, from a stationary board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from measureapp.arrays import FloatArray
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison, changes_between, millimetres
from measureapp.calibrate.draft.draft import Draft, Effect, Kind, Known, Limits, Setup, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, guide_estimates
from measureapp.calibrate.draft.locate import Located, locate_board
from measureapp.calibrate.guidance.travel import advise_guide, ghost_for_guide
from measureapp.calibrate.kinds.axis import NO_RIG
from measureapp.calibrate.kinds.fit import explain_by_rejected, name_poses, solved_axes
from measureapp.calibrate.motions import inlier_solutions
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.inlier_solutions import InlierSolution
from measureapp.calibrate.motions.linear_guide import GuideProblem, GuideSolution, shortfalls
from measureapp.calibrate.motions.propagation import propagate_robot_to_guide, turn_sigma_rad
from measureapp.data.calibration import HandEye, LinearGuide
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError, InputError
from measureapp.progress import Progress

STROKE_MM = 500.0  # a usual travel of the guide


class Guide(Kind):
    """Direction and scale of the guide by a straight line through the positions of the robot's base."""

    name = "guide"
    words = Words(
        subject="the linear guide",
        title="Calibrate the linear guide",
        action="Linear guide",
        tip="Direction and scale of the guide",
        purpose="Determines direction and scale of the guide, with cameras and hand–eye as calibrated. "
        "Fix the board on the table; the guide moves the robot past it.",
        step="Take the views",
        hints=(
            "Neither the board nor the robot's arm moves; only the guide does.",
            "Move the guide as far as the board stays in view: a longer travel determines its direction better.",
        ),
    )
    limits = Limits(0.05, 0.2, "views that are off by less than 0.05 mm need no registration, those up to 0.2 mm register safely")
    file = "guide.json"
    needs = "rig"
    readback = ("base_from_flange", "guide_mm")
    readback_in_rig = readback
    motions = ("guide",)
    uses_hand_eye = True

    @override
    def check(self, setup: Setup) -> None:
        if setup.hand_eye is None:
            raise InputError("To calibrate the linear guide, the hand-eye transform is needed.", "Calibrate hand-eye first.")

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        hand_eye, setup = _hand_eye(draft), draft.setup
        seen = locate_board(draft)
        progress.report(0, 1, "straight line of the guide")
        try:
            found = solve_inliers(problem_of(seen, hand_eye), setup.board.corners_mm, setup.noise)
        except CalibrationError as error:
            raise explain_by_rejected(error, seen) from error
        kept = [seen.observations[index] for index in found.kept]
        predicted = name_poses([one.id for one in kept], inlier_solutions.predict_guide_boards(found.solution.guide, hand_eye, kept))
        moved = {seen.observations[index].id: reason for index, reason in found.rejected.items()}
        return solved_axes(draft, seen, found.solution, predicted, moved)

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        try:
            return shortfalls(locate_board(draft).observations)
        except CalibrationError as error:
            return (str(error),)

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        advise_guide(draft, notes, still_robot=True)
        return ghost_for_guide(draft)

    @override
    def result(self, solved: Solved) -> LinearGuide:
        solution: GuideSolution = solved.solution
        return solution.guide

    @override
    def method(self, result: LinearGuide) -> str:
        return "straight line through the positions"

    @override
    def estimates(self, result: LinearGuide) -> Sequence[Estimate]:
        return guide_estimates(result)

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        guide, turn_rad = self.result(solved), turn_sigma_rad(_hand_eye(draft), draft.setup.noise)
        own_rad = np.sqrt(max(guide.direction_sigma_rad**2 - turn_rad**2, 0.0))  # the solution contains both
        value = COVERAGE_FACTOR * STROKE_MM * float(np.hypot(own_rad, guide.scale_sigma))
        sentence = f"Moves a point by {millimetres(value)} (k = 2) between views {STROKE_MM:.0f} mm of the guide apart"
        return Effect(value, sentence, robot_mm=COVERAGE_FACTOR * STROKE_MM * turn_rad)

    @override
    def previous(self, known: Known) -> LinearGuide | None:
        return None if known.rig is None else known.rig.guide

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        if not isinstance(previous, LinearGuide):
            return None
        new = self.result(solved)
        moved = STROKE_MM * float(np.linalg.norm(new.scale * new.direction - previous.scale * previous.direction))
        sigmas = [np.hypot(guide.direction_sigma_rad, guide.scale_sigma) for guide in (previous, new)]
        changes = tuple(changes_between(guide_estimates(previous), guide_estimates(new)))
        expanded = COVERAGE_FACTOR * STROKE_MM * float(np.hypot(*sigmas))
        return Comparison(changes, moved, expanded, f"a point, between views {STROKE_MM:.0f} mm of the guide apart,")

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        if known.rig is None:
            raise CalibrationError(*NO_RIG)
        return Known(known.rig.cameras, replace(known.rig, guide=self.result(solved)))


def problem_of(seen: Located, hand_eye: HandEye) -> GuideProblem:
    """Return the problem of observations with robot pose, guide position and pose of the board."""
    return GuideProblem(seen.observations, hand_eye, seen.prior)


def solve_inliers(problem: GuideProblem, marks_mm: FloatArray, noise: AxisNoise) -> InlierSolution[GuideSolution]:
    """Solve without outliers, and with the uncertainty that robot and hand-eye add to the direction. Raises CalibrationError."""
    found = inlier_solutions.solve_guide(problem, marks_mm)
    guide = propagate_robot_to_guide(found.solution.guide, problem.hand_eye, noise)
    return replace(found, solution=replace(found.solution, guide=guide))


def _hand_eye(draft: Draft) -> HandEye:
    assert draft.setup.hand_eye is not None  # guaranteed by `check`
    return draft.setup.hand_eye
