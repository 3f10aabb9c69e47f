"""Only `acquire` moves an axis or triggers a camera: everything else goes through its sessions."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MOTIONS = {"move_to", "move_joints"}  # of axes; finding the reference counts as one
EXPOSURES = {"arm", "trigger", "play", "next_frame", "set_exposure_us", "wait_ready"}  # of cameras and projector
HANDS = ("measureapp/acquire/", "measureapp/devices/", "measureapp/peers/")


def calls(path: Path) -> Iterator[tuple[str, int]]:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            finds_reference = node.func.attr == "home" and any(keyword.arg == "timeout_s" for keyword in node.keywords)
            yield "move_to" if finds_reference else node.func.attr, node.lineno


@pytest.mark.parametrize("room", ["measureapp", "ui"])
def test_no_other_room_moves_an_axis_or_triggers_a_camera(room: str) -> None:
    found = []
    for path in sorted((ROOT / room).rglob("*.py")):
        place = path.relative_to(ROOT).as_posix()
        if not place.startswith(HANDS):
            found += [f"{place}:{line} calls {name}" for name, line in calls(path) if name in MOTIONS | EXPOSURES]
    assert not found, "\n".join(found)


def test_the_rooms_that_may_do_so_do() -> None:
    names = {name for path in (ROOT / "measureapp/acquire").rglob("*.py") for name, _ in calls(path)}
    assert "move_to" in names
