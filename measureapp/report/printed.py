"""The data of the printed report: every number formatted, every text a value."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

from measureapp.data.control_frame import ControlFrame
from measureapp.data.dimension import SEVERITY, Dimension, Verdict
from measureapp.data.frame_symbols import symbol_svg
from measureapp.report.header import field_words
from measureapp.report.model import DeviationSummary, Fact, Picture, PlanLine, ReportModel, ViewLine
from measureapp.report.words import (
    COLOURS,
    NEUTRAL,
    NONE,
    SIGNS,
    format_contributions,
    format_datums,
    format_key,
    format_name,
    format_time,
    format_tolerance,
    number,
    percent,
)

SCALE_STOPS = 81
MOST_WORST = 10
WIDEST = 1.3  # of the tolerance's half width: where the bar of a deviation ends


def typst_document(model: ReportModel) -> dict[str, Any]:
    """Return the data of the layout; pictures are named as in `picture_files`."""
    template, details, aligned = model.details.template, model.details, alignments(model)
    dimensions = [
        _dimension(number_, one, name) for number_, (one, name) in enumerate(zip(model.dimensions, aligned, strict=True), start=1)
    ]
    facts = {fact.name: fact.value for section in model.sections for fact in section.facts}
    return {
        "title": model.title,
        "heading": template.description.title,
        "software": model.software,
        "footer": " · ".join(word for word in (model.software, model.measurement.project, model.title, _template_words(model)) if word),
        "company": template.description.company,
        "address": template.description.address,
        "logo": "" if template.logo is None else f"logo{template.logo[0]}",
        "opening": template.description.opening,
        "closing": template.description.closing,
        "signatures": list(template.description.signatures),
        "pages": list(template.description.pages),
        "created": format_time(details.created_at),
        "verdict": _verdict(model.verdict),
        "counts": _counts(model.dimensions),
        "summary": model.summary,
        "rule": model.verdict_rule,
        "remarks": field_words(details.identification, "remarks"),
        "header": _facts(model.header),
        "basis": [
            {"name": name, "value": facts[name]}
            for name in ("Alignment to the nominal", "Residual of the alignment", "Calibration age", "Adds to a length (k = 2)")
            if facts.get(name)
        ],
        "warnings": [fact.value for section in model.sections for fact in section.facts if fact.name == "Warning"],
        "pictures": [_picture(f"picture{n}.png", picture) for n, picture in enumerate(model.pictures)],
        "dimensions": dimensions,
        "alignments": alignment_note(aligned),
        "worst": [dimensions[index] for index in worst_first(model.dimensions)[:MOST_WORST]],
        "groups": _groups(model.dimensions, dimensions),
        "failing": [
            {**_picture(f"failing{n}.png", one.picture), "row": next(row for row in dimensions if row["key"] == one.name)}
            for n, one in enumerate(model.failing)
        ],
        "origins": [_traceability(dimension) for dimension in model.dimensions if dimension.traceability],
        "deviation": None if model.deviation is None else _deviation(model.deviation),
        "cross_sections": [_picture(f"section{n}.svg", picture) for n, picture in enumerate(model.cross_sections)],
        "views": [_view(view) for view in model.views],
        "plan": [_plan_line(line) for line in model.plan_lines],
        "sections": [{"title": section.title, "facts": _facts(section.facts)} for section in model.sections],
    }


def picture_files(model: ReportModel) -> dict[str, bytes]:
    """Return the pictures of the layout by the names that its data gives them."""
    files = {f"picture{n}.png": picture.png for n, picture in enumerate(model.pictures)}
    files |= {f"failing{n}.png": one.picture.png for n, one in enumerate(model.failing)}
    files |= {f"section{n}.svg": picture.png for n, picture in enumerate(model.cross_sections)}
    if model.deviation is not None:
        files |= {f"deviation{n}.png": picture.png for n, picture in enumerate(model.deviation.pictures)}
    frames = {dimension.frame.characteristic for dimension in model.dimensions if dimension.frame is not None}
    files |= {symbol_file(one): symbol_svg(one).encode() for one in frames}
    logo = model.details.template.logo
    return files if logo is None else {**files, f"logo{logo[0]}": logo[1]}


def worst_first(dimensions: Sequence[Dimension]) -> list[int]:
    """Return the indices of dimensions: by verdict, the worst first, then by how much of the tolerance they use."""
    return sorted(range(len(dimensions)), key=lambda index: (SEVERITY.index(dimensions[index].verdict), -used_share(dimensions[index])))


def used_share(dimension: Dimension) -> float:
    """Return how far the deviation is from the middle of the tolerance, relative to its half width; 1 at a limit."""
    place = position_in_tolerance(dimension)
    return 0.0 if place is None else abs(place)


def position_in_tolerance(dimension: Dimension) -> float | None:
    """Return where the deviation lies between the limits: −1 at the lower, 1 at the upper one; None without a value.

    >>> position_in_tolerance(Dimension("a", 10, 10.1, 0.05, 0.0, 0.2, Verdict.PASS))
    0.0
    """
    lower, upper = dimension.lower_tolerance, dimension.upper_tolerance
    if dimension.deviation is None or lower is None or upper is None or upper <= lower:
        return None
    return round((2 * dimension.deviation - upper - lower) / (upper - lower), 9)


def _template_words(model: ReportModel) -> str:
    description = model.details.template.description
    return f"template {description.name}, version {description.version}"


def _verdict(verdict: Verdict | None) -> dict[str, str]:
    if verdict is None:
        return {"word": "NO VERDICT", "colour": NEUTRAL, "sign": NONE}
    return {"word": verdict.value.upper(), "colour": COLOURS[verdict], "sign": SIGNS[verdict]}


def _counts(dimensions: Sequence[Dimension]) -> list[dict[str, str]]:
    counts = Counter(dimension.verdict for dimension in dimensions)
    return [{"word": kind.value, "count": str(counts[kind]), "colour": COLOURS[kind], "sign": SIGNS[kind]} for kind in SEVERITY]


def _facts(facts: Sequence[Fact]) -> list[dict[str, str]]:
    return [{"name": fact.name, "value": fact.value} for fact in facts]


def _picture(name: str, picture: Picture) -> dict[str, Any]:
    flags = [
        {"x": flag.at[0], "y": flag.at[1], "text": list(flag.text), "colour": flag.colour, "further": [list(at) for at in flag.further]}
        for flag in picture.flags
    ]
    return {"file": name, "caption": picture.caption, "flags": flags}


def _groups(dimensions: Sequence[Dimension], rows: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return the rows grouped by the feature that they are about, in the program's order."""
    groups: dict[str, list[dict[str, Any]]] = {}
    for dimension, row in zip(dimensions, rows, strict=True):
        names = list(dict.fromkeys(name.split(".")[0] for name in dimension.features))
        title = " – ".join(format_name(name) for name in names[:3]) + (" …" if len(names) > 3 else "")
        groups.setdefault(title or "Further dimensions", []).append(row)
    return [{"title": title, "rows": found} for title, found in groups.items()]


