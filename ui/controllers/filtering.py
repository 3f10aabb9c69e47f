"""Filtering the merged cloud, and taking filters back; the stitched cloud is never changed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from measureapp.errors import StorageError
from ui.controllers.jobs import JobRunner
from ui.look.wording import counted
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.cloud import StitchedCloud
    from measureapp.register.clouds.filter_chain import Filter, FilterChain
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class Filtered:
    """Filters on a cloud, and why they could not be kept with the project, if they could not."""

    of: StitchedCloud
    chain: FilterChain
    problem: StorageError | None


class FilteringController(QObject):
    """Keeps filters, and what they leave of the merged cloud, in the session and in the project's folder of results."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner

    @property
    def can_undo(self) -> bool:
        """Whether a filter can be taken back."""
        return self._session.filters is not None and not self._session.busy_with

    @property
    def _folder(self) -> Path | None:
        """Where the stitched cloud lies, and filters beside it; nowhere without a project on disk."""
        stored = self._session.files.get("stitched_cloud")
        return None if stored is None or not stored.exists() else stored.parent

    @Slot(object)
    def apply(self, wanted: Filter) -> None:
        """Filter what is left of the merged cloud."""
        session = self._session
        cloud, chain, folder = session.stitched, session.filters, self._folder
        if cloud is not None and not session.busy_with:
            self._runner.run("Filtering", lambda job: filtered(cloud, chain, wanted, folder, job), self._keep)

    @Slot()
    def undo(self) -> None:
        """Take the last filter back."""
        cloud, chain, folder = self._session.stitched, self._session.filters, self._folder
        if cloud is not None and chain is not None and self.can_undo:
            self._runner.run("Taking the filter back", lambda job: kept(cloud, chain.without_last(), folder, job), self._take_back)

    @Slot(object)
    def _keep(self, found: Filtered) -> None:
        session = self._session
        if found.of is not session.stitched:
            return
        before = len(session.filtered or found.of)
        if before == int(found.chain.kept_mask.sum()):
            session.tell("The filter takes no point away.", "Tighten it, or choose another kind.")
            return
        session.set_filters(found.chain)
        words = f"{counted(before - len(session.filtered or ()))} of {counted(before)} points are filtered out."
        self._tell(found, words, "Dimensions stay those of the stitched cloud.")

    @Slot(object)
    def _take_back(self, found: Filtered) -> None:
        if found.of is self._session.stitched:
            self._session.set_filters(found.chain)
            self._tell(found, "The last filter is taken back.", "")

    def _tell(self, found: Filtered, words: str, hint: str) -> None:
        if found.problem is None:
            self._session.tell(words, hint, "done")
        else:
            self._session.tell(f"{words} This is not kept with the project: {found.problem.message}", found.problem.hint, "warning")


def filtered(cloud: StitchedCloud, chain: FilterChain | None, wanted: Filter, folder: Path | None, job: Job) -> Filtered:
    """Add a filter to those of a cloud and keep them in ``folder``; runs on a job's thread."""
    from measureapp.progress import PartOf
    from measureapp.register.clouds.filter_chain import FilterChain

    before = FilterChain.empty(len(cloud)) if chain is None else chain
    after = before.append(wanted, cloud.points_mm, PartOf(job, 0.0, 0.9))
    return Filtered(cloud, after, None) if after.kept_mask.sum() == before.kept_mask.sum() else kept(cloud, after, folder, job)


def kept(cloud: StitchedCloud, chain: FilterChain, folder: Path | None, job: Job) -> Filtered:
    """Keep the filters of a cloud in ``folder``; where that cannot be written they are used all the same. Runs on a job's thread."""
    from measureapp.project.filter_file import save_filters

    job.report(9, 10, "Storing")
    try:
        if folder is not None:
            save_filters(folder, chain, cloud)
    except StorageError as error:
        return Filtered(cloud, chain, error)
    return Filtered(cloud, chain, None)
