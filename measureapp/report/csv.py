"""Table of dimensions as CSV."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from measureapp.data.dimension import CONTRIBUTIONS
from measureapp.project.atomic import replacing
from measureapp.report.json_document import dimension_document
from measureapp.report.model import ReportModel

COLUMNS = (
    "name",
    "nominal",
    "measured",
    "error",
    "relative_error",
    "uncertainty",
    "lower_tolerance",
    "upper_tolerance",
    "tolerance_source",
    "unit",
    "verdict",
    "reason",
    "kind",
    "datums",
    "alignment",
    "group",
    "warning",
    "origin",
    *(f"uncertainty_{name}" for name in CONTRIBUTIONS),
)
DIGITS = 9
FORMULA = ("=", "+", "-", "@", "\t", "\r")  # beginnings of formulas


def csv_text(model: ReportModel) -> str:
    """Return a header line and one line per dimension; missing values are empty."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for dimension in model.dimensions:
        document = dimension_document(dimension)
        document["lower_tolerance"], document["upper_tolerance"] = document.pop("tolerance")
        budget = document.pop("uncertainty_budget")
        document |= {f"uncertainty_{name}": budget.get(name) for name in CONTRIBUTIONS}
        document["datums"] = "|".join(document["datums"])
        writer.writerow({key: _cell(value) for key, value in document.items()})
    return text.getvalue()


def _cell(value: object) -> object:
    """Round numbers, and mark texts that a spreadsheet would take for a formula and carry out with an apostrophe."""
    if isinstance(value, float):
        return round(value, DIGITS)
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value


def write_csv(model: ReportModel, path: Path) -> Path:
    """Write the table, whole or not at all, and return ``path``. Raises StorageError."""
    with replacing(path) as temporary:
        temporary.write_text(csv_text(model), encoding="utf-8-sig")  # byte order mark, by which spreadsheets recognise UTF-8
    return path
