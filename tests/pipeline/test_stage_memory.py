"""Memory of the stages after the clouds, in a program of its own."""

from __future__ import annotations

from pathlib import Path

from tests.stage_memory import SURROUNDINGS, run

VIEWS, STEP_MM = 4, 0.2
MOST_BYTES = 160  # of a point, its cloud included: 53 are the cloud, up to 53 what is left of it; placing all views at once took 192


def test_surroundings_are_excluded_without_a_copy_of_all_views(tmp_path: Path) -> None:
    found = run(VIEWS, STEP_MM, tmp_path, SURROUNDINGS)
    stages, points = found["stages"], found["points"]
    assert points > 1_000_000
    assert found["excluded"]["table"] > 0.2 * points
    assert stages[SURROUNDINGS]["peak"] - stages["program"]["peak"] < MOST_BYTES * points
