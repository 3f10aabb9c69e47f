"""Trend and capability of one dimension over many parts (ISO 22514-2, in the manner of)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.series import SeriesRun, SeriesValue

LEAST_PARTS, FULL_PARTS = 25, 50
D2 = 1.128  # mean range of two values of a normal distribution, in its standard deviations
NORMAL_95 = 1.959964


@dataclass(frozen=True, slots=True)
class Index:
    """A capability index with its 95 % interval [1]_.

    .. [1] A. F. Bissell, How reliable is your capability index?, Applied Statistics 39(3), 331-340, 1990.
    """

    name: str  # "Cpk", "Ppk"; "Ck", "Pk" where only one limit exists
    value: float
    interval: tuple[float, float]
    spread_only: float | None  # Cp or Pp; None for a one-sided tolerance
    sigma: float
    sigma_from: str


@dataclass(frozen=True, slots=True, eq=False)
class Trend:
    """One dimension over all parts, in the order of measurement."""

    name: str
    unit: str
    nominal: float
    limits: tuple[float | None, float | None]  # absolute; None: there is none
    values: FloatArray  # (N,), NaN where not measured
    measured_at: tuple[str, ...]
    mean: float | None
    std: float | None
    mean_moving_range: float | None
    uncertainty: float | None  # root mean square of the stated U (k = 2)
    indices: tuple[Index, ...]  # overall first; empty below 25 parts
    remark: str  # on the number of parts, or why there is no index

    @property
    def n(self) -> int:
        """Number of parts with a value."""
        return int(np.isfinite(self.values).sum())


def count_once(runs: Sequence[SeriesRun]) -> tuple[SeriesRun, ...]:
    """Return the last run of each serial number, and all runs without one, in order of measurement."""
    last = {run.identification.serial_number: run for run in runs if run.identification.serial_number}
    return tuple(run for run in runs if not run.identification.serial_number or last[run.identification.serial_number] is run)


def trends(runs: Sequence[SeriesRun]) -> tuple[Trend, ...]:
    """Return the trend of every dimension of the last run, over all parts that have it with the same nominal and limits."""
    parts = count_once(runs)
    return tuple(_trend(value, parts) for value in parts[-1].values) if parts else ()


def index(values: FloatArray, lower: float | None, upper: float | None, sigma: float, words: tuple[str, str]) -> Index:
    """Return the index of finite ``values`` (N,) for a standard deviation.

    Parameters
    ----------
    lower, upper : limits; one of them may be missing
    words : beginning of the index's name, "C" or "P", and where ``sigma`` comes from
    """
    mean, n = float(values.mean()), len(values)
    sides = [(mean - lower) / (3 * sigma)] if lower is not None else []
    sides += [(upper - mean) / (3 * sigma)] if upper is not None else []
    value = min(sides)
    half = NORMAL_95 * sqrt(1 / (9 * n) + value**2 / (2 * (n - 1)))
    both = None if lower is None or upper is None else (upper - lower) / (6 * sigma)
    name = f"{words[0]}{'k' if both is None else 'pk'}"
    return Index(name, value, (value - half, value + half), both, sigma, words[1])


def _trend(last: SeriesValue, parts: Sequence[SeriesRun]) -> Trend:
    found = [_same(last, run) for run in parts]
    values = np.array([np.nan if one is None or one.measured is None else one.measured for one in found], float)
    there = values[np.isfinite(values)]
    stated = [one.uncertainty for one in found if one is not None and one.uncertainty is not None]
    ranges = np.abs(np.diff(there))
    std = float(there.std(ddof=1)) if len(there) > 1 else None
    lower, upper = _limits(last)
    indices, remark = _indices(there, (lower, upper), std, float(ranges.mean()) if len(ranges) else None)
    return Trend(
        last.name,
        last.unit,
        last.nominal,
        (lower, upper),
        values,
        tuple(run.measured_at for run in parts),
        float(there.mean()) if len(there) else None,
        std,
        float(ranges.mean()) if len(ranges) else None,
        float(np.sqrt(np.mean(np.square(stated)))) if stated else None,
        indices,
        remark,
    )


def _indices(
    values: FloatArray, limits: tuple[float | None, float | None], std: float | None, moving_range: float | None
) -> tuple[tuple[Index, ...], str]:
    n = len(values)
    if limits == (None, None):
        return (), "No tolerance: no index."
    if n < LEAST_PARTS:
        return (), f"{n} parts: no index below {LEAST_PARTS}."
    if not std or not moving_range:
        return (), "No spread: no index."
    overall = index(values, *limits, std, ("P", "standard deviation of all parts"))
    within = index(values, *limits, moving_range / D2, ("C", "mean moving range of two parts / 1.128"))
    stated = f"Preliminary: {n} parts." if n < FULL_PARTS else f"{n} parts."
    return (overall, within), f"{stated} Normal distribution not tested. The spread includes that of the measurement."


def _limits(value: SeriesValue) -> tuple[float | None, float | None]:
    """Return the absolute limits; a zone such as flatness, with nominal and lower limit 0, has only an upper one."""
    if value.lower_tolerance is None or value.upper_tolerance is None:
        return None, None
    zone = value.nominal == 0 and value.lower_tolerance == 0
    return (None if zone else value.nominal + value.lower_tolerance), value.nominal + value.upper_tolerance


def _same(last: SeriesValue, run: SeriesRun) -> SeriesValue | None:
    """Return the value of a dimension in a run, unless it had another nominal or other limits then."""
    for one in run.values:
        if one.name == last.name:
            stated = (one.nominal, one.lower_tolerance, one.upper_tolerance, one.unit)
            return one if stated == (last.nominal, last.lower_tolerance, last.upper_tolerance, last.unit) else None
    return None
