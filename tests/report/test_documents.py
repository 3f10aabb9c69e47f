from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.cli.outcome import dimension_line
from measureapp.data.control_frame import ControlFrame, frame_from
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.frame_symbols import symbol_svg
from measureapp.data.mesh import Mesh
from measureapp.errors import StorageError
from measureapp.report.compose import compose, summarise_verdicts
from measureapp.report.csv import csv_text
from measureapp.report.documents import ALL_KINDS, write_documents
from measureapp.report.html import html_text
from measureapp.report.json_document import dimension_document, report_document
from measureapp.report.model import Details
from measureapp.report.part_pictures import render_part
from measureapp.report.pdf import page_images, pdf_bytes
from measureapp.report.printed import picture_files, typst_document
from measureapp.report.template import Template
from measureapp.report.words import format_name, format_tolerance, number


def test_pdf_csv_and_json_say_the_same_of_every_dimension(measured) -> None:
    model = compose(measured(), pictures=False)
    rows = list(csv.DictReader(io.StringIO(csv_text(model))))
    document = json.loads(json.dumps(report_document(model)))
    printed = typst_document(model)["dimensions"]
    assert len(rows) == len(document["dimensions"]) == len(printed) == len(model.dimensions)
    for row, entry, line, dimension in zip(rows, document["dimensions"], printed, model.dimensions, strict=True):
        assert row["name"] == entry["name"] == dimension.name
        assert line["name"] == format_name(dimension.name)
        assert row["verdict"] == entry["verdict"] == line["verdict"] == dimension.verdict.value
        assert row["reason"] == entry["reason"] == dimension.reason
        for key in ("measured", "error", "uncertainty"):
            value = dimension.deviation if key == "error" else getattr(dimension, key)
            assert entry[key] == value
            assert (row[key] == "") if value is None else (float(row[key]) == pytest.approx(value, abs=1e-9))
            assert line[key].startswith(number(value, signed=key == "error"))


def test_every_document_names_the_contributions_to_uncertainty(measured) -> None:
    model = compose(measured(), pictures=False)
    first, second = list(csv.DictReader(io.StringIO(csv_text(model))))[:2]
    assert [first[f"uncertainty_{name}"] for name in ("noise", "stitching", "calibration")] == ["0.018", "0.024", "0.0"]
    assert second["uncertainty_noise"] == ""
    words = "stitching 0.0240, noise 0.0180 mm"
    assert typst_document(model)["origins"][0]["shares"].replace("\u00a0", " ") == words
    assert words in html_text(model).replace("\u00a0", " ")
    assert json.loads(json.dumps(report_document(model)))["dimensions"][0]["uncertainty_budget"]["stitching"] == 0.024


def test_the_calibration_states_image_blur_where_the_board_determined_it(measured) -> None:
    model = compose(measured(), pictures=False)
    facts = {fact.name: fact.value for section in model.sections for fact in section.facts}
    assert facts["Camera left"] == "rms 0.040 px, blur 0.75 px, serial S1"
    assert facts["Camera right"] == "rms 0.040 px, serial S1"
    assert facts["Length reference"].endswith("not included (taken as exact)")
    cameras = json.loads(json.dumps(report_document(model)))["calibration"]["cameras"]
    assert (cameras["left"]["blur_px"], cameras["right"]["blur_px"]) == (0.75, None)


def test_the_json_form_of_a_dimension_is_the_one_of_the_command_line(measured) -> None:
    first = dimension_document(measured().inspection.dimensions[0])
    assert set(first) == {
        "name", "nominal", "measured", "error", "relative_error", "uncertainty", "tolerance", "unit", "verdict", "reason", "kind", "datums", "origin",
        "uncertainty_budget", "tolerance_source", "warning", "alignment", "group", "control_frame", "datum_letters",
    }  # fmt: skip
    assert first["relative_error"] == pytest.approx(0.0123456789 / 80)
    assert first["tolerance"] == [-0.1, 0.1]


def test_the_gravest_dimension_decides(measured) -> None:
    dimensions = measured().inspection.dimensions
    assert summarise_verdicts(dimensions) == (Verdict.FAIL, "Of 5 dimensions: 1 fail, 1 not proven, 1 not measured, 2 pass.")
    assert summarise_verdicts(dimensions[2:]) == (Verdict.NOT_PROVEN, "Of 3 dimensions: 1 not proven, 1 not measured, 1 pass.")
    assert summarise_verdicts(dimensions[:1]) == (Verdict.PASS, "The dimension passes.")
    assert summarise_verdicts(())[0] is None


