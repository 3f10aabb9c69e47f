"""What many jobs say together: verdicts, and for virtual measurements how errors compare with their uncertainties."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from scipy.stats import beta

from measureapp.campaign.jobs import Finished

CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Coverage:
    """Errors of the dimensions of a group of measurements whose truth is known, beside their expanded uncertainties U (k = 2)."""

    group: str
    measurements: int
    dimensions: int
    inside: int  # errors that U contains
    lowest: float  # share inside, limits of the interval of Clopper and Pearson (1934), 95 %
    highest: float
    rms_error_over_u: float
    largest_error_mm: float
    median_u_mm: float
    largest_error_over_u: float

    @property
    def share(self) -> float:
        """Share of the errors that U contains."""
        return self.inside / self.dimensions


def coverage(finished: Iterable[Finished]) -> list[Coverage]:
    """Return the coverage of each group of virtual measurements: their names without the seed at the end. Only lengths in mm count."""
    groups: dict[str, list[Sequence[Mapping[str, Any]]]] = {}
    for one in finished:
        if "true_dimensions" in one.document:
            groups.setdefault(one.name.rpartition("-")[0], []).append(_lengths(one.document))
    return [_of_group(name, found) for name, found in groups.items() if any(found)]


def summary_document(finished: Sequence[Finished]) -> dict[str, Any]:
    """Return the summary for JSON."""
    return {
        "jobs": len(finished),
        "passed": sum(one.passed for one in finished),
        "failed": {one.name: one.problem for one in finished if one.problem},
        "coverage": [{**asdict(one), "share": one.share} for one in coverage(finished)],
    }


def summary_lines(finished: Sequence[Finished]) -> list[str]:
    """Return the summary for the terminal."""
    failed = [one for one in finished if one.problem]
    lines = [f"{len(finished)} jobs: {sum(one.passed for one in finished)} passed, {len(failed)} without a result."]
    lines += [f"  {one.name}: {one.problem}" for one in failed]
    lines += [
        f"  {one.group}: U (k = 2) contains the true value of {one.inside} of {one.dimensions} lengths "
        f"({one.share:.0%}; 95 % interval {one.lowest:.0%} to {one.highest:.0%}); error over U {one.rms_error_over_u:.2f} rms, "
        f"{one.largest_error_over_u:.2f} at most; largest error {one.largest_error_mm:.4f} mm, median U {one.median_u_mm:.4f} mm"
        for one in coverage(finished)
    ]
    return lines


def _lengths(document: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    units = {one["name"]: one.get("unit", "mm") for one in document.get("dimensions", ())}
    return [one for one in document["true_dimensions"] if units.get(one["name"], "mm") == "mm"]


def _of_group(name: str, measurements: Sequence[Sequence[Mapping[str, Any]]]) -> Coverage:
    found = [one for dimensions in measurements for one in dimensions]
    errors, limits = (np.array([abs(one[what]) for one in found], float) for what in ("error", "uncertainty"))
    inside, count, tail = int(np.count_nonzero(errors <= limits)), len(found), (1 - CONFIDENCE) / 2
    ratio = errors / np.maximum(limits, 1e-9)
    return Coverage(
        group=name,
        measurements=len(measurements),
        dimensions=count,
        inside=inside,
        lowest=float(beta.ppf(tail, inside, count - inside + 1)) if inside else 0.0,
        highest=float(beta.ppf(1 - tail, inside + 1, count - inside)) if inside < count else 1.0,
        rms_error_over_u=float(np.sqrt(np.mean(ratio**2))),
        largest_error_mm=float(errors.max()),
        median_u_mm=float(np.median(limits)),
        largest_error_over_u=float(ratio.max()),
    )
