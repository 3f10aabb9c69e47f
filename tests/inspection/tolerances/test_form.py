"""Form of surfaces with known deviations. What noise may do follows from its size; what cells may do from theirs."""

from __future__ import annotations

import numpy as np
import pytest
from inspection.machined_part import RADIUS_MM, Part, cylinder, plane

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.inspection_program import InspectionProgram
from measureapp.geometry.fits import fit
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.features.cells import cell_means, greatest_noise, greatest_noise_factor, surface_keys
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings, UncertaintySettings
from measureapp.inspection.tolerances.empirical_bayes import estimate_noise_free_heights
from measureapp.inspection.tolerances.zone_noise import Zone, estimate_noise_free_width

ONLY_NOISE = InspectionSettings(uncertainty=UncertaintySettings(placement_mm=0, systematic_mm=0, systematic_relative=0))
NOISE_MM = 0.02
TOP = plane("top", [0, 0, 0], [0, 0, 1])
SHAFT = cylinder("shaft", [0, 0, 0], RADIUS_MM)


def measured(part: Part, features: list[dict], settings: InspectionSettings = ONLY_NOISE, **dimension) -> Dimension:
    described = {"name": "d", "features": [features[0]["name"]], "upper_tolerance": 0.2, **dimension}
    document = {"name": "p", "alignment": "none", "features": features, "dimensions": [described]}
    return inspect(part.at_its_place(), InspectionProgram.model_validate(document), settings=settings).dimensions[0]


def quadrants(u, v):
    """Raised and lowered by 0.05 mm in turn: the plane between is the best, by four contacts on alternating sides."""
    return np.where(u * v > 0, 0.05, -0.05)


def thirds(u, _=None):
    """Up, down, up by 0.04 mm: three contacts on alternating sides of the middle line."""
    return np.where(np.abs(u) < 10, -0.04, 0.04)


def wavy_top(seed, noise_mm=NOISE_MM):
    part = Part(np.random.default_rng(seed), noise_mm)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0], height=quadrants)
    return part


def ridged_top(seed, noise_mm=NOISE_MM):
    part = Part(np.random.default_rng(seed), noise_mm)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0], height=thirds)
    return part


def oval_shaft(seed, noise_mm=NOISE_MM):
    part = Part(np.random.default_rng(seed), noise_mm)
    part.round([0, 0, 0], RADIUS_MM, radial=lambda turn: 0.03 * np.cos(2 * turn))
    return part


def bent_shaft(seed, noise_mm=NOISE_MM):
    part = Part(np.random.default_rng(seed), noise_mm)
    part.round([0, 0, 0], RADIUS_MM, bend=thirds)
    return part


TIMES = pytest.mark.parametrize("times", [3, pytest.param(80, marks=pytest.mark.slow)])


def enough(times: int) -> float:
    """How many of so many values must lie within their uncertainty: 95 of 100, less what chance may take."""
    return 0.95 * times - 2.5 * np.sqrt(0.05 * 0.95 * times)


def range_of_noise(noise_mm: float, cells: int, points: int) -> float:
    """The range that noise alone spans over means of so many points of a face, in 95 of 100 cases at most."""
    return 2 * greatest_noise_factor(cells) * noise_mm / np.sqrt(points / cells)


CELL_ANGLE = 5.0 / RADIUS_MM
OVAL_LOSS_MM = 0.06 * CELL_ANGLE**2  # 1 - cos of twice the half cell, and the mean within it
CASES = {
    "flatness": (wavy_top, TOP, {"kind": "flatness"}, 0.1, 0.0),
    "straightness of lines": (ridged_top, TOP, {"kind": "straightness", "along": [1, 0, 0]}, 0.08, 0.0),
    "straightness of an axis": (bent_shaft, SHAFT, {"kind": "straightness"}, 0.08, 0.0),
    "roundness": (oval_shaft, SHAFT, {"kind": "roundness"}, 0.06, OVAL_LOSS_MM),
    "cylindricity": (oval_shaft, SHAFT, {"kind": "cylindricity"}, 0.06, OVAL_LOSS_MM),
}


@pytest.mark.parametrize(
    ("make", "feature", "asked", "truth", "loss"), [c for c in CASES.values() if c[3]], ids=[n for n in CASES if CASES[n][3]]
)
def test_noise_free_form_is_the_known_one(make, feature, asked, truth, loss):
    found = measured(make(1, noise_mm=0.0), [feature], **asked)
    # slopes scatter the points within a cell, whose places are random: by 0.0015·5 mm/√12 on the shaft, by 0.0005 mm of a mean of 20
    assert found.uncertainty < 2 * greatest_noise_factor(600) * 0.0005
    assert found.measured == pytest.approx(truth, abs=loss + found.uncertainty + 2e-4), found.reason
    assert found.kind == asked["kind"] and "cells" in found.traceability and "minimum zone" in found.traceability


