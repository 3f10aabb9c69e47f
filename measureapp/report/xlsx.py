"""Table of dimensions as a workbook (XLSX): real numbers, a frozen header, and a second sheet with everything else that is stated."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measureapp.data.dimension import CONTRIBUTION_LABELS, CONTRIBUTIONS, Verdict
from measureapp.data.identification import FIELDS, LABELS
from measureapp.project.atomic import replacing
from measureapp.report.csv import dimension_rows
from measureapp.report.header import field_words
from measureapp.report.language import Words, words_of
from measureapp.report.model import ReportModel
from measureapp.report.origin import origin_words
from measureapp.report.printed import kind_words
from measureapp.report.words import COLOURS, NONE, SIGNS, format_time

if TYPE_CHECKING:
    import xlsxwriter  # type: ignore[import-untyped]

LENGTH, SHARE = "0.000", "0.000%"
DIMENSIONS, METADATA = "Dimensions", "Report"
COLUMNS = (  # title, key, number format, width
    ("No.", "", "0", 6),
    ("Balloon", "balloon", "", 9),
    ("Zone", "zone", "", 8),
    ("Dimension", "name", "", 28),
    ("Kind", "kind", "", 14),
    ("Datums", "datums", "", 14),
    ("Letters", "datum_letters", "", 8),
    ("Nominal", "nominal", LENGTH, 11),
    ("Lower", "lower_tolerance", LENGTH, 9),
    ("Upper", "upper_tolerance", LENGTH, 9),
    ("Measured", "measured", LENGTH, 11),
    ("Deviation", "error", LENGTH, 10),
    ("Relative", "relative_error", SHARE, 10),
    ("U (k = 2)", "uncertainty", LENGTH, 10),
    ("Unit", "unit", "", 6),
    ("Verdict", "verdict", "", 15),
    ("Reason", "reason", "", 30),
    ("Designator", "designator", "", 11),
    ("Control frame", "control_frame", "", 26),
    ("Source", "origin", "", 50),
    *((f"U {CONTRIBUTION_LABELS.get(name, name)}", f"uncertainty_{name}", "0.0000", 12) for name in CONTRIBUTIONS),
)


def write_xlsx(model: ReportModel, path: Path) -> Path:
    """Write the workbook, whole or not at all, and return ``path``. Raises StorageError."""
    import xlsxwriter

    words = words_of(model)
    with replacing(path) as temporary:
        book = xlsxwriter.Workbook(str(temporary), {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False})
        book.set_properties(
            {
                "title": f"{words.said(model.details.template.description.title)} {model.title}",
                "author": model.software,
                "created": datetime.fromisoformat(model.details.created_at).replace(tzinfo=None),
            }
        )
        _write_dimensions(book, model, words)
        _write_metadata(book, metadata(model, words), words)
        book.close()
    return path


def metadata(model: ReportModel, words: Words) -> list[tuple[str, str]]:
    """Return name and value of everything that the report states besides its dimensions."""
    details = model.details
    description = details.template.description
    verdict = NONE if model.verdict is None else words.label(model.verdict.value)
    pairs = [
        (words.tr("Verdict"), verdict),
        (words.tr("Summary"), words.said(model.summary)),
        (words.tr("Decision rule"), words.tr(model.verdict_rule)),
    ]
    pairs += [(words.tr(LABELS[name]), field_words(details.identification, name)) for name in FIELDS]
    pairs += [(words.said(fact.name), words.said(fact.value)) for fact in model.header]
    pairs += [(words.said(fact.name), words.said(fact.value)) for section in model.sections for fact in section.facts]
    pairs += [
        (words.tr("Template"), words.tr("{name}, version {version}", name=description.name, version=description.version)),
        (words.tr("Software"), model.software),
        (words.tr("Written"), format_time(details.created_at)),
    ]
    return list(dict.fromkeys(pair for pair in pairs if pair[1]))


def _write_dimensions(book: xlsxwriter.Workbook, model: ReportModel, words: Words) -> None:
    sheet = book.add_worksheet(words.tr(DIMENSIONS))
    head = book.add_format({"bold": True, "bottom": 1, "text_wrap": True, "valign": "top"})
    formats = {code: book.add_format({"num_format": code} if code else {}) for _, _, code, _ in COLUMNS}
    verdicts = {verdict: book.add_format({"bg_color": COLOURS[verdict], "font_color": "#FFFFFF", "bold": True}) for verdict in Verdict}
    for column, (title, key, _, width) in enumerate(COLUMNS):
        sheet.write_string(0, column, _title(title, key, words), head)
        sheet.set_column(column, column, width)
    for line, row in enumerate(dimension_rows(model), start=1):
        for column, (_, key, code, _) in enumerate(COLUMNS):
            if key == "verdict":
                verdict = Verdict(row[key])
                sheet.write_string(line, column, f"{SIGNS[verdict]} {words.label(verdict.value)}", verdicts[verdict])
            else:
                _write_cell(sheet, line, column, _printed(key, row[key], words) if key else line, formats[code])
    sheet.freeze_panes(1, 4)
    sheet.autofilter(0, 0, max(1, len(model.dimensions)), len(COLUMNS) - 1)
    sheet.set_landscape()
    sheet.fit_to_pages(1, 0)
    sheet.repeat_rows(0)


def _title(title: str, key: str, words: Words) -> str:
    """Return the title of a column in the language of the report; contributions to U are named after it."""
    return f"U {words.label(title.removeprefix('U '))}" if key.startswith("uncertainty_") else words.tr(title)


def _printed(key: str, value: Any, words: Words) -> Any:
    """Return a value of a column in the language of the report; numbers and names stay."""
    if key == "kind":
        return kind_words(value, words)
    if key == "control_frame":
        characteristic, bar, rest = value.partition(" | ")
        return kind_words(characteristic, words) + bar + rest
    if key == "origin":
        return origin_words(value, words)
    return words.said(value) if key == "reason" else value


def _write_cell(sheet: Any, line: int, column: int, value: Any, form: Any) -> None:
    """Write a number as a number and everything else as text: nothing is ever a formula."""
    if isinstance(value, (int, float)):
        sheet.write_number(line, column, value, form)
    elif value not in (None, ""):
        sheet.write_string(line, column, str(value), form)


def _write_metadata(book: xlsxwriter.Workbook, pairs: Sequence[tuple[str, str]], words: Words) -> None:
    sheet = book.add_worksheet(words.tr(METADATA))
    bold, wrapped = book.add_format({"bold": True, "valign": "top"}), book.add_format({"text_wrap": True, "valign": "top"})
    sheet.set_column(0, 0, 34)
    sheet.set_column(1, 1, 90)
    for line, (name, value) in enumerate(pairs):
        sheet.write_string(line, 0, name, bold)
        sheet.write_string(line, 1, value, wrapped)
    sheet.freeze_panes(0, 1)
