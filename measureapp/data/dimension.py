"""Dimensions: toleranced values with uncertainty and verdict."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from measureapp.data.control_frame import ControlFrame

CONTRIBUTIONS = (
    "noise",
    "stitching",
    "calibration",
    "form",
    "edges",
    "common",
    "setups",
    "unexplained",
    "certificate",
    "temperature",
    "scale",
)  # of the uncertainty budget
CONTRIBUTION_LABELS = {"common": "systematic", "setups": "set-ups"}  # where the printed name differs from that in files
CONTRADICTED = 0.75  # share of U that is unexplained above which the error model is contradicted: such a verdict needs a margin
CONTRIBUTION_DIGITS = 4  # so that small contributions are visible


class Verdict(StrEnum):
    """Conformance decision by ISO 14253-1."""

    PASS = "pass"
    FAIL = "fail"
    NOT_PROVEN = "not proven"
    NOT_MEASURED = "not measured"
    NO_TOLERANCE = "no tolerance"  # nothing to decide


SEVERITY = (Verdict.FAIL, Verdict.NOT_PROVEN, Verdict.NOT_MEASURED, Verdict.PASS, Verdict.NO_TOLERANCE)  # the worst first


def worst_verdict(verdicts: Iterable[Verdict]) -> Verdict | None:
    """Return the most severe verdict; None where no dimension has a tolerance."""
    return min((one for one in verdicts if one is not Verdict.NO_TOLERANCE), key=SEVERITY.index, default=None)


def of_other_versions(dimensions: Iterable[Dimension], version: str) -> tuple[Dimension, ...]:
    """Return the measured dimensions that were evaluated by another version than the rest; none where one version evaluated all.

    The rest are those of ``version``, or of the most frequent one where it evaluated none.
    """
    measured = [one for one in dimensions if one.measured is not None]
    counts = Counter(one.version for one in measured)
    rest = version if version in counts or not counts else counts.most_common(1)[0][0]
    return tuple(one for one in measured if one.version != rest)


@dataclass(frozen=True, slots=True)
class Dimension:
    """One line of the report. Lengths in mm, angles in degrees (`unit` says which)."""

    name: str
    nominal: float
    measured: float | None  # None: not measured, `reason` says why
    uncertainty: float | None  # expanded, k = 2
    lower_tolerance: float | None  # deviation from nominal, usually negative; None: no tolerance
    upper_tolerance: float | None
    verdict: Verdict
    unit: str = "mm"
    reason: str = ""
    features: tuple[str, ...] = ()
    kind: str = ""  # "distance", "flatness", …
    datums: tuple[str, ...] = ()  # features, in their order
    datum_letters: tuple[str, ...] = ()  # their letters in the program; none where the copies of a pattern have datums of their own
    traceability: str = ""  # source of the value: points, filter, criterion, datums, and assumptions for its uncertainty
    tolerance_source: str = ""  # the text its limits follow from, such as "H7"; empty: stated as numbers
    warning: str = ""  # what limits the use of the result, in one sentence
    alignment: str = ""  # name of its own alignment; empty: that of the program
    group: str = ""  # heading under which tables list it
    budget: Mapping[str, float] = field(default_factory=dict)  # the `CONTRIBUTIONS` to `uncertainty`, k = 2, to be added in quadrature
    frame: ControlFrame | None = None  # of a geometrical tolerance; None: it has none, or was stored by an earlier version
    version: str = ""  # of MeasureApp that evaluated it; empty: stored by an earlier one, which did not state it

    @property
    def deviation(self) -> float | None:
        """Measured minus nominal."""
        return None if self.measured is None else self.measured - self.nominal

    def rank_contributions(self, digits: int = CONTRIBUTION_DIGITS) -> list[tuple[str, float]]:
        """Return the labelled contributions to the uncertainty (k = 2), largest first, without those that round to zero."""
        printed = [(CONTRIBUTION_LABELS.get(name, name), size) for name, size in self.budget.items() if round(size, digits) > 0]
        return sorted(printed, key=lambda contribution: -contribution[1])

    def round_uncertainty(self, digits: int = 3) -> float | None:
        """Return the uncertainty for printing with ``digits``: at least one unit of the last digit (JCGM 100, 7.2.6)."""
        return max(self.uncertainty, 10.0**-digits) if self.uncertainty else self.uncertainty

    @property
    def relative_deviation(self) -> float | None:
        """Deviation over nominal; None where the nominal is zero."""
        return None if self.deviation is None or self.nominal == 0 else self.deviation / self.nominal