@pytest.mark.parametrize(
    ("make", "feature", "asked", "truth", "loss"), [c for c in CASES.values() if c[3]], ids=[n for n in CASES if CASES[n][3]]
)
@TIMES
def test_the_uncertainty_of_form_holds_in_95_of_100_cases(make, feature, asked, truth, loss, times):
    found = [measured(make(seed, NOISE_MM), [feature], **asked) for seed in range(times)]
    assert sum(abs(one.deviation - truth) <= one.uncertainty + loss for one in found) >= enough(times)
    assert all(one.verdict is Verdict.PASS for one in found)  # within 0.2 mm, uncertainty included


@TIMES
def test_a_perfect_surface_may_be_perfect(times):
    """The flatness of a flat plane is no more than its uncertainty in 95 of 100 cases."""
    within = []
    for seed in range(times):
        part = Part(np.random.default_rng(seed), NOISE_MM)
        part.square([0, 0, 0], [0, 0, 1], [1, 0, 0])
        found = measured(part, [TOP], kind="flatness")
        within.append(found.measured <= found.uncertainty * (1 + 1e-9))
    assert sum(within) >= enough(times)


@pytest.mark.parametrize(
    ("make", "feature", "asked", "cells", "points"),
    [(wavy_top, TOP, {"kind": "flatness"}, 144, 4000), (oval_shaft, SHAFT, {"kind": "cylindricity"}, 600, 12000)],
)
def test_intervals_of_form_are_narrower_than_the_worst_effect_of_noise(make, feature, asked, cells, points):
    """Whatever the form is, noise adds between nothing and its own range: an interval of that width would need no estimate."""
    found = measured(make(7), [feature], **asked)
    assert 2 * found.uncertainty < range_of_noise(NOISE_MM, cells, points)
    assert "by noise" in found.traceability


FORMS_OF_FACES = {
    "many equal places": quadrants,
    "few far ones": lambda u, v: 2e-4 * (u**2 + v**2),
    "ridges": lambda u, v: 0.03 * np.cos(u / 10),
}


@pytest.mark.parametrize("form", FORMS_OF_FACES.values(), ids=FORMS_OF_FACES)
@pytest.mark.parametrize(("cells", "times"), [(60, 12), pytest.param(200, 120, marks=pytest.mark.slow)])
def test_the_shift_by_noise_is_taken_off_whatever_the_form(form, cells, times):
    """By the regression plane, at places drawn anew each time: the widths come out as they are without noise."""
    rng, noise_mm = np.random.default_rng(11), 0.004
    errors, sigmas = np.empty(times), np.empty(times)
    for number in range(times):
        u, v = rng.uniform(-30, 30, (2, cells))
        design = np.column_stack([u / 30, v / 30, np.ones(cells)])
        true, noisy = (
            Zone(np.zeros((1, cells)), design[None], np.full(cells, noise_mm)).fit_residuals(heights[None, None])[0]
            for heights in (form(u, v), form(u, v) + noise_mm * rng.standard_normal(cells))
        )
        zone = Zone(noisy, design[None], np.full(cells, noise_mm))
        found = estimate_noise_free_width([zone], float(np.ptp(noisy)), "least-squares", 40)
        errors[number], sigmas[number] = found.value_mm - float(np.ptp(true)), found.sigma_mm
    assert np.count_nonzero(np.abs(errors) <= 2 * sigmas) >= enough(times)
    # what is left of the shift is part of the standard uncertainty
    assert abs(errors.mean()) < np.sqrt(np.mean(sigmas**2)) + 2.5 * errors.std() / np.sqrt(times)


def test_heights_that_differ_by_noise_alone_are_equal():
    rng = np.random.default_rng(3)
    true = np.repeat([0.0, 1.0, 4.0], 40)
    found = estimate_noise_free_heights((true + 0.1 * rng.standard_normal(120))[None], np.full(120, 0.1))
    # each level is the mean of 40 heights, known to 0.016; the likeliest distribution leaves some of their scatter
    assert np.sqrt(np.mean((found[0] - true) ** 2)) < 0.05
    flat = estimate_noise_free_heights(rng.standard_normal((2, 60)), np.ones(60))
    assert np.sqrt(np.mean(np.sum(flat**2, axis=0))) < 0.6  # of offsets that are noise alone, √2 at first


def test_least_squares_form_is_never_less_than_the_minimum_zone():
    zone, squares = (measured(wavy_top(3), [TOP], kind="flatness", criterion=name) for name in ("minimum-zone", "least-squares"))
    assert zone.measured <= squares.measured < 1.3 * zone.measured
    assert "least squares" in squares.traceability


