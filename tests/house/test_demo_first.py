"""The first file that asks for the demo is begun before all others."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import demo_first


@dataclass(frozen=True)
class Item:
    name: str
    path: Path
    fixturenames: tuple[str, ...] = ()


def test_the_first_file_that_asks_for_the_demo_comes_first_and_the_others_keep_their_order() -> None:
    a, b, c = (Path(f"tests/{room}/test_it.py") for room in "abc")
    items = [Item("1", a), Item("2", b), Item("3", b, ("demo",)), Item("4", c, ("demo",)), Item("5", c)]
    demo_first.pytest_collection_modifyitems(items)
    assert [item.name for item in items] == ["2", "3", "1", "4", "5"]


def test_without_the_demo_nothing_moves() -> None:
    items = [Item("1", Path("tests/b/test_it.py")), Item("2", Path("tests/a/test_it.py"))]
    demo_first.pytest_collection_modifyitems(items)
    assert [item.name for item in items] == ["1", "2"]
