"""The report as PDF, typeset by Typst."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.measurement import Measurement
from measureapp.project.atomic import replacing
from measureapp.report.compose import compose
from measureapp.report.model import DeviationSummary, Fact, ReportModel, ViewLine
from measureapp.report.part_pictures import diverging_colours
from measureapp.report.typeset import typeset
from measureapp.report.words import (
    COLOURS,
    NEUTRAL,
    SIGNS,
    format_contributions,
    format_datums,
    format_key,
    format_name,
    format_tolerance,
    number,
    percent,
)
from measureapp.resources import resource

TEMPLATE = "report/report.typ"
SCALE_STOPS = 21


def write_pdf(model: ReportModel, path: Path, template: Path | None = None) -> Path:
    """Write the report as PDF, whole or not at all, and return ``path``.

    Raises
    ------
    StorageError
        The file cannot be written, or the template has an error, which is named.
    """
    document = pdf_bytes(model, template)
    with replacing(path) as temporary:
        temporary.write_bytes(document)
    return path


def pdf_bytes(model: ReportModel, template: Path | None = None) -> bytes:
    """Return the report as PDF. Raises StorageError when the template has an error, which is named."""
    return _typeset(model, template, format="pdf")[0]


def page_images(measurement: Measurement, ppi: float = 110.0) -> tuple[bytes, ...]:
    """Return the pages of a measurement's report as PNG, as in the PDF but without the deviation from a nominal."""
    return model_page_images(compose(measurement), ppi)


def model_page_images(model: ReportModel, ppi: float = 110.0, template: Path | None = None) -> tuple[bytes, ...]:
    """Return the pages of a report as PNG. Raises StorageError when the template has an error, which is named."""
    return _typeset(model, template, format="png", ppi=ppi)


def _typeset(model: ReportModel, template: Path | None, **options: Any) -> tuple[bytes, ...]:
    """Typeset the report with its pictures."""
    files = {"report.json": json.dumps(typst_document(model)).encode()}
    files |= {f"picture{n}.png": picture.png for n, picture in enumerate(model.pictures)}
    if model.deviation is not None:
        files["deviation.png"] = model.deviation.picture.png
    return typeset(template or resource(TEMPLATE), files, **options)


def typst_document(model: ReportModel) -> dict[str, Any]:
    """Return the data of the template, with all numbers formatted."""
    word = "NO VERDICT" if model.verdict is None else model.verdict.value.upper()
    colour = NEUTRAL if model.verdict is None else COLOURS[model.verdict]
    return {
        "title": model.title,
        "software": model.software,
        "footer": f"{model.software} · {model.measurement.project} · {model.title}",
        "verdict": {"word": word, "colour": colour, "sign": "–" if model.verdict is None else SIGNS[model.verdict]},
        "summary": model.summary,
        "rule": model.verdict_rule,
        "header": _facts(model.header),
        "pictures": [{"file": f"picture{n}.png", "caption": picture.caption} for n, picture in enumerate(model.pictures)],
        "dimensions": [_dimension(dimension) for dimension in model.dimensions],
        "origins": [_traceability(dimension) for dimension in model.dimensions if dimension.traceability],
        "deviation": None if model.deviation is None else _deviation(model.deviation),
        "views": [_view(view) for view in model.views],
        "sections": [{"title": section.title, "facts": _facts(section.facts)} for section in model.sections],
    }


def _facts(facts: tuple[Fact, ...]) -> list[dict[str, str]]:
    return [{"name": fact.name, "value": fact.value} for fact in facts]


def _dimension(dimension: Dimension) -> dict[str, str]:
    unit = "°" if dimension.unit == "°" else f" {dimension.unit}"
    return {
        "name": format_name(dimension.name),
        "nominal": number(dimension.nominal) + unit,
        "measured": number(dimension.measured) + (unit if dimension.measured is not None else ""),
        "error": number(dimension.deviation, signed=True),
        "relative": percent(dimension.relative_deviation, 3, signed=True),
        "uncertainty": number(dimension.round_uncertainty()),
        "tolerance": format_tolerance(dimension.lower_tolerance, dimension.upper_tolerance),
        "verdict": dimension.verdict.value,
        "sign": SIGNS[dimension.verdict],
        "colour": COLOURS[dimension.verdict],
        "reason": dimension.reason,
    }


def _traceability(dimension: Dimension) -> dict[str, str]:
    """Return the traceability of a value: kind, datums, source, and uncertainty budget."""
    return {
        "name": format_name(dimension.name),
        "kind": format_key(dimension.kind),
        "datums": format_datums(dimension.datums),
        "shares": format_contributions(dimension),
        "origin": dimension.traceability,
    }


def _view(view: ViewLine) -> dict[str, str]:
    verdict = Verdict.PASS if view.used and view.verdict == "good" else Verdict.NOT_PROVEN if view.used else Verdict.FAIL
    return {
        "name": view.viewpoint_id,
        "points": f"{view.points:,}".replace(",", "\u2009"),
        "noise": number(view.noise_mm),
        "completeness": percent(view.completeness),
        "moved": number(view.correction_mm),
        "turned": number(view.correction_deg),
        "residual": number(view.residual_mm),
        "verdict": view.verdict,
        "sign": SIGNS[verdict],
        "colour": COLOURS[verdict],
    }


def _deviation(deviation: DeviationSummary) -> dict[str, Any]:
    figures = deviation.figures_mm
    facts = [(name, f"{number(figures[key], signed=key not in {'rms', 'p95'})} mm") for name, key in _FIGURES]
    stops = np.rint(255 * diverging_colours(np.linspace(-1, 1, SCALE_STOPS))).astype(int)
    return {
        "file": "deviation.png",
        "low": f"{number(-deviation.limit_mm, 2)} mm",
        "high": f"{number(deviation.limit_mm, 2, signed=True)} mm",
        "stops": ["#{:02x}{:02x}{:02x}".format(*stop) for stop in stops],
        "histogram": list(deviation.histogram),
        "facts": [
            {"name": name, "value": value} for name, value in (*facts, ("Nominal not measured", percent(deviation.unmeasured_share)))
        ],
        "note": f"Alignment: {deviation.alignment}. Positive: outside the nominal. Grey: filled, not measured.",
    }


_FIGURES = (("Mean", "mean"), ("RMS", "rms"), ("95 % within", "p95"), ("Minimum", "min"), ("Maximum", "max"))
