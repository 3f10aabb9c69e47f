"""Editing of inspection programs as text, which preserves comments and layout."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping, Sequence

from measureapp.errors import InputError
from measureapp.project.program_file import parse_program

HEAD = re.compile(r"^(?=\[\[(?:features|dimensions|alignments)\]\])", re.MULTILINE)  # start of an entry of one of the lists
Value = str | float | Sequence["Value"] | Mapping[str, "Value"]


def format_entry(kind: str, values: Mapping[str, Value]) -> str:
    """Format one entry as TOML.

    >>> print(format_entry("features", {"name": "top", "grow": {"seed_mm": (1.0, 2.0, 0.5)}}))
    [[features]]
    name = "top"
    grow = { seed_mm = [1.0, 2.0, 0.5] }
    <BLANKLINE>
    """
    return "\n".join((f"[[{kind}]]", *(f"{name} = {format_value(value)}" for name, value in values.items()), ""))


def add_entry(text: str, lines: str) -> str:
    """Append an entry to the program; raises InputError when it conflicts with the others."""
    changed = f"{text.rstrip()}\n\n{lines}"
    parse_program(changed)
    return changed


def remove_entry(text: str, name: str) -> str:
    """Remove the feature or dimension of this name from the program.

    Raises
    ------
    InputError
        There is none, or other entries use it; names the first of them.
    """
    parts = HEAD.split(text)
    kept = [part for part in parts if not (part.startswith("[[") and name in _names(part))]
    if len(kept) == len(parts):
        raise InputError(f"The inspection program has no entry {name!r}.", "Choose one of its features or dimensions.")
    changed = "".join(kept)
    parse_program(changed)
    return changed


def _names(part: str) -> list[str]:
    """Return the names of the entries in a part of the text."""
    entries = next(iter(tomllib.loads(part).values()))
    return [one.get("name") for one in entries]


def format_value(value: Value) -> str:
    """Format a value as TOML in one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{name} = {format_value(one)}" for name, one in value.items()) + " }"
    if isinstance(value, Sequence):
        return "[" + ", ".join(format_value(one) for one in value) + "]"
    return repr(value) if isinstance(value, int) else repr(float(value))