def test_a_report_with_everything_becomes_pages_with_pictures(measured, block) -> None:
    measurement = measured()
    model = compose(measurement, block)
    assert pdf_bytes(model).startswith(b"%PDF-")
    pages = page_images(model, ppi=40)
    assert len(pages) == 4
    assert all(page.startswith(b"\x89PNG") for page in pages)


def test_many_views_run_over_to_further_pages(measured) -> None:
    model = compose(measured(view_count=90), pictures=False)
    assert len(page_images(model, ppi=20)) == 5


@pytest.mark.parametrize("mesh", [True, False])
def test_a_part_without_program_gets_a_report_that_says_so(mesh: bool, measured) -> None:
    model = compose(measured(dimensions=None, mesh=mesh), pictures=mesh)
    assert model.verdict is None and typst_document(model)["verdict"]["word"] == "NO VERDICT"
    assert pdf_bytes(model).startswith(b"%PDF-")
    assert "without an inspection program" in html_text(model)


def test_names_with_the_signs_of_markup_are_printed_as_they_are(measured) -> None:
    model = compose(measured(), pictures=False)
    assert typst_document(model)["title"] == model.measurement.part
    html = html_text(model)
    assert html.count("<i>") == 1  # the template's own, around the reason of the dimension that was not measured
    assert "&lt;i&gt; &amp;" in html


def test_a_broken_template_is_named(measured, tmp_path: Path) -> None:
    template = tmp_path / "mine.typ"
    template.write_text("#let x = (")
    with pytest.raises(StorageError, match=r"mine\.typ"):
        pdf_bytes(compose(measured(), details=Details(template=Template(layout=template)), pictures=False))


def test_all_documents_are_written_whole(measured, block, tmp_path: Path) -> None:
    files = write_documents(compose(measured(), block), tmp_path / "out", ALL_KINDS)
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "report.csv", "report.html", "report.json", "report.pdf", "report.xlsx",
    ]  # fmt: skip
    document = json.loads(files["json"].read_text())
    assert document["verdict"] == "fail"
    assert document["deviation_mm"]["rms"] == pytest.approx(0.0, abs=1e-4)
    found = document["deviation_statistics"]
    assert found["range_mm"] == [-0.2, 0.2] and found["inside"] == 1.0
    assert document["views"][1]["verdict"].startswith("correction exceeds")


def test_numbers_are_printed_with_a_true_minus_and_no_negative_zero() -> None:
    assert number(-0.0001) == "0.000"
    assert number(-1.5) == "−1.500"
    assert format_tolerance(-0.1, 0.1) == "± 0.1"
    assert format_tolerance(-0.1, 0.05) == "−0.1 / +0.05"


def test_a_cloud_that_does_not_match_the_nominal_is_reported_without_deviation_and_says_why(measured, block) -> None:
    tiny = Mesh(np.asarray(block.vertices_mm) / 1000, block.triangles, "nominal")
    model = compose(measured(dimensions=None), tiny, pictures=False)
    assert model.deviation is None
    assert any(fact.name == "No deviation from the nominal" and "metres" in fact.value for fact in model.sections[0].facts)


def test_the_report_says_what_a_value_is_and_what_it_rests_on(measured) -> None:
    zone = Dimension(
        "boss_position", 0.0, 0.005, 0.077, 0.0, 0.2, Verdict.PASS,
        features=("boss",), kind="position", datums=("gear face", "bore"), datum_letters=("A", "B"), traceability="boss: 1372 points, 99 left out; associated axis",
    )  # fmt: skip
    model = compose(measured((zone,)), pictures=False)
    printed = typst_document(model)
    assert printed["dimensions"][0]["tolerance"] == "0 / +0.2"
    assert printed["origins"] == [
        {
            "name": "Boss position",
            "kind": "position",
            "datums": "A gear face, B bore",
            "shares": "–",
            "origin": "boss: 1372 points, 99 left out; associated axis",
        }
    ]
    assert "k = 2" in printed["rule"] and "ISO 14253-1" in printed["rule"]
    assert pdf_bytes(model).startswith(b"%PDF-")
    html = html_text(model)
    assert "A gear face, B bore" in html and "1372 points, 99 left out" in html and "ISO 14253-1" in html


def test_filled_surface_without_points_is_distinguished_in_the_pictures(measured) -> None:
    filled, whole = measured(), measured()
    whole = replace(whole, mesh=replace(whole.mesh, measured=None))
    assert "dark: filled, not measured" in render_part(filled)[0].caption
    assert "filled" not in render_part(whole)[0].caption
    assert render_part(filled)[0].png != render_part(whole)[0].png


