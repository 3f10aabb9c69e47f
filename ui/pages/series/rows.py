"""Rows of the table of a series."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import quantity, several
from ui.widgets.data_table import Cell, number

if TYPE_CHECKING:
    from measureapp.report.series.capability import Index, Trend
    from ui.controllers.series import ReadSeries

HEADERS = ("Dimension", "Parts", "Mean", "s", "U (k = 2)", "Overall", "Within")
NUMERIC = (1, 2, 3, 4)
DIGITS, SPREAD_DIGITS = 3, 4
NOTHING = "–"


def rows_of(trends: tuple[Trend, ...]) -> list[list[Cell]]:
    """Return one row per dimension, in the order of the program."""
    return [_row(trend) for trend in trends]


def summary(found: ReadSeries) -> str:
    """Return how many parts have which verdict, in a sentence."""
    verdicts = [str(run.verdict or "no verdict") for run in found.runs]
    counts = ", ".join(f"{verdicts.count(verdict)} {verdict}" for verdict in dict.fromkeys(verdicts))
    return tr("{count} by the program {program}: {counts}.", count=several(len(found.runs), "run"), program=found.program, counts=counts)


def _row(trend: Trend) -> list[Cell]:
    return [
        Cell(trend.name, bold=True, tip=trend.remark),
        number(str(trend.n)),
        number(quantity(trend.mean, trend.unit, DIGITS)),
        number(quantity(trend.std, "", SPREAD_DIGITS)),
        number(quantity(trend.uncertainty, "", SPREAD_DIGITS)),
        _index(trend, 0),
        _index(trend, 1),
    ]


def _index(trend: Trend, place: int) -> Cell:
    if place >= len(trend.indices):
        return Cell(NOTHING, tip=trend.remark)
    found: Index = trend.indices[place]
    low, high = found.interval
    return Cell(
        f"{found.name} {found.value:.2f} ({low:.2f} … {high:.2f})",
        tip=tr("95 % interval; σ from {sigma_from}. {remark}", sigma_from=found.sigma_from, remark=trend.remark),
    )
