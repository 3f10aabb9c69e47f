"""The header of a report: how old the calibration was."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from measureapp.report.header import calibration_age

CALIBRATED = "2026-03-01T10:00:00+00:00"


@pytest.mark.parametrize(
    ("measured", "age"),
    [
        ("2026-03-01T10:12:00+00:00", "12 min"),
        ("2026-03-01T11:59:00+00:00", "119 min"),
        ("2026-03-01T15:00:00+00:00", "5 h"),
        ("2026-03-02T10:00:00+00:00", "24 h"),
        ("2026-03-11T10:00:00+00:00", "10 days"),
        ("no time", "–"),
    ],
)
def test_the_age_of_a_calibration_is_in_minutes_hours_or_days(measured: str, age: str) -> None:
    calibration = SimpleNamespace(provenance=SimpleNamespace(created=CALIBRATED))
    measurement: Any = SimpleNamespace(calibration=calibration, measured_at=measured)
    assert calibration_age(measurement) == age
