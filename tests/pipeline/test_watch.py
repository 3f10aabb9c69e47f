"""What a profile says a stage used."""

from __future__ import annotations

import subprocess
import sys

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
            np.tile(written, 10).sum()
    saving, thinking = watch.use["saving"], watch.use["thinking"]
    assert saving.written_mb == pytest.approx(20, rel=0.05) or saving.written_mb == 0  # systems that count no traffic
    assert thinking.written_mb < 1
    assert thinking.processor_s > 0
    assert thinking.peak_memory_mb > saving.peak_memory_mb + 150
    assert watch.seconds.keys() == watch.use.keys()
    assert watch.lines()[0].startswith("stage") and len(watch.lines()) == 4


def test_an_error_within_a_stage_ends_it():
    with Profile() as watch, pytest.raises(ValueError, match="gone"), watch.stage("clouds"):
        raise ValueError("gone")
    assert watch.document()["clouds"]["wall_s"] >= 0


BUSY = """
import time
held, start = bytearray(200_000_000), time.process_time()
while time.process_time() < start + 1.0:
    held[:: 4096] = bytes(len(held[:: 4096]))
"""


def test_a_program_that_a_stage_starts_counts_with_its_processor_time_and_memory():
    with Profile() as watch:
        with watch.stage("surface"):
            subprocess.run([sys.executable, "-c", BUSY], check=True)
        with watch.stage("report"):
            pass
    assert watch.use["surface"].processor_s >= 1.0
    assert watch.use["surface"].peak_memory_mb > watch.use["report"].peak_memory_mb + 150
    assert watch.use["report"].processor_s < 0.5


def test_the_whole_is_what_all_stages_and_the_time_between_them_used():
    with Profile() as watch, watch.stage("thinking"):
        np.sort(np.random.default_rng(1).random(1_000_000))
    whole, part = watch.use["whole"], watch.use["thinking"]
    assert whole.wall_s >= part.wall_s and whole.processor_s >= part.processor_s and whole.peak_memory_mb >= part.peak_memory_mb
