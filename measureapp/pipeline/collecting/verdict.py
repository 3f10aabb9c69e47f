"""Is a calibration any good? Answered in millimetres on the part, with the limits it is held to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from measureapp.calibrate.cameras.array import CameraArraySolution
from measureapp.calibrate.cameras.projector import HeadSolution
from measureapp.calibrate.cameras.uncertainty import WorkingVolume
from measureapp.calibrate.cameras.validation import CrossValidation
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.motions.linear_guide import GuideSolution
from measureapp.calibrate.motions.rotation_axis import AxisSolution
from measureapp.calibrate.rig.joint_solution import RigSolution
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import CalibrationError
from measureapp.pipeline.collecting.carried import axis_sigmas, turn_sigma_rad
from measureapp.pipeline.collecting.collection import Collection
from measureapp.pipeline.collecting.on_part import (
    RADIUS_MM,
    few_of,
    fitting_length_mm,
    fitting_together_sigma_mm,
    half_turn_sigma_mm,
    length_beside_projector,
    length_uncertainty,
    placing_sigma_mm,
    sideways_sigma_mm,
    volume_of,
)
from measureapp.pipeline.collecting.setup import Kind, Setup
from measureapp.pipeline.collecting.solved import Solved

Level = Literal["good", "usable", "bad"]
MOST_LEFT_OUT = 0.25  # of the observations
MOST_TIMES = 10.0  # as many observations again: beyond, something else has to change
BY_THE_ROBOT = (
    "What robot and hand–eye add does not shrink with more observations. Calibrate the whole rig: it averages over many robot poses; "
    "or let registration take it out."
)
NO_COVARIANCE = "What the cameras themselves leave uncertain is not known: it comes on top."
BY_THE_CAMERAS = (
    "More views for the projector alone will not make it good: {added} of it come from the calibration of the cameras. "
    "Calibrate the cameras from more views first."
)
STROKE_MM = 500.0  # a usual travel of the guide


@dataclass(frozen=True, slots=True)
class Limits:
    """Up to where an expanded uncertainty (k = 2) is good or usable, and why there."""

    good_mm: float
    usable_mm: float
    why: str


LIMITS: Mapping[Kind, Limits] = {
    "cameras": Limits(0.02, 0.05, "of 0.05 mm that a measurement may be uncertain by, 0.02 mm hardly shows and 0.05 mm uses it up"),
    "projector": Limits(0.02, 0.05, "points that the projector gives lie beside those of two cameras and should be as certain"),
    "axis": Limits(0.05, 0.2, "views that are off by less than 0.05 mm need no fine stitching, those up to 0.2 mm are stitched safely"),
    "hand-eye": Limits(0.1, 0.5, "fine stitching of overlapping views takes out 0.1 mm with ease, and starts safely up to 0.5 mm"),
    "guide": Limits(0.05, 0.2, "views that are off by less than 0.05 mm need no fine stitching, those up to 0.2 mm are stitched safely"),
    "rig": Limits(0.1, 0.5, "fine stitching of overlapping views takes out 0.1 mm with ease, and starts safely up to 0.5 mm"),
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """What a calibration adds to a measurement, and whether that is good enough."""

    level: Level
    sentence: str  # with the number and the level
    expanded_mm: float  # k = 2, of what this calibration estimates; the level is judged by it
    limits: Limits
    reasons: tuple[str, ...]  # what else speaks against it; each makes a good one at most usable
    cameras_add_mm: float = 0.0  # k = 2, part of `expanded_mm`: what cameras that were calibrated before bring with them
    robot_adds_mm: float = 0.0  # k = 2, where the result is used from other robot poses than it was seen from; no observation tells it

    @property
    def reason(self) -> str:
        """Why the number leads to that level."""
        limits = self.limits
        return f"Up to {limits.good_mm:g} mm is good, up to {limits.usable_mm:g} mm usable: {limits.why}."

    @property
    def remedy(self) -> str:
        """What makes it good; where it is, what would make the robot's part smaller. Noise averages with the square root of the number of observations."""
        if self.expanded_mm <= self.limits.good_mm:
            return BY_THE_ROBOT if self.robot_adds_mm > self.limits.good_mm else ""
        times = max(self.expanded_mm**2 - self.cameras_add_mm**2, 0.0) / self.limits.good_mm**2
        if times <= 1.0:
            return BY_THE_CAMERAS.format(added=millimetres(self.cameras_add_mm))
        if times <= MOST_TIMES:
            return f"About {max(times, 1.5):.1f} times as many observations, as different from each other, would make it good."
        return "More observations alone will not make it good: sharper images, a larger board, or larger differences between positions are needed."


