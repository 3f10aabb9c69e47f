"""Teaching an axis: its scale and sense of motion, from one commanded step and the travel that a person observed."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import Literal

from measureapp.errors import InputError

Unit = Literal["mm", "degree"]
MAGNITUDE = 10.0  # an observation this many times larger or smaller than expected is doubted
LEAST_READINGS = 3.0  # travel in units of the reading's uncertainty, below which its sign is not determined


@dataclass(frozen=True, slots=True)
class TeachingStep:
    """What was commanded: a signed number of counts, and what was believed before.

    Parameters
    ----------
    counts : commanded step, in counts
    counts_per_unit : counts per mm or degree in use when the step was commanded
    sense : in use when the step was commanded
    """

    counts: float
    counts_per_unit: float
    sense: Literal[1, -1] = 1

    @classmethod
    def of_units(cls, step: float, counts_per_unit: float, sense: Literal[1, -1] = 1) -> TeachingStep:
        """Return the step commanded as ``step`` mm or degrees of the rig."""
        return cls(sense * step * counts_per_unit, counts_per_unit, sense)


@dataclass(frozen=True, slots=True)
class TaughtScale:
    """What follows from the observation."""

    counts_per_unit: float
    sense: Literal[1, -1]
    relative_uncertainty: float  # standard uncertainty, of the reading of the travel

    def settings_lines(self) -> str:
        """Return the lines for the table ``[devices.NAME] settings`` of the rig description, in TOML."""
        return f"counts_per_unit = {float(f'{self.counts_per_unit:.9g}')}\nsense = {self.sense}\n"


def teach(step: TeachingStep, travel: float, unit: Unit, reading_uncertainty: float = 0.1) -> TaughtScale:
    """Compute scale and sense of an axis.

    Parameters
    ----------
    travel : observed, in mm or degrees; positive in the rig's positive direction
    reading_uncertainty : standard uncertainty of ``travel``, in the same unit

    Raises
    ------
    InputError
        A step or travel that is zero or no number, a travel within its own uncertainty, or of another order of magnitude than commanded.
    """
    _refuse_numbers(step, travel, reading_uncertainty)
    if abs(travel) < LEAST_READINGS * reading_uncertainty:
        raise InputError(
            f"A travel of {travel:g} {unit} is too small for a reading uncertainty of {reading_uncertainty:g} {unit}.",
            "Check that the axis moved; command a longer step.",
        )
    expected = abs(step.counts) / step.counts_per_unit
    ratio = abs(travel) / expected
    if ratio >= MAGNITUDE or ratio <= 1.0 / MAGNITUDE:
        raise InputError(
            f"The axis was commanded to move {expected:g} {unit} and a travel of {abs(travel):g} {unit} was entered: "
            f"{'more' if ratio > 1 else 'less'} by a factor of {max(ratio, 1 / ratio):.3g}.",
            f"Check unit and decimal point. If the travel is right, set counts_per_unit = {abs(step.counts / travel):.6g} and repeat the step.",
        )
    sense: Literal[1, -1] = 1 if step.counts * travel > 0 else -1
    return TaughtScale(abs(step.counts / travel), sense, reading_uncertainty / abs(travel))


def _refuse_numbers(step: TeachingStep, travel: float, reading_uncertainty: float) -> None:
    stated = {"commanded step": step.counts, "scale in use": step.counts_per_unit, "observed travel": travel}
    for what, value in (*stated.items(), ("reading uncertainty", reading_uncertainty)):
        if not isfinite(value):
            raise InputError(f"The {what} is {value}, which is no number.", "Enter a number.")
    for what, value in stated.items():
        if value == 0:
            raise InputError(f"The {what} is zero.", "Command a step that can be seen, and enter its travel; check that the axis moved.")
    if step.counts_per_unit < 0 or reading_uncertainty <= 0:
        raise InputError("Scale in use and reading uncertainty must be positive.", "State the direction by the sign of the travel.")
