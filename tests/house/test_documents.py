"""The documents name only what is there, and all of it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.core import TyperGroup
from typer.main import get_command

from measureapp.cli.main import build

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "resources/docs/commands.md")
TOP = ("measureapp", "ui", "plugins", "resources", "tests", "installer", ".ci")


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_path_a_document_names_exists(document: str) -> None:
    quoted = re.findall(r"`([\w./-]+)`", (ROOT / document).read_text(encoding="utf-8"))
    paths = [name for name in quoted if name.split("/")[0] in TOP and "/" in name]
    assert not [path for path in paths if not (ROOT / path).exists()]


def test_the_map_shows_every_room_and_where_to_start_in_it() -> None:
    text = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
    rooms = [path.parent.name for top in ("measureapp", "ui") for path in (ROOT / top).glob("*/__init__.py")]
    assert not [room for room in rooms if f"{room}/" not in text]
    for room, files in re.findall(r"^\| `(\w+)/` \|.*\| ([^|]*) \|$", text, flags=re.MULTILINE):
        assert not [name for name in re.findall(r"`([\w.]+)`", files) if not (ROOT / "measureapp" / room / name).is_file()], room


def commands(group: TyperGroup, prefix: str = "") -> Iterator[str]:
    for name, command in group.commands.items():
        if isinstance(command, TyperGroup):
            yield from commands(command, f"{prefix}{name} ")
        else:
            yield prefix + name


def test_the_list_of_commands_is_complete() -> None:
    listed = re.findall(
        r"^\| `([a-z -]+)` \|", (ROOT / "resources" / "docs" / "commands.md").read_text(encoding="utf-8"), flags=re.MULTILINE
    )
    group = get_command(build())
    assert isinstance(group, TyperGroup)
    assert set(listed) == set(commands(group))
