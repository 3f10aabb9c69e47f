"""Entries join an inspection program, and leave it, without touching what people wrote around them."""

from __future__ import annotations

import pytest

from measureapp.errors import InputError
from measureapp.project.program_file import parse_program
from measureapp.project.program_text import add_entry, format_entry, remove_entry

TEXT = """# of the bracket
name = "bracket"
alignment = "none"

[[features]]
name = "top"  # milled
shape = "plane"
point_mm = [0, 0, 50]
direction = [0, 0, 1]

[features.cut]
edge_mm = 3

[[features]]
name = "base"
shape = "plane"
point_mm = [0, 0, 0]
direction = [0, 0, -1]

[[dimensions]]
name = "height"
kind = "distance"
features = ["top", "base"]
nominal = 50
"""
SEED = {"name": 'a "b"', "shape": "plane", "grow": {"seed_mm": (1.0, -2.5, 0.125)}}


def test_an_entry_joins_and_leaves_and_the_text_is_as_before():
    longer = add_entry(TEXT, format_entry("features", SEED))
    grown = parse_program(longer).features[-1]
    assert (grown.name, grown.grow.seed_mm) == ('a "b"', (1.0, -2.5, 0.125))
    assert longer.startswith(TEXT)
    assert remove_entry(longer, 'a "b"').rstrip() == TEXT.rstrip()


def test_an_entry_leaves_with_its_tables():
    left = remove_entry(remove_entry(TEXT, "height"), "top")
    assert [feature.name for feature in parse_program(left).features] == ["base"] and "edge_mm" not in left and "# of the bracket" in left


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda: remove_entry(TEXT, "top"), "'height' needs feature 'top'"),
        (lambda: remove_entry(TEXT, "lid"), "no entry 'lid'"),
        (lambda: add_entry(TEXT, format_entry("features", SEED | {"name": "top"})), "two features have the name 'top'"),
    ],
)
def test_a_change_that_does_not_fit_is_refused(change, told):
    with pytest.raises(InputError, match=told):
        change()
