"""What a profile says a stage used."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.pipeline.watch import Profile, Stopwatch


def test_stages_of_one_name_are_added_up():
    watch = Stopwatch()
    for _ in range(2):
        with watch.stage("clouds"):
            pass
    assert list(watch.seconds) == ["clouds"]


def test_a_profile_states_processor_time_peak_memory_and_traffic(tmp_path):
    written = np.random.default_rng(1).integers(0, 255, 20_000_000, dtype=np.uint8)
    with Profile() as watch:
        with watch.stage("saving"):
            (tmp_path / "data").write_bytes(written.tobytes())
        with watch.stage("thinking"):
            np.sort(np.tile(written, 10))
    saving, thinking = watch.use["saving"], watch.use["thinking"]
    assert saving.written_mb == pytest.approx(20, rel=0.05) or saving.written_mb == 0  # systems that count no traffic
    assert thinking.written_mb < 1
    assert thinking.processor_s > 0
    assert thinking.peak_memory_mb > saving.peak_memory_mb + 150
    assert watch.seconds.keys() == watch.use.keys()
    assert watch.lines()[0].startswith("stage") and len(watch.lines()) == 3


def test_an_error_within_a_stage_ends_it():
    with Profile() as watch, pytest.raises(ValueError, match="gone"), watch.stage("clouds"):
        raise ValueError("gone")
    assert watch.document()["clouds"]["wall_s"] >= 0
