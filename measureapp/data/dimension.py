"""A toleranced value, as it stands on the report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

CONTRIBUTIONS = ("noise", "stitching", "calibration", "form", "common", "scale")  # that make up the uncertainty of a dimension
CONTRIBUTION_DIGITS = 4  # so that what a small share adds is seen


class Verdict(StrEnum):
    """Outcome of a comparison with a tolerance by ISO 14253-1."""

    PASS = "pass"
    FAIL = "fail"
    NOT_PROVEN = "not proven"
    NOT_MEASURED = "not measured"


@dataclass(frozen=True, slots=True)
class Dimension:
    """One line of the report. Lengths in mm, angles in degrees (`unit` says which)."""

    name: str
    nominal: float
    measured: float | None  # None: not measured, `reason` says why
    uncertainty: float | None  # expanded, k = 2
    lower_tolerance: float  # deviation from nominal, usually negative
    upper_tolerance: float
    verdict: Verdict
    unit: str = "mm"
    reason: str = ""
    features: tuple[str, ...] = ()
    kind: str = ""  # "distance", "flatness", …
    datums: tuple[str, ...] = ()  # A, B, C
    traceability: str = ""  # where the value came from: points, filter, criterion, datums, and what was assumed for its uncertainty
    budget: Mapping[str, float] = field(default_factory=dict)  # the `CONTRIBUTIONS` of `uncertainty`, k = 2; their squares add up

    @property
    def deviation(self) -> float | None:
        """Measured minus nominal."""
        return None if self.measured is None else self.measured - self.nominal

    def rank_contributions(self, digits: int = CONTRIBUTION_DIGITS) -> list[tuple[str, float]]:
        """Return the shares of the uncertainty (k = 2), the largest first, without those that would read as zero."""
        return sorted(((name, size) for name, size in self.budget.items() if round(size, digits) > 0), key=lambda share: -share[1])

    def round_uncertainty(self, digits: int = 3) -> float | None:
        """Return the uncertainty for so many digits: one that would read as zero is rounded up to the last of them (JCGM 100, 7.2.6)."""
        return max(self.uncertainty, 10.0**-digits) if self.uncertainty else self.uncertainty

    @property
    def relative_deviation(self) -> float | None:
        """Error over nominal; None where the nominal is zero."""
        return None if self.deviation is None or self.nominal == 0 else self.deviation / self.nominal
