"""Mean and spread of repeated measurements, and the test of the spread against the stated uncertainty."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.measurement import Alignment, Inspection
from measureapp.data.repeats import RepeatedMeasurement, RepeatStudy
from measureapp.errors import InspectionError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.repeats import InspectedPart, evaluate_repeats

NOMINALS = {"length": 80.0, "bore": 12.0, "flatness": 0.0}


def line(name: str, value: float | None, sigma: float = 0.01) -> Dimension:
    reason = "" if value is not None else "bore: no points"
    return Dimension(name, NOMINALS[name], value, 2 * sigma, -0.1, 0.1, Verdict.NOT_PROVEN, reason=reason)


def measured(number: int, values: dict[str, float | None], moved_mm: float = 0.0, program: str = "block") -> InspectedPart:
    placed = RigidTransform.from_vector([0, 0, 0.1], [moved_mm, 0, 3], "nominal", "part")
    inspection = Inspection(program, Alignment("best fit", placed, 0.01), (), tuple(line(name, value) for name, value in values.items()))
    return InspectedPart(RepeatedMeasurement(f"day{number}", "2026-05-04T10:20:30+00:00", ""), inspection)


def study(spread_mm: float, count: int = 10, seed: int = 1, **options: float) -> RepeatStudy:
    rng = np.random.default_rng(seed)
    values = [{name: nominal + 0.02 + spread_mm * rng.normal() for name, nominal in NOMINALS.items()} for _ in range(count)]
    return evaluate_repeats("block", [measured(n, one, options.get("moved_mm", 0.0) * n) for n, one in enumerate(values)])


def test_mean_spread_and_deviations_follow_their_definitions() -> None:
    values = (80.01, 80.03, 80.05)
    found = evaluate_repeats("block", [measured(n, {"length": value}) for n, value in enumerate(values)]).dimensions[0]
    assert found.n == 3
    assert found.mean == pytest.approx(80.03)
    assert found.std == pytest.approx(0.02)
    assert found.deviation == pytest.approx(0.03)
    assert found.relative == pytest.approx(0.03 / 80)
    assert found.mean_half_width == pytest.approx(4.302653 * 0.02 / 3**0.5, rel=1e-6)  # Student's t of two degrees of freedom, 95 %
    assert found.std_interval == pytest.approx((0.02 * (2 / 7.377759) ** 0.5, 0.02 * (2 / 0.0506356) ** 0.5), rel=1e-5)


def test_the_intervals_cover_the_true_values_as_often_as_they_state() -> None:
    found = [one for seed in range(200) for one in study(0.01, 5, seed).dimensions]
    mean = np.mean([abs(one.deviation - 0.02) <= one.mean_half_width for one in found])
    std = np.mean([one.std_interval[0] <= 0.01 <= one.std_interval[1] for one in found])
    bound = 4 * (0.95 * 0.05 / len(found)) ** 0.5
    assert mean == pytest.approx(0.95, abs=bound)
    assert std == pytest.approx(0.95, abs=bound)


def test_a_spread_that_the_stated_uncertainty_explains_rarely_contradicts_it() -> None:
    alarms = np.mean([bool(study(0.01, 6, seed).contradictions) for seed in range(300)])
    assert alarms <= 0.05 + 4 * (0.05 * 0.95 / 300) ** 0.5  # the level of the whole study, of three dimensions


def test_a_spread_of_five_times_the_stated_uncertainty_contradicts_it_in_words() -> None:
    found = study(0.05)
    assert set(found.contradictions) == set(NOMINALS)
    said = next(sentence for sentence in found.sentences if sentence.startswith("length:"))
    assert "contradicts the stated uncertainty U = 0.0200 mm (chi-square test, p < 0.001)" in said


def test_a_dimension_missing_in_one_measurement_is_evaluated_from_the_others_and_named() -> None:
    found = evaluate_repeats("block", [measured(n, {"length": 80 + n / 100, "bore": None if n == 1 else 12 + n / 1000}) for n in range(3)])
    bore = found.dimensions[1]
    assert (bore.n, bore.reasons) == (2, {"day1": "bore: no points"})
    assert "bore: not measured in day1; evaluated from 2 of 3 measurements." in found.sentences


def test_a_dimension_measured_once_has_a_mean_but_no_spread() -> None:
    found = evaluate_repeats("block", [measured(n, {"length": 80 + n / 100, "bore": 12.1 if n == 1 else None}) for n in range(3)])
    bore = found.dimensions[1]
    assert (bore.mean, bore.std, bore.std_interval, bore.test) == (12.1, None, None, None)


def test_a_nominal_of_zero_has_no_relative_deviation() -> None:
    assert study(0.01).dimensions[2].relative is None


def test_a_part_that_was_displaced_was_clamped_anew() -> None:
    assert "(reproducibility)" in study(0.01, moved_mm=2.0).sentences[0]
    assert "does not include clamping" in study(0.01).sentences[0]


@pytest.mark.parametrize(
    ("other", "reason"),
    [
        (measured(1, {"length": 80.0}, program="disc"), "different programs: 'block' and 'disc'"),
        (measured(1, {"length": 80.0, "bore": 12.0}), "only one has bore"),
        (measured(1, {"length": 80.1}), "the same measurement"),
    ],
)
def test_measurements_that_cannot_be_compared_are_refused(other: InspectedPart, reason: str) -> None:
    with pytest.raises(InspectionError, match=reason):
        evaluate_repeats("block", [measured(0, {"length": 80.1}), other])


def test_one_measurement_has_no_spread() -> None:
    with pytest.raises(InspectionError, match="at least two measurements"):
        evaluate_repeats("block", [measured(0, {"length": 80.0})])
