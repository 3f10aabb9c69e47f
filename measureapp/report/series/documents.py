"""Documents of a series in a folder: PDF, CSV and JSON."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from measureapp import __version__
from measureapp.data.series import SeriesRun
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH
from measureapp.project.atomic import replacing, write_json
from measureapp.report.csv import guarded
from measureapp.report.language import Words
from measureapp.report.series.capability import Index, Trend, count_once, trends
from measureapp.report.series.chart import run_chart
from measureapp.report.typeset import Typeset, typeset
from measureapp.report.words import COLOURS, NEUTRAL, NONE, SIGNS, format_name, format_time, number
from measureapp.resources import resource

TEMPLATE = "report/series.typ"
SPREAD_DIGITS = 4
MOST_LISTED = 60


def write_series(program: str, runs: Sequence[SeriesRun], folder: Path, language: str = ENGLISH) -> dict[str, Path]:
    """Write `series.pdf`, `.csv` and `.json` into ``folder``, each whole or not at all; the PDF is in ``language``.

    Raises
    ------
    InputError
        There are no runs.
    StorageError
        A document cannot be written.
    """
    if not runs:
        raise InputError(f"The series of {program} has no runs.", "Add measured projects: measureapp series add PROJECT.")
    files = {kind: folder / f"series.{kind}" for kind in ("pdf", "csv", "json")}
    (document,) = typeset(series_typeset(program, runs, language=language), "pdf")
    with replacing(files["pdf"]) as temporary:
        temporary.write_bytes(document)
    with replacing(files["csv"]) as temporary:
        temporary.write_text(series_csv_text(runs), encoding="utf-8-sig")
    write_json(files["json"], series_document(program, runs))
    return files


def series_typeset(program: str, runs: Sequence[SeriesRun], created_at: str = "", language: str = ENGLISH) -> Typeset:
    """Return the report of a series, to be typeset."""
    found = trends(runs)
    created = created_at or datetime.now(UTC).isoformat(timespec="seconds")
    pictures = {f"chart{n}.svg": run_chart(trend).encode() for n, trend in enumerate(found)}
    words = Words(language, _names(program, runs))
    return Typeset(resource(TEMPLATE), typst_series(program, runs, found, created, words), pictures, created, words)


def _names(program: str, runs: Sequence[SeriesRun]) -> Iterator[str]:
    """Yield the texts of a series that people gave."""
    yield program
    for run in runs:
        yield run.repeat_reason
        for value in run.values:
            yield from (value.name, format_name(value.name))


def series_document(program: str, runs: Sequence[SeriesRun]) -> dict[str, Any]:
    """Return runs, trends and capability as JSON; missing numbers are None."""
    return {
        "schema_version": 1,
        "program": program,
        "runs": [run.model_dump(mode="json") for run in runs],
        "parts": len(count_once(runs)),
        "dimensions": [_trend_document(trend) for trend in trends(runs)],
    }


def series_csv_text(runs: Sequence[SeriesRun]) -> str:
    """Return one line per run: what identifies it, its verdict, and the value of every dimension."""
    names = list(dict.fromkeys(value.name for run in runs for value in run.values))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["measured_at", "serial_number", "order", "operator", "verdict", "repeat_reason", "version", *map(guarded, names)])
    for run in runs:
        values = {value.name: value.measured for value in run.values}
        known = run.identification
        row = [run.measured_at, known.serial_number, known.order, known.operator, run.verdict or "", run.repeat_reason, run.version]
        writer.writerow([guarded(str(cell)) for cell in row] + [values.get(name) for name in names])
    return text.getvalue()


def typst_series(program: str, runs: Sequence[SeriesRun], found: Sequence[Trend], created_at: str, words: Words) -> dict[str, Any]:
    """Return the data of the layout, with all numbers formatted."""
    parts = count_once(runs)
    return {
        "title": program,
        "software": f"MeasureApp {__version__}",
        "created": format_time(created_at),
        "header": [
            {"name": words.tr("Number of runs"), "value": str(len(runs))},
            {"name": words.tr("Parts"), "value": str(len(parts))},
            {"name": words.tr("First run"), "value": format_time(runs[0].measured_at)},
            {"name": words.tr("Last run"), "value": format_time(runs[-1].measured_at)},
        ],
        "trends": [{**_printed(trend, words), "chart": f"chart{n}.svg"} for n, trend in enumerate(found)],
        "runs": [_run(run, words) for run in runs[-MOST_LISTED:]],
        "left_out": max(0, len(runs) - MOST_LISTED),
    }


def _run(run: SeriesRun, words: Words) -> dict[str, str]:
    known = run.identification
    return {
        "at": format_time(run.measured_at),
        "serial": known.serial_number or NONE,
        "order": known.order or NONE,
        "operator": known.operator or NONE,
        "verdict": NONE if run.verdict is None else words.label(run.verdict.value),
        "sign": NONE if run.verdict is None else SIGNS[run.verdict],
        "colour": NEUTRAL if run.verdict is None else COLOURS[run.verdict],
        "reason": run.repeat_reason,
    }


def _printed(trend: Trend, words: Words) -> dict[str, Any]:
    unit = "°" if trend.unit == "°" else f" {trend.unit}"
    facts = [
        ("Nominal", number(trend.nominal) + unit),
        ("Limits", " … ".join(number(limit) for limit in trend.limits)),
        ("Parts with a value", str(trend.n)),
        ("Mean", number(trend.mean)),
        ("Standard deviation", number(trend.std, SPREAD_DIGITS)),
        ("Mean moving range", number(trend.mean_moving_range, SPREAD_DIGITS)),
        ("U of one value (k = 2)", number(trend.uncertainty, SPREAD_DIGITS)),
    ]
    return {
        "name": format_name(trend.name),
        "facts": [{"name": words.tr(name), "value": value} for name, value in facts],
        "indices": [_printed_index(one, words) for one in trend.indices],
        "remark": words.said(trend.remark),
    }


def _printed_index(one: Index, words: Words) -> dict[str, str]:
    spread = "" if one.spread_only is None else f"{one.name[:-1]} {number(one.spread_only, 2)}, "
    interval = words.tr("95 % interval {low} … {high}", low=number(one.interval[0], 2), high=number(one.interval[1], 2))
    return {
        "words": f"{spread}{one.name} {number(one.value, 2)}",
        "interval": interval,
        "sigma": words.tr("σ {sigma}: {source}", sigma=number(one.sigma, SPREAD_DIGITS), source=one.sigma_from),
    }


def _trend_document(trend: Trend) -> dict[str, Any]:
    return {
        "name": trend.name,
        "unit": trend.unit,
        "nominal": trend.nominal,
        "limits": list(trend.limits),
        "n": trend.n,
        "mean": trend.mean,
        "std": trend.std,
        "mean_moving_range": trend.mean_moving_range,
        "uncertainty": trend.uncertainty,
        "values": [None if np.isnan(value) else float(value) for value in trend.values],
        "indices": [asdict(one) for one in trend.indices],
        "remark": trend.remark,
    }