def judge(collection: Collection, limits: Limits | None = None, *, held_back: CrossValidation | None = None) -> Verdict:
    """Judge the last solution of a collection.

    Parameters
    ----------
    limits : instead of the usual ones of its kind
    held_back : what `check_held_back` found; a solution that fails it is never good

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or the uncertainty cannot be told.
    """
    solved = collection.solved
    if solved is None:
        raise CalibrationError("There is no solution yet.", "Solve what was collected first.")
    limits = limits or LIMITS[collection.setup.kind]
    expanded, what = _expanded(collection, solved)
    reasons = _reasons(collection, solved)
    if held_back is not None and not held_back.healthy:
        reasons.append(held_back.verdict)
    level: Level = "good" if expanded <= limits.good_mm else "usable" if expanded <= limits.usable_mm else "bad"
    if level == "good" and reasons:
        level = "usable"
    robot, cameras = _robot_adds_mm(collection.setup, solved), _cameras_add_mm(collection.setup, solved)
    from_elsewhere = f" Used from other robot poses, robot and hand–eye add {millimetres(robot)} (k = 2)." if robot > 0 else ""
    return Verdict(level, f"{what}: {level}.{from_elsewhere}", expanded, limits, tuple(reasons), cameras, robot)


def millimetres(value: float) -> str:
    """Return a length with two significant digits at least."""
    return f"{value:.3f} mm" if value >= 0.01 else f"{value:.4f} mm"


def _expanded(collection: Collection, solved: Solved) -> tuple[float, str]:
    """Return the expanded uncertainty on the part and what it says, without the level."""
    solution, setup = solved.solution, collection.setup
    if isinstance(solution, CameraArraySolution):
        return _of_cameras(solution, setup.standoff_mm, setup.length_mm)
    if isinstance(solution, HeadSolution):
        return _of_projector(solution, setup)
    if isinstance(solution, AxisSolution):
        value = COVERAGE_FACTOR * half_turn_sigma_mm(solution.best.axis, solution.covariance)
        return value, f"Moves a point {RADIUS_MM:.0f} mm from the axis by {millimetres(value)} (k = 2) between views half a turn apart"
    if isinstance(solution, HandEyeSolution):
        value = COVERAGE_FACTOR * placing_sigma_mm(solution)
        away = float(solution.part_in_camera_mm[2])
        return value, f"Places a point {away:.0f} mm before the cameras to {millimetres(value)} (k = 2) against the flange"
    if isinstance(solution, GuideSolution):
        guide = solution.guide
        turn_rad = _robot_turn_rad(setup)
        own_rad = np.sqrt(max(guide.direction_sigma_rad**2 - turn_rad**2, 0.0))  # the solution carries both
        value = COVERAGE_FACTOR * STROKE_MM * float(np.hypot(own_rad, guide.scale_sigma))
        return value, f"Moves a point by {millimetres(value)} (k = 2) between views {STROKE_MM:.0f} mm of the guide apart"
    used = {one.id: one for one in collection.usable if one.id in solved.used}
    chosen = few_of([used[name].readback.full() for name in solved.used if name in used])
    if len(chosen) < 2:
        raise CalibrationError("The observations of the solution are no longer there.", "Solve again.")
    typical, worst = (COVERAGE_FACTOR * sigma for sigma in fitting_together_sigma_mm(solution, chosen))
    return (
        typical,
        f"Views of one part fit together to {millimetres(typical)} (k = 2), at worst {millimetres(worst)}, before fine stitching",
    )


