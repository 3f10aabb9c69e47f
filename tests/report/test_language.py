"""Reports in Simplified Chinese: every fixed word is translated, numbers, verdicts and names are the same, and JSON and CSV stay English."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from measureapp.data.cloud import LoopClosure
from measureapp.data.consistency import Consistency, ConsistencyCheck
from measureapp.data.control_frame import ControlFrame
from measureapp.data.dimension import CONTRIBUTIONS, Dimension, Verdict
from measureapp.data.identification import Identification
from measureapp.data.measurement import Measurement
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.data.repeats import RepeatedDimension, RepeatedMeasurement, RepeatStudy
from measureapp.data.setups import JoinedSetUp
from measureapp.data.validity import Drift, Validity
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.language.catalogue import Catalogue, Entry
from measureapp.language.languages import LANGUAGES, catalogue_of, known_language
from measureapp.pipeline.chosen_views import REFUSED
from measureapp.register.joint.registration import Contradiction
from measureapp.report.compose import compose
from measureapp.report.csv import csv_text
from measureapp.report.html import html_text
from measureapp.report.json_document import report_document
from measureapp.report.language import Words, layout_texts, read_layout
from measureapp.report.model import Details, ReportModel
from measureapp.report.pdf import page_images, pdf_bytes
from measureapp.report.printed import kind_words, typst_document
from measureapp.report.repeats.pdf import typst_study
from measureapp.report.series.capability import trends
from measureapp.report.series.documents import typst_series
from measureapp.report.xlsx import write_xlsx
from measureapp.resources import resource
from tests.report.series.test_capability import runs

LAYOUTS = ("report.typ", "series.typ", "repeats.typ", "report.html")
NAMES = re.compile(
    r"\b(?:Length|Width|Deviation|Bore|Tilt|Seat|Meridian|length|width|deviation|bore|tilt|seat|meridian|face|pin|lug|left|right|clamp \w+|"
    r"v\d\d|Paper rig|project|program|part|best fit|joint|Face|Pin|Works|Smith|S1|MeasureApp|Cpk?|Ppk?|lid|day\d)\b"
)  # that people gave, and of the program
UNITS = re.compile(r"\b(?:mm|px|ppm|ms|UTC|rms|dpi)\b")
KEYS = {"file", "key", "svg", "colour", "stops", "pages", "logo", "chart", "words", "lang", "fonts", "signatures"}  # not printed
SENTENCES = (
    "No dimension has a tolerance: no verdict.",
    "All 4 dimensions with a tolerance pass; 2 without tolerance.",
    "1 dimension, chi-square test at a level of 5%",
)


def dimensions() -> tuple[Dimension, ...]:
    """Return dimensions of every verdict; the name of one is a word of the report."""
    shares = {name: 0.001 * place for place, name in enumerate(CONTRIBUTIONS, start=1)}
    frame = ControlFrame("position", 0.1, "Ø", (), ("A", "B"))
    bore = "bore: no section is measured over more than 68% of its circumference, 75% are needed"
    return (
        Dimension("length", 80.0, 80.0123, 0.03, -0.1, 0.1, Verdict.PASS, kind="distance", traceability="face: 800 points, 3 rejected", budget=shares),
        Dimension("width", 60.0, 59.8, 0.03, -0.1, 0.1, Verdict.FAIL, kind="step", features=("face", "pin")),
        Dimension("deviation", 40.0, 40.095, 0.03, -0.1, 0.1, Verdict.NOT_PROVEN, kind="thickness"),
        Dimension("bore", 12.0, None, None, -0.1, 0.05, Verdict.NOT_MEASURED, reason=bore, kind="diameter"),
        Dimension("tilt", 90.0, 90.01, 0.02, -0.5, 0.5, Verdict.PASS, unit="°", kind="angle"),
        Dimension("meridian", 9.0, 9.01, 0.02, None, None, Verdict.NO_TOLERANCE, kind="radius", version="0.0.9"),
        Dimension(
            "seat", 0.0, 0.03, 0.01, 0.0, 0.1, Verdict.PASS, kind="position", frame=frame, datums=("face", "pin"), datum_letters=("A", "B"),
            traceability="seat: 178 points, 4 rejected, face: 2034 points, 0 rejected; associated axis over 4.6 mm; datums face|pin",
        ),
    )  # fmt: skip


@pytest.fixture(scope="module")
def full(measured) -> Measurement:
    """A measurement with everything that a report can state."""
    made = measured(dimensions(), view_count=4)
    contradicting = f"{Contradiction(0.41, 0.05, 3.2).sentence}: excluded"
    placed = [replace(one, verdict=said) for one, said in zip(made.stitched.placements, ("good", contradicting, REFUSED), strict=False)]
    decode = {"left": {"valid_ratio": {"exposures": [0.5, 0.7], "composite": 0.9}, "decoded_ratio": 0.85}}
    drift = Drift(
        "watch",
        "Camera left has turned by 0.030° since the calibration: its image is off by 0.100 px (the calibration left 0.040 px), which moves measured "
        "points by 0.380 mm; check the calibration with a few views of the board before the next measurement that matters.",
        undetectable="This scan would not show a roll of left below 0.041°, a yaw of right below 0.04° or a pitch of left below 0.094°; fringes of "
        "both directions, or a few views of the board, would.",
    )
    check = ConsistencyCheck("surface direction", 0.0123, 0.0045, 0.0114, 1e-6, "error motions of the table, or a part that moved")
    alignment = replace(made.inspection.alignment, method="best-fit")
    here = RigidTransform.identity("part", "part")
    return replace(
        made,
        part="part #1",
        project="project 件",
        stitched=replace(
            made.stitched,
            placements=tuple(placed[:3]),
            notes={"spacing_mm": 1.5, "merge_voxel_mm": 1.5, "views_used": 3.0, "set-ups": 2.0},
            loop_closure=LoopClosure(("v00", "v01", "v02"), 0.003, 0.0029, 0.008),
        ),
        views=tuple(replace(view, decode=decode if place < 3 else {}) for place, view in enumerate(made.views)),
        inspection=replace(made.inspection, program="program 7", alignment=alignment),
        validity=Validity((), drift, 35.0),
        consistency=Consistency((check,)),
        setups=(
            JoinedSetUp("clamp one", here, "reference", 0.0, 0.0, 0.0, 1.0),
            *(JoinedSetUp(f"clamp {method}", here, method, 0.01, 0.02, 0.03, 0.4) for method in ("overlap", "spheres", "nominal")),
        ),
        settings={
            "plan": "part #1",
            "patterns": PATTERN_SETS["three-close-both"].name,
            "exposures_us": [100_000, 20_000],
            "exposure rule": "all unsaturated exposures, weighted by inverse variance",
            "noise": {"left": "assumed: full well 6000 e, read noise 7.0 e"},
        },
    )


@pytest.fixture
def reported(full, block) -> Callable[[str], ReportModel]:
    header = Identification(operator="Smith", customer="Works", temperature_c=21.5, remarks="Deviation")
    english = compose(full, block, details=Details(header, created_at="2026-05-05T08:00:00+00:00", exposures_us={"v00": (80_000, 20_000)}))
    return lambda language: replace(english, details=replace(english.details, language=language))


@pytest.fixture
def bracketed(monkeypatch) -> None:
    """Let the catalogue hold each translated text in brackets in place of its translation."""
    chinese = catalogue_of("zh_CN")
    assert chinese is not None
    texts = {source: Entry(source, f"⟦{source}⟧") for source, entry in chinese.entries.items() if entry.translation}
    made = Catalogue("zh_CN", texts)
    monkeypatch.setattr("measureapp.report.language.catalogue_of", lambda name: made if name == "zh_CN" else None)


def english_left(texts: Iterator[str]) -> list[str]:
    """Return the texts with words outside brackets that are neither names nor units."""
    found = []
    for text in texts:
        bare, count = text, 1
        while count:
            bare, count = re.subn(r"⟦[^⟦⟧]*⟧", "", bare)
        if re.search(r"[A-Za-z]{2}", UNITS.sub("", NAMES.sub("", bare))):
            found.append(text)
    return sorted(set(found))


def printed_texts(value: Any) -> Iterator[str]:
    """Yield every text of a layout's data that is printed."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for key, item in value.items():
            if key not in KEYS:
                yield from printed_texts(item)
    elif isinstance(value, list):
        for item in value:
            yield from printed_texts(item)


