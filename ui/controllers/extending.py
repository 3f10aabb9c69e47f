"""After a scan: what is still missing, and the viewpoints and exposures that are expected to measure it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.scanning import ScanController
from ui.controllers.stored_sessions import project_on_disk
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.plan import ScanPlan
    from measureapp.pipeline.closed_loop.of_project import ClosedLoop
    from ui.workers.job import Job


class ExtendingController(QObject):
    """Proposes viewpoints for the open project, and scans them."""

    found = Signal(object)  # ClosedLoop

    def __init__(self, session: Session, runner: JobRunner, scanning: ScanController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._scanning = session, runner, scanning
        self._extended: ScanPlan | None = None

    @property
    def can_look(self) -> bool:
        """Whether there is a scan to be compared with a nominal."""
        folder = project_on_disk(self._session)
        return bool(self._session.views) and folder is not None and any((folder / "inspection").glob("nominal.*"))

    @Slot()
    def look(self) -> None:
        """Compare the scan with the nominal, and find the views that pay."""
        folder = project_on_disk(self._session)
        if folder is not None:
            self._runner.run("Comparing the scan with its nominal", lambda job: find_missing(folder, job), self._show)

    @Slot(object)
    def _show(self, found: ClosedLoop) -> None:
        self._extended = found.plan
        self.found.emit(found)

    @Slot()
    def scan(self) -> None:
        """Add the proposed viewpoints to the plan of the project, and scan them."""
        folder, plan = project_on_disk(self._session), self._extended
        if folder is None or plan is None:
            return
        self._extended = None
        self._runner.run("Extending the plan", lambda job: store_plan(folder, plan, job), self._stored, quiet=True)

    @Slot(object)
    def _stored(self, plan: ScanPlan) -> None:
        self._session.set_plan(plan)
        self._session.await_viewpoints(tuple(one.id for one in plan if one.id not in self._session.viewpoints))
        self._scanning.take_up()


def find_missing(folder: Path, job: Job) -> ClosedLoop:
    """Find what a scan has not measured, and the views that pay; runs on a job's thread."""
    from measureapp.pipeline.closed_loop.of_project import find_next_views
    from measureapp.project.folder import ProjectFolder

    return find_next_views(ProjectFolder.open(folder), progress=job)


def store_plan(folder: Path, plan: ScanPlan, job: Job) -> ScanPlan:
    """Store the extended plan in the project; runs on a job's thread."""
    from measureapp.project.folder import ProjectFolder

    job.check()
    project = ProjectFolder.open(folder)
    with project.lock():
        project.save_plan(plan)
    return plan
