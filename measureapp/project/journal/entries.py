"""Entries of the journal: what happened, which files it concerns, and the hash that chains it to the entries before."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

CHAIN_START = "0" * 64


@dataclass(frozen=True, slots=True)
class FileState:
    """Content of a file, as its size and SHA-256.

    Image files begin with a short header, which is kept as it is in ``head``; the hash is then that of the bytes behind it, which are
    the raw pixels. So the pixels are hashed once, and every byte of the file is covered.
    """

    size: int
    sha256: str
    head: str = ""  # hexadecimal
    part: str = ""  # path of the temporary file that takes the place of this one, relative to the project

    def same_content(self, other: FileState) -> bool:
        """Whether both are the same bytes."""
        return (self.size, self.sha256, self.head) == (other.size, other.sha256, other.head)


Files = Mapping[str, FileState | None]
"""Path relative to the project, with slashes → its content; None: removed."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One thing that happened to a project, before it is numbered and chained."""

    kind: str  # such as "viewpoint stored"
    files: Files = field(default_factory=dict)
    viewpoint: str = ""
    note: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Line:
    """An entry as it stands in the journal."""

    number: int  # from 1, without gaps
    at: str  # UTC, ISO 8601
    entry: Entry
    chain: str  # hash of this line and the hash before it


def content_of(entry: Entry) -> str:
    """Return files and note of an entry as canonical JSON."""
    files = {
        name: None if state is None else {key: value for key, value in asdict(state).items() if value != ""}
        for name, state in entry.files.items()
    }
    return json.dumps({"files": files, "note": entry.note}, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)


def entry_from(kind: str, viewpoint: str, content: str) -> Entry:
    """Return the entry of a row; raises ValueError, KeyError or TypeError where it is none."""
    document = json.loads(content)
    files = {name: None if state is None else FileState(**state) for name, state in document["files"].items()}
    return Entry(kind, files, viewpoint, document["note"])


def next_hash(before: str, number: int, at: str, kind: str, viewpoint: str, content: str) -> str:
    """Return the hash of one row and of the hash before it."""
    row = json.dumps([number, at, kind, viewpoint, content], ensure_ascii=True, separators=(",", ":"))
    return hashlib.sha256(bytes.fromhex(before) + row.encode("ascii")).hexdigest()
