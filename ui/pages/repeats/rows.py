"""Rows of the table of repeats."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.wording import percent, quantity
from ui.widgets.data_table import Cell, number, verdict_cell

if TYPE_CHECKING:
    from measureapp.data.repeats import RepeatedDimension, RepeatStudy

HEADERS = ("Dimension", "Nominal", "Mean", "Deviation", "Relative", "s", "n", "U (k = 2)", "p", "Spread")
NUMERIC = tuple(range(1, 9))
DIGITS, SPREAD_DIGITS = 3, 4
SMALLEST_P = 0.001
NOTHING = "–"
TIPS = {
    True: "The spread is larger than the stated U explains (chi-square test)",
    False: "The stated U explains the spread (chi-square test)",
}


def rows_of(study: RepeatStudy) -> list[list[Cell]]:
    """Return one row per dimension: first those whose spread contradicts U, then those without a value."""
    return [_row(one) for one in sorted(study.dimensions, key=_rank)]


def _rank(one: RepeatedDimension) -> int:
    if one.test is not None and one.test.contradicts:
        return 0
    return 1 if one.mean is None else 2


def _row(one: RepeatedDimension) -> list[Cell]:
    from measureapp.inspection.uncertainty import COVERAGE_FACTOR

    test = one.test
    stated = None if test is None else COVERAGE_FACTOR * test.stated_sigma
    chance = NOTHING if test is None else f"< {SMALLEST_P}" if test.p_value < SMALLEST_P else f"{test.p_value:.3f}"
    return [
        Cell(one.name, bold=True, tip="\n".join(f"{name}: {reason}" for name, reason in one.reasons.items())),
        number(quantity(one.nominal, one.unit, DIGITS)),
        number(quantity(one.mean, one.unit, DIGITS)),
        number(quantity(one.deviation, "", DIGITS, signed=True)),
        number(percent(one.relative, DIGITS, signed=True)),
        number(quantity(one.std, "", SPREAD_DIGITS)),
        number(str(one.n)),
        number(quantity(stated, "", SPREAD_DIGITS)),
        number(chance),
        _verdict(one),
    ]


def _verdict(one: RepeatedDimension) -> Cell:
    if one.mean is None:
        return verdict_cell("not measured", "Not measured", "\n".join(one.reasons.values()))
    if one.test is None:
        return verdict_cell("not measured", "Not tested", "A test needs two values and a stated U")
    if one.test.contradicts:
        return verdict_cell("fail", "Larger than U", TIPS[True])
    return verdict_cell("pass", "Within U", TIPS[False])
