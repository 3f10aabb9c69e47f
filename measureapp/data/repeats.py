"""Repeated measurements of one part: mean and spread of every dimension."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RepeatedMeasurement:
    """One of the repeated measurements."""

    name: str  # unique among the measurements of a study
    measured_at: str  # ISO 8601
    calibration: str  # when its rig was calibrated, ISO 8601; empty where not known


@dataclass(frozen=True, slots=True)
class SpreadTest:
    """Chi-square test of the spread of a dimension against its stated uncertainty."""

    p_value: float  # probability of this spread or a larger one, if the stated uncertainty is right
    level: float  # significance level of this test: the study's level over the number of its tests
    stated_sigma: float  # half of the root mean square of the stated U

    @property
    def contradicts(self) -> bool:
        """Whether the spread is larger than the stated uncertainty explains."""
        return self.p_value < self.level


@dataclass(frozen=True, slots=True)
class RepeatedDimension:
    """Mean and spread of one dimension; in mm or degrees (`unit`). None: too few values."""

    name: str
    nominal: float
    unit: str
    values: Mapping[str, float | None]  # by measurement; None: not measured
    reasons: Mapping[str, str]  # why a measurement has no value
    mean: float | None
    std: float | None  # sample standard deviation, n - 1 degrees of freedom
    mean_half_width: float | None  # of the confidence interval of the mean, from the spread alone
    std_interval: tuple[float, float] | None  # confidence interval of the standard deviation
    test: SpreadTest | None  # None: no spread, or no stated uncertainty

    @property
    def n(self) -> int:
        """Number of values."""
        return sum(value is not None for value in self.values.values())

    @property
    def deviation(self) -> float | None:
        """Mean minus nominal."""
        return None if self.mean is None else self.mean - self.nominal

    @property
    def relative(self) -> float | None:
        """Deviation over nominal; None where the nominal is zero."""
        return None if self.deviation is None or self.nominal == 0 else self.deviation / self.nominal


@dataclass(frozen=True, slots=True)
class RepeatStudy:
    """Repeated measurements of one part by one inspection program."""

    part: str
    program: str
    measurements: tuple[RepeatedMeasurement, ...]
    dimensions: tuple[RepeatedDimension, ...]
    confidence: float  # of the intervals
    level: float  # significance level of all tests together
    displacement_mm: float | None  # largest displacement of the part on the table between two measurements; None where not known
    sentences: tuple[str, ...] = ()  # conclusions

    @property
    def contradictions(self) -> tuple[str, ...]:
        """Names of the dimensions whose spread contradicts the stated uncertainty."""
        return tuple(one.name for one in self.dimensions if one.test is not None and one.test.contradicts)
