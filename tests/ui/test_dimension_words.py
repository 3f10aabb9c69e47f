"""What the page says about dimensions: what they are, what they rest on, and by which rule they are judged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.measurement import Alignment
from measureapp.geometry.transform import RigidTransform
from ui.pages.inspection.dimension_rows import datum_words, dimension_properties, tolerance
from ui.pages.layers import filled_share
from ui.widgets.properties_panel import Properties

ALIGNMENT = Alignment("best fit", RigidTransform.identity("nominal", "part"), 0.021, 0.93, ("rotation about z",), {"bore": 0.004})
ZONE = Dimension(
    "boss_position", 0.0, 0.005, 0.077, 0.0, 0.2, Verdict.PASS,
    features=("boss",), kind="position", datums=("gear face", "bore"), datum_letters=("A", "D"), traceability="boss: 1372 points, 99 left out; associated axis; datums gear face|bore",
)  # fmt: skip


def plain(text: str) -> str:
    return text.replace("\u00a0", " ").replace("\u2009", " ")


def plain_groups(properties: Properties) -> dict[str, list[tuple[str, str]]]:
    return {group.heading: [(name, plain(value)) for name, value in group.rows] for group in properties.groups}


def feature(name: str, shape: str, points: int = 40) -> Feature:
    return Feature(name, shape, np.zeros(3), np.array([0, 0, 1.0]), points=points, form_error_mm=0.05)  # type: ignore[arg-type]


def test_the_properties_of_a_zone_name_kind_datums_origin_and_rule():
    shown = dimension_properties(ZONE, [feature("boss", "cylinder")], ALIGNMENT, "By a rule.")
    groups = plain_groups(shown)
    assert ("Kind", "Position") in groups["Result"]
    assert ("Datums", "A Gear face, D Bore") in groups["Result"]
    assert ("Tolerance", "0 / +0.200 mm") in groups["Result"]
    assert ("Uncertainty (k = 2)", "0.077 mm") in groups["Result"]
    assert groups["Traceability"] == [("", "Boss: 1372 points, 99 left out."), ("", "Associated axis.")]
    assert groups["Decision rule"] == [("", "By a rule.")]
    assert "Uncertainty budget (k = 2)" not in groups


def test_the_shares_of_an_uncertainty_are_named_the_largest_first():
    shared = replace(ZONE, budget={"noise": 0.0301, "stitching": 0.0708, "calibration": 0.0})
    shown = plain_groups(dimension_properties(shared, [], ALIGNMENT, ""))
    assert shown["Uncertainty budget (k = 2)"] == [("Stitching", "0.0708 mm"), ("Noise", "0.0301 mm")]


@pytest.mark.parametrize(
    ("lower", "upper", "words"),
    [(-0.1, 0.1, "± 0.100 mm"), (0.0, 0.2, "0 / +0.200 mm"), (-0.2, 0.05, "\u22120.200 / +0.050 mm"), (-0.1, 0.0, "\u22120.100 / 0 mm")],
)
def test_a_tolerance_is_short_where_it_is_symmetric_and_a_limit_of_nothing_is_nought(lower, upper, words):
    assert plain(tolerance(lower, upper, "mm")) == words


def test_datums_of_a_pattern_have_no_letters():
    assert datum_words(("a", "b", "c", "d"), ()) == "A, B, C, D"


def test_the_page_prints_the_rule_and_states_what_was_filled_without_points(application, window, measurement, qtbot):
    page = window.pages["inspection"]
    application.session.set_measurement(measurement, {})
    window.show_page("inspection")
    qtbot.waitUntil(lambda: not page.is_composing, timeout=10_000)
    assert "ISO 14253-1" in page.side.rule.text() and "k = 2" in page.side.rule.text()
    share = filled_share(measurement.mesh)
    assert 0.0 < share < 0.2
    assert page.filled.isVisible() and f"{100 * share:.1f}" in page.filled.words.text()
    application.session.set_measurement(replace(measurement, mesh=replace(measurement.mesh, measured=None)), {})
    qtbot.waitUntil(lambda: not page.is_composing, timeout=10_000)
    assert not page.filled.isVisible()


def test_a_feature_of_the_list_shows_its_fit(application, window, measurement):
    page = window.pages["inspection"]
    application.session.set_measurement(measurement, {})
    window.show_page("inspection")
    page.side.list.setValue("features")
    page.side.features.select_names(["equator"])
    assert page.properties.title == "Equator"
    assert page.view._flags == ()
