"""Colours of values: one ramp from the lower end of the range over the tolerance band to the upper end, in all pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np

from measureapp.arrays import FloatArray

if TYPE_CHECKING:
    from measureapp.data.deviation_scale import DeviationScale, RampName

AnyRamp: TypeAlias = "RampName | Literal['growing']"
BEYOND_SHADE = 0.62  # of the end colours outside the range
# dark blue – teal – yellow, as nodes of a linear interpolation, for what only grows
GROWING = np.array([[38, 24, 95], [33, 96, 140], [31, 150, 139], [104, 198, 96], [240, 228, 66]], float)
GO, NO_GO = np.array([27, 153, 139], float), np.array([209, 73, 91], float)


@dataclass(frozen=True, eq=False)
class Ramp:
    """Colours from the lower end to the band, of the band, and from the band to the upper end; 0…255."""

    below: FloatArray  # (K, 3), from the lower end of the range to the band
    band: FloatArray  # (3,), within the tolerance
    above: FloatArray  # (K, 3), from the band to the upper end of the range


RAMPS: dict[AnyRamp, Ramp] = {
    "blue-white-red": Ramp(
        np.array([[24, 60, 140], [56, 117, 190], [116, 169, 218], [196, 219, 238]], float),
        np.array([247, 247, 247], float),
        np.array([[248, 208, 192], [232, 140, 116], [208, 72, 66], [150, 16, 38]], float),
    ),
    "rainbow": Ramp(
        np.array([[38, 34, 148], [28, 96, 214], [22, 176, 226], [88, 208, 170]], float),
        np.array([64, 170, 78], float),
        np.array([[176, 208, 62], [248, 220, 52], [242, 140, 36], [200, 30, 34]], float),
    ),
    "colour-blind-safe": Ramp(
        np.array([[0, 50, 110], [20, 104, 176], [92, 162, 214], [186, 214, 236]], float),
        np.array([247, 247, 247], float),
        np.array([[250, 222, 166], [238, 174, 80], [200, 116, 20], [128, 62, 4]], float),
    ),
    "growing": Ramp(GROWING, GROWING[0], GROWING),
}


@dataclass(frozen=True)
class ColourScale:
    """A colour scale on a definite range."""

    low: float
    high: float
    ramp: AnyRamp = "blue-white-red"
    steps: int = 0  # 0: continuous
    tolerance: tuple[float, float] | None = None
    go_no_go: bool = False
    swapped: bool = False

    @classmethod
    def of(cls, scale: DeviationScale, range_mm: tuple[float, float]) -> ColourScale:
        """Return the stored scale on the range that it has, or on ``range_mm`` where it leaves the range open."""
        low, high = scale.range_mm or range_mm
        return cls(low, high, scale.ramp, scale.steps, scale.tolerance_mm, scale.go_no_go, scale.swapped)

    def colours(self, values: FloatArray) -> FloatArray:
        """Map finite values (N,) to colours (N, 3), 0…255; darker beyond the range."""
        if self.go_no_go and self.tolerance is not None:
            inside = (values >= self.tolerance[0]) & (values <= self.tolerance[1])
            made = np.where(inside[:, None], GO, NO_GO)
        else:
            made = self._ramp_colours(self._stepped(values))
        beyond = (values < self.low) | (values > self.high)
        return np.where(beyond[:, None], BEYOND_SHADE * made, made)

    def stops(self, count: int) -> list[str]:
        """Return colours of equally spaced values over the range as `#rrggbb`, for a colour bar."""
        made = np.rint(self.colours(np.linspace(self.low, self.high, count))).astype(int)
        return ["#{:02x}{:02x}{:02x}".format(*one) for one in made]

    def _ramp_colours(self, values: FloatArray) -> FloatArray:
        """Map values to colours; without a tolerance the middle of the range has the colour of the band."""
        ramp = RAMPS[self.ramp]
        if self.ramp == "growing":
            places = (values - self.low) / max(self.high - self.low, 1e-12)
            return colours_between(ramp.below, 1.0 - places if self.swapped else places)
        middle = (self.low + self.high) / 2.0
        start, end = self.tolerance if self.tolerance is not None else (middle, middle)
        below, above = (ramp.above[::-1], ramp.below[::-1]) if self.swapped else (ramp.below, ramp.above)
        if self.tolerance is None:  # without a band the colours meet in the middle
            below, above = np.vstack([below, ramp.band]), np.vstack([ramp.band, above])
        under = colours_between(below, (values - self.low) / max(start - self.low, 1e-12))
        over = colours_between(above, (values - end) / max(self.high - end, 1e-12))
        return np.where((values < start)[:, None], under, np.where((values > end)[:, None], over, ramp.band))

    def _stepped(self, values: FloatArray) -> FloatArray:
        """Replace values by the middle of their step; those inside the tolerance stay inside, the others outside."""
        span = self.high - self.low
        if not self.steps or span <= 0:
            return values
        place = np.clip(np.floor((values - self.low) / span * self.steps), 0, self.steps - 1)
        middles = self.low + (place + 0.5) * span / self.steps
        if self.tolerance is None:
            return np.asarray(middles)
        start, end = self.tolerance
        apart = 1e-9 * max(span, 1e-9)
        outside = np.where(values < start, np.minimum(middles, start - apart), np.maximum(middles, end + apart))
        return np.asarray(np.where((values >= start) & (values <= end), (start + end) / 2.0, outside))


def colours_between(nodes: FloatArray, places: FloatArray) -> FloatArray:
    """Interpolate colours (N, 3) at positions (N,) in 0…1 of equally spaced nodes (K, 3)."""
    spread = np.clip(places, 0.0, 1.0) * (len(nodes) - 1)
    supports = np.arange(len(nodes))
    return np.stack([np.interp(spread, supports, nodes[:, channel]) for channel in range(3)], axis=-1)
