"""RAPID values as text: numbers, strings, joint targets and the order of the mailbox."""

from __future__ import annotations

import json
import re

import numpy as np

from measureapp.arrays import FloatArray

UNUSED = "9E+09"  # an external axis that takes no part
NUM_TOLERANCE = 1e-3  # a num has 23 bits of mantissa
LARGEST_COUNT = 2**23
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
NUMBERS_AND_BRACKETS = re.compile(rf"(?:\s*(?:{NUMBER}|\[|\]|,))*\s*")


def text(value: str) -> str:
    """Write a string."""
    return '"' + value.replace('"', '""') + '"'


def read_text(rapid: str) -> str:
    """Read a string; raises ValueError."""
    if len(rapid) < 2 or rapid[0] != '"' or rapid[-1] != '"':
        raise ValueError(f"{rapid[:40]!r} is no string")
    return rapid[1:-1].replace('""', '"')


def read_numbers(rapid: str) -> FloatArray:
    """Read all numbers of a num, or of a record of nums, in their order; raises ValueError."""
    if not NUMBERS_AND_BRACKETS.fullmatch(rapid):
        raise ValueError(f"{rapid[:40]!r} is no record of numbers")
    numbers = np.array([float(number) for number in re.findall(NUMBER, rapid)])
    if not numbers.size or not np.isfinite(numbers).all():
        raise ValueError(f"{rapid[:40]!r} has no finite numbers")
    return numbers


def order(number: int, goal_deg: FloatArray, speed_mm_per_s: float, speed_deg_per_s: float) -> str:
    """Write the record mm_job: number, goal (6,) and speed of one move."""
    joints = json.dumps([round(float(angle), 5) for angle in goal_deg], separators=(",", ":"))
    unused = "[" + ",".join([UNUSED] * 6) + "]"
    speed = f"[{speed_mm_per_s:g},{speed_deg_per_s:g},{speed_mm_per_s:g},{speed_deg_per_s:g}]"
    return f"[{number},[{joints},{unused}],{speed}]"


def equal(one: str, other: str) -> bool:
    """Whether two values are the same to the resolution of a num."""
    if one == other:
        return True
    try:
        first, second = read_numbers(one), read_numbers(other)
    except ValueError:
        return False
    return first.shape == second.shape and bool(np.allclose(first, second, rtol=1e-7, atol=NUM_TOLERANCE))
