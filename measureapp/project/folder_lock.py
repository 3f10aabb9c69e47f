"""Exclusive lock on a folder, so that two windows or commands never write into the same one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from filelock import FileLock, Timeout

from measureapp.errors import StorageError

LOCK = ".lock"


@contextmanager
def lock_folder(folder: Path) -> Iterator[None]:
    """Lock ``folder``, which must exist, until the body ends; the system releases the lock when the process dies.

    Raises
    ------
    StorageError
        Another window or command has locked it, or it cannot be written to.
    """
    lock = FileLock(Path(folder) / LOCK, timeout=0)
    try:
        lock.acquire()
    except Timeout as error:
        raise StorageError(
            f"{folder} is in use by another window or command.", "Wait until it has finished, or close it; then try again."
        ) from error
    except OSError as error:
        raise StorageError(
            f"{folder} cannot be written to: {error.strerror or error}.", "Check the permissions, or copy the folder to a disk of your own."
        ) from error
    try:
        yield
    finally:
        lock.release()
