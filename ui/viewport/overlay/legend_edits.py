"""Edits of a legend by mouse, wheel, menu and typed numbers; each returns another legend."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from ui.viewport.overlay.legend import Legend, one_two_five

Handle = Literal["low", "high", "tolerance low", "tolerance high"]
STEP_CHOICES = (0, 10, 15, 20, 30)
DRAG_STEPS = 200.0  # of the range; a dragged end moves in round steps of about this size
TIED = 1e-6  # ends of equal absolute value stay tied


def value_of(legend: Legend, handle: Handle) -> float:
    """Return the number that a handle stands for; of the tolerance 0 where there is none."""
    if handle in ("low", "high"):
        return legend.low if handle == "low" else legend.high
    start, end = legend.tolerance or (0.0, 0.0)
    return start if handle == "tolerance low" else end


def with_value(legend: Legend, handle: Handle, value: float) -> Legend:
    """Return the legend with another number at a handle; ends of equal absolute value and opposite sign stay so."""
    low, high = (legend.low, legend.high) if handle in ("low", "high") else legend.tolerance or (0.0, 0.0)
    lower = handle in ("low", "tolerance low")
    tied = abs(low + high) <= TIED * max(abs(low), abs(high), 1e-12) and (value < 0 if lower else value > 0)
    if tied:
        low, high = -abs(value), abs(value)
    elif lower:
        low = value
    else:
        high = value
    return legend.with_range(low, high) if handle in ("low", "high") else legend.with_tolerance(low, high)


def dragged(legend: Legend, handle: Handle, upward_px: float, bar_px: float) -> Legend:
    """Return the legend after a handle moved up by a distance on a bar of this length, in round steps."""
    step = one_two_five(legend.span / DRAG_STEPS)
    moved = value_of(legend, handle) + upward_px / max(bar_px, 1.0) * legend.span
    return with_value(legend, handle, round(round(moved / step) * step, 9))


def scaled(legend: Legend, notches: int) -> Legend:
    """Widen (positive) or narrow the range about its middle by steps of 1, 2, 5."""
    if legend.ramp == "growing":
        return legend.with_range(legend.low, _neighbour(legend.high - legend.low, notches) + legend.low)
    middle = (legend.low + legend.high) / 2.0
    half = _neighbour(legend.span / 2.0, notches)
    return legend.with_range(middle - half, middle + half)


def _neighbour(value: float, notches: int) -> float:
    for _ in range(abs(notches)):
        value = one_two_five(value * 1.01) if notches > 0 else _before(value)
    return value


def _before(value: float) -> float:
    power = 10.0 ** np.floor(np.log10(max(value, 1e-9)) + 1e-9)
    return float(next(round(step * power, 12) for step in (5, 2, 1, 0.5) if step * power < value * 0.99))


def symmetric(legend: Legend) -> Legend:
    """Return the legend with a range symmetric about zero."""
    end = max(abs(legend.low), abs(legend.high))
    return legend.with_range(-end, end)


def swapped(legend: Legend) -> Legend:
    """Exchange the colours of both ends."""
    return replace(legend, swapped=not legend.swapped)


def reset(legend: Legend) -> Legend:
    """Return the legend on its default range, continuous, with its colours in the usual order."""
    low, high = legend.usual or (legend.low, legend.high)
    return replace(legend, low=low, high=high, steps=0, go_no_go=False, swapped=False)
