"""The worst dimension decides, and comes first."""

from __future__ import annotations

import itertools

import pytest

from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.verdicts import part_verdict, used_tolerance, worst_first


def dimension(name: str, measured: float | None, verdict: Verdict) -> Dimension:
    return Dimension(name, 10.0, measured, None if measured is None else 0.01, -0.1, 0.3, verdict)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_part_passes_only_if_all_its_dimensions_with_a_tolerance_pass(count):
    for verdicts in itertools.product(Verdict, repeat=count):
        assert (part_verdict(verdicts) is Verdict.PASS) == (set(verdicts) - {Verdict.NO_TOLERANCE} == {Verdict.PASS})
        if Verdict.FAIL in verdicts:
            assert part_verdict(verdicts) is Verdict.FAIL


def test_a_part_without_dimensions_is_not_measured():
    assert part_verdict([]) is Verdict.NOT_MEASURED


def test_the_worst_comes_first_and_among_equals_the_one_farthest_out():
    found = (
        dimension("good", 10.1, Verdict.PASS),
        dimension("none", None, Verdict.NOT_MEASURED),
        dimension("out", 10.31, Verdict.FAIL),
        dimension("far out", 9.5, Verdict.FAIL),
        dimension("near", 10.299, Verdict.NOT_PROVEN),
    )
    assert [one.name for one in worst_first(found)] == ["far out", "out", "near", "none", "good"]


def test_the_share_of_the_tolerance_is_counted_from_its_middle():
    assert used_tolerance(dimension("middle", 10.1, Verdict.PASS)) == pytest.approx(0.0)
    assert used_tolerance(dimension("edge", 10.3, Verdict.PASS)) == pytest.approx(1.0)
