"""The verdict on a part from those on its dimensions, and the order in which both are shown."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from measureapp.data.dimension import SEVERITY, Dimension, Verdict, worst_verdict

if TYPE_CHECKING:
    from measureapp.data.measurement import Measurement

ACCEPTED = (Verdict.PASS, Verdict.NO_TOLERANCE)


def part_verdict(verdicts: Iterable[Verdict | str]) -> Verdict:
    """Return the most severe verdict; without any, the part is not measured, and without a tolerance nothing is proven.

    >>> part_verdict(["pass", "not measured", "not proven"]).value, part_verdict([]).value, part_verdict(["no tolerance"]).value
    ('not proven', 'not measured', 'not proven')
    """
    found = [Verdict(one) for one in verdicts]
    return worst_verdict(found) or (Verdict.NOT_PROVEN if found else Verdict.NOT_MEASURED)


def has_passed(measurement: Measurement) -> bool:
    """Whether all dimensions pass and no camera has drifted since the calibration."""
    drift = measurement.validity.drift
    if drift is not None and drift.status == "drifted":
        return False
    return measurement.inspection is None or all(dimension.verdict in ACCEPTED for dimension in measurement.inspection.dimensions)


def worst_first(dimensions: Sequence[Dimension]) -> tuple[Dimension, ...]:
    """Return dimensions by severity; those of one verdict by how much of their tolerance they use, the most first."""
    return tuple(sorted(dimensions, key=lambda one: (SEVERITY.index(one.verdict), -used_tolerance(one))))


def used_tolerance(dimension: Dimension) -> float:
    """Return how far a value is from the middle of its tolerance, in halves of the tolerance: above 1 it is outside; 0 without limits."""
    deviation, lower, upper = dimension.deviation, dimension.lower_tolerance, dimension.upper_tolerance
    if deviation is None or lower is None or upper is None:
        return 0.0
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    return abs(deviation - middle) / max(half, 1e-9)
