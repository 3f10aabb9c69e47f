"""The data of the printed report: every number formatted, every text a value."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from measureapp.data.control_frame import ControlFrame
from measureapp.data.dimension import SEVERITY, Dimension, Verdict
from measureapp.data.frame_symbols import symbol_svg
from measureapp.inspection.surface.statistics import DeviationStatistics
from measureapp.report.header import field_words
from measureapp.report.language import Words, words_of
from measureapp.report.model import DeviationSummary, Fact, Picture, PlanLine, ReportModel, ViewLine
from measureapp.report.origin import origin_words
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
BASIS = ("Alignment to the nominal", "Residual of the alignment", "Calibration age", "Share of calibration and length scale in U")
KINDS = {"step": "Height of a step", "pitch": "Pitch of blades"}  # of dimensions, where the word has another meaning in the window
SIGNATURES = {  # of the roles of the built-in template
    "Measured": "Measured: name, date, signature",
    "Checked": "Checked: name, date, signature",
    "Released": "Released: name, date, signature",
}
WIDEST = 1.3  # of the tolerance's half width: where the bar of a deviation ends


def typst_document(model: ReportModel, words: Words | None = None) -> dict[str, Any]:
    """Return the data of the layout, in the language of the report; pictures are named as in `picture_files`.

    Parameters
    ----------
    words : those of the report, if they are at hand
    """
    words = words or words_of(model)
    template, details, aligned = model.details.template, model.details, alignments(model)
    dimensions = [
        _dimension(number_, one, name, words) for number_, (one, name) in enumerate(zip(model.dimensions, aligned, strict=True), start=1)
    ]
    facts = {fact.name: fact for section in model.sections for fact in section.facts}
    return {
        "title": model.title,
        "heading": words.said(template.description.title),
        "software": model.software,
        "footer": " · ".join(
            word for word in (model.software, model.measurement.project, model.title, template_words(model, words)) if word
        ),
        "company": template.description.company,
        "address": template.description.address,
        "logo": "" if template.logo is None else f"logo{template.logo[0]}",
        "opening": template.description.opening,
        "closing": template.description.closing,
        "signatures": list(template.description.signatures),
        "signature_lines": [signature_line(role, words) for role in template.description.signatures],
        "pages": list(template.description.pages),
        "created": format_time(details.created_at),
        "verdict": _verdict(model.verdict, words),
        "counts": _counts(model.dimensions, words),
        "summary": words.said(model.summary),
        "rule": words.tr(model.verdict_rule),
        "remarks": field_words(details.identification, "remarks"),
        "header": printed_facts(model.header, words),
        "basis": printed_facts([facts[name] for name in BASIS if name in facts and facts[name].value], words),
        "warnings": [words.said(fact.value) for section in model.sections for fact in section.facts if fact.name == "Warning"],
        "pictures": [_picture(f"picture{n}.png", picture, words) for n, picture in enumerate(model.pictures)],
        "dimensions": dimensions,
        "alignments": alignment_note(aligned, words),
        "worst": [dimensions[index] for index in worst_first(model.dimensions)[:MOST_WORST]],
        "groups": _groups(model.dimensions, dimensions, words),
        "failing": [
            {**_picture(f"failing{n}.png", one.picture, words), "row": next(row for row in dimensions if row["key"] == one.name)}
            for n, one in enumerate(model.failing)
        ],
        "origins": [_traceability(dimension, words) for dimension in model.dimensions if dimension.traceability],
        "deviation": None if model.deviation is None else _deviation(model.deviation, words),
        "cross_sections": [_picture(f"section{n}.svg", picture, words) for n, picture in enumerate(model.cross_sections)],
        "views": [_view(view, words) for view in model.views],
        "plan": [_plan_line(line, words) for line in model.plan_lines],
        "sections": [
            {"key": section.title, "title": words.tr(section.title), "facts": printed_facts(section.facts, words)}
            for section in model.sections
        ],
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


def template_words(model: ReportModel, words: Words) -> str:
    """Return the name and version of the template."""
    description = model.details.template.description
    return words.tr("template {name}, version {version}", name=description.name, version=description.version)


def signature_line(role: str, words: Words) -> str:
    """Return what stands below the line of a signature."""
    return words.tr(SIGNATURES[role]) if role in SIGNATURES else words.tr("{role}: name, date, signature", role=role)


def _verdict(verdict: Verdict | None, words: Words) -> dict[str, str]:
    if verdict is None:
        return {"word": words.tr("NO VERDICT"), "colour": NEUTRAL, "sign": NONE}
    return {"word": words.label(verdict.value).upper(), "colour": COLOURS[verdict], "sign": SIGNS[verdict]}


def _counts(dimensions: Sequence[Dimension], words: Words) -> list[dict[str, str]]:
    counts = Counter(dimension.verdict for dimension in dimensions)
    return [
        {"word": words.label(kind.value), "count": str(counts[kind]), "colour": COLOURS[kind], "sign": SIGNS[kind]} for kind in SEVERITY
    ]


def printed_facts(facts: Sequence[Fact], words: Words) -> list[dict[str, str]]:
    """Return facts in the language of the report."""
    return [{"name": words.said(fact.name), "value": words.said(fact.value)} for fact in facts]


def printed_flag(text: Sequence[str], words: Words) -> list[str]:
    """Return the lines of a flag in the language of the report."""
    return [words.said(line) for line in text]


def _picture(name: str, picture: Picture, words: Words) -> dict[str, Any]:
    flags = [
        {
            "x": flag.at[0],
            "y": flag.at[1],
            "text": printed_flag(flag.text, words),
            "colour": flag.colour,
            "further": [list(at) for at in flag.further],
        }
        for flag in picture.flags
    ]
    return {"file": name, "caption": words.said(picture.caption), "flags": flags}


def _groups(dimensions: Sequence[Dimension], rows: Sequence[dict[str, Any]], words: Words) -> list[dict[str, Any]]:
    """Return the rows grouped by the feature that they are about, in the program's order."""
    groups: dict[str, list[dict[str, Any]]] = {}
    for dimension, row in zip(dimensions, rows, strict=True):
        names = list(dict.fromkeys(name.split(".")[0] for name in dimension.features))
        title = " – ".join(format_name(name) for name in names[:3]) + (" …" if len(names) > 3 else "")
        groups.setdefault(title or words.tr("Further dimensions"), []).append(row)
    return [{"title": title, "rows": found} for title, found in groups.items()]


