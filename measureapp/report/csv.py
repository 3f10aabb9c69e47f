"""Table of dimensions as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from measureapp.data.dimension import CONTRIBUTIONS
from measureapp.data.report_template import Balloon
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
    "datum_letters",
    "control_frame",
    "alignment",
    "group",
    "warning",
    "origin",
    *(f"uncertainty_{name}" for name in CONTRIBUTIONS),
    "balloon",  # AS9102 form 3, from the template
    "zone",
    "designator",
)
FORMULA = ("=", "+", "-", "@", "\t", "\r")  # beginnings of formulas


def csv_text(model: ReportModel) -> str:
    """Return a header line and one line per dimension, with dots and commas everywhere; missing values are empty."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for row in dimension_rows(model):
        writer.writerow({key: guarded(value) for key, value in row.items()})
    return text.getvalue()


def dimension_rows(model: ReportModel) -> Iterator[dict[str, Any]]:
    """Yield the values of each dimension by column, numbers as they are."""
    balloons = model.details.template.description.balloons
    for dimension in model.dimensions:
        document = dimension_document(dimension)
        document["lower_tolerance"], document["upper_tolerance"] = document.pop("tolerance")
        budget = document.pop("uncertainty_budget")
        document |= {f"uncertainty_{name}": budget.get(name) for name in CONTRIBUTIONS}
        document |= {name: "|".join(document[name]) for name in ("datums", "datum_letters")}
        document["control_frame"] = (
            "" if dimension.frame is None else " | ".join((dimension.frame.characteristic, *dimension.frame.words()))
        )
        balloon = balloons.get(dimension.name, Balloon(number=""))
        yield {**document, "balloon": balloon.number, "zone": balloon.zone, "designator": balloon.designator}


def guarded(value: object) -> object:
    """Mark texts that a spreadsheet would take for a formula and carry out with an apostrophe."""
    return f"'{value}" if isinstance(value, str) and value.startswith(FORMULA) else value


def write_csv(model: ReportModel, path: Path) -> Path:
    """Write the table, whole or not at all, and return ``path``. Raises StorageError."""
    with replacing(path) as temporary:
        temporary.write_text(csv_text(model), encoding="utf-8-sig")  # byte order mark, by which spreadsheets recognise UTF-8
    return path