def visible(page: str) -> Iterator[str]:
    """Yield the texts of a page between its tags and in attributes that are read, and those of the flags in its 3-D view."""
    scene = re.search(r'<script type="application/json" id="scene">(.*?)</script>', page, re.DOTALL)
    if scene is not None and scene[1] != "null":
        yield from (line for flag in json.loads(scene[1])["flags"] for line in flag["text"])
    bare = re.sub(r"<(script|style|svg)\b.*?</\1>", "", page, flags=re.DOTALL)
    yield from re.findall(r'(?:alt|title|aria-label)="([^"]*)"', bare)
    yield from (text.strip() for text in re.split(r"<[^>]*>", bare) if text.strip() not in ("", "&nbsp;"))


def test_no_word_of_the_printed_report_is_left_in_english(reported, bracketed) -> None:
    assert not english_left(printed_texts(typst_document(reported("zh_CN"))))


def test_no_word_of_the_page_is_left_in_english(reported, bracketed) -> None:
    page = html_text(reported("zh_CN"))
    assert '<html lang="zh-CN">' in page and "⟦Drag to turn" in page
    assert not english_left(visible(page))


def test_sentences_of_a_chinese_page_follow_each_other_without_a_space(reported) -> None:
    texts = list(visible(html_text(reported("zh_CN"))))
    assert any("。" in text[:-1] for text in texts)
    assert not [text for text in texts if "。 " in text]


