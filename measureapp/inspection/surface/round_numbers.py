"""Round numbers of scales: 1, 2 and 5 times powers of ten."""

from __future__ import annotations

import math

STEPS = (1.0, 2.0, 5.0, 10.0)
EXACT = 1e-9  # relative: a number that is round already stays


def round_up(value: float) -> float:
    """Return the next number 1, 2 or 5 times a power of ten that is not smaller; 0 for 0.

    >>> round_up(0.07), round_up(0.2), round_up(3.1), round_up(0.0)
    (0.1, 0.2, 5.0, 0.0)
    """
    return _round(value, up=True)


def round_down(value: float) -> float:
    """Return the next number 1, 2 or 5 times a power of ten that is not greater; 0 for 0.

    >>> round_down(0.07), round_down(70.0)
    (0.05, 50.0)
    """
    return _round(value, up=False)


def _round(value: float, *, up: bool) -> float:
    if value <= 0 or not math.isfinite(value):
        return 0.0
    power = math.floor(math.log10(value))
    share = value / 10.0**power
    if up:
        step = next(step for step in STEPS if step >= share * (1 - EXACT))
    else:
        step = next(step for step in reversed(STEPS) if step <= share * (1 + EXACT))
    return float(f"{step * 10.0**power:.1e}")  # without the rounding of the product