def _dimension(row: int, dimension: Dimension, aligned_by: str) -> dict[str, Any]:
    unit = "" if dimension.unit == "mm" else "°" if dimension.unit == "°" else f" {dimension.unit}"
    lower, upper = dimension.lower_tolerance, dimension.upper_tolerance
    half = 0.0 if lower is None or upper is None else (upper - lower) / 2
    place = position_in_tolerance(dimension)
    return {
        "number": str(row),
        "key": dimension.name,
        "name": format_name(dimension.name),
        "about": _about(dimension),
        "frame": _frame(dimension.frame),
        "aligned_by": aligned_by,
        "nominal": number(dimension.nominal) + unit,
        "upper": number(upper, signed=True),
        "lower": number(lower, signed=True),
        "measured": number(dimension.measured) + (unit if dimension.measured is not None else ""),
        "error": number(dimension.deviation, signed=True),
        "relative": percent(dimension.relative_deviation, 3, signed=True),
        "uncertainty": number(dimension.round_uncertainty()),
        "tolerance": format_tolerance(dimension.lower_tolerance, dimension.upper_tolerance),
        "place": None if place is None else max(-WIDEST, min(WIDEST, place)) / WIDEST,
        "beyond": place is not None and abs(place) > WIDEST,
        "spread": min(1.0, (dimension.uncertainty or 0.0) / half / WIDEST) if half > 0 else 0.0,
        "limit": 1 / WIDEST,
        "verdict": dimension.verdict.value,
        "sign": SIGNS[dimension.verdict],
        "colour": COLOURS[dimension.verdict],
        "reason": dimension.reason,
    }


