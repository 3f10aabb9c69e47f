"""Colour ramps of deviations and of growing values, continuous or in steps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from ui.viewport.colouring import GROWING, UNKNOWN

RampName = Literal["blue-white-red", "rainbow", "colour-blind-safe", "growing"]
BEYOND_SHADE = 0.62  # of the end colours outside the range
GO, NO_GO = np.array([27, 153, 139], float), np.array([209, 73, 91], float)


@dataclass(frozen=True, eq=False)
class Ramp:
    """Colours from the lower end to the band, of the band, and from the band to the upper end."""

    below: np.ndarray  # (K, 3), from the lower end of the range to the band
    band: np.ndarray  # (3,), within the tolerance
    above: np.ndarray  # (K, 3), from the band to the upper end of the range


RAMPS: dict[RampName, Ramp] = {
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
RAMP_WORDS: dict[RampName, str] = {
    "blue-white-red": "Blue – white – red",
    "rainbow": "Rainbow with green band",
    "colour-blind-safe": "Colour-blind-safe",
    "growing": "Dark to bright",
}


def colours_between(nodes: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Interpolate colours (N, 3) at positions (N,) in 0…1 of equally spaced nodes (K, 3)."""
    spread = np.clip(places, 0.0, 1.0) * (len(nodes) - 1)
    supports = np.arange(len(nodes))
    return np.stack([np.interp(spread, supports, nodes[:, channel]) for channel in range(3)], axis=-1)


def ramp_colours(
    name: RampName, values: np.ndarray, ends: tuple[float, float], band: tuple[float, float] | None, *, swapped: bool = False
) -> np.ndarray:
    """Map values (N,) to float colours (N, 3); ``band``: the tolerance, None: the middle of the range has the colour of the band.

    Values beyond the ends get the end colours; the caller marks them.
    """
    ramp = RAMPS[name]
    low, high = ends
    if name == "growing":
        places = (values - low) / max(high - low, 1e-12)
        return colours_between(ramp.below, 1.0 - places if swapped else places)
    middle = (low + high) / 2.0
    start, end = band if band is not None else (middle, middle)
    below, above, mid = (ramp.above[::-1], ramp.below[::-1], ramp.band) if swapped else (ramp.below, ramp.above, ramp.band)
    if band is None:  # without a band the colours meet in the middle
        below, above = np.vstack([below, mid]), np.vstack([mid, above])
    under = colours_between(below, (values - low) / max(start - low, 1e-12))
    over = colours_between(above, (values - end) / max(high - end, 1e-12))
    made = np.where((values < start)[:, None], under, np.where((values > end)[:, None], over, mid))
    return np.asarray(made)


def unknown_colour() -> np.ndarray:
    """Return the colour of what has no value; the picture hatches it."""
    return UNKNOWN
