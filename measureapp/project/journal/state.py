"""What a project consists of according to its journal, and whether the files on disk are these."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from threading import Lock
from typing import Any

from measureapp.errors import Damaged
from measureapp.project.journal import database, disk, publish
from measureapp.project.journal.entries import CHAIN_START, FileState, Line

STORED, DROPPED, RESULTS = "viewpoint stored", "viewpoint dropped", "results stored"
ACCEPT = "Restore it from a backup. If you changed it on purpose, accept it (measureapp verify PROJECT --accept {name})."
AGAIN = "Restore it from a backup, or take the viewpoint again: measureapp discard PROJECT {viewpoint}, then measureapp scan … --resume."
COMPUTE = "Compute it again: measureapp process PROJECT."
IMAGES = ("stacks/", "calibration/views/")
Compared = tuple[int, int, str]  # size, time of the last change in ns, and SHA-256 of a file that was found equal to the journal


@dataclass(slots=True)
class Contents:
    """Files and viewpoints after some line of the journal."""

    files: dict[str, FileState] = field(default_factory=dict)
    owner: dict[str, str] = field(default_factory=dict)  # file -> viewpoint
    viewpoints: dict[str, Line] = field(default_factory=dict)  # id -> line that stored it
    results: Mapping[str, Any] = field(default_factory=dict)  # note of the last results: what they were computed from
    lines: int = 0
    chain: str = CHAIN_START

    def copied(self) -> Contents:
        """Return a copy to which further lines can be applied."""
        return replace(self, files=dict(self.files), owner=dict(self.owner), viewpoints=dict(self.viewpoints))

    def apply(self, line: Line) -> None:
        """Take one more line into account."""
        entry = line.entry
        for name, state in entry.files.items():
            self.files.pop(name, None)
            self.owner.pop(name, None)
            if state is not None:
                self.files[name] = state
                self.owner[name] = entry.viewpoint
        if entry.kind == STORED:
            self.viewpoints[entry.viewpoint] = line
        elif entry.kind == DROPPED:
            self.viewpoints.pop(entry.viewpoint, None)
        elif entry.kind == RESULTS:
            self.results = entry.note
        self.lines, self.chain = line.number, line.chain


class Journal:
    """The journal of one project, read as far as it has come; none for a project of an earlier version before it is first changed."""

    def __init__(self, project: Path) -> None:
        self.project = Path(project)
        self._contents = Contents()
        self._reading = Lock()
        self._checked: dict[Path, tuple[int, int]] = {}  # file -> size and time of its last change
        self._compared: dict[str, Compared] = {}

    def contents(self) -> Contents | None:
        """Return files and viewpoints; None without a journal.

        Raises
        ------
        Damaged
            A line is not the one that was stored, or the journal was deleted.
        StorageError
        """
        if not database.has_journal(self.project):
            if (self.project / publish.SEAL).exists():
                raise Damaged(f"{self.project / database.JOURNAL} is missing.", database.RESTORE)
            return None
        with self._reading:
            lines = database.read(self.project, self._contents.lines, self._contents.chain)
            if lines:  # a copy, since other threads may be reading the former one
                known = self._contents.copied()
                for line in lines:
                    known.apply(line)
                self._contents = known
            return self._contents

    def check(self, *paths: Path) -> None:
        """Compare files with the journal before they are used; files that are not there, or that it does not know, pass.

        Raises
        ------
        Damaged
            Names the file and the remedy.
        """
        contents = self.contents()
        if contents is None:
            return
        for path in paths:
            name = publish.relative_name(self.project, path)
            known = contents.files.get(name)
            if known is not None and path.exists() and not self.is_same(name, known):
                raise Damaged(f"{path} is not what was stored.", remedy(name, contents.owner.get(name, "")))

    def check_once(self, path: Path) -> None:
        """Compare a file with the journal as `check`, unless that was done since it was last changed."""
        if not path.exists():
            return
        found = path.stat()
        if self._checked.get(path) != (found.st_size, found.st_mtime_ns):
            self.check(path)
            self._checked[path] = (found.st_size, found.st_mtime_ns)

    def size_problems(self) -> tuple[str, ...]:
        """Return, in sentences, which files are missing or have another size than what was stored; no content is read. Raises StorageError."""
        contents, found = self.contents(), []
        for name, state in sorted(contents.files.items()) if contents is not None else ():
            waiting = self.project / state.part if state.part else None
            path = waiting if waiting is not None and waiting.exists() else self.project / name
            if not path.exists():
                found.append(f"{self.project / name} is missing.")
            elif path.stat().st_size != state.size:
                found.append(f"{self.project / name} has {path.stat().st_size} bytes; {state.size} were stored.")
        return tuple(found)

    def is_same(self, name: str, known: FileState) -> bool:
        """Whether a file has the content ``known``; what waits beside its place counts as if it were there."""
        path = self.project / name
        waiting = self.project / known.part if known.part else path
        try:
            found = (waiting if waiting.exists() else path).stat()
            same = disk.state_of(waiting if waiting.exists() else path, len(known.head) // 2).same_content(known)
        except OSError:
            return False
        if same:
            self._compared[name] = (found.st_size, found.st_mtime_ns, known.sha256)
        return same

    def is_unchanged(self, name: str, known: FileState) -> bool:
        """Whether a file has the content ``known``; not compared again where size and time are those with which it was once found equal."""
        try:
            found = (self.project / name).stat()
        except OSError:
            return self.is_same(name, known)
        return self._compared.get(name) == (found.st_size, found.st_mtime_ns, known.sha256) or self.is_same(name, known)

    def compared_images(self) -> dict[str, Compared]:
        """Return the files of part and board that were found equal to the journal, and are still as they were then stored."""
        files = self._contents.files
        return {
            name: one for name, one in self._compared.items() if name.startswith(IMAGES) and name in files and files[name].sha256 == one[2]
        }

    def take_as_compared(self, files: Mapping[str, Compared]) -> None:
        """Take files as found equal earlier, as long as size and time of their last change are what they were then."""
        self._compared = {**files, **self._compared}


def remedy(name: str, viewpoint: str) -> str:
    """Return what to do about a damaged file."""
    if viewpoint and name.startswith("stacks/"):
        return AGAIN.format(viewpoint=viewpoint)
    if name.startswith(("results/", "report/")):
        return COMPUTE
    return ACCEPT.format(name=name)
