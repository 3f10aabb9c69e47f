"""The SQLite file of a series: one table of runs that are never changed nor deleted.

A rollback journal, not a write-ahead log, so that the folder may lie on a network drive; every transaction is synced.
"""

from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import closing, contextmanager
from datetime import datetime
from pathlib import Path

from pydantic import ValidationError

from measureapp.data.series import SeriesRun
from measureapp.errors import Damaged, DiskFailed, DiskFull, InputError, StorageError

FILE = "results.sqlite"
APPLICATION_ID, SCHEMA = 0x4D415352, 1
BUSY_S = 30.0
REBUILD = "Rebuild it from the project folders: measureapp series rebuild PROGRAM PROJECT…"
TABLE = """
CREATE TABLE run (
    number INTEGER PRIMARY KEY AUTOINCREMENT, run_id TEXT NOT NULL UNIQUE, serial TEXT NOT NULL, at REAL NOT NULL,
    verdict TEXT, document TEXT NOT NULL, sha256 TEXT NOT NULL);
CREATE INDEX run_serial ON run (serial);
CREATE INDEX run_at ON run (at);
CREATE TRIGGER run_is_kept BEFORE DELETE ON run BEGIN SELECT RAISE(ABORT, 'runs are never deleted'); END;
CREATE TRIGGER run_is_final BEFORE UPDATE ON run BEGIN SELECT RAISE(ABORT, 'runs are never changed'); END;
"""


def seconds(moment: str) -> float:
    """Return an ISO 8601 time as seconds since 1970; without zone it is local time. Raises InputError."""
    try:
        return datetime.fromisoformat(moment).timestamp()
    except (ValueError, OverflowError, OSError) as error:
        raise InputError(f"{moment!r} is not a date or time.", "Give it as 2026-05-04 or 2026-05-04T10:20:30+02:00.") from error


def insert(connection: sqlite3.Connection, run: SeriesRun) -> None:
    """Append one run."""
    document = run.model_dump_json()
    connection.execute(
        "INSERT INTO run (run_id, serial, at, verdict, document, sha256) VALUES (?, ?, ?, ?, ?, ?)",
        (run.run_id, run.identification.serial_number, seconds(run.measured_at), run.verdict, document, _digest(document)),
    )


def select(path: Path, where: str, arguments: Iterable[object]) -> tuple[SeriesRun, ...]:
    """Return the runs of a condition, in order of measurement. Raises Damaged naming the run that is not what was stored."""
    if not path.exists():
        return ()
    with errors_named(path), closing(connect(path, "ro")) as connection:
        rows = connection.execute(
            f"SELECT number, document, sha256 FROM run WHERE {where} ORDER BY at, number", tuple(arguments)
        ).fetchall()
    return tuple(_checked(path, *row) for row in rows)


def salvage(path: Path) -> tuple[SeriesRun, ...]:
    """Return the runs that a damaged file still holds intact, read one by one."""
    found: dict[str, SeriesRun] = {}
    try:
        with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as connection:
            for down in (False, True):
                _walk(connection, path, found, down=down)
    except sqlite3.Error:
        pass  # what was read so far is what there is
    return tuple(sorted(found.values(), key=lambda run: seconds(run.measured_at)))


def _walk(connection: sqlite3.Connection, path: Path, found: dict[str, SeriesRun], *, down: bool) -> None:
    """Read from one end until a page is damaged; both ends together lose only what lies between."""
    try:
        for row in connection.execute(f"SELECT number, document, sha256 FROM run ORDER BY number {'DESC' if down else 'ASC'}"):
            try:
                run = _checked(path, *row)
            except Damaged:
                continue
            found[run.run_id] = run
    except sqlite3.Error:
        return


def create(path: Path) -> None:
    """Make an empty file if there is none; the caller holds the lock."""
    if path.exists():
        return
    with errors_named(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        with closing(connect(path, "rwc", check=False)) as connection:
            connection.executescript(f"BEGIN; PRAGMA application_id={APPLICATION_ID}; PRAGMA user_version={SCHEMA}; {TABLE} COMMIT;")


def connect(path: Path, mode: str, *, check: bool = True) -> sqlite3.Connection:
    """Open the file; waits for another writer."""
    connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode={mode}", uri=True, isolation_level=None, timeout=BUSY_S)
    try:
        connection.execute("PRAGMA synchronous=FULL")
        if check:
            _check_format(path, connection)
    except BaseException:
        connection.close()
        raise
    return connection


def _check_format(path: Path, connection: sqlite3.Connection) -> None:
    made_by = connection.execute("PRAGMA application_id").fetchone()[0]
    version = connection.execute("PRAGMA user_version").fetchone()[0]
    if made_by != APPLICATION_ID or version < SCHEMA:
        raise Damaged(f"{path} does not hold results of a series.", REBUILD)
    if version > SCHEMA:
        raise StorageError(f"{path} was written by a newer version of MeasureApp.", "Open it with that version.")


def _checked(path: Path, number: int, document: str, sha256: str) -> SeriesRun:
    if not isinstance(document, str) or _digest(document) != sha256:
        raise Damaged(f"{path} is damaged: run {number} is not what was stored.", REBUILD)
    try:
        return SeriesRun.model_validate_json(document)
    except ValidationError as error:
        raise Damaged(f"{path} is damaged: run {number} cannot be read.", REBUILD) from error


def _digest(document: str) -> str:
    return hashlib.sha256(document.encode()).hexdigest()


@contextmanager
def errors_named(path: Path) -> Iterator[None]:
    """Turn errors of SQLite and the disk into StorageErrors that name the file."""
    try:
        yield
    except OSError as error:
        raise StorageError(f"{path} cannot be written: {error.strerror or error}.", "Check the folder and its permissions.") from error
    except sqlite3.Error as error:
        code = getattr(error, "sqlite_errorcode", 0) & 0xFF
        if code == sqlite3.SQLITE_FULL:
            raise DiskFull(f"{path} cannot be written: the disk is full.", "Free some space. What was stored before is kept.") from error
        if code in (sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN):
            raise DiskFailed(f"{path} cannot be opened: {error}.", "Check the disk and its connection.") from error
        if code in (sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED):
            raise StorageError(f"{path} is in use by another program.", "Wait until that has finished, then try again.") from error
        if code == sqlite3.SQLITE_READONLY:
            raise StorageError(f"{path} cannot be written to.", "Check the permissions of the folder.") from error
        if code == sqlite3.SQLITE_CONSTRAINT:
            raise StorageError(f"{path}: {error}.", "Measured results are kept; measure the part again and state why.") from error
        raise Damaged(f"{path} is damaged: {error}.", REBUILD) from error
