"""The table of processor time by room: it adds up every test of every process, and names the room that outgrew its share."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
import room_times

TESTS = Path(__file__).resolve().parents[1]
BUSY = """
import time

def test_busy():
    end = time.process_time() + {seconds}
    while time.process_time() < end:
        pass
"""
CONFTEST = """
import room_times

room_times.BUDGET_S, room_times.SHOWN_S = 4.0, 0.1
pytest_plugins = ["room_times"]
"""


@pytest.mark.parametrize("processes", [[], ["-n", "2"]], ids=["one process", "two processes"])
def test_the_time_of_each_room_is_added_up_and_an_excess_named(tmp_path: Path, processes: list[str]) -> None:
    (tmp_path / "pytest.ini").write_text("[pytest]\ntestpaths = tests\n")
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests/conftest.py").write_text(CONFTEST)
    for room, seconds in (("long", 0.6), ("short", 0.2)):
        (tmp_path / "tests" / room).mkdir()
        (tmp_path / "tests" / room / f"test_{room}.py").write_text(BUSY.format(seconds=seconds))
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:dash", "--import-mode=importlib", *processes]
    run = subprocess.run(command, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(TESTS)}, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    lines = {line.split()[0]: line for line in run.stdout.splitlines() if line.startswith(("long", "short", "all rooms"))}
    took = {name: float(line.removeprefix("all rooms").split(" s")[0].split()[-1]) for name, line in lines.items()}
    assert took["long"] >= 0.6 and 0.2 <= took["short"] < took["long"]
    assert took["all"] == pytest.approx(took["long"] + took["short"], abs=0.11)
    assert "more than its share of 0 s" in lines["long"]
    assert "share" not in lines["all"]


def test_rooms_are_sorted_and_a_short_one_is_left_out() -> None:
    lines = room_times.table(Counter({"fringe": 20.0, "calibrate": 130.0, "data": 1.0}))
    assert [line.split()[0] for line in lines] == ["calibrate", "fringe", "all"]
    assert "more than its share of 120 s" in lines[0] and "share" not in lines[1] and "151.0 s of 1200 s" in lines[2]


def test_a_file_in_no_folder_is_a_room_of_its_own() -> None:
    assert room_times.room_of("tests/ui/plan/test_form.py::test_x[a::b]") == "ui"
    assert room_times.room_of("tests/test_arrays.py::test_x") == "test_arrays.py"
