"""Fonts, archiving and reproducibility of the PDF."""

from __future__ import annotations

import io
from dataclasses import replace

import cv2
import numpy as np
import pytest
from PIL import Image

from measureapp.data.identification import Identification
from measureapp.data.report_template import ReportTemplate
from measureapp.report.compose import compose
from measureapp.report.fonts import covered, missing_letters, spell_out
from measureapp.report.model import Details, DimensionPicture, Fact, Flag, Section
from measureapp.report.pdf import page_images, pdf_bytes
from measureapp.report.template import Template

AT = "2026-05-04T12:00:00+00:00"


def report(measured, name: str) -> bytes:
    return pdf_bytes(compose(measured(), details=Details(Identification(part_name=name), created_at=AT), pictures=False))


def test_the_same_report_at_the_same_time_is_the_same_byte_by_byte(measured) -> None:
    assert report(measured, "Laufrad 叶轮") == report(measured, "Laufrad 叶轮")


def test_the_pdf_is_for_archiving_and_has_a_title_and_its_fonts_embedded(measured) -> None:
    made = report(measured, "Größe 件")
    assert b"pdfaid:part>2<" in made and b"pdfaid:conformance>B<" in made
    assert "Measurement report Größe 件".encode() in made
    assert b"NotoSans-Regular" in made and b"NotoSansCJKsc" in made and b"/FontFile" in made
    assert b"DejaVu" not in made


def test_the_fonts_have_what_reports_and_gb_2312_need() -> None:
    chinese = {bytes((high, low)) for high in range(0xB0, 0xF8) for low in range(0xA1, 0xFF)}
    texts = [one.decode("gb2312", "ignore") for one in chinese]
    assert len({text for text in texts if text}) > 6700
    assert not missing_letters([*texts, "ÄÖÜäöüßØøÅéèçñŁő αβγµσ −±≤≥°′″·…–—„“”«» ⌖⏥⌭∥⊥◎ ✓✗?", "Привет"])
    assert len(covered()) > 9000


@pytest.mark.parametrize("name", ["한국어 부품", "snowman \u2603 \U0001f600", "\U0010fffd"])
def test_letters_that_the_fonts_lack_do_not_vanish(name: str, measured) -> None:
    made = report(measured, name)
    assert made.startswith(b"%PDF-") and made != report(measured, "")
    model = compose(measured(), details=Details(Identification(part_name=name), created_at=AT), pictures=False)
    assert page_images(model, ppi=20)


def test_invisible_letters_are_spelt_out() -> None:
    assert spell_out({"a": ["x\u202ey"]}, frozenset("\u202e")) == {"a": ["x[U+202E]y"]}


def test_text_that_looks_like_markup_stays_text(measured) -> None:
    nasty = '#panic("x") $a$ *b* _c_ `d` <e> @f [g] \\ // /* 件'
    assert report(measured, nasty).startswith(b"%PDF-")
    first = measured().inspection.dimensions[0]
    model = compose(measured((replace(first, name=nasty),)), details=Details(created_at=AT), pictures=False)
    assert pdf_bytes(model).startswith(b"%PDF-")


@pytest.mark.parametrize("failing", [0, 1, 2])
def test_a_page_with_pictures_of_failing_dimensions_goes_on_with_the_deviation(failing: int, measured, block) -> None:
    one = measured().inspection.dimensions[0]
    dimensions = tuple(replace(one, name=f"size {place}") for place in range(6))  # as many as the impeller has
    model = compose(measured(dimensions), block, details=Details(created_at=AT))
    assert model.deviation is not None and model.deviation.pictures
    drawn = tuple(DimensionPicture(f"size {place}", model.deviation.pictures[0]) for place in range(failing))
    page = np.asarray(Image.open(io.BytesIO(page_images(replace(model, failing=drawn), ppi=40)[1])).convert("L"))
    text_mm = np.flatnonzero((page < 200).any(axis=1)) / page.shape[0] * 297
    assert text_mm[text_mm < 275].max() > 225  # above the footer


def test_a_long_name_leaves_the_columns_of_the_budget_their_width(measured) -> None:
    one = measured().inspection.dimensions[0]
    template = Template(ReportTemplate(pages=("uncertainty",)))

    def height_mm(name: str) -> float:
        dimensions = (replace(one, name=name), *(replace(one, name=f"size {place}") for place in range(5)))
        model = compose(measured(dimensions), details=Details(template=template, created_at=AT), pictures=False)
        pages = page_images(replace(model, sections=()), ppi=40)
        page = np.asarray(Image.open(io.BytesIO(pages[-1])).convert("L"))
        text_mm = np.flatnonzero((page < 200).any(axis=1)) / page.shape[0] * 297
        return float(text_mm[text_mm < 275].max())

    assert height_mm("outer width over all of the rib on the far side, measured from the datums A, B and C") < height_mm("width") + 25


@pytest.mark.parametrize("at", [(0.97, 0.06), (0.05, 0.1), (0.9, 0.95)])
def test_the_label_of_a_flag_covers_no_place(at: tuple[float, float], measured, block) -> None:
    model = compose(measured(), block, details=Details(created_at=AT))
    assert model.deviation is not None
    flags = tuple(Flag(one, ("Minimum", "-0.2 mm"), "#FF0000") for one in (at, (0.55, 0.5)))
    pictures = (replace(model.deviation.pictures[0], flags=flags),)
    pages = page_images(replace(model, deviation=replace(model.deviation, pictures=pictures)), ppi=100)
    dots = 0
    for page in pages:
        red, green, _ = np.moveaxis(np.asarray(Image.open(io.BytesIO(page)).convert("RGB")).astype(int), -1, 0)
        filled = cv2.erode(((red > 200) & (green < 60)).astype(np.uint8), np.ones((5, 5), np.uint8))
        dots += cv2.connectedComponents(filled)[0] - 1
    assert dots == 2


def test_no_row_of_a_table_of_facts_is_alone_on_a_page(measured) -> None:
    whole = compose(measured(), details=Details(template=Template(ReportTemplate(pages=("settings",))), created_at=AT), pictures=False)
    seen = set()
    for count in range(56, 62):  # about as many as a page has room for
        facts = tuple(Fact(f"setting {place}", "as planned") for place in range(count))
        pages = page_images(replace(whole, sections=(Section("Settings", facts),)), ppi=100)
        seen |= {len(text_lines(page)) for page in pages[1:]}
    assert seen >= {2, 3, 4}
    assert 1 not in seen


def text_lines(page: bytes) -> list[int]:
    """Return where lines of text begin in the left third of a page, without head and foot."""
    ink = np.asarray(Image.open(io.BytesIO(page)).convert("L"))
    inside = (ink[int(0.06 * len(ink)) : int(0.9 * len(ink)), : ink.shape[1] // 3] < 140).any(axis=1)
    return [int(row) for row in np.flatnonzero(np.diff(inside.astype(int)) == 1)]
