"""The journal of a project that was written by a version without one: made from what is there, before the project is first changed."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from measureapp.errors import StorageError
from measureapp.project.frame_store import DESCRIPTION, image_names
from measureapp.project.journal import database, disk, publish
from measureapp.project.journal.entries import Entry, FileState
from measureapp.project.journal.state import STORED

CREATED, TAKEN_OVER = "project created", "project taken over from an earlier version"
STACKS = "stacks"


def create_journal(project: Path) -> None:
    """Make the journal of a new project from the files that are there. Raises StorageError."""
    with disk.explained(project):
        files = {publish.relative_name(project, path): disk.state_of(path) for path in _files(project)}
        database.create(project, (Entry(CREATED, files),))


def take_over(project: Path) -> None:
    """Make the journal of a project of an earlier version.

    The pixels are not read: their checksums are those of the stack's description. A stack without a readable description is not taken over.

    Raises
    ------
    StorageError
    """
    with disk.explained(project):
        stacks = [entry for folder in sorted((project / STACKS).glob("*/")) if (entry := _stack(project, folder)) is not None]
        others = [path for path in _files(project) if publish.relative_name(project, path).split("/")[0] != STACKS]
        files = {publish.relative_name(project, path): disk.state_of(path) for path in others}
        database.create(project, (Entry(TAKEN_OVER, files), *stacks))


def renew(project: Path) -> None:
    """Make a new journal in place of a damaged one, which is kept as ``journal.damaged-TIME.sqlite``. Raises StorageError."""
    former = project / database.JOURNAL
    with disk.explained(former):
        if former.exists():
            disk.rename(former, project / f"journal.damaged-{datetime.now(UTC):%Y%m%dT%H%M%SZ}.sqlite")
        for name in (*database.COMPANIONS, publish.SEAL):
            (project / name).unlink(missing_ok=True)
    take_over(project)


def _files(project: Path) -> Iterator[Path]:
    for folder, folders, names in os.walk(project):
        folders[:] = sorted(name for name in folders if not disk.PART.match(name))
        here = Path(folder)
        yield from (here / name for name in sorted(names) if not disk.PART.match(name) and (here != project or name not in publish.OWN))


def _stack(project: Path, folder: Path) -> Entry | None:
    """Return the entry of a stored stack; None if it is incomplete or unreadable."""
    path = folder / DESCRIPTION
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        files = {publish.relative_name(project, path): disk.state_of(path)}
        for name in image_names(folder, document):
            head = _head(folder / name)
            size = (folder / name).stat().st_size
            files[publish.relative_name(project, folder / name)] = FileState(size, str(document["checksums"][name]), head.hex())
    except (OSError, ValueError, AttributeError, TypeError, RecursionError, StorageError):
        return None
    return Entry(STORED, files, folder.name)


def _head(path: Path) -> bytes:
    """Return what an ``.npy`` file begins with. Raises ValueError or OSError."""
    with path.open("rb") as file:
        version = np.lib.format.read_magic(file)
        reader = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
        reader(file)
        length = file.tell()
        file.seek(0)
        return file.read(length)
