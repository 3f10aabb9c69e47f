"""Curves of a measured blade section: sides, edges, mean line, chord and maximum thickness."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.blades.edge import Edge
from measureapp.inspection.blades.profile import EDGE_SHARE, Profile
from measureapp.inspection.blades.section_frame import SectionFrame

STEPS = 200
ARC_STEPS = 40


@dataclass(frozen=True, slots=True, eq=False)
class BladeCurves:
    """Curves (K, 3) of one measured section, in the nominal's frame."""

    sides: tuple[FloatArray, FloatArray]  # from the leading to the trailing end
    edges: Mapping[str, FloatArray]  # "leading", "trailing": half circles; missing if not measured
    mean_line: FloatArray
    chord: FloatArray | None  # (2, 3); None where an edge was not measured
    thickest: FloatArray  # (2, 3), maximum thickness, from side to side

    @property
    def outline(self) -> tuple[FloatArray, ...]:
        """Both sides and the edges."""
        return (*self.sides, *self.edges.values())


def trace_blade_curves(made: Profile, frame: SectionFrame, number: int) -> BladeCurves:
    """Return the curves of the profile of blade ``number`` (from 0), on its cutting surface."""
    line, ends = made.line, made.line.feet(made.ends_mm)[0]
    first, last = (
        ends[0] + _depth(made.leading, frame.shape.open_leading, ends),
        ends[1] - _depth(made.trailing, frame.shape.open_trailing, ends),
    )
    x = np.linspace(first, last, STEPS)
    upper, lower = made.sides.heights(line.lengths(x))
    foot, normals = line.points(x), line.normals(x)
    above, below = foot + upper[:, None] * normals, foot + lower[:, None] * normals
    thick = int((upper - lower).argmax())
    edges = {
        name: frame.lift(_half_circle(edge, sign * _direction(made, at)), number)
        for name, edge, at, sign in (("leading", made.leading, ends[0], 1.0), ("trailing", made.trailing, ends[1], -1.0))
        if edge.apex_mm is not None
    }
    return BladeCurves(
        (frame.lift(above, number), frame.lift(below, number)),
        edges,
        frame.lift(line.points(np.linspace(ends[0], ends[1], STEPS)), number),
        frame.lift(made.ends_mm, number) if len(edges) == 2 else None,
        frame.lift(np.stack([above[thick], below[thick]]), number),
    )


def _depth(edge: Edge, is_open: bool, ends: FloatArray) -> float:
    """Return the distance from an end at which the sides begin: at an edge, the radius of its circle."""
    if is_open:
        return 0.0
    return float(EDGE_SHARE * (ends[1] - ends[0])) if edge.apex_mm is None else edge.radius_mm


def _direction(made: Profile, x_mm: float) -> FloatArray:
    """Return the mean line's direction (2,) towards the trailing end."""
    slope = float(made.line.slopes(np.array([x_mm]))[0])
    return np.array([1.0, slope]) / np.hypot(1.0, slope)


def _half_circle(edge: Edge, inwards: FloatArray) -> FloatArray:
    assert edge.apex_mm is not None
    angle = np.linspace(-np.pi / 2, np.pi / 2, ARC_STEPS)[:, None]
    across = np.array([-inwards[1], inwards[0]])
    return np.asarray(edge.apex_mm + edge.radius_mm * (inwards - np.cos(angle) * inwards + np.sin(angle) * across))
