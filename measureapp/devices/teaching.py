"""Teaching the scale and the sense of an axis: it is sent one small step, and a person says how far and which way it went."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite

from measureapp.errors import InputError

LARGEST_CORRECTION = 100.0  # of the scale; beyond it something else is wrong


@dataclass(frozen=True, slots=True)
class TaughtScale:
    """Settings of an axis that make its read-back agree with what was observed."""

    counts_per_unit: float
    sense: int  # 1 or -1

    def lines(self) -> str:
        """Return the settings as lines of a rig description."""
        return f"counts_per_unit = {self.counts_per_unit:.10g}\nsense = {self.sense}"


def teach_scale(commanded: float, observed: float, counts_per_unit: float, sense: int) -> TaughtScale:
    """Return scale and sense of an axis from one step.

    Parameters
    ----------
    commanded : the step that the axis was sent, in mm or degrees, signed
    observed : how far it really went in the rig's positive direction, by a ruler, dial gauge or protractor
    counts_per_unit, sense : the settings with which it was sent

    Raises
    ------
    InputError
        A value is zero or not a number, or the observation is of another order of magnitude.
    """
    if not (isfinite(commanded) and isfinite(observed) and isfinite(counts_per_unit)) or 0.0 in (commanded, counts_per_unit):
        raise InputError("Step, observation and scale must be numbers other than zero.", "Repeat the step.")
    if observed == 0.0:
        raise InputError(
            "The axis did not move at all.", "Check that its drive is switched on, enabled and not braked; a scale cannot follow from this."
        )
    ratio = commanded / observed
    if not 1.0 / LARGEST_CORRECTION <= abs(ratio) <= LARGEST_CORRECTION:
        raise InputError(
            f"The axis was sent {commanded:g} and went {observed:g}: another order of magnitude.",
            "Check the unit of what you entered and the drive's resolution, correct counts_per_unit by hand, then repeat the step.",
        )
    return TaughtScale(counts_per_unit * abs(ratio), sense if ratio > 0 else -sense)
