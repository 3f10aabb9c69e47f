"""Filtering the merged cloud, and taking filters back; the stitched cloud is never changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.wording import counted
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.cloud import StitchedCloud
    from measureapp.register.sieve import Filter
    from ui.workers.job import Job

FILE = "filtered_cloud.ply"


class FilteringController(QObject):
    """Keeps what is left of the merged cloud beside it, in the session and in the project's folder of results."""

    undoChanged = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._former: list[StitchedCloud | None] = []
        self._of: StitchedCloud | None = None
        session.cloudsChanged.connect(self._follow)

    @property
    def can_undo(self) -> bool:
        """Whether a filter can be taken back."""
        return bool(self._former) and not self._session.busy_with

    @property
    def _path(self) -> Path | None:
        """Where the filtered cloud lies: beside the stitched one; nowhere without a project on disk."""
        stored = self._session.files.get("stitched_cloud")
        return None if stored is None or not stored.exists() else stored.with_name(FILE)

    @Slot(object)
    def apply(self, wanted: Filter) -> None:
        """Filter what is left of the merged cloud."""
        session = self._session
        cloud, path = session.filtered or session.stitched, self._path
        if cloud is None or session.busy_with:
            return
        self._of = session.stitched
        self._runner.run("Filtering", lambda job: filtered(cloud, wanted, path, job), self._keep)

    @Slot()
    def undo(self) -> None:
        """Take the last filter back."""
        if self.can_undo:
            former, path = self._former[-1], self._path
            self._runner.run("Taking the filter back", lambda job: kept(former, path, job), self._take_back)

    @Slot(object)
    def _keep(self, found: StitchedCloud) -> None:
        session = self._session
        if session.stitched is None or self._of is not session.stitched:
            return
        before = session.filtered or session.stitched
        self._former.append(session.filtered)
        session.set_filtered(found)
        where = f"It lies beside the stitched cloud as {FILE}. " if self._path is not None else ""
        words = f"{counted(len(before) - len(found))} of {counted(len(before))} points are filtered out."
        session.tell(words, f"{where}Dimensions stay those of the stitched cloud.", "done")
        self.undoChanged.emit()

    @Slot(object)
    def _take_back(self, former: StitchedCloud | None) -> None:
        if self._former:
            self._former.pop()
        self._session.set_filtered(former)
        self._session.tell("The last filter is taken back.", "", "done")
        self.undoChanged.emit()

    @Slot()
    def _follow(self) -> None:
        """Forget the filters of a cloud that is no longer there."""
        if self._session.filtered is None and self._former and self._session.stitched is not self._of:
            self._former.clear()
            self.undoChanged.emit()


def filtered(cloud: StitchedCloud, wanted: Filter, path: Path | None, job: Job) -> StitchedCloud:
    """Return what a filter leaves, written to ``path``; runs on a job's thread."""
    from measureapp.register.sieve import sieved

    stays, _ = sieved(cloud.points_mm, (wanted,), job)
    left = cloud.where(stays)
    kept(left, path, job)
    return left


def kept(cloud: StitchedCloud | None, path: Path | None, job: Job) -> StitchedCloud | None:
    """Write the filtered cloud, or take its file away where nothing is filtered; runs on a job's thread."""
    from measureapp.project.geometry.files import write_cloud

    job.check()
    if path is not None and cloud is None:
        path.unlink(missing_ok=True)
    elif path is not None and cloud is not None:
        write_cloud(path, cloud)
    return cloud
