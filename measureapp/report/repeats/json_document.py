"""Repeated measurements as a JSON document."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from measureapp.data.repeats import RepeatedDimension, RepeatStudy
from measureapp.inspection.uncertainty import COVERAGE_FACTOR


def study_document(study: RepeatStudy) -> dict[str, Any]:
    """Return a study as JSON; missing numbers are None."""
    return {
        "schema_version": 1,
        "part": study.part,
        "program": study.program,
        "measurements": [asdict(one) for one in study.measurements],
        "dimensions": [_dimension(one) for one in study.dimensions],
        "confidence": study.confidence,
        "level": study.level,
        "displacement_mm": study.displacement_mm,
        "contradictions": list(study.contradictions),
        "conclusions": list(study.sentences),
    }


def _dimension(one: RepeatedDimension) -> dict[str, Any]:
    test = one.test
    return {
        "name": one.name,
        "nominal": one.nominal,
        "unit": one.unit,
        "mean": one.mean,
        "std": one.std,
        "n": one.n,
        "deviation": one.deviation,
        "relative": one.relative,
        "mean_half_width": one.mean_half_width,
        "std_interval": None if one.std_interval is None else list(one.std_interval),
        "stated_uncertainty": None if test is None else COVERAGE_FACTOR * test.stated_sigma,
        "p_value": None if test is None else test.p_value,
        "contradicts_uncertainty": None if test is None else test.contradicts,
        "values": dict(one.values),
        "reasons": dict(one.reasons),
    }
