"""The whole rig: hand-eye, guide and rotation axis in one solution, and the cameras from the same images where they are not known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.shortfalls import shortfalls as lens_shortfalls
from measureapp.calibrate.cameras.validation import CrossValidation
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison, changes_between, millimetres
from measureapp.calibrate.draft.draft import ALL_AXES, Draft, Effect, Kind, Known, Limits, Setup, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, axis_estimates, camera_estimates, guide_estimates, hand_eye_estimates
from measureapp.calibrate.draft.locate import Located, locate_board, locate_in_solution
from measureapp.calibrate.guidance.lenses import advise_lenses, ghost_for_lenses
from measureapp.calibrate.guidance.travel import advise_guide, advise_table
from measureapp.calibrate.guidance.turns import advise_turns, ghost_for_turns
from measureapp.calibrate.kinds.axis import axis_at_height, axis_changes
from measureapp.calibrate.kinds.cameras import GOOD_VIEWS, outdated_projector
from measureapp.calibrate.kinds.fit import explain_by_rejected, name_poses, residuals_mm, residuals_px, solved_axes
from measureapp.calibrate.kinds.lenses import cross_validate_cameras, lens_problem, mark_warnings, solve_cameras
from measureapp.calibrate.kinds.on_part import part_points_mm, sample_readbacks, view_consistency_sigma_mm
from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.calibrate.rig.joint import number_approaches, shortfalls, solve_rig
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.calibrate.sightings import rms
from measureapp.data.calibration import CameraArrayCalibration, HandEye, RigCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import PartOf, Progress

CAMERAS_SHARE = 0.7  # of the progress


class Rig(Kind):
    """All links of the kinematic chain by one joint adjustment with a single covariance."""

    name = "rig"
    words = Words(
        subject="the rig",
        title="Calibrate the whole rig",
        action="Whole rig",
        tip="Cameras, hand–eye, linear guide and table axis in one automatic run",
        purpose="Fix the board on the table. The rig views it from all sides, moves along the guide and turns the table, "
        "and everything is solved together.",
        step="Take the views",
        hints=GOOD_VIEWS,
    )
    limits = Limits(0.1, 0.5, "registration of overlapping views corrects 0.1 mm with ease, and starts safely up to 0.5 mm")
    needs = ""
    readback = ALL_AXES
    readback_in_rig = ALL_AXES
    motions = ("robot", "table", "guide", "passes", "stations")

    @override
    def lenses(self, setup: Setup) -> tuple[str, ...]:
        return setup.camera_names if setup.cameras is None else ()

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        numbered = _number_observations(draft.observations)
        if draft.setup.cameras is None:
            cameras = solve_cameras(draft, PartOf(progress, 0.0, CAMERAS_SHARE))
            assert cameras.camera_solution is not None  # they were calibrated
            rig = solve_with_cameras(numbered, cameras.camera_solution, draft.setup, PartOf(progress, CAMERAS_SHARE, 1.0))
            return _with_view_gaps(draft, _with_rig(draft, cameras, rig))
        seen = locate_board(replace(draft, observations=numbered))
        try:
            rig = solve_located(seen, draft.setup, progress)
        except CalibrationError as error:
            raise explain_by_rejected(error, seen) from error
        return _with_view_gaps(draft, solved_axes(draft, seen, rig, _predict_boards(rig), rig.rejected))

    @override
    def solve_cameras_alone(self, draft: Draft, progress: Progress) -> CameraArrayCalibration | None:
        return solve_cameras(draft, progress, roughly=True).cameras if draft.setup.cameras is None else None

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        lenses = lens_shortfalls(lens_problem(draft, draft.setup.lenses)) if draft.setup.lenses else ()
        return (*lenses, *shortfalls([one.axes for one in draft.observations]))

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        if draft.setup.lenses:
            advise_lenses(draft, notes, fixed_board=True)
        if draft.cameras is not None:
            advise_turns(draft, notes)
        advise_table(draft, notes)
        advise_guide(draft, notes)
        return ghost_for_lenses(draft) if draft.cameras is None else ghost_for_turns(draft)

    @override
    def result(self, solved: Solved) -> RigCalibration:
        solution: RigSolution = solved.solution
        return solution.calibration

    @override
    def estimates(self, result: RigCalibration) -> Sequence[Estimate]:
        return (
            *camera_estimates(result.cameras),
            *hand_eye_estimates(result.hand_eye),
            *guide_estimates(result.guide),
            *axis_estimates(result.axis),
        )

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        chosen = sample_readbacks(_used_readbacks(draft, solved))
        if len(chosen) < 2:
            raise CalibrationError("The observations of the solution are no longer there.", "Solve again.")
        typical, worst = (COVERAGE_FACTOR * sigma for sigma in view_consistency_sigma_mm(solved.solution, chosen))
        sentence = f"Views of one part fit together to {millimetres(typical)} (k = 2), at worst {millimetres(worst)}, before registration"
        return Effect(typical, sentence)

    @override
    def previous(self, known: Known) -> RigCalibration | None:
        return known.rig

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        if not isinstance(previous, RigCalibration):
            return None
        new, solution = self.result(solved), solved.solution
        changes = [
            *changes_between(hand_eye_estimates(previous.hand_eye), hand_eye_estimates(new.hand_eye)),
            *changes_between(guide_estimates(previous.guide), guide_estimates(new.guide)),
            *axis_changes(previous.axis, new.axis),
        ]
        used, points = sample_readbacks(_used_readbacks(draft, solved)), part_points_mm(solution)
        there = np.concatenate([points for _ in used])
        seen = [new.part_from_camera(readback).inverse().apply(points) for readback in used]
        before = np.concatenate([previous.part_from_camera(readback).apply(part) for readback, part in zip(used, seen, strict=True)])
        motion = rigid_motion(before, there)
        typical, _ = view_consistency_sigma_mm(solution, used)
        moved = rms(before @ motion[:3, :3].T + motion[:3, 3] - there)
        both = COVERAGE_FACTOR * float(np.hypot(1.0, _hand_eye_ratio(previous.hand_eye, new.hand_eye))) * typical
        return Comparison(tuple(changes), moved, both, "views of one part relative to each other (rms)")

    @override
    def outdates(self, known: Known) -> Sequence[str]:
        return outdated_projector(known)

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        rig = self.result(solved)
        return Known(rig.cameras, rig)

    @override
    def shown(self, known: Known, result: Known) -> Sequence[Estimate]:
        rig = known.rig
        if rig is None or result.rig is None:
            return ()
        axis = axis_at_height(rig.axis, float(result.rig.axis.point_mm[2]))
        return (*hand_eye_estimates(rig.hand_eye), *guide_estimates(rig.guide), *axis, *camera_estimates(rig.cameras))

    @override
    def cross_validate(self, draft: Draft, solved: Solved, progress: Progress | None) -> CrossValidation | None:
        return cross_validate_cameras(draft, solved, progress)

    @override
    def warnings(self, solved: Solved) -> Sequence[str]:
        solution: RigSolution = solved.solution
        unseen = (f"Not observable: {what}." for what in solution.not_observable)
        return [*mark_warnings(solved.camera_solution), *solution.warnings, *unseen]


def solve_with_cameras(observations: Sequence[Observation], cameras: CameraArraySolution, setup: Setup, progress: Progress) -> RigSolution:
    """Solve hand-eye, guide and axis with cameras calibrated from the same observations, their covariance included. Raises CalibrationError."""
    seen = locate_in_solution(observations, cameras)
    return solve_rig(seen.observations, cameras.calibration, noise=setup.noise, camera_prior=seen.prior, progress=progress)


def solve_located(seen: Located, setup: Setup, progress: Progress) -> RigSolution:
    """Solve hand-eye, guide and axis with known cameras, their covariance included where it is known. Raises CalibrationError."""
    assert setup.cameras is not None  # the caller chose this way
    return solve_rig(seen.observations, setup.cameras, noise=setup.noise, camera_prior=seen.prior, progress=progress)


def _number_observations(observations: Sequence[Observation]) -> tuple[Observation, ...]:
    """Number the approaches of the robot where they are not known, before any observation is rejected."""
    if all(one.approach is not None for one in observations):
        return tuple(observations)
    numbers = number_approaches([one.axes.base_from_flange for one in observations])
    return tuple(replace(one, approach=number) for one, number in zip(observations, numbers, strict=True))


def _with_rig(draft: Draft, cameras: Solved, rig: RigSolution) -> Solved:
    """Return a solved rig together with the cameras calibrated from the same observations."""
    predicted, calibrated = _predict_boards(rig), rig.calibration.cameras
    reasons = {**cameras.reasons}
    for name, reason in rig.rejected.items():
        whole = f"{reason[0].upper()}{reason[1:]}."
        reasons[name] = f"{whole} {reasons[name]}" if reasons.get(name) else whole
    return replace(
        cameras,
        solution=rig,
        used=tuple(predicted),
        cameras=calibrated,
        reasons=reasons,
        residuals_px=residuals_px(draft.observations, predicted, calibrated, cameras.board),
        residuals_mm=residuals_mm(predicted, cameras.places, cameras.board),
    )


def _with_view_gaps(draft: Draft, solved: Solved) -> Solved:
    """Return the same, with the gaps between views stated in the calibration, by its joint covariance."""
    chosen = sample_readbacks(_used_readbacks(draft, solved))
    if len(chosen) < 2:
        return solved
    typical, _ = view_consistency_sigma_mm(solved.solution, chosen)
    rig: RigSolution = solved.solution
    return replace(solved, solution=replace(rig, calibration=replace(rig.calibration, view_gaps_mm=COVERAGE_FACTOR * typical)))


def _predict_boards(rig: RigSolution) -> dict[str, RigidTransform]:
    return name_poses([residual.name for residual in rig.residuals], rig.chain.predict(rig.state))


def _used_readbacks(draft: Draft, solved: Solved) -> list[AxisReadback]:
    used = {one.id: one for one in draft.observations if one.id in solved.used}
    return [used[name].axes for name in solved.used if name in used]


def _hand_eye_ratio(previous: HandEye, new: HandEye) -> float:
    """Return how many times less certain the previous rig was, by its hand-eye transform; 1 where that is not stated."""
    return previous.translation_sigma_mm / new.translation_sigma_mm if previous.translation_sigma_mm and new.translation_sigma_mm else 1.0