def test_no_word_of_the_workbook_is_left_in_english(reported, bracketed, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("measureapp.report.xlsx.DIMENSIONS", "Kind")  # as names of sheets cannot have 32 letters or brackets in brackets
    book = openpyxl.load_workbook(write_xlsx(reported("zh_CN"), tmp_path / "r.xlsx"))
    texts = [str(cell.value) for sheet in book for row in sheet for cell in row if isinstance(cell.value, str)]
    assert len(texts) > 100
    assert not english_left(iter((*texts, *book.sheetnames)))


def test_no_word_of_series_and_repeats_is_left_in_english(bracketed) -> None:
    made = Words("zh_CN", ("lid", "width"))
    for count in (3, 30, 60):
        some = runs(count)
        assert not english_left(printed_texts(typst_series("lid", some, trends(some), "2026-05-05T08:00:00+00:00", made)))
    study = RepeatStudy(
        "part", "program", (RepeatedMeasurement("day1", "2026-05-05T08:00:00+00:00", "2026-05-05T08:00:00+00:00"),),
        (RepeatedDimension("width", 80.0, "mm", {"day1": 80.01}, {}, None, None, None, None, None),), 0.95, 0.05, None,
        ("The alignment of the program does not show whether the part was clamped anew between the measurements.",
         "No dimension has both a spread and a stated uncertainty to compare it with.",
         "No spread contradicts the stated uncertainty (4 dimensions, chi-square test at a level of 5% in all). Systematic errors cause no spread."),
    )  # fmt: skip
    assert not english_left(printed_texts(typst_study(study, made)))


def test_every_text_of_the_layouts_is_translated_and_none_stands_beside_them(bracketed) -> None:
    for name in LAYOUTS:
        layout = read_layout(resource(f"report/{name}"))
        assert layout_texts(layout)
        assert all(made == f"⟦{source}⟧" for source, made in Words("zh_CN").of_layout(layout).items())
        bare = re.sub(
            r'//.*|<!--.*?-->|<(style)\b.*?</\1>|"[^"\n]*"|\{[{%].*?[}%]\}', "", layout, flags=re.DOTALL if name.endswith("html") else 0
        )
        found = (
            re.findall(r">\s*([A-Za-z]{2,}[^<]*)<", bare)
            if name.endswith("html")
            else re.findall(r"\n\s*==\s+[A-Za-z].*|\[[A-Z][a-z]+.*", bare)
        )
        assert not found, name


def test_what_reports_may_also_say_is_translated() -> None:
    chinese = Words("zh_CN")
    for text in (*SENTENCES, *(one.name for one in PATTERN_SETS.values())):
        assert not re.findall(r"[A-Za-z]{3,}", chinese.said(text)), text
    kinds = ("step", "slot_width", "max_thickness", "camber", "pitch", "blade_form", "circular_runout", "line_profile")
    assert not [kind for kind in kinds if re.search("[a-z]", kind_words(kind, chinese))]
    assert kind_words("cone_angle", Words()) == "cone angle"


def test_numbers_verdicts_and_names_are_the_same_in_both_languages(reported) -> None:
    english, chinese = typst_document(reported("en")), typst_document(reported("zh_CN"))
    same = (
        "number",
        "key",
        "name",
        "nominal",
        "upper",
        "lower",
        "measured",
        "error",
        "relative",
        "uncertainty",
        "tolerance",
        "sign",
        "colour",
    )
    for one, other in zip(english["dimensions"], chinese["dimensions"], strict=True):
        assert {key: one[key] for key in same} == {key: other[key] for key in same}
    words = {one["verdict"]: other["verdict"] for one, other in zip(english["dimensions"], chinese["dimensions"], strict=True)}
    assert words["pass"] == "合格" and words["fail"] == "不合格" and words["not proven"] == "未证实" and words["not measured"] == "未测量"
    assert chinese["dimensions"][2]["name"] == "Deviation" and chinese["remarks"] == "Deviation"  # a name, though a word of the report
    pairs = list(zip(printed_texts(english), printed_texts(chinese), strict=True))
    differing = [pair for pair in pairs if numbers(pair[0]) != numbers(pair[1])]
    assert len(pairs) > 200 and not differing


def numbers(text: str) -> list[str]:
    return sorted(re.findall(r"\d+(?:\.\d+)?", text))


def test_documents_for_programs_stay_english(reported) -> None:
    english, chinese = reported("en"), reported("zh_CN")
    assert csv_text(english) == csv_text(chinese)
    first, second = report_document(english), report_document(chinese)
    assert (first.pop("language"), second.pop("language")) == ("en", "zh_CN")
    assert json.dumps(first) == json.dumps(second)


def test_a_chinese_report_becomes_pages_in_the_fonts_of_the_program(reported) -> None:
    model = reported("zh_CN")
    document = pdf_bytes(model)
    assert document.startswith(b"%PDF-") and document != pdf_bytes(reported("en"))
    assert len(page_images(model, ppi=20)) >= 4


def test_an_unknown_language_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="'fr'") as refused:
        known_language("fr")
    assert all(name in refused.value.hint for name in LANGUAGES)
