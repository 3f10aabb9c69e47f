"""Files take their place in a project together: written beside, entered in the journal, then renamed.

The entry names the temporary file of every file. Where the program dies, or the disk fails, between the entry and the last rename, the next
one to write finishes the renames (`finish_last`). So the journal's transaction decides: before it nothing has changed, after it everything has.
"""

from __future__ import annotations

import os
import re
import secrets
import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path

import psutil  # type: ignore[import-untyped]
from filelock import FileLock, Timeout

from measureapp.errors import DiskFailed, StorageError
from measureapp.project.journal import database, disk
from measureapp.project.journal.entries import Entry, FileState, Line

ACCEPTED = "change accepted"
LOCK = ".lock"  # of the whole project, see `folder_lock`
HOLDER = ".lock.json"
WRITING = ".journal.lock"
WRITING_TIMEOUT_S = 30.0
SEAL = "journal.seal.json"
RUN = secrets.token_hex(3)  # of this program: after a restart of the computer another one may have its process number
OWN = {database.JOURNAL, *database.COMPANIONS, LOCK, HOLDER, WRITING, SEAL}


@dataclass(frozen=True, slots=True)
class Staged:
    """A file that waits beside its place, completely written and synced."""

    part: Path
    state: FileState


def part_of(path: Path) -> Path:
    """Return a new name beside ``path`` for a file that is being written; it keeps the extension, by which writers choose their format."""
    return path.with_name(f".{path.stem}.{os.getpid()}-{RUN}-{secrets.token_hex(3)}.part{path.suffix}")


def is_part(relative: Path) -> bool:
    """Whether a path inside a project is a file that is being written, or lies in a folder of such files."""
    return any(disk.PART.match(name) for name in relative.parts)


def project_of(path: Path) -> Path | None:
    """Return the project with a journal that ``path`` belongs to; None if there is none, or it is a file that is being written."""
    place = path.absolute()
    for folder in place.parents:
        if database.has_journal(folder):
            return None if is_part(place.relative_to(folder)) else folder
    return None


def relative_name(project: Path, path: Path) -> str:
    """Return the path of a file relative to its project, with slashes."""
    return path.absolute().relative_to(project.absolute()).as_posix()


def publish(project: Path, entry: Entry, staged: Mapping[Path, Staged], removed: Iterable[Path] = ()) -> None:
    """Append ``entry`` with all files to the journal, and let the files take their places.

    Raises
    ------
    DiskFull, DiskFailed, StorageError
        Either nothing has changed, and the temporary files are deleted; or the entry is written, and the rest follows with the next change.
    """
    files: dict[str, FileState | None] = {
        relative_name(project, path): replace(one.state, part=relative_name(project, one.part)) for path, one in staged.items()
    }
    files |= {relative_name(project, path): None for path in removed}
    full = Entry(entry.kind, files, entry.viewpoint, entry.note)
    try:
        with _writing(project):
            finish_last(project)
            database.append(project, full)
            staged = {}  # from here on they are part of the project
            _take_places(project, full)
    finally:
        discard(one.part for one in staged.values())


def record(project: Path, entry: Entry) -> None:
    """Append an entry about files that are in their places already, or about none. Raises StorageError."""
    with _writing(project):
        finish_last(project)
        database.append(project, entry)


def accept(project: Path, path: Path) -> None:
    """Enter the present content of a file in the journal. Raises StorageError."""
    with disk.explained(path):
        state = disk.state_of(path)
    record(project, Entry(ACCEPTED, {relative_name(project, path): state}))


@contextmanager
def staging(path: Path) -> Iterator[Path]:
    """Provide a temporary file beside ``path``, which is deleted if the body fails."""
    part = part_of(path)
    try:
        yield part
    except BaseException:
        discard([part])
        raise


def discard(parts: Iterable[Path]) -> None:
    """Delete temporary files, as far as that is possible."""
    for part in parts:
        with suppress(OSError):
            part.unlink(missing_ok=True)


def finish_last(project: Path) -> None:
    """Finish the renames and removals of the last entry, as after the program died. Raises StorageError."""
    line = database.last(project)
    if line is not None and is_unfinished(project, line):
        _take_places(project, line.entry)


def recover(project: Path) -> None:
    """Finish the last entry, and delete temporary files of programs that died. Raises StorageError."""
    with _writing(project):
        finish_last(project)
        sweep(project)


def is_unfinished(project: Path, line: Line) -> bool:
    """Whether files of a line have not yet taken their places."""
    return any(
        (project / name).exists() if state is None else bool(state.part) and (project / state.part).exists()
        for name, state in line.entry.files.items()
    )


def waits(project: Path, folder: Path) -> bool:
    """Whether files in a temporary folder belong to the last entry, and have not yet taken their places."""
    line = database.last(project)
    name = relative_name(project, folder)
    states = [] if line is None else line.entry.files.values()
    return any(state is not None and state.part.startswith(f"{name}/") and (project / state.part).exists() for state in states)


def sweep(project: Path) -> None:
    """Delete temporary files and folders of programs that do not run any more."""
    for folder, folders, files in os.walk(project):
        for name in (*files, *folders):
            if (found := disk.PART.match(name)) and not _is_running(found):
                shutil.rmtree(Path(folder) / name, ignore_errors=True)
                discard([Path(folder) / name])
        folders[:] = [name for name in folders if not disk.PART.match(name)]


def _is_running(found: re.Match[str]) -> bool:
    process = int(found["process"])
    return found["run"] == RUN if process == os.getpid() else psutil.pid_exists(process)


def _take_places(project: Path, entry: Entry) -> None:
    folders = set()
    for name, state in entry.files.items():
        target = project / name
        with disk.explained(target):
            if state is None:
                target.unlink(missing_ok=True)
            elif state.part and (part := project / state.part).exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                disk.rename(part, target)
            folders.add(target.parent)
    for folder in folders:
        if folder.is_dir():
            with disk.explained(folder):
                disk.sync_folder(folder)
    for name in {state.part.split("/")[0] for state in entry.files.values() if state is not None}:
        if disk.PART.match(name):  # a folder of staged files
            shutil.rmtree(project / name, ignore_errors=True)


@contextmanager
def _writing(project: Path) -> Iterator[None]:
    """Let one program, and one thread, at a time enter files and rename them."""
    if not database.has_journal(project):
        raise vanished(project)
    lock = FileLock(project / WRITING, timeout=WRITING_TIMEOUT_S, thread_local=False)
    try:
        with disk.explained(project / database.JOURNAL):
            lock.acquire()
    except Timeout as error:
        raise StorageError(f"{project} is being written by another program.", "Wait until that has finished, then try again.") from error
    try:
        yield
    finally:
        lock.release()


def vanished(project: Path) -> DiskFailed:
    """Return the error for a project whose folder is not there any more."""
    return DiskFailed(f"The project folder {project} is gone.", "Connect its disk again, or put the folder back where it was.")