def _dimension(row: int, dimension: Dimension, aligned_by: str, words: Words) -> dict[str, Any]:
    unit = "" if dimension.unit == "mm" else "°" if dimension.unit == "°" else f" {dimension.unit}"
    lower, upper = dimension.lower_tolerance, dimension.upper_tolerance
    half = 0.0 if lower is None or upper is None else (upper - lower) / 2
    place = position_in_tolerance(dimension)
    return {
        "number": str(row),
        "key": dimension.name,
        "name": format_name(dimension.name),
        "about": _about(dimension, words),
        "frame": _frame(dimension.frame, words),
        "aligned_by": words.said(aligned_by),
        "nominal": number(dimension.nominal) + unit,
        "upper": number(upper, signed=True),
        "lower": number(lower, signed=True),
        "measured": number(dimension.measured) + (unit if dimension.measured is not None else ""),
        "error": number(dimension.deviation, signed=True),
        "relative": percent(dimension.relative_deviation, 3, signed=True),
        "uncertainty": number(dimension.round_uncertainty()),
        "tolerance": format_tolerance(dimension.lower_tolerance, dimension.upper_tolerance),
        "place": None if place is None else max(-WIDEST, min(WIDEST, place)) / WIDEST,
        "beyond": place is not None and bool(abs(place) > WIDEST),
        "spread": min(1.0, (dimension.uncertainty or 0.0) / half / WIDEST) if half > 0 else 0.0,
        "limit": 1 / WIDEST,
        "verdict": words.label(dimension.verdict.value),
        "sign": SIGNS[dimension.verdict],
        "colour": COLOURS[dimension.verdict],
        "reason": words.said(dimension.reason),
    }


def alignments(model: ReportModel) -> tuple[str, ...]:
    """Return the name of the alignment that each dimension refers to."""
    inspection = model.measurement.inspection
    common = "" if inspection is None else inspection.alignment.name
    return tuple(dimension.alignment or common for dimension in model.dimensions)


def alignment_note(aligned: Sequence[str], words: Words) -> str:
    """Return which alignment dimensions refer to, if it is the same for all; of several, each dimension states its own."""
    names = set(aligned)
    return words.tr("All dimensions refer to the alignment by {name}.", name=names.pop()) if len(names) == 1 and "" not in names else ""


def symbol_file(characteristic: str) -> str:
    """Return the name of the picture of a characteristic's symbol."""
    return f"symbol_{characteristic}.svg"


def _frame(frame: ControlFrame | None, words: Words) -> dict[str, Any] | None:
    """Return the cells of a feature control frame, and the picture of its symbol."""
    if frame is None:
        return None
    symbol = symbol_svg(frame.characteristic)
    return {
        "file": symbol_file(frame.characteristic),
        "svg": symbol,
        "name": kind_words(frame.characteristic, words),
        "cells": list(frame.words()),
    }


