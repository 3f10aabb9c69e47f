"""The journal's SQLite file: rows are appended, never changed, and chained by hashes."""

from __future__ import annotations

import os
import shutil
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime
from pathlib import Path
from tempfile import TemporaryDirectory

from measureapp.errors import Damaged, DiskFailed, DiskFull, StorageError
from measureapp.project.journal import disk
from measureapp.project.journal.entries import CHAIN_START, Entry, Line, content_of, entry_from, next_hash

JOURNAL = "journal.sqlite"
COMPANIONS = (f"{JOURNAL}-wal", f"{JOURNAL}-shm", f"{JOURNAL}-journal")  # of SQLite, while the journal is in use
APPLICATION_ID, SCHEMA = 0x4D415052, 1
BUSY_MS = 10_000
LONGEST_PATH_BYTES = 500  # SQLite takes 512 with its own endings
RESTORE = "Restore it from a backup, or make a new one from what is there: measureapp verify PROJECT --renew-journal."
TABLE = """
CREATE TABLE journal (number INTEGER PRIMARY KEY, at TEXT NOT NULL, kind TEXT NOT NULL, viewpoint TEXT NOT NULL, content TEXT NOT NULL,
                      chain TEXT NOT NULL) STRICT;
CREATE TRIGGER never_changed BEFORE UPDATE ON journal BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;
CREATE TRIGGER never_deleted BEFORE DELETE ON journal BEGIN SELECT RAISE(ABORT, 'the journal is append-only'); END;
"""


def has_journal(project: Path) -> bool:
    """Whether the folder is a project with a journal."""
    return (project / JOURNAL).is_file()


def require_short(project: Path) -> None:
    """Raise StorageError where the path of a project is too long for its journal."""
    if len(os.fsencode((project / JOURNAL).absolute())) > LONGEST_PATH_BYTES:
        raise StorageError(
            f"The path of {project.name} is too long: it exceeds {LONGEST_PATH_BYTES} bytes.", "Choose a folder with a shorter path."
        )


def create(project: Path, entries: Iterable[Entry]) -> None:
    """Make the journal with its first entries; it is there as a whole or not at all. Raises StorageError."""
    require_short(project)
    part = project / f".{JOURNAL}.{os.getpid()}.part"
    with disk.explained(project / JOURNAL), _sqlite_errors(project):
        part.unlink(missing_ok=True)
        with closing(sqlite3.connect(part, isolation_level=None)) as connection:
            connection.executescript(f"PRAGMA application_id={APPLICATION_ID}; PRAGMA user_version={SCHEMA}; BEGIN; {TABLE} COMMIT;")
            connection.execute("PRAGMA synchronous=OFF")  # the file is synced as a whole
            for entry in entries:
                _insert(connection, entry)
        disk.sync_file(part)
        disk.rename(part, project / JOURNAL)
        disk.sync_folder(project)


def append(project: Path, entry: Entry) -> int:
    """Append an entry in one transaction and return its number; it is on the disk when this returns. Raises StorageError."""
    with _sqlite_errors(project), closing(_connect(project)) as connection:
        return _insert(connection, entry)


def read(project: Path, after: int = 0, chain: str = CHAIN_START) -> tuple[Line, ...]:
    """Return the lines behind number ``after``, whose hash is ``chain``, oldest first.

    Raises
    ------
    Damaged
        A line was changed, is missing, or the file is none of SQLite.
    StorageError
        The journal is of a newer version or cannot be read.
    """
    lines: list[Line] = []
    with _sqlite_errors(project), _reading(project) as connection:
        _check_format(project, connection)
        for number, at, kind, viewpoint, content, stored in connection.execute(
            "SELECT number, at, kind, viewpoint, content, chain FROM journal WHERE number > ? ORDER BY number", (after,)
        ):
            try:
                found = next_hash(chain, number, at, kind, viewpoint, content)
                entry = entry_from(kind, viewpoint, content)
            except (ValueError, TypeError, KeyError) as error:
                raise _broken(project, number) from error
            if found != stored or number != after + len(lines) + 1:
                raise _broken(project, number)
            chain = found
            lines.append(Line(number, at, entry, chain))
    return tuple(lines)


def last(project: Path) -> Line | None:
    """Return the last line, unchecked. Raises StorageError."""
    with _sqlite_errors(project), _reading(project) as connection:
        row = connection.execute("SELECT number, at, kind, viewpoint, content, chain FROM journal ORDER BY number DESC LIMIT 1").fetchone()
    if row is None:
        return None
    number, at, kind, viewpoint, content, chain = row
    try:
        return Line(number, at, entry_from(kind, viewpoint, content), chain)
    except (ValueError, TypeError, KeyError) as error:
        raise _broken(project, number) from error