def alignments(model: ReportModel) -> tuple[str, ...]:
    """Return the name of the alignment that each dimension refers to."""
    inspection = model.measurement.inspection
    common = "" if inspection is None else inspection.alignment.name
    return tuple(dimension.alignment or common for dimension in model.dimensions)


def alignment_note(aligned: Sequence[str]) -> str:
    """Return which alignment dimensions refer to, if it is the same for all; of several, each dimension states its own."""
    names = set(aligned)
    return f"All dimensions refer to the alignment by {names.pop()}." if len(names) == 1 and "" not in names else ""


def symbol_file(characteristic: str) -> str:
    """Return the name of the picture of a characteristic's symbol."""
    return f"symbol_{characteristic}.svg"


def _frame(frame: ControlFrame | None) -> dict[str, Any] | None:
    """Return the cells of a feature control frame, and the picture of its symbol."""
    if frame is None:
        return None
    symbol = symbol_svg(frame.characteristic)
    return {
        "file": symbol_file(frame.characteristic),
        "svg": symbol,
        "name": format_key(frame.characteristic),
        "cells": list(frame.words()),
    }


def _about(dimension: Dimension) -> str:
    """Return kind and datums, as far as the name does not say them already."""
    kind = format_key(dimension.kind)
    words = [
        "" if kind.lower() in format_name(dimension.name).lower() else kind,
        format_datums(dimension) if dimension.datums else "",
    ]
    return ", ".join(word for word in words if word)


def _traceability(dimension: Dimension) -> dict[str, str]:
    """Return the traceability of a value: kind, datums, source, and uncertainty budget."""
    return {
        "name": format_name(dimension.name),
        "kind": format_key(dimension.kind),
        "datums": format_datums(dimension),
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


def _plan_line(line: PlanLine) -> dict[str, str]:
    times = " · ".join(number(exposure / 1000, 1) for exposure in line.exposures_us)
    return {
        "name": line.viewpoint_id,
        "table": number(line.table_deg, 2),
        "guide": number(line.guide_mm, 2),
        "flange": ", ".join(number(value, 1) for value in line.flange_mm),
        "exposures": times or NONE,
        "planned": "" if line.as_planned is None or line.as_planned else "not as planned",
    }


def _deviation(deviation: DeviationSummary) -> dict[str, Any]:
    found = deviation.statistics
    facts = [
        ("Mean", f"{number(found.mean_mm, signed=True)} mm"),
        ("RMS", f"{number(found.rms_mm)} mm"),
        ("95 % within", f"{number(found.p95_mm)} mm"),
    ]
    for name, extreme in (("Minimum", found.minimum), ("Maximum", found.maximum)):
        if extreme is not None:
            place = ", ".join(number(float(value), 1) for value in extreme.point_mm)
            facts += [(f"{name}, confirmed", f"{number(extreme.value_mm, signed=True)} mm"), (f"{name} at", place)]
    if found.all_points_mm is not None:
        facts.append(("Of all points", " … ".join(f"{number(value, signed=True)}" for value in found.all_points_mm) + " mm"))
    limits = "the scale" if found.tolerance_mm is None else format_tolerance(*found.tolerance_mm)
    facts += [
        (f"Points within {limits}", percent(found.inside)),
        ("Below, above", f"{percent(found.below)}, {percent(found.above)}"),
        ("Nominal not seen", percent(found.no_data.not_seen)),
        ("Filled, too far", f"{percent(found.no_data.filled)}, {percent(found.no_data.too_far)}"),
    ]
    return {
        "pictures": [_picture(f"deviation{n}.png", picture) for n, picture in enumerate(deviation.pictures)],
        "low": f"{number(deviation.scale.low, signed=deviation.scale.low > 0)} mm",
        "high": f"{number(deviation.scale.high, signed=True)} mm",
        "stops": deviation.scale.stops(SCALE_STOPS),
        "histogram": list(deviation.histogram),
        "facts": [{"name": name, "value": value} for name, value in facts],
        "note": f"Alignment: {deviation.alignment}. Positive: outside the nominal. Hatched: not measured within {number(found.search_mm, 0)} mm.",
    }
