"""Filtering of the merged cloud, with undo; the stitched cloud is never changed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Slot

from measureapp.errors import StorageError
from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.look.wording import counted
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.cloud import StitchedCloud
    from measureapp.register.clouds.filter_chain import Filter, FilterChain
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class Filtered:
    """Filters of a cloud, and the error if they could not be stored with the project."""

    of: StitchedCloud
    chain: FilterChain
    problem: StorageError | None


class FilteringController(QObject):
    """Holds filters and the filtered cloud in the session, and stores them with the project's results."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner

    @property
    def can_undo(self) -> bool:
        """Whether a filter can be undone."""
        return self._session.filters is not None and not self._session.busy_with

    @property
    def _folder(self) -> Path | None:
        """The folder of the stitched cloud and its filters; None without a project on disk."""
        stored = self._session.files.get("stitched_cloud")
        return None if stored is None or not stored.exists() else stored.parent

    @Slot(object)
    def apply(self, wanted: Filter) -> None:
        """Add a filter to the merged cloud."""
        session = self._session
        cloud, chain, folder = session.stitched, session.filters, self._folder
        if cloud is not None and not session.busy_with:
            self._runner.run("Filtering", lambda job: add_filter(cloud, chain, wanted, folder, job), self._keep)

    @Slot()
    def undo(self) -> None:
        """Undo the last filter."""
        cloud, chain, folder = self._session.stitched, self._session.filters, self._folder
        if cloud is not None and chain is not None and self.can_undo:
            self._runner.run("Undoing the filter", lambda job: store_filters(cloud, chain.without_last(), folder, job), self._undo_finished)

    @Slot(object)
    def _keep(self, found: Filtered) -> None:
        session = self._session
        if found.of is not session.stitched:
            return
        before = len(session.filtered or found.of)
        if before == int(found.chain.kept_mask.sum()):
            session.tell("The filter removes no points.", "Use stricter limits, or another filter.")
            return
        session.set_filters(found.chain)
        words = tr("{counted} of {before} points removed.", counted=counted(before - len(session.filtered or ())), before=counted(before))
        self._tell(found, words, "Dimensions still refer to the stitched cloud.")

    @Slot(object)
    def _undo_finished(self, found: Filtered) -> None:
        if found.of is self._session.stitched:
            self._session.set_filters(found.chain)
            self._tell(found, "Last filter undone.", "")

    def _tell(self, found: Filtered, words: str, hint: str) -> None:
        if found.problem is None:
            self._session.tell(words, hint, "done")
        else:
            self._session.tell(
                tr("{words} Not saved with the project: {message}", words=words, message=found.problem.message),
                found.problem.hint,
                "warning",
            )


def add_filter(cloud: StitchedCloud, chain: FilterChain | None, wanted: Filter, folder: Path | None, job: Job) -> Filtered:
    """Add a filter to those of a cloud and store them in ``folder``; runs on a job's thread."""
    from measureapp.progress import PartOf
    from measureapp.register.clouds.filter_chain import FilterChain

    before = FilterChain.empty(len(cloud)) if chain is None else chain
    after = before.append(wanted, cloud.points_mm, PartOf(job, 0.0, 0.9))
    return Filtered(cloud, after, None) if after.kept_mask.sum() == before.kept_mask.sum() else store_filters(cloud, after, folder, job)


def store_filters(cloud: StitchedCloud, chain: FilterChain, folder: Path | None, job: Job) -> Filtered:
    """Store the filters of a cloud in ``folder``; they are used even if that fails. Runs on a job's thread."""
    from measureapp.project.filter_file import save_filters

    job.report(9, 10, "Storing")
    try:
        if folder is not None:
            save_filters(folder, chain, cloud)
    except StorageError as error:
        return Filtered(cloud, chain, error)
    return Filtered(cloud, chain, None)
