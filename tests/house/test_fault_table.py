"""The table of faults has every row, and names only tests that exist."""

from __future__ import annotations

import ast
import re
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLE = (ROOT / "resources" / "docs" / "faults.md").read_text(encoding="utf-8")
ROWS = [f"{group}{number}" for group, last in (("D", 9), ("M", 8), ("R", 7), ("N", 4)) for number in range(1, last + 1)]


@cache
def names_in(path: str) -> frozenset[str]:
    tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))
    return frozenset(node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"))


def test_every_row_is_there_with_what_is_injected_the_outcome_and_a_test() -> None:
    found = {cells[1]: cells for line in TABLE.splitlines() if len(cells := [cell.strip() for cell in line.split("|")]) == 6}
    assert not [row for row in ROWS if row not in found]
    assert not [row for row in ROWS if not all(found[row][2:5]) or "::test_" not in found[row][4]]


def test_every_test_named_exists() -> None:
    named = re.findall(r"`(tests/[\w/]+\.py)::(\w+)`", TABLE)
    assert len(named) > len(ROWS)
    assert not [f"{path}::{name}" for path, name in named if not (ROOT / path).is_file() or name not in names_in(path)]