def test_the_noise_of_means_is_that_of_their_points():
    part = Part(np.random.default_rng(5), NOISE_MM)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0], count=20_000)
    points = part.at_its_place().points_mm
    feature = fit("plane", points)
    cells = cell_means(FoundFeature("top", feature, points_mm=points), feature, surface_keys(points, feature, 5.0))
    # 12 × 12 to 13 × 13 cells; the scatter of 140 means is known to 6 %
    assert np.std(cells.deviations_mm) == pytest.approx(cells.noise_mm, rel=0.2)
    assert cells.noise_mm == pytest.approx(NOISE_MM / np.sqrt(20_000 / 144), rel=0.1)


def test_the_slope_of_a_form_across_a_cell_is_no_noise():
    """Waves climb by 0.03 mm across a cell, six times the noise; what their bend leaves in a cell is a twentieth of that."""
    noise_mm, amplitude, length = 0.005, 0.1, 5.0 * np.pi
    part = Part(np.random.default_rng(6), noise_mm)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0], height=lambda u, v: amplitude * np.sin(u / length), count=20_000)
    points = part.at_its_place().points_mm
    feature = fit("plane", points)
    cells = cell_means(FoundFeature("top", feature, points_mm=points), feature, surface_keys(points, feature, 5.0))
    slope = amplitude / length * 5.0 / np.sqrt(12)  # scatter about the mean of a cell at the steepest places
    bend = amplitude / length**2 * 5.0**2 / np.sqrt(720)  # of a parabola about its straight line, where it bends most
    alone = noise_mm / np.sqrt(20_000 / 144)
    assert slope > 1.5 * noise_mm
    assert cells.noise_mm == pytest.approx(alone, rel=0.1 + (bend / noise_mm) ** 2)


def test_the_greatest_noise_of_unlike_means_is_exceeded_in_5_of_100_cases():
    noises = np.r_[np.full(60, 1.0), np.full(20, 2.0)]
    greatest = np.abs(noises * np.random.default_rng(1).standard_normal((4000, 80))).max(axis=1)
    assert np.mean(greatest > greatest_noise(noises)) == pytest.approx(0.05, abs=0.015)
    assert greatest_noise(np.ones(80)) == pytest.approx(greatest_noise_factor(80))


def test_a_form_that_noise_alone_could_have_made_says_that_its_interval_is_one_sided():
    part = Part(np.random.default_rng(0), NOISE_MM)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0])
    flat, wavy = measured(part, [TOP], kind="flatness"), measured(wavy_top(0), [TOP], kind="flatness")
    assert f"one-sided, at most {flat.measured + flat.uncertainty:.4f} mm" in flat.traceability
    assert flat.measured <= flat.uncertainty and "one-sided" not in wavy.traceability


def test_the_reach_of_noise_is_exceeded_in_5_of_100_cases():
    greatest = np.abs(np.random.default_rng(0).standard_normal((4000, 50))).max(axis=1)
    assert np.mean(greatest > greatest_noise_factor(50)) == pytest.approx(0.05, abs=0.015)


@pytest.mark.parametrize(
    ("feature", "asked", "said"),
    [
        (TOP, {"kind": "roundness"}, "defined for a cylinder or cone"),
        (TOP, {"kind": "cylindricity"}, "defined for a cylinder"),
        (SHAFT, {"kind": "flatness"}, "defined for a plane"),
        (TOP, {"kind": "straightness"}, "needs `along`"),
        (TOP, {"kind": "straightness", "along": [0, 0, 1]}, "is perpendicular"),
    ],
)
def test_form_not_defined_for_a_feature_is_refused(feature, asked, said):
    part = wavy_top(0) if feature is TOP else oval_shaft(0)
    found = measured(part, [feature], **asked)
    assert found.verdict is Verdict.NOT_MEASURED and said in found.reason


def test_half_a_shaft_has_no_roundness():
    part = oval_shaft(0)
    whole = part.points[0]
    part.points[0], part.normals[0] = whole[whole[:, 0] > 0], part.normals[0][whole[:, 0] > 0]
    for kind in ("roundness", "cylindricity", "straightness"):
        found = measured(part, [SHAFT], kind=kind)
        assert found.verdict is Verdict.NOT_MEASURED and "75% are needed" in found.reason


def test_a_surface_of_few_points_has_no_form():
    part = Part(np.random.default_rng(0), NOISE_MM)
    part.square([0, 0, 0], [0, 0, 1], [1, 0, 0], half_mm=5.0, count=200)
    found = measured(part, [TOP], kind="flatness")
    assert found.verdict is Verdict.NOT_MEASURED and "12 are needed" in found.reason
