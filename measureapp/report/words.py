"""Formatting of numbers, verdicts and names for documents."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from measureapp.data.dimension import CONTRIBUTION_DIGITS, Dimension, Verdict
from measureapp.data.shown_number import shown_number

MINUS = "−"
NONE = "–"
TOGETHER = "\u00a0"  # a space at which no line ends
SIGNS: dict[Verdict, str] = {
    Verdict.PASS: "✓",
    Verdict.FAIL: "✗",
    Verdict.NOT_PROVEN: "?",
    Verdict.NOT_MEASURED: "–",
    Verdict.NO_TOLERANCE: "·",
}
COLOURS: dict[Verdict, str] = {
    Verdict.PASS: "#1B998B",
    Verdict.FAIL: "#D1495B",
    Verdict.NOT_PROVEN: "#EDAE49",
    Verdict.NOT_MEASURED: "#8A8F98",
    Verdict.NO_TOLERANCE: "#8A8F98",
}
NEUTRAL = "#8A8F98"


def number(value: float | None, digits: int = 3, *, signed: bool = False) -> str:
    """Return a number with fixed digits and a true minus sign; a dash where there is none.

    >>> number(-0.01234), number(0.5, 2, signed=True), number(None)
    ('−0.012', '+0.50', '–')
    """
    if value is None:
        return NONE
    return shown_number(value, digits, signed=signed).replace("-", MINUS)


def percent(value: float | None, digits: int = 1, *, signed: bool = False) -> str:
    """Return a share as per cent.

    >>> percent(0.1234), percent(None)
    ('12.3 %', '–')
    """
    return NONE if value is None else number(100 * value, digits, signed=signed) + " %"


def format_tolerance(lower: float | None, upper: float | None) -> str:
    """Return a tolerance, abbreviated if it is symmetric; a dash where there is none.

    >>> format_tolerance(-0.1, 0.1), format_tolerance(-0.2, 0.05), format_tolerance(0.0, 0.2)
    ('± 0.1', '−0.2 / +0.05', '0 / +0.2')
    """
    if lower is None or upper is None:
        return NONE
    if lower == -upper:
        return f"± {upper:g}"
    return " / ".join("0" if limit == 0 else f"{limit:+g}" for limit in (lower, upper)).replace("-", MINUS)


def format_datums(dimension: Dimension) -> str:
    """Return datums in order with their letters; those of a pattern without letters.

    >>> given = {"datums": ("gear face", "bore"), "datum_letters": ("A", "D")}
    >>> none = Dimension("a", 0, 0.1, 0.05, 0, 0.2, Verdict.PASS)
    >>> format_datums(Dimension("a", 0, 0.1, 0.05, 0, 0.2, Verdict.PASS, **given)), format_datums(none)
    ('A gear face, D bore', '–')
    """
    if not dimension.datums:
        return NONE
    if not dimension.datum_letters:
        return ", ".join(dimension.datums)
    return ", ".join(f"{letter} {name}" for letter, name in zip(dimension.datum_letters, dimension.datums, strict=True))


def format_contributions(dimension: Dimension, label: Callable[[str], str] = str) -> str:
    """Return the uncertainty budget: contributions with k = 2, largest first, without those that round to zero; ``label`` names them.

    >>> format_contributions(Dimension("a", 10, 10, 0.05, -0.1, 0.1, Verdict.PASS, budget={"noise": 0.03, "stitching": 0.04})).replace(TOGETHER, " ")
    'stitching 0.0400, noise 0.0300 mm'
    >>> format_contributions(Dimension("a", 10, 10, 0.05, -0.1, 0.1, Verdict.PASS, budget={"noise": 0.03, "form": 0.00002})).replace(TOGETHER, " ")
    'noise 0.0300 mm'
    """
    named = ", ".join(f"{label(name)}{TOGETHER}{number(size, CONTRIBUTION_DIGITS)}" for name, size in dimension.rank_contributions())
    return f"{named}{'' if dimension.unit == '°' else TOGETHER}{dimension.unit}" if named else NONE


def format_setting(value: Any) -> str:
    """Return a setting of any JSON kind as words."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:g}".replace("-", MINUS)
    if isinstance(value, dict):
        return ", ".join(f"{format_key(key)} {format_setting(item)}" for key, item in value.items())
    if isinstance(value, (list, tuple)):
        return ", ".join(format_setting(item) for item in value)
    return NONE if value is None else str(value)


def format_key(key: str) -> str:
    """Return a key of a document as words, its unit in brackets.

    >>> format_key("exposures_us"), format_key("least_points"), format_key("stitch.voxel_mm")
    ('exposures (µs)', 'least points', 'stitch voxel (mm)')
    """
    match = re.fullmatch(r"(.*)_(mm|us|deg|rad|px|s)", key)
    name, unit = (match.group(1), {"us": "µs", "deg": "°"}.get(match.group(2), match.group(2))) if match else (key, "")
    words = name.replace("_", " ").replace(".", " ")
    return f"{words} ({unit})" if unit else words


def format_name(name: str) -> str:
    """Return an identifier as words with a capital letter; other names and single letters unchanged.

    >>> format_name("outer_diameter"), format_name("a"), format_name("P1_x, hole")
    ('Outer diameter', 'a', 'P1_x, hole')
    """
    return name.replace("_", " ").capitalize() if re.fullmatch(r"[a-z][a-z0-9_]+", name) else name


def format_time(iso: str) -> str:
    """Return an ISO 8601 time as date and time of day.

    >>> format_time("2026-05-04T10:20:30.123+00:00")
    '2026-05-04 10:20:30 UTC'
    """
    match = re.match(r"(\d{4}-\d\d-\d\d)T(\d\d:\d\d:\d\d)(?:\.\d+)?(Z|[+-]\d\d:\d\d)?$", iso)
    if match is None:
        return iso or NONE
    zone = match.group(3) or ""
    return f"{match.group(1)} {match.group(2)}" + (" UTC" if zone in ("Z", "+00:00") else f" {zone}" if zone else "")
