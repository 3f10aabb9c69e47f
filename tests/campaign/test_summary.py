"""Coverage of the truth by stated uncertainties, over many jobs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.campaign.jobs import Finished
from measureapp.campaign.summary import coverage, summary_document, summary_lines


def measured(name, errors, uncertainty):
    true = [{"name": f"d{n}", "error": error, "uncertainty": uncertainty} for n, error in enumerate(errors)]
    return Finished(name, Path(name), True, {"true_dimensions": true, "dimensions": []})


def test_errors_of_known_spread_are_covered_as_often_as_they_should_be():
    generator = np.random.default_rng(4)
    jobs = [measured(f"gypsum-good-{seed}", generator.normal(scale=0.01, size=5), 0.02) for seed in range(200)]
    (found,) = coverage(jobs)
    assert (found.group, found.measurements, found.dimensions) == ("gypsum-good", 200, 1000)
    assert found.lowest < 0.9545 < found.highest  # of a normal distribution within two standard deviations
    assert found.highest - found.lowest < 0.03
    assert found.rms_error_over_u == pytest.approx(0.5, rel=0.05)


def test_groups_are_parts_on_rigs_and_angles_do_not_count():
    angled = Finished(
        "gear-bad-1",
        Path("x"),
        False,
        {
            "true_dimensions": [{"name": "a", "error": 0.5, "uncertainty": 0.1}, {"name": "b", "error": 0.01, "uncertainty": 0.1}],
            "dimensions": [{"name": "a", "unit": "°"}, {"name": "b", "unit": "mm"}],
        },
    )
    found = coverage([measured("gypsum-good-1", [0.1], 0.2), measured("gypsum-bad-1", [0.3], 0.2), angled])
    assert [(one.group, one.dimensions, one.inside) for one in found] == [("gypsum-good", 1, 1), ("gypsum-bad", 1, 0), ("gear-bad", 1, 1)]
    assert (found[0].highest, found[1].lowest) == (1.0, 0.0)


def test_a_job_without_a_result_is_named_with_its_reason():
    jobs = [measured("gypsum-good-1", [0.1], 0.2), Finished("lost", Path("lost"), False, problem="No images. Scan first.")]
    assert summary_document(jobs)["failed"] == {"lost": "No images. Scan first."}
    assert "2 jobs: 1 passed, 1 without a result." in summary_lines(jobs)[0]
    assert "lost: No images. Scan first." in summary_lines(jobs)[1]
