"""Changing an inspection program as text, so that what people wrote around an entry stays as it is."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping, Sequence

from measureapp.errors import InputError
from measureapp.project.program_file import program_from

HEAD = re.compile(r"^(?=\[\[(?:features|dimensions)\]\])", re.MULTILINE)  # where an entry of one of the lists begins
Value = str | float | Sequence[str] | Sequence[float] | Mapping[str, "Value"]


def entry(kind: str, values: Mapping[str, Value]) -> str:
    """Return the lines of one entry.

    >>> print(entry("features", {"name": "top", "grow": {"seed_mm": (1.0, 2.0, 0.5)}}))
    [[features]]
    name = "top"
    grow = { seed_mm = [1.0, 2.0, 0.5] }
    <BLANKLINE>
    """
    return "\n".join((f"[[{kind}]]", *(f"{name} = {_written(value)}" for name, value in values.items()), ""))


def with_entry(text: str, lines: str) -> str:
    """Return the program with one more entry at its end; raises InputError where it does not fit the others."""
    changed = f"{text.rstrip()}\n\n{lines}"
    program_from(changed)
    return changed


def without_entry(text: str, name: str) -> str:
    """Return the program without the feature or dimension of this name.

    Raises
    ------
    InputError
        There is none, or others rest on it; then the first of these is named.
    """
    parts = HEAD.split(text)
    kept = [part for part in parts if not (part.startswith("[[") and name in _names(part))]
    if len(kept) == len(parts):
        raise InputError(f"The inspection program has no entry {name!r}.", "Choose one of its features or dimensions.")
    changed = "".join(kept)
    program_from(changed)
    return changed


def _names(part: str) -> list[str]:
    """Return the name of the entry that a part of the text is."""
    entries = next(iter(tomllib.loads(part).values()))
    return [one.get("name") for one in entries]


def _written(value: Value) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{name} = {_written(one)}" for name, one in value.items()) + " }"
    if isinstance(value, Sequence):
        return "[" + ", ".join(_written(one) for one in value) + "]"
    return repr(float(value))
