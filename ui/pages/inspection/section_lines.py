"""Sections as lines of the 3-D view: blades with the measured lines of a dimension, and deviations as magnified whiskers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from measureapp.inspection.surface.colour_scale import RAMPS
from ui.viewport.layers import LineLayer

if TYPE_CHECKING:
    from measureapp.inspection.blades.curves import BladeCurves
    from measureapp.inspection.surface.section import Section

MOST_WHISKERS = 240
WHISKER_SHARE = 0.05  # of the section's extent: length of the 90 % whisker
LONGEST_SHARE = 0.12  # of the section's extent: longest whisker
GAINS = (1, 2, 5, 10, 20, 50, 100, 200, 500)
Colour = tuple[int, int, int]


def measured_lines(kind: str, curves: BladeCurves) -> list[np.ndarray]:
    """Return the lines (K, 3) that a blade dimension of this kind measures."""
    chord = [] if curves.chord is None else [curves.chord]
    ends = curves.mean_line[[0, -1]]
    if kind in ("max_thickness", "max_thickness_place"):
        return [curves.thickest, *(chord if kind == "max_thickness_place" else [])]
    if kind == "chord":
        return chord
    if kind == "camber":
        return [curves.mean_line, *chord]
    if kind in ("stagger", "twist", "pitch"):
        return [ends if curves.chord is None else curves.chord]
    if kind in ("leading_radius", "trailing_radius"):
        edge = curves.edges.get(kind.removesuffix("_radius"))
        return [] if edge is None else [edge]
    return []


@dataclass(frozen=True, eq=False)
class Whiskers:
    """Deviations along a section, as the means of neighbouring points."""

    feet_mm: np.ndarray  # (G, 3), on the nominal
    normals: np.ndarray  # (G, 3)
    means_mm: np.ndarray  # (G,)

    @classmethod
    def of(cls, found: Section) -> Whiskers:
        """Average neighbouring points so that at most `MOST_WHISKERS` whiskers remain."""
        count = len(found.deviations_mm)
        groups = np.array_split(np.arange(count), min(count, MOST_WHISKERS)) if count else []
        middles = np.array([group[len(group) // 2] for group in groups], int)
        means = np.array([found.deviations_mm[group].mean() for group in groups])
        normals = found.nominal_normals[middles]
        return cls(found.measured_mm[middles] - found.deviations_mm[middles, None] * normals, normals, means)

    @property
    def gain(self) -> int:
        """The magnification: a round number for which typical deviations are visible."""
        if not len(self.means_mm):
            return 1
        usual = max(float(np.percentile(np.abs(self.means_mm), 90)), 1e-6)
        wanted = WHISKER_SHARE * self._extent_mm / usual
        return max((gain for gain in GAINS if gain <= wanted), default=1)

    @property
    def _extent_mm(self) -> float:
        return float(np.ptp(self.feet_mm, axis=0).max()) if len(self.feet_mm) else 0.0

    def layers(self) -> list[LineLayer]:
        """Return lines from the nominal outwards (red) and inwards (blue)."""
        longest = LONGEST_SHARE * self._extent_mm
        lengths = np.clip(self.gain * self.means_mm, -longest, longest)
        ends = self.feet_mm + lengths[:, None] * self.normals
        layers, ramp = [], RAMPS["blue-white-red"]
        for side, colour in ((self.means_mm >= 0, ramp.above[-1]), (self.means_mm < 0, ramp.below[0])):
            lines = tuple(np.stack([foot, end]) for foot, end in zip(self.feet_mm[side], ends[side], strict=True))
            layers.append(LineLayer(lines, (int(colour[0]), int(colour[1]), int(colour[2])), 2.0))
        return [layer for layer in layers if layer.lines]


def blade_layers(kind: str, blades: Sequence[BladeCurves], nominal: Sequence[np.ndarray], colour: Colour, drawn: Colour) -> list[LineLayer]:
    """Return the outlines of blades, thick the measured lines of a dimension of this kind, thin the nominal."""
    outlines = tuple(curve for one in blades for curve in one.outline)
    about = tuple(line for one in blades for line in measured_lines(kind, one))
    layers = [LineLayer(tuple(nominal), drawn, 1.5), LineLayer(outlines, colour, 2.5), LineLayer(about, colour, 5.0)]
    return [layer for layer in layers if layer.lines]
