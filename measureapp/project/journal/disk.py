"""The few operations by which a project changes on disk, and the words for what can go wrong with them."""

from __future__ import annotations

import errno
import hashlib
import os
import re
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from measureapp.errors import DiskFailed, DiskFull, StorageError
from measureapp.project.journal.entries import FileState

NOT_ALLOWED = (errno.EACCES, errno.EPERM, errno.EROFS)
MISPLACED = (errno.EEXIST, errno.ENOTDIR, errno.EISDIR)
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
BLOCK = 8 * 2**20
PART = re.compile(r"^\.(?P<stem>.+)\.(?P<process>\d+)(-(?P<run>[0-9a-f]{6})-[0-9a-f]{6})?\.part(?P<ending>\.[^.]*)?$")
"""Name of a file or folder while it is being written, see `publish.part_of`."""


@contextmanager
def explained(path: Path) -> Iterator[None]:
    """Turn an OSError into a StorageError that names ``path``.

    Raises
    ------
    DiskFull
        There is no room, or the quota is exhausted.
    DiskFailed
        The disk reported an error, or the folder vanished.
    StorageError
        Permissions, or another reason.
    """
    try:
        yield
    except OSError as error:
        raise storage_error(path, error) from error


def _final_name(name: str) -> str:
    """Return the name that a file or folder has when it is written."""
    part = PART.match(name)
    return name if part is None else part["stem"] + (part["ending"] or "")


def storage_error(path: Path, error: OSError) -> StorageError:
    """Return the StorageError for ``error`` on ``path``."""
    path = Path(*(_final_name(name) for name in path.parts))
    reason = error.strerror or _without_system_words(error)
    message = f"{path} cannot be written: {reason}."
    if error.errno in FULL:
        return DiskFull(message, "Free some space, or choose another folder. What was stored before is kept.")
    if error.errno in NOT_ALLOWED:
        return StorageError(message, "Check the permissions, or choose another folder.")
    if error.errno in MISPLACED:
        return StorageError(
            f"{path} cannot be written: there is a file in the place of a folder, or a folder in that of a file.", "Choose another path."
        )
    if error.errno is None:  # of NumPy, which states bytes in place of a reason
        return DiskFull(f"{path} cannot be written completely.", "Free some space, or choose another folder.")
    return DiskFailed(message, "Check the disk and its connection, or choose another folder. What was stored before is kept.")


def _without_system_words(error: OSError) -> str:
    return str(error) or "unknown error"


def write_hashed(path: Path, head: bytes, body: memoryview) -> FileState:
    """Write ``head`` and ``body`` in blocks, hashing the body in another thread meanwhile, and sync the file.

    Raises
    ------
    OSError
    """
    digest = hashlib.sha256()
    with ThreadPoolExecutor(1, "hashing") as pool, path.open("wb", buffering=0) as file:
        _write_all(file.fileno(), memoryview(head))
        for start in range(0, len(body), BLOCK):
            block = body[start : start + BLOCK]
            hashing = pool.submit(digest.update, block)
            _write_all(file.fileno(), block)
            hashing.result()
        os.fsync(file.fileno())
    return FileState(len(head) + len(body), digest.hexdigest(), head.hex())


def _write_all(handle: int, block: memoryview) -> None:
    while len(block):
        block = block[os.write(handle, block) :]


def state_of(path: Path, head_bytes: int = 0) -> FileState:
    """Read a file and return its state, its first ``head_bytes`` kept as they are. Raises OSError."""
    digest, size = hashlib.sha256(), 0
    with path.open("rb") as file:
        head = file.read(head_bytes)
        while block := file.read(BLOCK):
            digest.update(block)
            size += len(block)
    return FileState(len(head) + size, digest.hexdigest(), head.hex())


def sync_file(path: Path) -> None:
    """Wait until the content of a file is on the disk. Raises OSError."""
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def sync_folder(folder: Path) -> None:
    """Wait until the names in a folder are on the disk. Raises OSError."""
    if os.name != "posix":  # Windows cannot open a folder
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def rename(part: Path, target: Path) -> None:
    """Let ``part`` take the place of ``target``. Raises OSError."""
    part.replace(target)
