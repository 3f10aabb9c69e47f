"""Fonts of documents: those that come with the program, and which letters they have."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from measureapp.resources import resource

FAMILIES = ("Noto Sans", "Noto Sans CJK SC", "Noto Sans Symbols 2", "Noto Sans Symbols2", "Noto Sans Symbols", "Noto Sans Math")
CHARACTERS = "characters.txt"


def font_folder() -> Path:
    """Return the folder of the fonts."""
    return resource("fonts")


@cache
def covered() -> frozenset[int]:
    """Return the code points that the fonts have."""
    found: set[int] = set()
    for line in (font_folder() / CHARACTERS).read_text(encoding="ascii").split():
        first, _, last = line.partition("-")
        found.update(range(int(first, 16), int(last or first, 16) + 1))
    return frozenset(found)


def missing_letters(texts: Iterable[str]) -> frozenset[str]:
    """Return the letters of ``texts`` that the fonts lack."""
    known = covered()
    return frozenset(letter for letter in set().union(*map(set, texts)) if ord(letter) not in known and letter not in "\n\t")


def spell_out(value: Any, letters: frozenset[str]) -> Any:
    r"""Return a JSON value with ``letters`` replaced by their code points, so that none vanishes.

    >>> spell_out({"name": "a\u2603"}, frozenset("\u2603"))
    {'name': 'a[U+2603]'}
    """
    if isinstance(value, str):
        return "".join(f"[U+{ord(letter):04X}]" if letter in letters else letter for letter in value) if letters else value
    if isinstance(value, Mapping):
        return {key: spell_out(item, letters) for key, item in value.items()}
    return [spell_out(item, letters) for item in value] if isinstance(value, (list, tuple)) else value


def is_invisible(letter: str) -> bool:
    """Whether a letter draws nothing, such as a mark that reverses the direction of what follows."""
    return unicodedata.category(letter) in ("Cc", "Cf", "Cs", "Co", "Cn")


def every_text(value: Any) -> Iterable[str]:
    """Yield all texts of a JSON value."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from every_text(item)
    elif isinstance(value, (list, tuple)):
        for item in value:
            yield from every_text(item)
