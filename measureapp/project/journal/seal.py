"""The seal of a journal: a checksum of its file, written whenever a program has finished with the project.

Hashes chain the lines of the journal; the seal covers the bytes of the file around them, too, and reveals that a journal was deleted.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from measureapp.errors import StorageError
from measureapp.project.journal import database, disk, publish


def write(project: Path) -> None:
    """Seal the journal, unless another program is reading it just now: then the former seal counts for its lines. Raises StorageError."""
    line = database.last(project)
    if line is None or not database.is_settled(project):
        return
    path = project / publish.SEAL
    part = publish.part_of(path)
    with disk.explained(path):
        state = disk.state_of(project / database.JOURNAL)
        disk.write_hashed(part, b"", memoryview(_text(line.number, state.size, state.sha256).encode("ascii")))
        disk.rename(part, path)
        disk.sync_folder(project)


def problem(project: Path, lines: int) -> str:
    """Return in words how the journal differs from its seal; empty if it does not, or has grown since."""
    path = project / publish.SEAL
    try:
        text = path.read_bytes().decode("ascii")
        document = json.loads(text)
        sealed, size, sha256 = int(document["lines"]), int(document["size"]), str(document["sha256"])
        if text != _text(sealed, size, sha256):
            raise ValueError
    except FileNotFoundError:
        return f"its seal {path.name} is missing"
    except (OSError, ValueError, KeyError, TypeError):
        return f"its seal {path.name} cannot be read"
    if lines < sealed:
        return f"it ends at line {lines} of {sealed}"
    beside = project / f"{database.JOURNAL}-wal"
    if lines > sealed or (beside.exists() and beside.stat().st_size):
        return ""
    try:
        state = disk.state_of(project / database.JOURNAL)
    except OSError as error:
        raise StorageError(f"{project / database.JOURNAL} cannot be read: {error}.", database.RESTORE) from error
    return "" if (state.size, state.sha256) == (size, sha256) else "it is not the file that was sealed"


def _text(lines: int, size: int, sha256: str) -> str:
    """Return the content of a seal, with a checksum of its own."""
    check = hashlib.sha256(f"{lines} {size} {sha256}".encode("ascii")).hexdigest()
    return json.dumps({"lines": lines, "size": size, "sha256": sha256, "check": check})
