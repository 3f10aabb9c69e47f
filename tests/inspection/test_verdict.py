import pytest

from measureapp.data.dimension import Verdict
from measureapp.inspection.verdict import RULES, conformance_probability, decide_verdict


def test_the_probability_of_conformance_is_that_of_the_normal_distribution() -> None:
    assert conformance_probability(0.0, 0.05, -0.1, 0.1) == pytest.approx(0.9545, abs=1e-4)
    assert conformance_probability(0.1, 0.01, -0.1, 0.1) == pytest.approx(0.5, abs=1e-9)


@pytest.mark.parametrize(
    ("error", "verdict"),
    [
        (0.0, Verdict.PASS),
        (0.1 - 1.66 * 0.01, Verdict.PASS),
        (0.1 - 1.63 * 0.01, Verdict.NOT_PROVEN),
        (0.1 + 1.63 * 0.01, Verdict.NOT_PROVEN),
        (0.1 + 1.66 * 0.01, Verdict.FAIL),
        (-0.1 - 1.66 * 0.01, Verdict.FAIL),
    ],
)
def test_near_one_limit_the_guard_band_is_1_645_standard_uncertainties(error: float, verdict: Verdict) -> None:
    assert decide_verdict(error, 0.02, -0.1, 0.1) is verdict


def test_an_uncertainty_as_wide_as_the_tolerance_never_passes() -> None:
    assert decide_verdict(0.0, 0.12, -0.1, 0.1) is Verdict.NOT_PROVEN


@pytest.mark.parametrize("error", [0.0, 0.1, 0.5])
def test_an_uncertainty_far_wider_than_the_tolerance_proves_nothing(error: float) -> None:
    assert decide_verdict(error, 100.0, -0.1, 0.1) is Verdict.NOT_PROVEN
    assert decide_verdict(error + 200.0, 100.0, -0.1, 0.1) is Verdict.FAIL


def test_a_value_without_uncertainty_is_not_proven_however_good_it_looks() -> None:
    assert decide_verdict(0.0, None, -0.1, 0.1) is Verdict.NOT_PROVEN
    assert decide_verdict(0.0, 0.0, -0.1, 0.1) is Verdict.NOT_PROVEN


def test_the_older_rule_keeps_the_whole_expanded_uncertainty_away_from_the_limits() -> None:
    assert decide_verdict(0.079, 0.02, -0.1, 0.1, "guard-band") is Verdict.PASS
    assert decide_verdict(0.081, 0.02, -0.1, 0.1, "guard-band") is Verdict.NOT_PROVEN
    assert decide_verdict(0.121, 0.02, -0.1, 0.1, "guard-band") is Verdict.FAIL


def test_simple_acceptance_does_not_look_at_the_uncertainty() -> None:
    assert decide_verdict(0.099, None, -0.1, 0.1, "simple") is Verdict.PASS
    assert decide_verdict(0.101, 5.0, -0.1, 0.1, "simple") is Verdict.FAIL


def test_every_rule_has_a_description() -> None:
    assert all("PASS" in text and "FAIL" in text for text in RULES.values())
