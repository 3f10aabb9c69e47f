"""The ground truth of a simulated rig is shown beside results, and nothing that measures reads it."""

from __future__ import annotations

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
READERS = {"measureapp/demo.py", "ui/controllers/rig_connection.py"}  # to show it
SIMULATION = ("measureapp/simulate/", "measureapp/pattern_trial.py")


def test_only_the_demo_and_the_result_page_read_the_truth_of_a_rig() -> None:
    found = set()
    for room in ("measureapp", "ui"):
        for path in sorted((ROOT / room).rglob("*.py")):
            place = path.relative_to(ROOT).as_posix()
            if place.startswith(SIMULATION):
                continue
            calls = (node for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))) if isinstance(node, ast.Call))
            if any(isinstance(call.func, ast.Attribute) and call.func.attr == "truth" for call in calls):
                found.add(place)
    assert found == READERS
