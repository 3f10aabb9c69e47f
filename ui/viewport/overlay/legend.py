"""The legend of a colour scale: quantity, range, steps, tolerance; it defines the colours of the picture and of reports."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.inspection.surface.colour_scale import AnyRamp, ColourScale
from ui.viewport.colouring import UNKNOWN

FINE_BINS = 512  # of the histogram that is kept, so that it can be drawn on any range
USUAL_SHARE = 99.5  # percentile that the default range covers
CHUNK = 1_000_000


@dataclass(frozen=True)
class Histogram:
    """Numbers of values in equal bins."""

    low: float
    high: float
    counts: tuple[int, ...]

    @classmethod
    def of(cls, values: np.ndarray) -> Histogram:
        """Count finite values (N,); the bins cover nearly all of them."""
        finite = values[np.isfinite(values)]
        if not len(finite):
            return cls(0.0, 1.0, (0,))
        low, high = (float(end) for end in np.percentile(finite, [0.05, 99.95]))
        high = high if high > low else low + 1e-6
        return cls(low, high, tuple(np.histogram(finite, FINE_BINS, (low, high))[0].tolist()))

    def on(self, low: float, high: float, bars: int) -> np.ndarray:
        """Return the counts (bars,) on another range."""
        edges = np.linspace(self.low, self.high, len(self.counts) + 1)
        reached = np.concatenate([[0.0], np.cumsum(self.counts)])
        return np.diff(np.interp(np.linspace(low, high, bars + 1), edges, reached))


@dataclass(frozen=True)
class Fractions:
    """Parts of the whole inside, below and above the tolerance, and without data; 0…1."""

    inside: float
    below: float
    above: float
    no_data: float

    @classmethod
    def of(cls, values: np.ndarray, tolerance: tuple[float, float], no_data: float = 0.0) -> Fractions:
        """Count values (N,), of which those that are not finite have no data; ``no_data``: fraction of the whole beside them."""
        known = values[np.isfinite(values)]
        rest = (1.0 - no_data) / max(len(values), 1)
        below, above = int((known < tolerance[0]).sum()), int((known > tolerance[1]).sum())
        missing = no_data + rest * (len(values) - len(known)) if len(values) else 1.0
        return cls(rest * (len(known) - below - above), rest * below, rest * above, missing)


@dataclass(frozen=True)
class Legend:
    """A colour scale with everything its legend shows; edits return another one."""

    quantity: str
    low: float
    high: float
    unit: str = "mm"
    ramp: AnyRamp = "blue-white-red"
    steps: int = 0  # 0: continuous
    tolerance: tuple[float, float] | None = None
    go_no_go: bool = False
    swapped: bool = False
    histogram: Histogram | None = None
    fractions: Fractions | None = None
    note: str = ""
    usual: tuple[float, float] | None = None  # the range that Reset restores
    editable: bool = True

    @property
    def span(self) -> float:
        """Length of the range."""
        return self.high - self.low

    def colours(self, values: np.ndarray) -> np.ndarray:
        """Map values (N,) to colours (N, 3) uint8: darker beyond the range, `UNKNOWN` where they are not finite."""
        made = np.empty((len(values), 3), np.uint8)
        for start in range(0, len(values), CHUNK):
            part = slice(start, start + CHUNK)
            made[part] = self._colours(np.asarray(values[part], float))
        return made

    @property
    def scale(self) -> ColourScale:
        """The colour scale that the legend explains."""
        return ColourScale(self.low, self.high, self.ramp, self.steps, self.tolerance, self.go_no_go, self.swapped)

    def _colours(self, values: np.ndarray) -> np.ndarray:
        finite = np.isfinite(values)
        made = np.rint(self.scale.colours(np.where(finite, values, 0.0))).astype(np.uint8)
        made[~finite] = UNKNOWN
        return made

    def with_range(self, low: float, high: float) -> Legend:
        """Return the legend on another range; an empty range leaves it as it is."""
        return replace(self, low=low, high=high) if high > low else self

    def with_tolerance(self, low: float, high: float) -> Legend:
        """Return the legend with another tolerance; the fractions of the former one are dropped."""
        return replace(self, tolerance=(low, high), fractions=None) if high >= low else self


def one_two_five(value: float) -> float:
    """Round a positive value up to 1, 2 or 5 times a power of ten.

    >>> [one_two_five(value) for value in (0.013, 0.21, 5.0, 7.0)]
    [0.02, 0.5, 5.0, 10.0]
    """
    power = 10.0 ** np.floor(np.log10(max(value, 1e-9)) + 1e-9)
    return float(next(round(step * power, 12) for step in (1, 2, 5, 10) if step * power >= value * (1 - 1e-9)))


def usual_range(values: np.ndarray, tolerance: tuple[float, float] | None) -> tuple[float, float]:
    """Return the default range: symmetric, at least twice the tolerance, covering 99.5 % of the finite values; never from extremes."""
    finite = np.abs(values[np.isfinite(values)])
    covered = float(np.percentile(finite, USUAL_SHARE)) if len(finite) else 0.0
    twice = 2.0 * max(abs(end) for end in tolerance) if tolerance is not None else 0.0
    end = max(twice, one_two_five(covered)) if covered > 0 else twice or 0.1
    return -end, end
