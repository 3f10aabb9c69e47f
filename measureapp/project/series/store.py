"""Store of the results of many parts: one folder per program, by default below the user's home."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from filelock import FileLock, Timeout

from measureapp.data.series import SeriesRun
from measureapp.errors import InputError, StorageError
from measureapp.project.file_names import safe_file_name
from measureapp.project.series import database

NAME_FILE = "program.txt"
LOCK = ".lock"
LOCK_TIMEOUT_S = 30.0


def results_folder() -> Path:
    """Return the folder that holds the series of all programs."""
    return Path.home() / "MeasureApp" / "results"


def series_folder(program: str, root: Path | None = None) -> Path:
    """Return the folder of a program's series; names that differ only in what a file name cannot hold get folders of their own."""
    safe = safe_file_name(program)[:100].rstrip(". ")
    mark = "" if safe == program else f" {hashlib.sha256(program.encode()).hexdigest()[:6]}"
    return (root or results_folder()) / f"{safe}{mark}"


def list_programs(root: Path | None = None) -> tuple[str, ...]:
    """Return the programs that have a series, by name."""
    names = []
    for path in (root or results_folder()).glob(f"*/{NAME_FILE}"):
        try:
            names.append(path.read_text(encoding="utf-8").strip())
        except (OSError, UnicodeDecodeError):
            names.append(path.parent.name)
    return tuple(sorted(names))


@dataclass(frozen=True, slots=True)
class Rebuilt:
    """What a rebuild found."""

    runs: int
    from_damaged: int  # still readable in the damaged file
    from_projects: int
    kept_as: Path | None  # the damaged file under its new name


class SeriesStore:
    """The runs of one program; several programs may read and write at a time. Nothing is ever changed or deleted."""

    def __init__(self, program: str, root: Path | None = None) -> None:
        self.program = program
        self.folder = series_folder(program, root)
        self.path = self.folder / database.FILE

    def add(self, run: SeriesRun) -> bool:
        """Append a run, and return whether it is new; one that is stored already is left as it is.

        Raises
        ------
        InputError
            The run is of another program, or the part was measured before and no reason is given.
        StorageError
            The file cannot be written, or is damaged (`Damaged`).
        """
        if run.program != self.program:
            raise InputError(f"The run is of program {run.program}, not {self.program}.", "Store it in the series of its own program.")
        with self._locked():
            database.create(self.path)
            with database.errors_named(self.path), closing(database.connect(self.path, "rw")) as connection:
                connection.execute("BEGIN IMMEDIATE")
                self._require_reason(run)
                is_new = connection.execute("SELECT 1 FROM run WHERE run_id = ?", (run.run_id,)).fetchone() is None
                if is_new:
                    database.insert(connection, run)
                connection.execute("COMMIT")
        return is_new

    def runs(self, *, serial_number: str | None = None, since: str | None = None) -> tuple[SeriesRun, ...]:
        """Return runs in order of measurement; none if there is no series yet.

        Parameters
        ----------
        serial_number : only of this part
        since : ISO 8601; only those measured then or later

        Raises
        ------
        Damaged
            The file, or a run in it, is not what was stored; names it.
        """
        conditions: list[str] = ["1"]
        arguments: list[object] = []
        if serial_number is not None:
            conditions.append("serial = ?")
            arguments.append(serial_number)
        if since is not None:
            conditions.append("at >= ?")
            arguments.append(database.seconds(since))
        return database.select(self.path, " AND ".join(conditions), arguments)

    def rebuild(self, found_in_projects: Iterable[SeriesRun]) -> Rebuilt:
        """Make the file anew from what its damaged version still holds and from runs found in project folders.

        The damaged file is kept under another name.
        """
        projects = [run for run in found_in_projects if run.program == self.program]
        with self._locked():
            salvaged = database.salvage(self.path) if self.path.exists() else ()
            every = {run.run_id: run for run in (*projects, *salvaged)}
            kept = self._set_aside()
            database.create(self.path)
            with database.errors_named(self.path), closing(database.connect(self.path, "rw")) as connection:
                connection.execute("BEGIN IMMEDIATE")
                for run in sorted(every.values(), key=lambda run: database.seconds(run.measured_at)):
                    database.insert(connection, run)
                connection.execute("COMMIT")
        known = {run.run_id for run in salvaged}
        return Rebuilt(len(every), len(salvaged), sum(run.run_id not in known for run in projects), kept)

    def _require_reason(self, run: SeriesRun) -> None:
        serial = run.identification.serial_number
        if not serial or run.repeat_reason:
            return
        before = self.runs(serial_number=serial)
        if before and run.run_id not in {one.run_id for one in before}:
            raise InputError(
                f"Serial number {serial} was measured before ({before[-1].measured_at}).", "State why this part is measured again."
            )

    def _set_aside(self) -> Path | None:
        if not self.path.exists():
            return None
        kept = self.path.with_name(f"results.damaged-{datetime.now(UTC):%Y%m%dT%H%M%S%fZ}.sqlite")
        with database.errors_named(self.path):
            self.path.rename(kept)
        return kept

    @contextmanager
    def _locked(self) -> Iterator[None]:
        lock = FileLock(self.folder / LOCK, timeout=LOCK_TIMEOUT_S, thread_local=False)
        try:
            with database.errors_named(self.path):
                self.folder.mkdir(parents=True, exist_ok=True)
                lock.acquire()
                if not (self.folder / NAME_FILE).exists():
                    (self.folder / NAME_FILE).write_text(self.program, encoding="utf-8")
        except Timeout as error:
            raise StorageError(f"{self.path} is in use by another program.", "Wait until that has finished, then try again.") from error
        try:
            yield
        finally:
            lock.release()
