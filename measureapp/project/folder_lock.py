"""Exclusive lock on a folder, so that two windows or commands never write into the same one."""

from __future__ import annotations

import getpass
import json
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path

from filelock import FileLock, Timeout

from measureapp.errors import StorageError
from measureapp.project.journal.publish import HOLDER, LOCK

YIELDED_WITHIN_S = 60.0  # one viewpoint at full size, on a slow disk


@contextmanager
def lock_folder(folder: Path, *, yields: bool = False) -> Iterator[None]:
    """Lock ``folder``, which must exist, until the body ends; the system releases the lock when the process dies.

    Parameters
    ----------
    yields : the lock is held by a job in the background, for some seconds; another one then waits for it

    Raises
    ------
    StorageError
        Another window or command has locked it (names the holder), or it cannot be written to.
    """
    folder = Path(folder)
    lock = FileLock(folder / LOCK, timeout=0)
    try:
        if not folder.is_dir():
            raise FileNotFoundError(2, "the folder does not exist")
        _acquire(lock, folder)
    except Timeout as error:
        raise StorageError(
            f"{folder} is in use by another window or command: {_holder(folder)}.",
            "Wait until it has finished, or close it; then try again.",
        ) from error
    except OSError as error:
        raise StorageError(
            f"{folder} cannot be written to: {error.strerror or error}.", "Check the permissions, or copy the folder to a disk of your own."
        ) from error
    try:
        _name_holder(folder, yields)
        yield
    finally:
        with suppress(OSError):
            (folder / HOLDER).unlink(missing_ok=True)
        lock.release()


def holder_of(folder: Path) -> str | None:
    """Return in words who has locked a folder; None where nobody has, or where that cannot be found out."""
    if not (folder / LOCK).exists():
        return None
    lock = FileLock(folder / LOCK, timeout=0)
    try:
        lock.acquire()
    except Timeout:
        return None if _holder_yields(folder) else _holder(folder)
    except OSError:
        return None
    lock.release()
    return None


def _acquire(lock: FileLock, folder: Path) -> None:
    """Take the lock at once, or as soon as a job in the background gives it back. Raises Timeout."""
    try:
        lock.acquire()
    except Timeout:
        if not _holder_yields(folder):
            raise
        lock.acquire(timeout=YIELDED_WITHIN_S)


def _holder_yields(folder: Path) -> bool:
    try:
        return json.loads((folder / HOLDER).read_text(encoding="utf-8")).get("yields") is True
    except (OSError, ValueError, AttributeError):
        return False


def _name_holder(folder: Path, yields: bool) -> None:
    """Write who holds the lock beside it; for information only, the lock itself is the system's."""
    holder = {
        "program": " ".join(("measureapp", *[word for word in sys.argv[1:2] if not word.startswith("-")])),
        "process": os.getpid(),
        "user": getpass.getuser(),
        "computer": socket.gethostname(),
        "yields": yields,
        "since": datetime.now().astimezone().isoformat(timespec="seconds"),
    }
    with suppress(OSError):
        (folder / HOLDER).write_text(json.dumps(holder), encoding="utf-8")


def _holder(folder: Path) -> str:
    """Return the holder in words, also where its file is damaged or not yet written."""
    try:
        entry = json.loads((folder / HOLDER).read_text(encoding="utf-8"))
        who = "this program" if entry["process"] == os.getpid() else f"{entry['program']}, process {entry['process']}"
        return f"{who}, user {entry['user']} at {entry['computer']}, since {entry['since']}"
    except (OSError, ValueError, KeyError, TypeError):
        return "its name is not known"
