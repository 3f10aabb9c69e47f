"""Teaching an axis: scale and sense are recovered from what a person reads, and nonsense is refused in words."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from measureapp.devices.teaching import TeachingStep, teach
from measureapp.errors import InputError


@given(
    true_scale=st.floats(1.0, 1e5),
    wrong_by=st.floats(0.2, 5.0),
    true_sense=st.sampled_from([1, -1]),
    assumed_sense=st.sampled_from([1, -1]),
    step=st.floats(1.0, 100.0),
    forward=st.booleans(),
)
def test_scale_and_sense_are_recovered_whatever_was_assumed(true_scale, wrong_by, true_sense, assumed_sense, step, forward) -> None:
    commanded = TeachingStep.of_units(step if forward else -step, true_scale * wrong_by, assumed_sense)
    travel = true_sense * commanded.counts / true_scale
    taught = teach(commanded, travel, "mm", reading_uncertainty=0.01)
    assert taught.counts_per_unit == pytest.approx(true_scale, rel=1e-12)
    assert taught.sense == true_sense


def test_the_scale_scatters_as_its_uncertainty_states() -> None:
    rng = np.random.default_rng(4)
    readings = 50.0 + rng.normal(0.0, 0.2, 2000)
    taught = [teach(TeachingStep(50_000.0, 1000.0), float(reading), "degree", 0.2) for reading in readings]
    scatter = np.std([one.counts_per_unit for one in taught]) / 1000.0
    assert scatter == pytest.approx(taught[0].relative_uncertainty, rel=5 / np.sqrt(2 * 2000))


def test_the_lines_are_toml_for_the_settings() -> None:
    lines = teach(TeachingStep(2000.0, 100.0), -10.0, "mm").settings_lines()
    assert tomllib.loads(lines) == {"counts_per_unit": 200.0, "sense": -1}
    assert lines == "counts_per_unit = 200.0\nsense = -1\n"


@pytest.mark.parametrize(
    ("step", "travel", "words"),
    [
        (TeachingStep(0.0, 100.0), 1.0, "commanded step is zero"),
        (TeachingStep(100.0, 100.0), 0.0, "observed travel is zero"),
        (TeachingStep(100.0, 100.0), float("nan"), "observed travel is nan"),
        (TeachingStep(float("inf"), 100.0), 1.0, "commanded step is inf"),
        (TeachingStep(100.0, 0.0), 1.0, "scale in use is zero"),
        (TeachingStep(100.0, -5.0), 1.0, "must be positive"),
        (TeachingStep(100.0, 100.0), 0.2, "too small for a reading uncertainty of 0.1 mm"),
        (TeachingStep(1000.0, 100.0), 100.0, r"commanded to move 10 mm and a travel of 100 mm .* more by a factor of 10"),
        (TeachingStep(1000.0, 100.0), -0.9, r"less by a factor of 11\.1"),
    ],
)
def test_nonsense_is_refused_in_words(step: TeachingStep, travel: float, words: str) -> None:
    with pytest.raises(InputError, match=words):
        teach(step, travel, "mm")


def test_a_scale_that_is_wrong_by_far_can_still_be_taught() -> None:
    with pytest.raises(InputError, match=r"set counts_per_unit = 10 and repeat"):
        teach(TeachingStep(1000.0, 100.0), 100.0, "mm")
    assert teach(TeachingStep(1000.0, 10.0), 100.0, "mm").counts_per_unit == 10.0
