"""Conformance decisions by ISO 14253-1, and the decision rules in words."""

from __future__ import annotations

from scipy.special import ndtr

from measureapp.data.dimension import Verdict
from measureapp.inspection.settings import VerdictRule

CONFORMANCE_PROBABILITY = 0.95
COVERAGE_FACTOR = 2.0

RULES: dict[VerdictRule, str] = {
    "iso-14253-1:2017": (
        "ISO 14253-1:2017: PASS when the true value lies within the tolerance with a probability of at least 95 %, "
        "FAIL when it lies beyond one limit with at least 95 %, otherwise NOT PROVEN. Uncertainties are expanded, k = 2."
    ),
    "guard-band": (
        "ISO 14253-1 with a guard band of the expanded uncertainty (k = 2): PASS inside the tolerance reduced by it, "
        "FAIL outside the tolerance widened by it, otherwise NOT PROVEN."
    ),
    "simple": "Simple acceptance: PASS within the tolerance, FAIL outside; the uncertainty (k = 2) is stated but not subtracted.",
}


def decide_verdict(
    error: float, expanded_uncertainty: float | None, lower: float, upper: float, rule: VerdictRule = "iso-14253-1:2017"
) -> Verdict:
    """Decide the conformance of a deviation with its tolerance.

    Parameters
    ----------
    deviation : measured minus nominal
    expanded_uncertainty : k = 2; None or zero allows the simple rule only
    lower, upper : tolerance as deviations from nominal

    >>> decide_verdict(0.05, 0.02, -0.1, 0.1), decide_verdict(0.095, 0.02, -0.1, 0.1), decide_verdict(0.15, 0.02, -0.1, 0.1)
    (<Verdict.PASS: 'pass'>, <Verdict.NOT_PROVEN: 'not proven'>, <Verdict.FAIL: 'fail'>)
    """
    if rule == "simple":
        return Verdict.PASS if lower <= error <= upper else Verdict.FAIL
    if expanded_uncertainty is None or expanded_uncertainty <= 0:
        return Verdict.NOT_PROVEN
    if rule == "guard-band":
        return _by_guard_band(error, expanded_uncertainty, lower, upper)
    sigma = expanded_uncertainty / COVERAGE_FACTOR
    if conformance_probability(error, sigma, lower, upper) >= CONFORMANCE_PROBABILITY:
        return Verdict.PASS
    # each limit alone: with a tolerance far narrower than the uncertainty, even its centre would fail against both together
    beyond_one = float(ndtr(max(lower - error, error - upper) / sigma))
    return Verdict.FAIL if beyond_one >= CONFORMANCE_PROBABILITY else Verdict.NOT_PROVEN


def conformance_probability(error: float, standard_uncertainty: float, lower: float, upper: float) -> float:
    """Return the probability that the true deviation is within the tolerance, for a normal distribution (JCGM 106)."""
    return float(ndtr((upper - error) / standard_uncertainty) - ndtr((lower - error) / standard_uncertainty))


def _by_guard_band(error: float, expanded: float, lower: float, upper: float) -> Verdict:
    if lower + expanded <= error <= upper - expanded:
        return Verdict.PASS
    return Verdict.FAIL if error < lower - expanded or error > upper + expanded else Verdict.NOT_PROVEN
