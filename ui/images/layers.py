"""What can be shown of a decoded camera: arrays of numbers in one unit, NaN where a pixel has none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import tau
from typing import TYPE_CHECKING

import numpy as np

from ui.look.language.words import tr, translated
from ui.look.wording import exposure, percent, point_reason, quantity

if TYPE_CHECKING:
    from measureapp.data.phase import PhaseMap

KINDS = {
    "fringes": "Images",
    "phase": "Phase",
    "wrapped": "Wrapped",
    "modulation": "Modulation",
    "sigma": "σ",
    "exposure": "Exposure",
    "state": "Reason",
}
TIPS = {
    "fringes": "Stored images, one by one",
    "phase": "Absolute phase",
    "wrapped": "Phase within one period of the finest fringes",
    "modulation": "Amplitude of the fringes at the exposure used",
    "sigma": "Standard deviation of the absolute phase",
    "exposure": "Longest exposure in which the pixel is not saturated",
    "state": "Why a pixel has no phase",
}
COVERED = (0.5, 99.5)  # percentiles that the colours span
SATURATED = (209, 73, 91)  # colour of saturated pixels in stored images, as the verdict "fail"


@dataclass(frozen=True)
class Category:
    """One value of a map of categories."""

    words: str
    colour: tuple[int, int, int]
    share: float  # of all pixels


@dataclass(frozen=True, eq=False)
class Layer:
    """Numbers of the pixels of one camera."""

    quantity: str
    unit: str
    values: np.ndarray  # (H, W) float32, NaN where there is none; or the levels of an image
    digits: int
    colours: str = "viridis"  # a colour map of pyqtgraph
    categories: tuple[Category, ...] = ()  # of whole values from 0; then the colours are theirs

    @cached_property
    def span(self) -> tuple[float, float]:
        """Range of the colours: nearly all finite values."""
        finite = self.values[np.isfinite(self.values)]
        if not finite.size:
            return 0.0, 1.0
        low, high = (float(end) for end in np.percentile(finite[:: max(1, finite.size // 100_000)], COVERED))
        return (low, high) if high > low else (low - 0.5, low + 0.5)

    def words_at(self, row: int, column: int) -> str:
        """Return the value of one pixel with its unit; a dash where it has none."""
        value = float(self.values[row, column])
        if self.categories:
            return self.categories[int(value)].words if np.isfinite(value) else "–"
        return quantity(value, self.unit, self.digits)


def layers_of(phase_map: PhaseMap) -> dict[str, Layer]:
    """Return all layers of a decoded camera by kind, with their spans; for a large camera it takes some tenths of a second."""
    layers = {kind: layer_of(phase_map, kind) for kind in KINDS if kind != "fringes"}
    for layer in layers.values():
        _ = layer.span  # kept
    return layers


def layer_of(phase_map: PhaseMap, kind: str) -> Layer:
    """Return a layer of a decoded camera; ``kind`` is one of `KINDS`, without the stored images."""
    valid = phase_map.valid
    if kind == "phase":
        return Layer("Absolute phase", "rad", _masked(phase_map.phase_rad, valid), 3)
    if kind == "wrapped":
        return Layer("Wrapped phase", "rad", _masked(np.mod(phase_map.phase_rad, np.float32(tau)), valid), 3, "CET-C1s")
    if kind == "modulation":
        return Layer("Modulation", "grey levels", _masked(phase_map.modulation, phase_map.modulation > 0), 0)
    if kind == "sigma":
        return Layer("Standard deviation σ of the phase", "rad", _masked(phase_map.sigma_rad, valid), 4)
    return _exposures(phase_map) if kind == "exposure" else _states(phase_map)


def frame_layer(image: np.ndarray) -> Layer:
    """Return the grey levels of one stored image (H, W)."""
    return Layer("Grey level", "", image, 0, "grey")


def _masked(values: np.ndarray, mask: np.ndarray) -> np.ndarray:
    return np.where(mask, values, np.nan).astype(np.float32)


def _exposures(phase_map: PhaseMap) -> Layer:
    index = phase_map.exposure_index
    times = phase_map.exposures_us or tuple(range(int(index.max(initial=0)) + 1))
    words = [exposure(round(time)) for time in phase_map.exposures_us] or [tr("No. {place}", place=time + 1) for time in times]
    values = _masked(index, index >= 0)
    return Layer("Exposure", "", values, 0, categories=_categories(values, words, _ramp(len(words))))


def _states(phase_map: PhaseMap) -> Layer:
    from measureapp.data.phase import PixelState
    from measureapp.pipeline.why_pictures import REASON_COLOURS

    names = [state.name.lower().replace("_", " ") for state in PixelState]
    words = ["Valid" if state == PixelState.VALID else point_reason(name) for state, name in zip(PixelState, names, strict=True)]
    colours = [REASON_COLOURS.get(name) or (110, 120, 126) for name in names]
    values = phase_map.state.astype(np.float32)
    return Layer("Reason", "", values, 0, categories=_categories(values, words, colours))


def _categories(values: np.ndarray, words: Sequence[str], colours: Sequence[tuple[int, int, int]]) -> tuple[Category, ...]:
    return tuple(
        Category(word, colour, float(np.mean(values == place))) for place, (word, colour) in enumerate(zip(words, colours, strict=True))
    )


def _ramp(count: int) -> list[tuple[int, int, int]]:
    """Return colours from long (dark blue) to short (yellow)."""
    import pyqtgraph as pg

    colours = pg.colormap.get("cividis").map(np.linspace(0.0, 1.0, max(2, count)))
    return [(int(red), int(green), int(blue)) for red, green, blue, *_ in colours[:count]]


def legend_words(layer: Layer) -> str:
    """Return the legend of a map of categories as rich text: those that occur, with their shares."""
    shown = [one for one in layer.categories if one.share > 0]
    return " &nbsp; ".join(f'<span style="color:rgb{one.colour}">■</span> {translated(one.words)} {percent(one.share)}' for one in shown)
