"""Edits of single entries of an inspection program as text; comments and layout of everything else stay."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from typing import Any

from measureapp.errors import InputError
from measureapp.project.program_file import parse_program
from measureapp.project.program_text import Value, format_value

HEAD = re.compile(r"^\[\[(features|dimensions)\]\]", re.MULTILINE)
TABLE = re.compile(r"^\[", re.MULTILINE)  # the next table, of the entry or after it
BEFORE = re.compile(r"(?:^[ \t]*#[^\n]*\n)+\Z", re.MULTILINE)  # comment lines directly before an entry belong to it


def change_entry(text: str, name: str, values: Mapping[str, Value | None]) -> str:
    """Set keys of the dimension or feature ``name``; None removes a key.

    Raises
    ------
    InputError
        There is no such entry, or the changed program is invalid.

    >>> change_entry('name = "a"\\n[[features]]\\nname = "f"\\nshape = "sphere"\\npoint_mm = [0, 0, 0]\\nradius_mm = 5.0\\n', "f", {"radius_mm": 6})
    'name = "a"\\n[[features]]\\nname = "f"\\nshape = "sphere"\\npoint_mm = [0, 0, 0]\\nradius_mm = 6.0\\n'
    """
    parts = split_entries(text)
    place = _place_of(parts, name)
    for key, value in values.items():
        parts[place] = _set_key(parts[place], key, value)
    return _checked("".join(parts))


def duplicate_entry(text: str, name: str, new_name: str) -> str:
    """Insert a copy of an entry behind it, with another name. Raises InputError as `change_entry`."""
    parts = split_entries(text)
    place = _place_of(parts, name)
    copied = _set_key(parts[place][_head_of(parts[place]) :], "name", new_name)
    if not parts[place].endswith("\n\n"):
        parts[place] = parts[place].rstrip("\n") + "\n\n"
    parts.insert(place + 1, copied)
    return _checked("".join(parts))


def move_entry(text: str, name: str, steps: int) -> str:
    """Move an entry among those of its kind: up with negative ``steps``; at the end it stays. Raises InputError as `change_entry`."""
    parts = [part if part.endswith("\n\n") else part.rstrip("\n") + "\n\n" for part in split_entries(text)]
    place = _place_of(parts, name)
    kind = _kind_of(parts[place])
    alike = [number for number, part in enumerate(parts) if _kind_of(part) == kind]
    now = alike.index(place)
    goal = alike[min(max(0, now + steps), len(alike) - 1)]
    parts.insert(goal, parts.pop(place))
    return _checked("".join(parts).rstrip("\n") + "\n")


def set_table(text: str, table: str, values: Mapping[str, Value] | None) -> str:
    """Replace a table or value of the whole program, such as `alignment`; None removes it. Raises InputError as `change_entry`."""
    parts = split_entries(text)
    top = re.sub(rf"(?ms)^\[{re.escape(table)}(?:\.[^\]]*)?\][ \t]*\n.*?(?=^\[|\Z)", "", parts[0])
    start = TABLE.search(top)
    head, rest = (top, "") if start is None else (top[: start.start()], top[start.start() :])
    head = _set_key(head, table, None)
    if values is not None:
        lines = "\n".join((f"[{table}]", *(f"{key} = {format_value(value)}" for key, value in values.items())))
        rest = f"{rest.rstrip()}\n\n{lines}\n\n".lstrip("\n")
    parts[0] = f"{head.rstrip()}\n\n{rest}" if rest else head
    return _checked("".join(parts))


def split_entries(text: str) -> list[str]:
    """Return the head of a program and its entries with the comments directly before them; joined they are the text."""
    starts = []
    for found in HEAD.finditer(text):
        comment = BEFORE.search(text[: found.start()])
        starts.append(found.start() if comment is None else comment.start())
    edges = [0, *starts, len(text)]
    return [text[low:high] for low, high in zip(edges, edges[1:], strict=False)]


def _checked(text: str) -> str:
    parse_program(text)
    return text


def _head_of(part: str) -> int:
    found = HEAD.search(part)
    return -1 if found is None else found.start()


def _kind_of(part: str) -> str:
    found = HEAD.search(part)
    return "" if found is None else found.group(1)


def _place_of(parts: list[str], name: str) -> int:
    for place, part in enumerate(parts):
        if _kind_of(part) and _values(part).get("name") == name:
            return place
    raise InputError(
        f"The inspection program has no entry {name!r} that can be changed here.", "Change it in the program's text, by Program…."
    )


def _values(part: str) -> dict[str, Any]:
    entries: list[dict[str, Any]] = tomllib.loads(part)[_kind_of(part)]
    return entries[0]


def _set_key(part: str, key: str, value: Value | None) -> str:
    """Set a key in the first table of a part; a comment behind its value stays."""
    start = _head_of(part)
    below = part.index("\n", start) + 1 if start >= 0 else 0
    end = TABLE.search(part, below)
    last = len(part) if end is None else end.start()
    body = part[below:last]
    found = re.search(rf"(?m)^[ \t]*{re.escape(key)}[ \t]*=", body)
    if found is None and value is None:
        return part
    line = "" if value is None else f"{key} = {format_value(value)}"
    if found is None:
        named = re.search(r"(?m)^[ \t]*name[ \t]*=[^\n]*\n", body)
        at = named.end() if named is not None and key != "name" else 0
        at = _after_last_key(body) if key not in ("name",) and start >= 0 else at
        body = f"{body[:at]}{'' if not at or body[:at].endswith(chr(10)) else chr(10)}{line}\n{body[at:]}"
    else:
        stop, comment = _extent(body, found.start())
        body = body[: found.start()] + (f"{line}{comment}\n" if value is not None else "") + body[stop:]
    return part[:below] + body + part[last:]


def _after_last_key(body: str) -> int:
    """Return the end of the last line that is neither empty nor a comment."""
    end, place = 0, 0
    for line in body.splitlines(keepends=True):
        place += len(line)
        if line.strip() and not line.lstrip().startswith("#"):
            end = place
    return end


def _extent(body: str, start: int) -> tuple[int, str]:
    """Return the end of the value that starts at a line of ``body``, and the comment behind it."""
    stop = start
    while stop < len(body):
        following = body.find("\n", stop)
        stop = len(body) if following < 0 else following + 1
        try:
            tomllib.loads(body[start:stop])
        except tomllib.TOMLDecodeError:
            continue
        break
    taken = body[start:stop].rstrip("\n")
    for mark in (place for place, letter in enumerate(taken) if letter == "#"):
        try:
            tomllib.loads(taken[:mark])
        except tomllib.TOMLDecodeError:
            continue
        return stop, "  " + taken[mark:]
    return stop, ""
