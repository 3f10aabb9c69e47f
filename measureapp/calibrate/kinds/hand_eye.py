"""Hand-eye: the pose of the reference camera on the robot's flange, from a stationary board seen from many robot poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from measureapp.calibrate.boards.observation import flanges_of
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison, changes_between, millimetres
from measureapp.calibrate.draft.draft import Draft, Effect, Kind, Known, Limits, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, hand_eye_estimates
from measureapp.calibrate.draft.locate import Located, locate_board
from measureapp.calibrate.guidance.turns import advise_turns, ghost_for_turns
from measureapp.calibrate.kinds.axis import NO_RIG
from measureapp.calibrate.kinds.fit import explain_by_rejected, name_poses, solved_axes
from measureapp.calibrate.kinds.on_part import placement_sigma_mm
from measureapp.calibrate.motions import inlier_solutions
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.hand_eye import HandEyeProblem, HandEyeSolution, shortfalls
from measureapp.calibrate.sightings import rms
from measureapp.data.calibration import HandEye
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.progress import Progress


class HandEyeKind(Kind):
    """Pose of the camera on the flange by seven closed-form methods, refined jointly."""

    name = "hand-eye"
    words = Words(
        subject="the hand-eye transform",
        title="Calibrate hand–eye",
        action="Hand–eye",
        tip="Pose of the head on the robot's flange",
        purpose="Determines the pose of the head on the flange, with the cameras as calibrated. "
        "Fix the board on the table; the robot turns the head.",
        step="Take the views",
        hints=(
            "The board must not move between the views.",
            "Turn the head about all three axes: up and down, sideways, and about its line of sight.",
            "Take ten poses or more: the robot's own errors average out.",
        ),
    )
    limits = Limits(0.1, 0.5, "registration of overlapping views corrects 0.1 mm with ease, and starts safely up to 0.5 mm")
    file = "hand-eye.json"
    needs = "rig"
    readback = ("base_from_flange",)
    readback_in_rig = readback
    guide_at_zero = True

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        seen = locate_board(draft)
        try:
            found = inlier_solutions.solve_hand_eye(problem_of(seen, draft.setup.noise), draft.setup.board.corners_mm, progress)
        except CalibrationError as error:
            raise explain_by_rejected(error, seen) from error
        kept = [seen.observations[index] for index in found.kept]
        predicted = name_poses([one.id for one in kept], inlier_solutions.predict_hand_eye_boards(found.solution, flanges_of(kept)))
        moved = {seen.observations[index].id: reason for index, reason in found.rejected.items()}
        return solved_axes(draft, seen, found.solution, predicted, moved)

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        try:
            return shortfalls(problem_of(locate_board(draft), draft.setup.noise))
        except CalibrationError as error:
            return (str(error),)

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        advise_turns(draft, notes)
        return ghost_for_turns(draft)

    @override
    def result(self, solved: Solved) -> HandEye:
        solution: HandEyeSolution = solved.solution
        return solution.hand_eye

    @override
    def method(self, result: HandEye) -> str:
        return result.method

    @override
    def estimates(self, result: HandEye) -> Sequence[Estimate]:
        return hand_eye_estimates(result)

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        solution: HandEyeSolution = solved.solution
        value = COVERAGE_FACTOR * placement_sigma_mm(solution)
        away = float(solution.part_in_camera_mm[2])
        return Effect(value, f"Places a point {away:.0f} mm in front of the cameras to {millimetres(value)} (k = 2) relative to the flange")

    @override
    def previous(self, known: Known) -> HandEye | None:
        return None if known.rig is None else known.rig.hand_eye

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        if not isinstance(previous, HandEye):
            return None
        solution: HandEyeSolution = solved.solution
        new, distance_mm = solution.hand_eye, float(solution.part_in_camera_mm[2])
        part = np.array([[0.0, 0.0, distance_mm]])
        moved = rms(new.flange_from_camera.apply(part) - previous.flange_from_camera.apply(part))
        sigmas = [np.hypot(one.translation_sigma_mm, distance_mm * one.rotation_sigma_rad) for one in (previous, new)]
        changes = tuple(changes_between(hand_eye_estimates(previous), hand_eye_estimates(new)))
        expanded = COVERAGE_FACTOR * float(np.hypot(*sigmas))
        return Comparison(changes, moved, expanded, f"a point {distance_mm:.0f} mm in front of the cameras")

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        if known.rig is None:
            raise CalibrationError(*NO_RIG)
        return Known(known.rig.cameras, replace(known.rig, hand_eye=self.result(solved)))

    @override
    def warnings(self, solved: Solved) -> Sequence[str]:
        solution: HandEyeSolution = solved.solution
        motions = [] if solution.degeneracy.verdict == "good" else [f"The motions are {solution.degeneracy.verdict}."]
        return [*motions, *solution.warnings]


def problem_of(seen: Located, noise: AxisNoise) -> HandEyeProblem:
    """Return the problem of observations with robot pose and pose of the board."""
    flanges = tuple(one.readback.base_from_flange for one in seen.observations if one.readback.base_from_flange is not None)
    return HandEyeProblem(flanges, tuple(one.pose for one in seen.observations), noise, seen.camera_jacobian, seen.prior)