def test_a_small_uncertainty_is_never_printed_as_none(measured) -> None:
    first = replace(measured().inspection.dimensions[0], uncertainty=0.0002)
    assert first.round_uncertainty() == 0.001 and first.round_uncertainty(4) == 0.0002
    assert "± 0.001 mm" in dimension_line(first)
    assert replace(first, uncertainty=0.0123).round_uncertainty() == 0.0123
    assert replace(first, uncertainty=0.0).round_uncertainty() == 0.0  # a drawing against itself
    assert replace(first, uncertainty=None).round_uncertainty() is None


def test_dimensions_without_tolerance_are_listed_and_decide_nothing(measured) -> None:
    first = measured().inspection.dimensions[0]
    free = replace(first, name="free", lower_tolerance=None, upper_tolerance=None, verdict=Verdict.NO_TOLERANCE)
    passing = replace(first, name="held", verdict=Verdict.PASS, tolerance_source="H7")
    model = compose(measured((passing, free)), pictures=False)
    assert model.verdict is Verdict.PASS and "1 without tolerance" in model.summary
    assert compose(measured((free,)), pictures=False).verdict is None
    rows = list(csv.DictReader(io.StringIO(csv_text(model))))
    assert rows[1]["lower_tolerance"] == "" and rows[0]["tolerance_source"] == "H7"
    assert json.loads(json.dumps(report_document(model)))["dimensions"][1]["tolerance"] == [None, None]
    assert "no tolerance" in html_text(model)
    assert typst_document(model)["dimensions"][1]["tolerance"] == "–"


def test_every_document_states_the_same_control_frame(measured) -> None:
    frame = ControlFrame("position", 0.1, "Ø", ("\u24c2",), ("C", "B\u24c1"))
    named = {"datums": ("face", "pin"), "datum_letters": ("C", "B")}
    seat = Dimension("seat", 0.0, 0.03, 0.01, 0.0, 0.1, Verdict.PASS, kind="position", frame=frame, **named)
    model = compose(measured((*measured().inspection.dimensions, seat)), pictures=False)
    cells = ["Ø\u00a00.100\u00a0\u24c2", "C", "B\u24c1"]
    (printed,) = [one for one in typst_document(model)["dimensions"] if one["frame"]]
    assert printed["name"] == "Seat" and printed["frame"]["cells"] == cells
    assert printed["frame"]["file"] in picture_files(model)
    (entry,) = [one for one in json.loads(json.dumps(report_document(model)))["dimensions"] if one["control_frame"]]
    assert frame_from(entry["control_frame"]) == model.dimensions[-1].frame
    assert entry["datums"] == ["face", "pin"] and entry["datum_letters"] == ["C", "B"]
    assert "C face, B pin" in printed["about"]
    page = html_text(model)
    assert symbol_svg("position") in page and all(f"<span>{cell}</span>" in page for cell in cells)
    (row,) = [one for one in csv.DictReader(io.StringIO(csv_text(model))) if one["control_frame"]]
    assert row["control_frame"] == " | ".join(["position", *cells]) and row["datum_letters"] == "C|B"
    assert pdf_bytes(model).startswith(b"%PDF")


def test_the_alignment_is_stated_once_if_it_is_common_and_per_dimension_if_not(measured) -> None:
    first, *rest = measured().inspection.dimensions
    common = typst_document(compose(measured(), pictures=False))
    assert "best fit" in common["alignments"]
    several = typst_document(compose(measured((replace(first, alignment="on the pins"), *rest)), pictures=False))
    assert several["alignments"] == ""
    assert [one["aligned_by"] for one in several["dimensions"]][:2] == ["on the pins", "best fit"]


def test_rows_that_another_version_evaluated_are_named(measured) -> None:
    first, *rest = measured().inspection.dimensions
    mixed = measured((replace(first, version="0.0.9"), *(replace(one, version="0.1.0") for one in rest)))
    (warning,) = typst_document(compose(mixed, pictures=False))["warnings"]
    assert f"{first.name} (0.0.9)" in warning and rest[0].name not in warning
    alike = measured(tuple(replace(one, version="0.0.9") for one in (first, *rest)))
    assert typst_document(compose(alike, pictures=False))["warnings"] == []


def test_a_best_fit_is_said_to_be_for_comparison_only(measured) -> None:
    measurement = measured()
    aligned = replace(measurement.inspection, alignment=replace(measurement.inspection.alignment, method="best-fit"))
    (warning,) = typst_document(compose(replace(measurement, inspection=aligned), pictures=False))["warnings"]
    assert "best fit" in warning and "comparison" in warning
    assert warning in html_text(compose(replace(measurement, inspection=aligned), pictures=False))
