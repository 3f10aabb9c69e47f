"""Tolerances as one text, the way a drawing states them: `±0.1`, `+0.1/-0.05`, `max 0.05`, `H7`, `2768-m`."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from measureapp.data.standard_tolerances import GENERAL_MM, general_tolerance, tolerance_class

NUMBER = r"\d+(?:\.\d*)?|\.\d+"
SYMMETRIC = re.compile(rf"(?:±|\+/?-)\s*({NUMBER})")
TWO_SIDED = re.compile(rf"([+-]?(?:{NUMBER}))\s*(?:[/;]|\s)\s*([+-]?(?:{NUMBER}))")
MAXIMUM = re.compile(rf"(?:max\.?|≤|<=)\s*({NUMBER})", re.IGNORECASE)
FIT = re.compile(r"([A-Za-z]{1,2})\s?(\d{1,2})")
GENERAL = re.compile(r"(?:DIN\s+)?(?:ISO\s*)?2768(?:-1)?\s*[- ]\s*([a-z])([A-Z]?)")
UNIT = re.compile(r"\s*(?:mm|°)$")
EXAMPLES = "±0.1, +0.1/-0.05, 0/-0.2, H7, 2768-m, or nothing for no verdict"
LENGTHS = ("distance", "thickness", "step", "diameter", "slot_width", "slot_length", "chord", "max_thickness")  # with a linear size


@dataclass(frozen=True, slots=True)
class Tolerance:
    """Limits as deviations from the nominal, and the text they come from."""

    lower: float
    upper: float
    source: str


def parse_tolerance(text: str, *, kind: str, nominal: float, is_zone: bool) -> Tolerance | None:
    """Parse a tolerance; None for an empty text: no tolerance, and no verdict.

    Parameters
    ----------
    text : as typed; a decimal comma and the minus sign U+2212 are understood
    kind : kind of the dimension; standard tolerances apply to linear sizes only
    nominal : size in mm, from which a standard tolerance follows
    is_zone : whether the value is the width of a tolerance zone, which has only a maximum

    Raises
    ------
    ValueError
        The text is not a tolerance of this kind, or its standard states none; the message names the remedy.

    >>> parse_tolerance("+0,1/−0.05", kind="distance", nominal=20.0, is_zone=False)
    Tolerance(lower=-0.05, upper=0.1, source='+0.1/-0.05')
    """
    given = UNIT.sub("", re.sub(r"(?<=\d),(?=\d)", ".", text.replace("−", "-")).strip())
    if not given:
        return None
    if is_zone:
        return _zone(given)
    if match := SYMMETRIC.fullmatch(given):
        width = _positive(match[1], given)
        return Tolerance(-width, width, given)
    if match := TWO_SIDED.fullmatch(given):
        return _two_sided(match[1], match[2], given)
    if match := GENERAL.fullmatch(given):
        return _general(match[1], match[2], kind, nominal, given)
    if match := FIT.fullmatch(given):
        _require_length(given, kind)
        return Tolerance(*tolerance_class(match[1], int(match[2]), abs(nominal)), given)
    raise _refusal(given)


def _zone(given: str) -> Tolerance:
    match = MAXIMUM.fullmatch(given) or re.fullmatch(f"({NUMBER})", given)
    if match is None:
        raise ValueError(f"{given!r} is not the width of a tolerance zone: enter one number, such as max 0.05")
    return Tolerance(0.0, _positive(match[1], given), given)


def _two_sided(first: str, second: str, given: str) -> Tolerance:
    numbers = [float(first), float(second)]
    for words, number in zip((first, second), numbers, strict=True):
        if number != 0 and words[0] not in "+-":
            raise ValueError(f"{given!r}: give both limits a sign, such as +{number:g}")
    if numbers[0] == numbers[1]:
        raise ValueError(f"{given!r}: both limits are equal; give a range")
    return Tolerance(min(numbers) + 0.0, max(numbers) + 0.0, given)


def _general(name: str, second: str, kind: str, nominal: float, given: str) -> Tolerance:
    if second:
        raise ValueError(f"{given!r}: {second} is the class of geometrical tolerances; for a size enter 2768-{name}")
    if name not in GENERAL_MM:
        raise ValueError(f"{given!r}: the classes of ISO 2768-1 are f, m, c and v")
    _require_length(given, kind)
    width = general_tolerance(name, abs(nominal))
    return Tolerance(-width, width, given)


def _require_length(given: str, kind: str) -> None:
    if kind not in LENGTHS:
        raise ValueError(f"{given!r} applies to linear sizes only: enter the limits as numbers, such as ±0.5")


def _positive(number: str, given: str) -> float:
    value = float(number)
    if not (value > 0 and math.isfinite(value)):
        raise ValueError(f"{given!r}: a tolerance of zero width cannot be verified; enter a number above 0")
    return value


def _refusal(given: str) -> ValueError:
    if re.search(r"22081", given):
        return ValueError(f"{given!r}: with ISO 22081 the drawing states the values: enter them, such as ±0.3")
    if MAXIMUM.fullmatch(given):
        return ValueError(f"{given!r}: max applies to the width of a tolerance zone; for a size enter both limits, such as 0/-0.2")
    if re.fullmatch(rf"[+-]?(?:{NUMBER})", given):
        return ValueError(f"{given!r} is one number: enter ±{given.lstrip('+-')}, or both limits, such as +{given.lstrip('+-')}/0")
    return ValueError(f"{given!r} is not a tolerance: enter {EXAMPLES}")
