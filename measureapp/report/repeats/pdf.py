"""Repeated measurements as PDF, typeset by Typst."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from measureapp import __version__
from measureapp.data.repeats import RepeatedDimension, RepeatStudy
from measureapp.inspection.uncertainty import COVERAGE_FACTOR
from measureapp.project.atomic import replacing
from measureapp.report.typeset import Typeset, typeset
from measureapp.report.words import NONE, format_name, format_time, number, percent
from measureapp.resources import resource

TEMPLATE = "report/repeats.typ"
SPREAD_DIGITS = 4


def write_repeats_pdf(study: RepeatStudy, path: Path) -> Path:
    """Write the tables as PDF, whole or not at all, and return ``path``. Raises StorageError."""
    (document,) = typeset(_document(study), "pdf")
    with replacing(path) as temporary:
        temporary.write_bytes(document)
    return path


def repeats_page_images(study: RepeatStudy, ppi: float = 110.0) -> tuple[bytes, ...]:
    """Return the pages as PNG. Raises StorageError."""
    return typeset(_document(study), "png", ppi)


def _document(study: RepeatStudy) -> Typeset:
    return Typeset(resource(TEMPLATE), typst_study(study), {}, datetime.now(UTC).isoformat(timespec="seconds"))


def typst_study(study: RepeatStudy) -> dict[str, Any]:
    """Return the data of the template, with all numbers formatted."""
    software = f"MeasureApp {__version__}"
    return {
        "title": study.part,
        "software": software,
        "footer": f"{software} · {study.part}",
        "header": [
            {"name": "Inspection program", "value": study.program},
            {"name": "Measurements", "value": str(len(study.measurements))},
            {"name": "Confidence level", "value": percent(study.confidence, 0)},
        ],
        "sentences": list(study.sentences),
        "dimensions": [_dimension(one) for one in study.dimensions],
        "measurements": [
            {
                "name": one.name,
                "measured_at": format_time(one.measured_at),
                "calibrated_at": format_time(one.calibration),
                "values": [number(dimension.values[one.name]) for dimension in study.dimensions],
            }
            for one in study.measurements
        ],
    }


def _dimension(one: RepeatedDimension) -> dict[str, str]:
    unit = "°" if one.unit == "°" else f" {one.unit}"
    test = one.test
    return {
        "name": format_name(one.name),
        "nominal": number(one.nominal) + unit,
        "mean": NONE if one.mean is None else number(one.mean) + unit,
        "deviation": number(one.deviation, signed=True),
        "relative": percent(one.relative, 3, signed=True),
        "half_width": number(one.mean_half_width, SPREAD_DIGITS),
        "std": number(one.std, SPREAD_DIGITS),
        "std_interval": NONE if one.std_interval is None else " … ".join(number(limit, SPREAD_DIGITS) for limit in one.std_interval),
        "n": str(one.n),
        "uncertainty": NONE if test is None else number(COVERAGE_FACTOR * test.stated_sigma, SPREAD_DIGITS),
        "p_value": NONE if test is None else "< 0.001" if test.p_value < 0.001 else number(test.p_value),
        "verdict": NONE if test is None else "contradicts U" if test.contradicts else "within U",
    }
