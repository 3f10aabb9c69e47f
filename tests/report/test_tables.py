"""The tables of CSV, XLSX and JSON hold the same numbers."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest

from measureapp.data.identification import Identification
from measureapp.report.compose import compose
from measureapp.report.csv import csv_text
from measureapp.report.json_document import report_document
from measureapp.report.model import Details
from measureapp.report.xlsx import COLUMNS, DIMENSIONS, METADATA, write_xlsx
from tests.report.conftest import SHARES_OF_LENGTH

NUMBERS = ("nominal", "measured", "error", "relative_error", "uncertainty", "lower_tolerance", "upper_tolerance")
AT = "2026-05-04T12:00:00+00:00"


@pytest.fixture
def model(measured):
    details = Details(Identification(serial_number="=7+1", operator="Ö", remarks="@cmd"), created_at=AT)
    return compose(measured(), details=details, pictures=False)


def cells(path: Path, sheet: str) -> list[list[object]]:
    book = openpyxl.load_workbook(path)
    try:
        return [[cell.value for cell in row] for row in book[sheet].iter_rows()]
    finally:
        book.close()


def same(one: object, other: object) -> bool:
    return one is other or one == pytest.approx(other, rel=1e-15)  # a workbook holds 16 digits


def test_csv_xlsx_and_json_hold_the_same_numbers(model, tmp_path: Path) -> None:
    _, *sheet = cells(write_xlsx(model, tmp_path / "r.xlsx"), DIMENSIONS)
    table = list(csv.DictReader(io.StringIO(csv_text(model))))
    documents = json.loads(json.dumps(report_document(model)))["dimensions"]
    keys = [key for _, key, _, _ in COLUMNS]
    for line, row, document in zip(sheet, table, documents, strict=True):
        stated = {**document, "lower_tolerance": document["tolerance"][0], "upper_tolerance": document["tolerance"][1]}
        for key in NUMBERS:
            assert same(line[keys.index(key)], stated[key]), key
            assert (None if row[key] == "" else float(row[key])) == stated[key], key
        assert line[keys.index("verdict")].endswith(stated["verdict"]) and row["verdict"] == stated["verdict"]


def test_a_workbook_has_a_frozen_header_and_everything_else_that_is_stated(model, tmp_path: Path) -> None:
    path = write_xlsx(model, tmp_path / "r.xlsx")
    book = openpyxl.load_workbook(path)
    sheet, keys = book[DIMENSIONS], [key for _, key, _, _ in COLUMNS]
    first = tuple(zip(keys, next(sheet.iter_rows(min_row=2)), strict=True))
    assert sheet.freeze_panes == first[keys.index("name") + 1][1].coordinate  # number and name of a dimension stay in view
    assert sheet.auto_filter.ref == f"A1:{first[-1][1].column_letter}{sheet.max_row}"
    forms = {key: cell.number_format for key, cell in first if cell.value is not None}
    assert {forms[key] for key in NUMBERS if key != "relative_error"} == {"0.000"} and forms["relative_error"] == "0.000%"
    assert {forms[f"uncertainty_{share}"] for share in SHARES_OF_LENGTH} == {"0.0000"}
    book.close()
    stated = dict(cells(path, METADATA))
    assert stated["Serial number"] == "=7+1" and stated["Operator"] == "Ö" and stated["Verdict"] == "fail"


def test_nothing_a_user_typed_becomes_a_formula(model, measured, tmp_path: Path) -> None:
    first = replace(measured().inspection.dimensions[0], name="=HYPERLINK(1)", reason="+1")
    model = replace(model, dimensions=(first,))
    path = write_xlsx(model, tmp_path / "r.xlsx")
    book = openpyxl.load_workbook(path)
    for sheet in book:
        assert all(cell.data_type != "f" for row in sheet.iter_rows() for cell in row)
    book.close()
    assert next(iter(csv.DictReader(io.StringIO(csv_text(model)))))["name"] == "'=HYPERLINK(1)"


def test_the_csv_file_is_utf_8_with_a_mark(model, tmp_path: Path) -> None:
    from measureapp.report.csv import write_csv

    assert write_csv(model, tmp_path / "r.csv").read_bytes().startswith(b"\xef\xbb\xbfname,nominal,")
