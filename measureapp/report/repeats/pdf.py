"""Repeated measurements as PDF, typeset by Typst."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from measureapp import __version__
from measureapp.data.repeats import RepeatedDimension, RepeatStudy
from measureapp.inspection.uncertainty import COVERAGE_FACTOR
from measureapp.language.languages import ENGLISH
from measureapp.project.atomic import replacing
from measureapp.report.language import Words
from measureapp.report.typeset import Typeset, typeset
from measureapp.report.words import NONE, format_name, format_time, number, percent
from measureapp.resources import resource

TEMPLATE = "report/repeats.typ"
SPREAD_DIGITS = 4


def write_repeats_pdf(study: RepeatStudy, path: Path, language: str = ENGLISH) -> Path:
    """Write the tables as PDF in ``language``, whole or not at all, and return ``path``. Raises StorageError."""
    (document,) = typeset(_document(study, language), "pdf")
    with replacing(path) as temporary:
        temporary.write_bytes(document)
    return path


def repeats_page_images(study: RepeatStudy, ppi: float = 110.0, language: str = ENGLISH) -> tuple[bytes, ...]:
    """Return the pages as PNG. Raises StorageError."""
    return typeset(_document(study, language), "png", ppi)


def _document(study: RepeatStudy, language: str) -> Typeset:
    words = Words(language, _names(study))
    return Typeset(resource(TEMPLATE), typst_study(study, words), {}, datetime.now(UTC).isoformat(timespec="seconds"), words)


def _names(study: RepeatStudy) -> Iterator[str]:
    """Yield the texts of a study that people gave."""
    yield from (study.part, study.program, *(one.name for one in study.measurements))
    for one in study.dimensions:
        yield from (one.name, format_name(one.name))


def typst_study(study: RepeatStudy, words: Words) -> dict[str, Any]:
    """Return the data of the template, with all numbers formatted."""
    software = f"MeasureApp {__version__}"
    return {
        "title": study.part,
        "software": software,
        "footer": f"{software} · {study.part}",
        "header": [
            {"name": words.tr("Inspection program"), "value": study.program},
            {"name": words.tr("Measurements"), "value": str(len(study.measurements))},
            {"name": words.tr("Confidence level"), "value": percent(study.confidence, 0)},
        ],
        "sentences": [words.said(one) for one in study.sentences],
        "dimensions": [_dimension(one, words) for one in study.dimensions],
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


def _dimension(one: RepeatedDimension, words: Words) -> dict[str, str]:
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
        "verdict": NONE if test is None else words.tr("contradicts U") if test.contradicts else words.tr("within U"),
    }
