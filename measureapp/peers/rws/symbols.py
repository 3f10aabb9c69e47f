"""RAPID data of a loaded module: declarations read from its text, values kept as the controller keeps them."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

DECLARATION = re.compile(r"^\s*(PERS|CONST|VAR)\s+(\w+)\s+(\w+)\s*:=\s*(.+?);\s*$", re.MULTILINE | re.IGNORECASE)
TOKEN = re.compile(r'\s*(\[|\]|,|"(?:[^"]|"")*"|TRUE|FALSE|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*', re.IGNORECASE)
UNUSED = float(np.float32(9e9))  # of an external axis that is not there
Value = float | bool | str | list["Value"]


@dataclass
class Symbol:
    """One data object."""

    storage: str  # PERS, CONST or VAR
    type: str
    value: Value


class Symbols:
    """The data of one module, by lower-case name: RAPID does not distinguish upper and lower case."""

    def __init__(self, module_text: str) -> None:
        self._symbols = {
            name.lower(): Symbol(storage.upper(), kind, parse(text)) for storage, kind, name, text in DECLARATION.findall(module_text)
        }

    def find(self, name: str) -> Symbol | None:
        """Return the data object ``name``."""
        return self._symbols.get(name.lower())

    def persistents(self) -> dict[str, Symbol]:
        """Return the PERS objects by name."""
        return {name: symbol for name, symbol in self._symbols.items() if symbol.storage == "PERS"}

    def text(self, name: str) -> str:
        """Return the value of ``name`` as RAPID text; raises KeyError."""
        return write(self._symbols[name].value)

    def number(self, name: str) -> float:
        """Return the num ``name``."""
        value = self._symbols[name].value
        assert isinstance(value, float)
        return value

    def record(self, name: str) -> list[Value]:
        """Return a copy of the components of the record ``name``."""
        value = self._symbols[name].value
        assert isinstance(value, list)
        return list(value)

    def put(self, name: str, value: Value) -> None:
        """Set ``name`` from the program."""
        self._symbols[name].value = rounded(value)


def parse(text: str) -> Value:
    """Read a RAPID value; raises ValueError."""
    value, rest = _read(text)
    if rest.strip():
        raise ValueError(f"{rest!r} follows the value")
    return rounded(value)


def same_shape(one: Value, other: Value) -> bool:
    """Whether two values have the same type."""
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(same_shape(a, b) for a, b in zip(one, other, strict=True))
    return type(one) is type(other)


def rounded(value: Value) -> Value:
    """Round numbers to the 23 bits of a num."""
    if isinstance(value, list):
        return [rounded(item) for item in value]
    return value if isinstance(value, bool | str) else float(np.float32(value))


def write(value: Value) -> str:
    """Write a value as the controller does."""
    if isinstance(value, list):
        return "[" + ",".join(write(item) for item in value) + "]"
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    if isinstance(value, str):
        return '"' + value.replace('"', '""') + '"'
    return "9E+09" if value == UNUSED else f"{value:.7g}"


def _read(text: str) -> tuple[Value, str]:
    match = TOKEN.match(text)
    if match is None:
        raise ValueError(f"{text[:20]!r} is no RAPID value")
    token, rest = match.group(1), text[match.end() :]
    if token == "[":
        return _read_list(rest)
    if token.startswith('"'):
        return token[1:-1].replace('""', '"'), rest
    if token.upper() in ("TRUE", "FALSE"):
        return token.upper() == "TRUE", rest
    if token in ("]", ","):
        raise ValueError(f"{token!r} is out of place")
    return float(token), rest


def _read_list(text: str) -> tuple[Value, str]:
    items: list[Value] = []
    while True:
        item, text = _read(text)
        items.append(item)
        match = TOKEN.match(text)
        if match is None or match.group(1) not in ("]", ","):
            raise ValueError("a bracket is not closed")
        text = text[match.end() :]
        if match.group(1) == "]":
            return items, text
