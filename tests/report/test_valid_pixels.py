"""The report states the valid pixels of the exposures: means over the viewpoints, the same numbers in all documents."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from measureapp.report.compose import compose
from measureapp.report.html import html_text
from measureapp.report.json_document import report_document
from measureapp.report.model import Details
from measureapp.report.printed import typst_document
from measureapp.report.valid_pixels import valid_pixels

TIMES = {"v00": (80_000, 20_000), "v01": (80_000, 20_000), "v02": (40_000,)}


def decode(single: tuple[float, ...], composite: float, decoded: float):
    return {"left": {"valid_ratio": {"exposures": list(single), "composite": composite}, "decoded_ratio": decoded}}


@pytest.fixture
def shiny(measured):
    made = measured()
    figures = (decode((0.5, 0.7), 0.9, 0.85), decode((0.6, 0.8), 0.94, 0.75), decode((0.4,), 0.4, 0.3))
    return replace(made, views=tuple(replace(view, decode=found) for view, found in zip(made.views, figures, strict=True)))


def test_viewpoints_with_the_same_exposures_are_averaged_and_the_worst_is_named(shiny) -> None:
    two, one = valid_pixels(shiny, TIMES)
    assert (two.camera, two.exposures_us) == ("left", (80_000, 20_000))
    assert two.exposures == pytest.approx((0.55, 0.75))
    assert (two.composite, two.decoded, two.least_decoded) == pytest.approx((0.92, 0.80, 0.75))
    assert two.least_viewpoint == "v01"
    assert (one.exposures_us, one.least_viewpoint) == ((40_000,), "v02")


def test_exposures_whose_times_are_not_stored_are_numbered(shiny) -> None:
    two, _ = valid_pixels(shiny, {"v00": (80_000,)})
    assert two.exposures_us == ()
    assert "exposure 1 55.0" in html_text(compose(shiny)).replace("\u202f", " ").replace("\u00a0", " ")


def test_pdf_html_and_json_have_the_same_ratios(shiny) -> None:
    model = compose(shiny, details=Details(exposures_us=TIMES), pictures=False)
    found = json.loads(json.dumps(report_document(model)))["valid_pixels"]
    assert found[0]["exposures"] == pytest.approx([0.55, 0.75])
    (section,) = [one for one in model.sections if one.title == "Valid pixels of the exposures"]
    words = section.facts[0].value
    assert "80.0" in words and "55.0" in words and "92.0" in words and "v01" in words
    assert section.title in html_text(model)
    printed = [one for one in typst_document(model)["sections"] if one["title"] == section.title]
    assert printed[0]["facts"][0]["value"] == words


def test_a_measurement_without_decoding_figures_has_no_such_section(measured) -> None:
    model = compose(measured(), pictures=False)
    assert report_document(model)["valid_pixels"] == []
    assert not [one for one in model.sections if one.title == "Valid pixels of the exposures" and one.facts]
