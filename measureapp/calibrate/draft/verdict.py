"""Verdict on a calibration: its expanded uncertainty on the part against limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from measureapp.calibrate.cameras.validation import CrossValidation
from measureapp.calibrate.draft.comparison import Comparison, millimetres
from measureapp.calibrate.draft.draft import Draft, Limits, Solved
from measureapp.errors import CalibrationError
from measureapp.progress import Progress

Level = Literal["good", "usable", "bad"]
MOST_REJECTED = 0.25  # of the observations
MOST_TIMES = 10.0  # as many observations again: beyond, something else has to change
BY_THE_ROBOT = (
    "The contribution of robot and hand–eye does not shrink with more observations. Calibrate the whole rig, which averages over many "
    "robot poses, or let registration correct it."
)
BY_THE_CAMERAS = (
    "More views for the projector alone will not make it good: {added} of it come from the calibration of the cameras. "
    "Calibrate the cameras from more views first."
)


@dataclass(frozen=True, slots=True)
class Verdict:
    """The contribution of a calibration to a measurement, and whether that is good enough."""

    level: Level
    sentence: str  # with the number and the level
    expanded_mm: float  # k = 2, of what this calibration estimates; it determines the level
    limits: Limits
    reasons: tuple[str, ...]  # further objections; each limits the level to usable
    cameras_add_mm: float = 0.0  # k = 2, the part of `expanded_mm` that comes from cameras calibrated before
    robot_adds_mm: float = 0.0  # k = 2, in addition, where the result is used from other robot poses than those of its observations

    @property
    def reason(self) -> str:
        """The limits behind the level."""
        limits = self.limits
        return f"Up to {limits.good_mm:g} mm is good, up to {limits.usable_mm:g} mm usable: {limits.why}."

    @property
    def remedy(self) -> str:
        """The remedy; for a good calibration that for the robot's contribution. Noise averages with the square root of the number of observations."""
        if self.expanded_mm <= self.limits.good_mm:
            return BY_THE_ROBOT if self.robot_adds_mm > self.limits.good_mm else ""
        times = max(self.expanded_mm**2 - self.cameras_add_mm**2, 0.0) / self.limits.good_mm**2
        if times <= 1.0:
            return BY_THE_CAMERAS.format(added=millimetres(self.cameras_add_mm))
        if times <= MOST_TIMES:
            return f"About {max(times, 1.5):.1f} times as many observations, as different from each other, would make it good."
        return "More observations alone will not make it good: sharper images, a larger board, or larger differences between positions are needed."


def evaluate(draft: Draft, limits: Limits | None = None, *, held_back: CrossValidation | None = None) -> Verdict:
    """Evaluate the last solution of a draft against limits.

    Parameters
    ----------
    limits : instead of the usual ones of its kind
    held_back : result of `cross_validate`; a solution that fails it is never good

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or the uncertainty cannot be determined.
    """
    solved, limits = require_solution(draft), limits or draft.kind.limits
    effect, reasons = draft.kind.effect(draft, solved), _reasons(draft, solved)
    if held_back is not None and not held_back.healthy:
        reasons.append(held_back.verdict)
    level: Level = "good" if effect.expanded_mm <= limits.good_mm else "usable" if effect.expanded_mm <= limits.usable_mm else "bad"
    limited = level == "good" and bool(reasons)
    if limited:
        level = "usable"
    robot = effect.robot_mm
    from_elsewhere = f" Used from other robot poses, robot and hand–eye add {millimetres(robot)} (k = 2)." if robot > 0 else ""
    judged = f"{effect.sentence}. Only usable for another reason: {reasons[0]}" if limited else f"{effect.sentence}: {level}."
    sentence = f"{judged}{from_elsewhere}"
    return Verdict(level, sentence, effect.expanded_mm, limits, tuple(reasons), effect.cameras_mm, robot)


def compare(previous: object, draft: Draft) -> Comparison:
    """Compare the last solution of a draft with an earlier calibration.

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or the two are calibrations of different things.
    """
    found = draft.kind.compare(previous, draft, require_solution(draft))
    if found is None:
        subject = draft.kind.words.subject
        raise CalibrationError(f"The previous calibration is not one of {subject}.", "Name a result of the same kind of calibration.")
    return found


def cross_validate(draft: Draft, progress: Progress | None = None) -> CrossValidation | None:
    """Test the stated uncertainty of the last solution with held-back views; None for a kind that calibrates no lens.

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or there are too few views to hold some back.
    """
    return draft.kind.cross_validate(draft, require_solution(draft), progress)


def require_solution(draft: Draft) -> Solved:
    """Return the last solution of a draft. Raises CalibrationError where there is none."""
    if draft.solved is None:
        raise CalibrationError("There is no solution yet.", "Solve what was collected first.")
    return draft.solved


def _reasons(draft: Draft, solved: Solved) -> list[str]:
    """Return the objections to a solution in addition to its covariance."""
    reasons = []
    rejected = len(solved.of) - len(solved.used)
    if rejected > MOST_REJECTED * len(solved.of):
        reasons.append(f"{rejected} of {len(solved.of)} observations were rejected: examine the reasons and replace them.")
    if not draft.is_solved:
        reasons.append("Observations changed since it was solved: solve again.")
    return [*reasons, *draft.shortfalls, *draft.kind.warnings(solved)]
