"""All calibrations of the rig in one automatic run: it takes the images of the board itself, and they are solved together."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_control import RigControl
from ui.controllers.run_events import RunEvents
from ui.controllers.stored_sessions import project_on_disk
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.board import AnyBoard
    from measureapp.pipeline.rig_calibration import CalibratedRig
    from measureapp.project.folder import ProjectFolder
    from ui.workers.job import Job

NEW_FOLDER = Path("MeasureApp") / "calibration"


class RigCalibratingController(QObject):
    """Lets the rig calibrate itself into a project. Views stored there are not taken again."""

    begun = Signal()
    progressed = Signal(float, str)
    calibrated = Signal(object)  # CalibratedRig
    failed = Signal(object)  # MeasureError
    ended = Signal()  # however it ended

    def __init__(self, session: Session, runner: JobRunner, rig: RigControl, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._rig = session, runner, rig
        self._events = RunEvents(session, self)
        self._job: Job | None = None

    @property
    def is_running(self) -> bool:
        """Whether the rig is being calibrated."""
        return self._job is not None

    def suggested_folder(self) -> Path:
        """Return the folder of the open project, or of a new one."""
        return project_on_disk(self._session) or Path.home() / NEW_FOLDER

    def board_in(self, folder: Path | None) -> AnyBoard | None:
        """Return the board of a project; None where there is none, or it cannot be read."""
        from measureapp.project.folder import ProjectFolder

        try:
            return None if folder is None else ProjectFolder.open(folder).settings.board
        except MeasureError:
            return None

    def start(self, folder: Path, board: AnyBoard | None) -> None:
        """Take the missing views of the board and solve all; ``board``: of a new project."""
        session, rig, held = self._session, self._session.rig, self._session.connection
        if rig is None or self.is_running:
            return
        if session.refuse_during_job():
            return
        events, plan = self._events, session.plan

        def work(job: Job) -> tuple[CalibratedRig, ProjectFolder]:
            from measureapp.pipeline.rig_calibration import CalibrationRequest, calibrate_into_project

            job.report(0, 1, "Connecting the rig")
            request = CalibrationRequest(rig, folder, plan, board)
            return calibrate_into_project(request, events.sink(job), job, held=held)

        self._job = self._runner.run(
            "Calibration of the rig", work, self._finish, on_event=self._events.apply, on_failed=self.failed.emit, moves=True
        )
        self._job.progressed.connect(self.progressed)
        self._job.ended.connect(self._end)
        self.begun.emit()

    @Slot()
    def stop(self) -> None:
        """Stop the run; the views taken so far are kept."""
        if self._job is not None:
            self._job.cancel()

    @Slot(object)
    def _finish(self, found: tuple[CalibratedRig, ProjectFolder]) -> None:
        calibrated, project = found
        session = self._session
        if session.folder != project.path:
            plan = session.plan
            session.open_project(project.name, project.settings.part, project.path)
            session.set_plan(project.plan() or plan)
        session.set_calibration(calibrated.solved.solution.calibration)
        verdict = calibrated.solved.verdict
        session.tell(
            tr("The rig is calibrated. {sentence}", sentence=verdict.sentence),
            verdict.remedy,
            "warning" if verdict.level == "bad" else "done",
        )
        self.calibrated.emit(calibrated)

    @Slot()
    def _end(self) -> None:
        self._job = None
        self._rig.refresh()  # where it stands, and whether it was stopped
        self.ended.emit()