def _about(dimension: Dimension, words: Words) -> str:
    """Return kind and datums, as far as the name does not say them already."""
    kind = format_key(dimension.kind)
    stated = [
        "" if kind.lower() in format_name(dimension.name).lower() else kind_words(dimension.kind, words),
        format_datums(dimension) if dimension.datums else "",
    ]
    return words.listed(", ".join(word for word in stated if word))


def kind_words(kind: str, words: Words) -> str:
    """Return the kind of a dimension, or the characteristic of a control frame."""
    title = KINDS.get(kind) or format_key(kind).capitalize()
    made = words.tr(title)
    return format_key(kind) if made == title else made


def _traceability(dimension: Dimension, words: Words) -> dict[str, str]:
    """Return the traceability of a value: kind, datums, source, and uncertainty budget."""
    return {
        "name": format_name(dimension.name),
        "kind": kind_words(dimension.kind, words),
        "datums": format_datums(dimension),
        "shares": words.listed(format_contributions(dimension, words.label)),
        "origin": origin_words(dimension.traceability, words),
    }


def _view(view: ViewLine, words: Words) -> dict[str, str]:
    verdict = Verdict.PASS if view.used and view.verdict == "good" else Verdict.NOT_PROVEN if view.used else Verdict.FAIL
    return {
        "name": view.viewpoint_id,
        "points": f"{view.points:,}".replace(",", "\u2009"),
        "noise": number(view.noise_mm),
        "completeness": percent(view.completeness),
        "moved": number(view.correction_mm),
        "turned": number(view.correction_deg),
        "residual": number(view.residual_mm),
        "verdict": words.said(view.verdict),
        "sign": SIGNS[verdict],
        "colour": COLOURS[verdict],
    }


def _plan_line(line: PlanLine, words: Words) -> dict[str, str]:
    times = " · ".join(number(exposure / 1000, 1) for exposure in line.exposures_us)
    return {
        "name": line.viewpoint_id,
        "table": number(line.table_deg, 2),
        "guide": number(line.guide_mm, 2),
        "flange": ", ".join(number(value, 1) for value in line.flange_mm),
        "exposures": times or NONE,
        "planned": "" if line.as_planned is None or line.as_planned else words.tr("not as planned"),
    }


def _deviation(deviation: DeviationSummary, words: Words) -> dict[str, Any]:
    found = deviation.statistics
    return {
        "pictures": [_picture(f"deviation{n}.png", picture, words) for n, picture in enumerate(deviation.pictures)],
        "low": f"{number(deviation.scale.low, signed=deviation.scale.low > 0)} mm",
        "high": f"{number(deviation.scale.high, signed=True)} mm",
        "stops": deviation.scale.stops(SCALE_STOPS),
        "histogram": list(deviation.histogram),
        "facts": [{"name": name, "value": value} for name, value in _deviation_facts(found, words)],
        "note": words.tr(
            "Alignment: {name}. Positive: outside the nominal. Hatched: not measured within {reach} mm.",
            name=deviation.alignment,
            reach=number(found.search_mm, 0),
        ),
    }


def _deviation_facts(found: DeviationStatistics, words: Words) -> Iterator[tuple[str, str]]:
    """Yield name and value of the statistics of a deviation."""
    yield words.tr("Mean"), f"{number(found.mean_mm, signed=True)} mm"
    yield words.tr("RMS"), f"{number(found.rms_mm)} mm"
    yield words.tr("95 % within"), f"{number(found.p95_mm)} mm"
    extremes = (("Minimum, confirmed", "Minimum at", found.minimum), ("Maximum, confirmed", "Maximum at", found.maximum))
    for confirmed, at, extreme in extremes:
        if extreme is not None:
            yield words.tr(confirmed), f"{number(extreme.value_mm, signed=True)} mm"
            yield words.tr(at), ", ".join(number(float(value), 1) for value in extreme.point_mm)
    if found.all_points_mm is not None:
        yield words.tr("Of all points"), " … ".join(number(value, signed=True) for value in found.all_points_mm) + " mm"
    if found.tolerance_mm is None:
        yield words.tr("Points within the scale"), percent(found.inside)
    else:
        yield words.tr("Points within {limits}", limits=format_tolerance(*found.tolerance_mm)), percent(found.inside)
    yield words.tr("Below, above"), f"{percent(found.below)}, {percent(found.above)}"
    yield words.tr("Nominal not seen"), percent(found.no_data.not_seen)
    yield words.tr("Filled, too far"), f"{percent(found.no_data.filled)}, {percent(found.no_data.too_far)}"
