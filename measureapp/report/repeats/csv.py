"""Table of repeated measurements as CSV: one line per dimension, one column per measurement."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from measureapp.data.repeats import RepeatStudy
from measureapp.project.atomic import replacing
from measureapp.report.repeats.json_document import study_document

FIGURES = ("name", "nominal", "unit", "mean", "std", "n", "deviation", "relative", "mean_half_width")
TEST = ("stated_uncertainty", "p_value", "contradicts_uncertainty")
DIGITS = 9


def repeats_csv_text(study: RepeatStudy) -> str:
    """Return a header line and one line per dimension; missing values are empty."""
    measured = [one.name for one in study.measurements]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*FIGURES, "std_lower", "std_upper", *TEST, *measured])
    for one in study_document(study)["dimensions"]:
        interval = one["std_interval"] or (None, None)
        row = [*(one[name] for name in FIGURES), *interval, *(one[name] for name in TEST), *(one["values"][name] for name in measured)]
        writer.writerow([round(value, DIGITS) if isinstance(value, float) else value for value in row])
    return text.getvalue()


def write_repeats_csv(study: RepeatStudy, path: Path) -> Path:
    """Write the table, whole or not at all, and return ``path``. Raises StorageError."""
    with replacing(path) as temporary:
        temporary.write_text(repeats_csv_text(study), encoding="utf-8-sig")  # byte order mark, by which spreadsheets recognise UTF-8
    return path
