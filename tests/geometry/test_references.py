"""Fits of noisy points against answers in 50 digits (`references.py`): whole shapes and 5° arcs, at the origin and 1000 mm away."""

from __future__ import annotations

import json

import numpy as np
import pytest
from geometry import references

from measureapp.geometry.feature import Feature
from measureapp.geometry.fits import fit

CASES = json.loads(references.FILE.read_text(encoding="utf-8"))
NAMES = [f"{case['shape']}, {case['arc']}, {case['offset_mm']:g} mm away" for case in CASES]
EXACT_MM = EXACT_RAD = 1e-7


def near(case: dict) -> Feature:
    """A start some tenths of a millimetre off: a 5° piece of a torus also fits others."""
    point, direction, sizes = (np.array([float(text) for text in case["answer"][name]]) for name in ("point_mm", "direction", "sizes"))
    return Feature("start", "torus", point + 0.3, direction, sizes[0] + 0.5, minor_radius_mm=sizes[1] - 0.2)


@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_a_fit_is_the_least_squares_answer_in_50_digits(case):
    narrow_torus = case["shape"] == "torus" and case["arc"] != "whole"
    found = fit(case["shape"], np.array(case["points_mm"]), start=near(case) if narrow_torus else None)
    point, direction, sizes = (np.array([float(text) for text in case["answer"][name]]) for name in ("point_mm", "direction", "sizes"))
    assert np.linalg.norm(found.point_mm - point) < EXACT_MM
    if len(direction):
        assert np.linalg.norm(np.cross(found.direction, direction)) < EXACT_RAD
    radii = [found.radius_mm, found.minor_radius_mm, found.half_angle_rad]
    assert np.allclose([size for size in radii if size is not None], sizes, rtol=0, atol=EXACT_MM)


@pytest.mark.slow
@pytest.mark.parametrize("case", range(len(CASES)), ids=NAMES)
def test_the_recorded_answers_are_those_that_50_digits_give(case):
    pytest.importorskip("mpmath")
    from geometry.fifty_digits import solved

    described = references.cases()[case]
    assert np.array_equal(described["points_mm"], np.array(CASES[case]["points_mm"]))
    assert solved(described) == CASES[case]["answer"]
