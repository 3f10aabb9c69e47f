"""Atomic file writing: temporary file, fsync, replace, fsync of the folder; inside a project with an entry in its journal."""

from __future__ import annotations

import json
import shutil
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from measureapp.errors import StorageError
from measureapp.project.journal import disk, publish
from measureapp.project.journal.entries import Entry

FILE, REMOVED = "file stored", "file removed"


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Provide a temporary path next to ``path`` that replaces it only if the body succeeds.

    Raises
    ------
    StorageError
        ``path`` is a folder, its folder cannot be written to, or the disk is full (`DiskFull`) or failed (`DiskFailed`).
    """
    path = Path(path)
    _check_is_file(path)
    temporary = publish.part_of(path)
    try:
        with disk.explained(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            yield temporary
            disk.sync_file(temporary)
            project = publish.project_of(path)
            staged = {} if project is None else {path: publish.Staged(temporary, disk.state_of(temporary))}
            if project is None:
                disk.rename(temporary, path)
                disk.sync_folder(path.parent)
    except BaseException:
        publish.discard([temporary])
        raise
    if project is not None:
        publish.publish(project, Entry(FILE), staged)


def require_writable(path: Path) -> None:
    """Try before a long job whether its file can be written. Raises StorageError, as `replacing`."""
    path = Path(path)
    _check_is_file(path)
    trial = publish.part_of(path)
    try:
        with disk.explained(path):
            path.parent.mkdir(parents=True, exist_ok=True)
            trial.touch()
    finally:
        publish.discard([trial])


def _check_is_file(path: Path) -> None:
    if not path.name or path.is_dir():
        raise StorageError(f"{path} is a folder.", "Give the path of the file to be written.")


@contextmanager
def replacing_together(folder: Path, entry: Entry, stale: Collection[str] = ()) -> Iterator[Path]:
    """Provide a folder whose files take their places in ``folder`` together, only if the body succeeds.

    Parameters
    ----------
    entry : what the journal says about it
    stale : patterns of files in ``folder`` that are removed unless they are written anew

    Raises
    ------
    StorageError
        As `replacing`; the files in ``folder`` are as they were.
    """
    folder = Path(folder)
    project = publish.project_of(folder / "any")
    staging = publish.part_of((project or folder.parent) / folder.name)
    try:
        with disk.explained(folder):
            staging.mkdir(parents=True)
            yield staging
            staged = {folder / path.relative_to(staging): path for path in sorted(staging.rglob("*")) if path.is_file()}
            for part in staged.values():
                disk.sync_file(part)
            removed = [path for pattern in stale for path in sorted(folder.glob(pattern)) if path not in staged]
            if project is None:
                _take_places(staged, removed)
        if project is not None:
            with disk.explained(folder):
                states = {target: publish.Staged(part, disk.state_of(part)) for target, part in staged.items()}
            publish.publish(project, entry, states, removed)
    finally:
        if project is None or not publish.waits(project, staging):
            shutil.rmtree(staging, ignore_errors=True)


def remove(*paths: Path) -> None:
    """Remove files, with an entry in the journal where they belong to a project. Raises StorageError."""
    there = [path for path in paths if path.exists()]
    for project in dict.fromkeys(map(publish.project_of, there)):
        own = [path for path in there if publish.project_of(path) == project]
        if project is not None:
            publish.publish(project, Entry(REMOVED), {}, own)
            continue
        for path in own:
            with disk.explained(path):
                path.unlink(missing_ok=True)


def _take_places(staged: Mapping[Path, Path], removed: Collection[Path]) -> None:
    for target, part in staged.items():
        target.parent.mkdir(parents=True, exist_ok=True)
        disk.rename(part, target)
        disk.sync_folder(target.parent)
    for path in removed:
        path.unlink(missing_ok=True)


def write_text(path: Path, text: str) -> None:
    """Write ``text`` as UTF-8, atomically."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def write_json(path: Path, document: Mapping[str, Any]) -> None:
    """Write ``document`` as indented JSON, atomically."""
    write_text(path, json.dumps(document, indent=2, allow_nan=False) + "\n")
