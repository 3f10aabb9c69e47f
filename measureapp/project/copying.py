"""A copy of a whole project under another name."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import nullcontext, suppress
from pathlib import Path

from measureapp.errors import InputError, StorageError
from measureapp.progress import NoProgress, Progress
from measureapp.project.atomic import write_text
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import disk, publish
from measureapp.project.upkeep import accept_changes

NOT_COPIED = frozenset({publish.LOCK, publish.HOLDER, publish.WRITING})
BLOCK_BYTES = 4 << 20


def copy_project(source: Path, target: Path, progress: Progress = NoProgress()) -> ProjectFolder:  # noqa: B008 - stateless
    """Copy the project in ``source`` to the new folder ``target`` and give it the name of that folder.

    It is copied to a folder beside the target, which takes its name when everything is there; a cancelled copy leaves nothing behind.

    Raises
    ------
    InputError
        ``source`` is no project, or ``target`` is not empty or lies within it.
    StorageError
        The project is in use, the disk is full, or a folder cannot be read or written.
    Cancelled
        From ``progress``.
    """
    source, target = Path(source), Path(target)
    project = ProjectFolder.open(source)
    if target.absolute().is_relative_to(source.absolute()):
        raise InputError(f"{target} is inside the project that is copied.", "Choose a folder outside the project.")
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise InputError(f"{target} is not an empty folder.", "Choose a new or an empty folder for the copy.")
    part = target.with_name(f".{target.name}.copy")
    shutil.rmtree(part, ignore_errors=True)
    try:
        # where nothing can be written, there is nobody to lock out, and a copy is what helps
        with project.lock() if os.access(source, os.W_OK) else nullcontext():
            _copy_files(source, part, progress)
        with disk.explained(target):
            with suppress(FileNotFoundError):
                target.rmdir()
            part.replace(target)
    finally:
        shutil.rmtree(part, ignore_errors=True)
    settings = project.settings.model_copy(update={"name": target.name})
    write_text(target / "project.json", settings.model_dump_json(indent=2))
    accept_changes(target, ["project.json"])
    return ProjectFolder.open(target)


def _copy_files(source: Path, part: Path, progress: Progress) -> None:
    files = tuple(_files(source))
    total = sum(file.stat().st_size for file in files)
    _require_room(part.parent, total)
    done = 0
    for file in files:
        name = file.relative_to(source)
        with disk.explained(part / name):
            (part / name).parent.mkdir(parents=True, exist_ok=True)
            with file.open("rb") as read, (part / name).open("wb") as written:
                while block := read.read(BLOCK_BYTES):
                    written.write(block)
                    done += len(block)
                    progress.report(done, max(1, total), f"Copying {name.parts[0]}")
                written.flush()
                os.fsync(written.fileno())


def _files(source: Path) -> Iterator[Path]:
    for file in sorted(source.rglob("*")):
        name = file.relative_to(source)
        if file.is_file() and not publish.is_part(name) and str(name) not in NOT_COPIED:
            yield file


def _require_room(folder: Path, size: int) -> None:
    try:
        free = shutil.disk_usage(folder).free
    except OSError as error:
        raise StorageError(f"{folder} cannot be used: {error.strerror or error}.", "Choose a folder that exists.") from error
    if free < size:
        raise StorageError(
            f"The copy needs {size / 1e9:.1f} GB, and {folder} has {free / 1e9:.1f} GB left.", "Free some space, or choose another disk."
        )