def _robot_adds_mm(setup: Setup, solved: Solved) -> float:
    """Return what robot and hand-eye add to an axis or a guide that is used from another robot pose than it was seen from, k = 2.

    They turn and shift what the cameras see as a whole. From the robot pose of the calibration this cancels, so that the calibration is judged
    without it; from another pose the robot errs otherwise.
    """
    solution = solved.solution
    if isinstance(solution, GuideSolution):
        return COVERAGE_FACTOR * STROKE_MM * _robot_turn_rad(setup)
    if isinstance(solution, AxisSolution) and setup.hand_eye is not None:
        turn_rad, shift_mm = axis_sigmas(solution.best.axis, setup.hand_eye, setup.noise)
        return COVERAGE_FACTOR * half_turn_sigma_mm(solution.best.axis, np.diag([turn_rad**2] * 2 + [shift_mm**2] * 2))
    return 0.0


def _robot_turn_rad(setup: Setup) -> float:
    return 0.0 if setup.hand_eye is None else turn_sigma_rad(setup.hand_eye, setup.noise)


def _of_cameras(solution: CameraArraySolution, standoff_mm: float | None, length_mm: float) -> tuple[float, str]:
    volume = volume_of(solution, standoff_mm)
    if len(solution.calibration.cameras) == 1:
        value = COVERAGE_FACTOR * sideways_sigma_mm(solution, volume.standoff_mm)
        return (
            value,
            f"Moves a point {volume.standoff_mm:.0f} mm before the camera by up to {millimetres(value)} (k = 2) across its line of sight",
        )
    found = length_uncertainty(solution, volume, fitting_length_mm(volume, length_mm))
    value, worst = COVERAGE_FACTOR * found.length_sigma_mm, COVERAGE_FACTOR * found.worst_length_sigma_mm
    return value, (
        f"Adds {millimetres(value)} (k = 2), at worst {millimetres(worst)}, to a length of {found.length_mm:g} mm in this volume"
    )


def _of_projector(head: HeadSolution, setup: Setup) -> tuple[float, str]:
    camera, volume, length_mm = _worst_beside(head, setup)
    found = length_beside_projector(head, camera, volume, length_mm)
    value, worst = COVERAGE_FACTOR * found.length_sigma_mm, COVERAGE_FACTOR * found.worst_length_sigma_mm
    return value, (
        f"Adds {millimetres(value)} (k = 2), at worst {millimetres(worst)}, to a length of {found.length_mm:g} mm "
        f"measured by camera {camera} and the projector"
    )


def _worst_beside(head: HeadSolution, setup: Setup) -> tuple[str, WorkingVolume, float]:
    """The camera beside which the projector measures worst, the volume, and the length for which that is told."""
    volume = volume_of(head.solution, setup.standoff_mm)
    length_mm = fitting_length_mm(volume, setup.length_mm)
    sigmas = {camera: length_beside_projector(head, camera, volume, length_mm).length_sigma_mm for camera in setup.camera_names}
    return max(sigmas, key=lambda camera: sigmas[camera]), volume, length_mm


def _cameras_add_mm(setup: Setup, solved: Solved) -> float:
    """Return what the cameras that were calibrated before bring into the projector's verdict, k = 2."""
    head = solved.solution
    if not isinstance(head, HeadSolution):
        return 0.0
    whole, own = (length_beside_projector(head, *_worst_beside(head, setup), own=own).length_sigma_mm for own in (False, True))
    return COVERAGE_FACTOR * float(np.sqrt(max(whole**2 - own**2, 0.0)))


def _reasons(collection: Collection, solved: Solved) -> list[str]:
    """Return what speaks against a solution besides its own covariance."""
    reasons = []
    out = len(solved.of) - len(solved.used)
    if out > MOST_LEFT_OUT * len(solved.of):
        reasons.append(f"{out} of {len(solved.of)} observations were left out: look at their reasons and replace them.")
    if not collection.is_solved:
        reasons.append("Observations changed since it was solved: solve again.")
    reasons += collection.shortfalls()
    return reasons + _warnings(solved)


def _warnings(solved: Solved) -> list[str]:
    solution = solved.solution
    if isinstance(solution, HandEyeSolution):
        motions = [] if solution.degeneracy.verdict == "good" else [f"The motions are {solution.degeneracy.verdict}."]
        return [*motions, *solution.warnings]
    if isinstance(solution, RigSolution):
        return [*solution.warnings, *(f"Not seen: {what}." for what in solution.not_observable)]
    if isinstance(solution, HeadSolution):
        return [] if solution.calibration.covariance is not None else [NO_COVARIANCE]
    return [] if isinstance(solution, CameraArraySolution) else list(solution.warnings)
