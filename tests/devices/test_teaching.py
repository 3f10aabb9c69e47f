"""Scale and sense of an axis follow from one step that a person observes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from measureapp.devices.teaching import teach_scale
from measureapp.errors import InputError

SCALES = st.floats(1.0, 1e6)


@given(
    true=SCALES,
    assumed=st.floats(0.02, 50.0),
    true_sense=st.sampled_from((1, -1)),
    sense=st.sampled_from((1, -1)),
    step=st.floats(0.1, 10.0),
)
def test_the_true_scale_and_sense_are_found_from_any_start(true: float, assumed: float, true_sense: int, sense: int, step: float) -> None:
    counts_per_unit = true * assumed
    counts = sense * step * counts_per_unit  # what the drive is sent
    observed = true_sense * counts / true  # where it really goes
    found = teach_scale(step, observed, counts_per_unit, sense)
    assert found.counts_per_unit == pytest.approx(true)
    assert found.sense == true_sense


def test_an_axis_that_fits_keeps_its_settings() -> None:
    assert teach_scale(1.0, 1.0, 100.0, -1).lines() == "counts_per_unit = 100\nsense = -1"


@pytest.mark.parametrize(
    ("commanded", "observed", "words"),
    [
        (1.0, 0.0, "did not move"),
        (0.0, 1.0, "other than zero"),
        (1.0, float("nan"), "other than zero"),
        (1.0, 250.0, "order of magnitude"),
        (1.0, 1e-4, "order of magnitude"),
    ],
)
def test_nonsense_is_refused_in_words(commanded: float, observed: float, words: str) -> None:
    with pytest.raises(InputError, match=words):
        teach_scale(commanded, observed, 100.0, 1)
