"""Comparison of two JSON documents that should be identical."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

NOT_COMPARED = ("created", "folder", "arguments", "files")  # when and where, not what


@dataclass(frozen=True, slots=True)
class Difference:
    """One value that is not identical in both documents; None if missing."""

    place: str  # such as cameras.left.matrix[0][2]
    stored: Any
    again: Any


def compare_documents(stored: Any, again: Any) -> tuple[tuple[Difference, ...], int]:
    """Return all differences of two JSON documents and the number of values compared; dates and file locations are ignored."""
    first, second = dict(_values(stored, "")), dict(_values(again, ""))
    places = list(dict.fromkeys((*first, *second)))
    found = tuple(
        Difference(place, first.get(place), second.get(place))
        for place in places
        if place not in first or place not in second or not _same(first[place], second[place])
    )
    return found, len(places)


def _same(one: Any, other: Any) -> bool:
    return bool(type(one) is type(other) and one == other)


def _values(document: Any, place: str) -> Iterator[tuple[str, Any]]:
    if isinstance(document, Mapping):
        for name, value in document.items():
            if name not in NOT_COMPARED:
                yield from _values(value, f"{place}.{name}" if place else str(name))
    elif isinstance(document, list):
        yield f"{place} (length)", len(document)
        for index, value in enumerate(document):
            yield from _values(value, f"{place}[{index}]")
    else:
        yield place, document
