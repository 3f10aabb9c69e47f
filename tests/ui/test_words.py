"""Numbers as people read them, and the theme."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

import pytest

from ui.look import wording
from ui.look.theme import Theme


@pytest.mark.parametrize(
    ("value", "words"),
    [(0.0123, "0.012 mm"), (-0.5, "−0.500 mm"), (-0.0001, "0.000 mm"), (None, "–"), (float("nan"), "–")],
)
def test_a_length_has_its_unit_and_sensible_digits(value, words):
    assert wording.millimetres(value).replace("\u00a0", " ") == words


def test_a_signed_error_shows_its_sign_and_zero_has_none():
    assert wording.millimetres(0.021, signed=True).startswith("+0.021")
    assert wording.millimetres(0.0, signed=True).startswith("0.000")


@pytest.mark.parametrize(("seconds", "words"), [(4.4, "4 s"), (130, "2 min 10 s"), (3900, "1 h 05 min")])
def test_a_duration_is_given_in_a_fitting_unit(seconds, words):
    assert wording.duration(seconds) == words


@pytest.mark.parametrize(("age", "words"), [(10, "just now"), (600, "10 min ago"), (7200, "2 h ago"), (259_200, "3 days ago")])
def test_an_age_is_given_in_words(age, words):
    now = datetime(2026, 1, 10, tzinfo=UTC)
    assert wording.when((now - timedelta(seconds=age)).isoformat(), now) == words


def test_an_age_nobody_wrote_down_is_empty():
    assert wording.when("") == ""


def test_exposures_counts_and_sizes_read_well():
    assert wording.exposure(80_000).replace("\u00a0", " ") == "80 ms"
    assert wording.exposure(500).replace("\u00a0", " ") == "500 µs"
    assert wording.counted(1_234_567).replace("\u2009", " ") == "1 234 567"
    assert wording.storage(12.4e9).replace("\u00a0", " ") == "12.4 GB"
    assert wording.quantity(60.0, "°", 1) == "60.0°"


def test_both_themes_have_the_same_tokens_and_verdict_colours():
    light, dark = Theme.load("light"), Theme.load("dark")
    assert light.colours.keys() == dark.colours.keys()
    for verdict in ("pass", "fail", "not proven", "not measured"):
        assert light.verdict(verdict) == dark.verdict(verdict)
    assert light.colours["accent"] == "#0F8B8D"
    assert len(set(light.views)) == 10


@pytest.mark.parametrize("shade", ["light", "dark"])
def test_text_stands_out_from_its_ground(shade):
    theme = Theme.load(shade)

    def luminance(name):
        parts = [value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4 for value in theme.colour(name).getRgbF()[:3]]
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]

    for text, least in (("text", 7.0), ("soft", 4.5), ("accent_text", 4.5)):
        dark, bright = sorted((luminance(text), luminance("surface")))
        assert (bright + 0.05) / (dark + 0.05) >= least, text
