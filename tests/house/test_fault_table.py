"""The table of injected faults names every row of the list, and tests that exist."""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
TABLE = ROOT / "resources/docs/faults.md"
ROWS = {"D": 9, "M": 8, "R": 7, "N": 4}
NAMED = re.compile(r"`(tests/[\w/]+\.py)::(test_\w+)`")


def test_every_row_has_an_outcome_and_a_test() -> None:
    text = TABLE.read_text(encoding="utf-8")
    lines = {line.split("|")[1].strip(): line for line in text.splitlines() if line.startswith("| ")}
    wanted = {f"{letter}{number}" for letter, count in ROWS.items() for number in range(1, count + 1)}
    assert wanted <= set(lines)
    assert all(NAMED.search(lines[row]) for row in wanted)


def test_every_test_that_the_table_names_exists() -> None:
    missing = []
    for path, name in NAMED.findall(TABLE.read_text(encoding="utf-8")):
        file = ROOT / path
        functions = (
            {node.name for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))) if isinstance(node, ast.FunctionDef)}
            if file.is_file()
            else set()
        )
        if name not in functions:
            missing.append(f"{path}::{name}")
    assert not missing
