"""Raw images after a scan, as the project states: kept, compressed, or dropped; a job of low priority that can be interrupted anywhere."""

from __future__ import annotations

import time
from concurrent.futures import Future
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from measureapp.data.raw_policy import RawPolicy
from measureapp.pipeline.worker import Worker
from measureapp.progress import Progress
from measureapp.project import raw_images
from measureapp.project.folder import ProjectFolder
from measureapp.project.inputs import current_inputs

POLL_S = 0.05


@dataclass(frozen=True, slots=True)
class RawOutcome:
    """What was done about the raw images of a project."""

    policy: RawPolicy
    done: tuple[str, ...]  # viewpoints
    freed_bytes: int

    @property
    def sentence(self) -> str:
        """What was done, in words; empty if nothing was."""
        if not self.done:
            return ""
        verb = "compressed" if self.policy == "compress" else "dropped"
        return f"Raw images of {len(self.done)} viewpoints {verb}: {self.freed_bytes / 1e6:.0f} MB freed."


def pending_raw(project: ProjectFolder) -> tuple[str, ...]:
    """Return the viewpoints whose raw images do not yet have the state that the project wants.

    Images are dropped only where the results have a cloud that was computed from them. Raises StorageError.
    """
    policy, contents = project.storage_rules().raw, project.journal.contents()
    if policy == "keep" or contents is None:
        return ()
    states = {one.viewpoint_id: one.state for one in raw_images.list_raw(project.journal)}
    if policy == "compress":
        return tuple(name for name, state in states.items() if state in ("raw", "mixed"))
    computed, now = contents.results.get("inputs", {}).get("stacks", {}), current_inputs(contents)["stacks"]

    def is_computed(name: str) -> bool:
        return bool(now.get(name)) and computed.get(name) == now[name] and f"results/clouds/{name}.ply" in contents.files

    return tuple(name for name, state in states.items() if state != "removed" and is_computed(name))


def apply_raw_policy(project: ProjectFolder, progress: Progress) -> RawOutcome:
    """Bring the raw images of a project into the state that it wants, one viewpoint after the other, at low priority.

    The project is locked for one viewpoint at a time, and whoever wants to write it meanwhile waits for no more than that one. Nothing is
    lost where the program is killed, or ``progress`` cancels: the next call continues.

    Raises
    ------
    StorageError
        The project is in use, or its disk fails.
    Cancelled
        From ``progress``.
    """
    wanted, before, done = pending_raw(project), _size(project), list[str]()
    policy = project.storage_rules().raw
    worker = Worker("raw images")
    try:
        for number, name in enumerate(wanted):
            progress.report(number, len(wanted), f"Raw images of {name}")
            _wait(worker.submit(partial(_one, project.path, name)), progress)
            done.append(name)
    finally:
        worker.close(0.0)
    progress.report(1, 1, "")
    return RawOutcome(policy, tuple(done), before - _size(project))


def _one(path: Path, viewpoint_id: str) -> None:
    project = ProjectFolder.open(path)
    with project.lock(yields=True):
        if viewpoint_id not in pending_raw(project):  # changed meanwhile
            return
        act = raw_images.compress if project.storage_rules().raw == "compress" else raw_images.remove_images
        act(project.journal, viewpoint_id)


def _wait(future: Future[None], progress: Progress) -> None:
    while not future.done():
        progress.check()
        time.sleep(POLL_S)
    future.result()


def _size(project: ProjectFolder) -> int:
    if project.journal.contents() is None:
        return 0
    return sum(one.bytes for one in raw_images.list_raw(project.journal))
