import math

import pytest
from pydantic import ValidationError

from measureapp.data.dimension_program import DimensionProgram
from measureapp.data.standard_tolerances import ABOVE_UM, BELOW_UM, GENERAL_MM, GRADES_UM, SIZES_MM, general_tolerance, tolerance_class
from measureapp.data.tolerance_text import Tolerance, parse_tolerance

MEANS = [math.sqrt(low * high) for low, high in zip((1, *SIZES_MM[:-1]), SIZES_MM, strict=True)]


def parse(text, kind="distance", nominal=40.0, is_zone=False):
    return parse_tolerance(text, kind=kind, nominal=nominal, is_zone=is_zone)


@pytest.mark.parametrize(
    ("text", "limits"),
    [
        ("±0.1", (-0.1, 0.1)),
        ("+-0,1 mm", (-0.1, 0.1)),
        ("+/-0.25", (-0.25, 0.25)),
        ("+0.1/-0.05", (-0.05, 0.1)),
        ("−0.05 / +0.1", (-0.05, 0.1)),
        ("+0.1/+0.02", (0.02, 0.1)),
        ("0/-0.2", (-0.2, 0.0)),
        ("+0.3 0", (0.0, 0.3)),
        ("H7", (0.0, 0.025)),
        ("g6", (-0.025, -0.009)),
        ("js9", (-0.031, 0.031)),
        ("2768-m", (-0.3, 0.3)),
        ("ISO 2768-f", (-0.15, 0.15)),
    ],
)
def test_the_texts_of_a_drawing_are_understood(text, limits):
    found = parse(text)
    assert (found.lower, found.upper) == pytest.approx(limits)


def test_an_empty_text_means_no_tolerance():
    assert parse("") is None and parse("  ") is None


def test_a_zone_has_one_number():
    assert parse("max 0.05", "flatness", 0.0, True) == Tolerance(0.0, 0.05, "max 0.05")
    assert parse("0.05", "flatness", 0.0, True).upper == 0.05
    with pytest.raises(ValueError, match="one number"):
        parse("±0.05", "flatness", 0.0, True)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("0.1", "one number"),
        ("0.1/0.05", "sign"),
        ("max 0.1", "both limits"),
        ("±0", "zero width"),
        ("H15", "IT5 to IT11"),
        ("Q7", "classes are"),
        ("k9", "classes are"),
        ("2768-mK", "geometrical"),
        ("2768-x", "f, m, c and v"),
        ("22081", "drawing states"),
        ("about 0.1", "not a tolerance"),
    ],
)
def test_what_is_not_a_tolerance_is_refused_with_its_remedy(text, reason):
    with pytest.raises(ValueError, match=reason):
        parse(text)


def test_standard_tolerances_are_refused_where_they_state_nothing():
    with pytest.raises(ValueError, match="linear sizes"):
        parse("2768-m", "angle", 30.0)
    with pytest.raises(ValueError, match="linear sizes"):
        parse("2768-m", "radius", 5.0)
    with pytest.raises(ValueError, match="500 mm"):
        parse("H7", nominal=620.0)
    with pytest.raises(ValueError, match="no tolerance for 2 mm"):
        parse("2768-v", nominal=2.0)


def test_standard_grades_follow_their_formula():
    factors = {5: 7, 6: 10, 7: 16, 8: 25, 9: 40, 10: 64, 11: 100}
    for grade, widths in GRADES_UM.items():
        for mean, width in list(zip(MEANS, widths, strict=True))[1:]:  # the first range has values of its own
            unit = 0.45 * mean ** (1 / 3) + 0.001 * mean
            assert width == pytest.approx(factors[grade] * unit, abs=0.8, rel=0.06)


def test_fundamental_deviations_follow_their_formulas():
    formulas = {"d": (16, 0.44), "e": (11, 0.41), "f": (5.5, 0.41), "g": (2.5, 0.34)}
    for name, (factor, power) in formulas.items():
        for mean, deviation in zip(MEANS, BELOW_UM[name], strict=True):
            assert deviation == pytest.approx(factor * mean**power, abs=1.05, rel=0.06)
    for number, mean in list(enumerate(MEANS))[1:]:
        assert ABOVE_UM["k"][number] == pytest.approx(0.6 * mean ** (1 / 3), abs=1.0)
        assert ABOVE_UM["m"][number] == GRADES_UM[7][number] - GRADES_UM[6][number]
        assert ABOVE_UM["n"][number] == pytest.approx(5 * mean**0.34, abs=1.0)
        assert 0 <= ABOVE_UM["p"][number] - GRADES_UM[7][number] <= 5


def test_general_tolerances_grow_with_size_and_class():
    for widths in GENERAL_MM.values():
        known = [width for width in widths if width is not None]
        assert known == sorted(known)
    for size in (1, 5, 20, 100, 300, 800, 1500):
        ordered = [general_tolerance(name, size) for name in "fmc"]
        assert ordered == sorted(ordered)


def test_the_upper_end_of_a_range_belongs_to_it():
    assert tolerance_class("H", 7, 50.0) == (0.0, 0.025) and tolerance_class("H", 7, 50.001) == (0.0, 0.03)
    assert general_tolerance("m", 30.0) == 0.2 and general_tolerance("m", 30.1) == 0.3 and general_tolerance("m", 0.5) == 0.1


@pytest.mark.parametrize("value", [0.05, [-0.1, 0.1]])
def test_a_tolerance_that_is_no_text_is_refused_with_one_that_is(value):
    with pytest.raises(ValidationError, match="is a text, such as"):
        DimensionProgram.model_validate({"name": "a", "kind": "diameter", "features": ["hub"], "nominal": 90, "tolerance": value})
