"""Comparison of two calibrations: the change of every value, and the displacement of the part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from measureapp.calibrate.draft.estimate import Estimate
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.uncertainty import COVERAGE_FACTOR


@dataclass(frozen=True, slots=True)
class Change:
    """One value before and now."""

    name: str
    previous: float
    new: float
    sigma: float  # standard deviation of the difference; 0 where neither calibration states one
    unit: str

    @property
    def difference(self) -> float:
        """New minus previous."""
        return self.new - self.previous

    @property
    def within(self) -> bool:
        """Whether the difference is within the expanded uncertainty (k = 2) of both."""
        return abs(self.difference) <= COVERAGE_FACTOR * self.sigma


@dataclass(frozen=True, slots=True)
class Comparison:
    """A new calibration against the one before."""

    changes: tuple[Change, ...]
    on_part_mm: float  # by how much the difference displaces the part
    expanded_mm: float  # expanded uncertainty (k = 2) of that displacement, by both calibrations
    what: str  # where on the part, as part of a sentence
    normalised: float = 1.0  # rms of all differences over their standard deviations, correlations included; about 1 for the same cameras

    @property
    def within(self) -> bool:
        """Whether the difference is within the expanded uncertainty of both, on the part and in all values together."""
        return self.on_part_mm <= self.expanded_mm and self.normalised <= COVERAGE_FACTOR

    @property
    def sentence(self) -> str:
        """Displacement and its expanded uncertainty in a sentence."""
        start = f"The new calibration moves {self.what} by {millimetres(self.on_part_mm)}"
        expanded = f"the combined expanded uncertainty of {millimetres(self.expanded_mm)} (k = 2)"
        if self.within:
            return f"{start}, within {expanded}."
        if self.on_part_mm <= self.expanded_mm:
            return (
                f"{start}, within {expanded}; but its values differ by {self.normalised:.1f} times their combined standard deviations: "
                "the cameras were knocked, refocused or warmed up in between."
            )
        return f"{start}, more than {expanded}: something changed in between, or one of the stated uncertainties is too small."


def changes_between(previous: Iterable[Estimate], new: Iterable[Estimate]) -> list[Change]:
    """Return the changes of all values that both calibrations have."""
    before = {one.name: one for one in previous}
    return [
        Change(one.name, before[one.name].value, one.value, float(np.hypot(before[one.name].sigma, one.sigma)), one.unit)
        for one in new
        if one.name in before
    ]


def sigma_ratio(previous: CameraArrayCalibration, new: CameraArrayCalibration) -> float:
    """Return how many times larger the standard deviations of the previous cameras are, by their median; 1 where none are stated."""
    ratios = [
        before / after
        for name, camera in new.cameras.items()
        for label, after in camera.standard_deviations.items()
        if (before := previous.cameras[name].standard_deviations.get(label, 0.0)) > 0 and after > 0
    ]
    return float(np.median(ratios)) if ratios else 1.0


def millimetres(value: float) -> str:
    """Return a length with two significant digits at least."""
    return f"{value:.3f} mm" if value >= 0.01 else f"{value:.4f} mm"