def is_settled(project: Path) -> bool:
    """Merge what SQLite keeps beside the journal into it; return whether that was possible. Raises StorageError."""
    with _sqlite_errors(project), closing(_connect(project)) as connection:
        return connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()[0] == 0


def find_damage(project: Path) -> str:
    """Check the database as a whole; return the problem in words, or an empty text. Raises StorageError."""
    with _sqlite_errors(project), _reading(project) as connection:
        found = [str(row[0]) for row in connection.execute("PRAGMA integrity_check(3)")]
    return "" if found == ["ok"] else "; ".join(found)


def _insert(connection: sqlite3.Connection, entry: Entry) -> int:
    connection.execute("BEGIN IMMEDIATE")
    try:
        row = connection.execute("SELECT number, chain FROM journal ORDER BY number DESC LIMIT 1").fetchone() or (0, CHAIN_START)
        number, at = row[0] + 1, datetime.now(UTC).isoformat(timespec="milliseconds")
        content = content_of(entry)
        values = (number, at, entry.kind, entry.viewpoint, content)
        connection.execute("INSERT INTO journal VALUES (?, ?, ?, ?, ?, ?)", (*values, next_hash(row[1], *values)))
        connection.execute("COMMIT")
    except BaseException:
        if connection.in_transaction:
            connection.execute("ROLLBACK")
        raise
    return int(number)


def _connect(project: Path) -> sqlite3.Connection:
    """Open the journal for writing: write-ahead log, synchronous FULL, waiting for another writer."""
    require_short(project)
    connection = sqlite3.connect(
        f"{(project / JOURNAL).absolute().as_uri()}?mode=rw", uri=True, isolation_level=None, timeout=BUSY_MS / 1000
    )
    try:
        _check_format(project, connection)
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
    except BaseException:
        connection.close()
        raise
    return connection


@contextmanager
def _reading(project: Path) -> Iterator[sqlite3.Connection]:
    """Open the journal for reading; a copy of it where the folder cannot be written to or its path is too long for SQLite."""
    try:
        connection = _connect(project)
    except (sqlite3.OperationalError, StorageError) as error:
        if isinstance(error, StorageError) and (
            isinstance(error, Damaged) or len(os.fsencode(project.absolute())) < LONGEST_PATH_BYTES - 20
        ):
            raise
        with TemporaryDirectory(prefix="measureapp-journal-") as folder:
            for name in (JOURNAL, f"{JOURNAL}-wal"):
                if (project / name).exists():
                    shutil.copyfile(project / name, Path(folder) / name)
            with closing(_connect(Path(folder))) as copy:
                yield copy
        return
    with closing(connection):
        yield connection


def _check_format(project: Path, connection: sqlite3.Connection) -> None:
    made_by = connection.execute("PRAGMA application_id").fetchone()[0]
    version = connection.execute("PRAGMA user_version").fetchone()[0]
    if made_by != APPLICATION_ID or version < SCHEMA:
        raise Damaged(f"{project / JOURNAL} is not the journal of a project.", RESTORE)
    if version > SCHEMA:
        raise StorageError(f"{project / JOURNAL} was written by a newer version of MeasureApp.", "Open the project with that version.")


def _broken(project: Path, number: int) -> Damaged:
    return Damaged(f"{project / JOURNAL} is damaged: line {number} is not the one that was stored.", RESTORE)


@contextmanager
def _sqlite_errors(project: Path) -> Iterator[None]:
    """Turn errors of SQLite into StorageErrors."""
    path = project / JOURNAL
    try:
        yield
    except sqlite3.Error as error:
        code = getattr(error, "sqlite_errorcode", 0) & 0xFF
        if code == sqlite3.SQLITE_FULL:
            raise DiskFull(f"{path} cannot be written: the disk is full.", "Free some space. What was stored before is kept.") from error
        if code in (sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN):
            raise DiskFailed(f"{path} cannot be written: {error}.", "Check the disk and its connection.") from error
        if code in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED):
            raise StorageError(
                f"{path} is locked by another program, for example a backup.", "Wait until that has finished, then try again."
            ) from error
        if code == sqlite3.SQLITE_READONLY:
            raise StorageError(
                f"{path} cannot be written to.", "Check the permissions, or copy the folder to a disk of your own."
            ) from error
        raise Damaged(f"{path} is damaged: {error}.", RESTORE) from error
