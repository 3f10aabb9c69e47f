"""Settings of operator mode: shifts, durations, folders."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from measureapp.errors import StorageError
from measureapp.project.operator_settings import KEPT_TIMES, OperatorSettings, read_operator_settings, write_operator_settings


@pytest.mark.parametrize(
    ("now", "start"),
    [((6, 0), (24, 6)), ((13, 59), (24, 6)), ((14, 0), (24, 14)), ((23, 0), (24, 22)), ((3, 0), (23, 22)), ((0, 0), (23, 22))],
)
def test_a_shift_begins_at_the_last_of_its_times_also_after_midnight(now, start):
    found = OperatorSettings().shift_start(datetime(2026, 11, 24, *now, tzinfo=UTC))
    assert (found.day, found.hour) == start


def test_the_usual_duration_is_the_median_of_the_last_runs():
    settings = OperatorSettings()
    assert settings.usual_seconds("cross") is None
    for seconds in (500.0, *([60.0] * (KEPT_TIMES - 1)), 62.0):
        settings = settings.with_duration("cross", seconds)
    assert settings.usual_seconds("cross") == 60.0 and len(settings.seconds["cross"]) == KEPT_TIMES


def test_settings_come_back_and_damaged_ones_are_refused(tmp_path):
    file = tmp_path / "operator.json"
    assert read_operator_settings(file) == OperatorSettings()
    changed = OperatorSettings(idle_minutes=3, shift_starts=("05:00",)).with_duration("cross", 61.0)
    write_operator_settings(file, changed)
    assert read_operator_settings(file) == changed
    file.write_text('{"idle_minutes": -1}')
    with pytest.raises(StorageError, match="idle_minutes"):
        read_operator_settings(file)
