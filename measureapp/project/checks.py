"""Every byte of a project against its journal."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from measureapp.errors import Damaged, StorageError
from measureapp.progress import NoProgress, Progress
from measureapp.project import raw_images
from measureapp.project.inputs import changes, current_inputs
from measureapp.project.journal import disk, publish, seal
from measureapp.project.journal.database import JOURNAL, find_damage
from measureapp.project.journal.state import Contents, Journal

THREADS = 2
STACKS, BOARD, CLOUDS = "stacks", ("calibration", "views"), ("results", "clouds")


@dataclass(frozen=True, slots=True)
class Damage:
    """A file that is not what was stored."""

    file: str  # path relative to the project
    viewpoint: str  # empty where the file belongs to none
    problem: str  # a sentence without its full stop


@dataclass(frozen=True, slots=True)
class Verified:
    """The result of a check."""

    viewpoints: tuple[str, ...]
    files: int
    bytes: int
    damage: tuple[Damage, ...] = ()
    unknown: tuple[str, ...] = ()  # files that the journal does not know
    stale: tuple[str, ...] = ()  # what has changed since the results were computed, in sentences
    removed: tuple[str, ...] = ()  # viewpoints whose raw images were removed on purpose
    journal: bool = True  # False: of an earlier version, whose checksums cover images only

    @property
    def whole(self) -> bool:
        """Whether nothing is damaged."""
        return not self.damage


@dataclass(slots=True)
class _Found:
    damage: list[Damage] = field(default_factory=list)
    bytes: int = 0


def verify(project: Path, journal: Journal, progress: Progress | None = None) -> Verified | None:
    """Compare every file with the journal, and the journal with itself; None without a journal.

    Files are read in two threads. Nothing is written.

    Raises
    ------
    Damaged, StorageError
        The journal itself cannot be used, so that nothing can be compared.
    Cancelled
        From ``progress``.
    """
    progress = progress or NoProgress()
    contents = journal.contents()
    if contents is None:
        return None
    found = _Found(list(_journal_damage(project, contents)))
    order = sorted(contents.files)
    whole = max(sum(state.size for state in contents.files.values()), 1)
    with ThreadPoolExecutor(THREADS, "verifying") as pool:
        try:
            for name, same in zip(order, pool.map(lambda name: journal.is_same(name, contents.files[name]), order), strict=True):
                found.bytes += contents.files[name].size
                progress.report(found.bytes, whole, name)
                if not same:
                    found.damage.append(_damage(project, name))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    board = {name.split("/")[2] for name in order if tuple(name.split("/")[:2]) == BOARD}
    return Verified(
        viewpoints=(*sorted(contents.viewpoints), *sorted(board)),
        files=len(order),
        bytes=found.bytes,
        damage=tuple(found.damage),
        unknown=tuple(_unknown(project, contents)),
        removed=tuple(one.viewpoint_id for one in raw_images.list_raw(journal) if one.state == "removed"),
        stale=changes(contents.results.get("inputs", {}), current_inputs(contents)),
    )


def of_journal(error: Damaged) -> Verified:
    """Return the result for a project whose journal cannot be used, so that nothing else can be compared."""
    return Verified((), 0, 0, (Damage(JOURNAL, "", f"{error.message} {error.hint}"),))


def of_images(project: Path, viewpoints: Iterable[str], problems: Mapping[str, tuple[str, ...]]) -> Verified:
    """Return the result for a project of an earlier version, whose checksums cover images only."""
    damage = tuple(Damage(_file_in(project, problem), viewpoint, problem) for viewpoint, found in problems.items() for problem in found)
    return Verified(tuple(viewpoints), 0, 0, damage, journal=False)


def _file_in(project: Path, problem: str) -> str:
    return next((word.removeprefix(f"{project}/") for word in problem.split() if word.startswith(str(project))), "")


def viewpoint_of(name: str) -> str:
    """Return the viewpoint, or the view of the board, that a file of a project belongs to; empty if it belongs to none."""
    parts = name.split("/")
    if parts[0] == STACKS and len(parts) > 2:
        return parts[1]
    if tuple(parts[:2]) == BOARD and len(parts) > 3:
        return parts[2]
    return Path(name).stem if tuple(parts[:2]) == CLOUDS else ""


def _damage(project: Path, name: str) -> Damage:
    path = project / name
    return Damage(name, viewpoint_of(name), f"{path} differs from its stored checksum" if path.exists() else f"{path} is missing")


def _journal_damage(project: Path, contents: Contents) -> list[Damage]:
    try:
        problem = find_damage(project) or seal.problem(project, contents.lines)
    except (Damaged, StorageError) as error:
        problem = error.message.rstrip(".")
    return [Damage(JOURNAL, "", f"{project / JOURNAL} is damaged: {problem}")] if problem else []


def _unknown(project: Path, contents: Contents) -> list[str]:
    waiting = {state.part for state in contents.files.values() if state.part}
    found = []
    for folder, folders, names in os.walk(project):
        here = Path(folder).relative_to(project)
        folders[:] = sorted(name for name in folders if not disk.PART.match(name))
        for name in sorted(names):
            relative = (here / name).as_posix()
            own = name in publish.OWN or disk.PART.match(name) is not None
            if not own and relative not in contents.files and relative not in waiting:
                found.append(relative)
    return found
