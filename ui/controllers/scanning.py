"""Scanning with the rig: check, start, pause, resume, skip, retake; the end in words."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.data.verdicts import part_verdict
from measureapp.errors import InputError, MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_control import RigControl
from ui.controllers.run_events import RunEvents
from ui.controllers.scan_choices import CheckedScan, MakeRequest, ScanChoices, request_maker
from ui.controllers.stored_sessions import project_on_disk
from ui.look.language.words import tr
from ui.look.verdict_words import summary_words
from ui.look.wording import several
from ui.messages import MOMENT
from ui.session import RunNow, Session

if TYPE_CHECKING:
    from measureapp.acquire.control import RunControl
    from measureapp.acquire.time_left import RunClock, TimeLeft
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.plan import ScanPlan
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.events import Event
    from measureapp.pipeline.run import Outcome, ScanRequest
    from ui.workers.job import Job

NOT_PROCESSED = "The images are stored. They are not processed, because the project has no calibration."
CALIBRATE_IT = "Calibrate the rig, then press Recompute on the page Scan."
PAUSES_FIRST = "The scan pauses before its first viewpoint; what comes before it can only be cancelled."


@dataclass(frozen=True, eq=False)
class ScanPrepared:
    """Rig, plan and folder of the scan that begins."""

    request: ScanRequest
    name: str
    part: str
    calibration: RigCalibration | None = None  # with which is scanned


class ScanController(QObject):
    """Runs scans, one at a time, and shows their progress in the session."""

    checked = Signal(object)  # CheckedScan
    completed = Signal(object)  # Outcome, or None for images that are not processed
    ended = Signal()  # however the scan ended

    def __init__(self, session: Session, runner: JobRunner, background: JobRunner, rig: RigControl, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._background, self._rig = session, runner, background, rig
        self._events = RunEvents(session, self)
        self._control: RunControl | None = None
        self._wanted: ScanChoices | None = None  # started after a check without problems
        self._passed = self._pauses_first = False
        self._subject = "scan"
        self._clock: RunClock | None = None

    @property
    def is_running(self) -> bool:
        """Whether a scan runs."""
        return self._session.run.state != "idle"

    @property
    def is_taking(self) -> bool:
        """Whether images are still to be taken; afterwards clouds are computed, which can only be cancelled."""
        return self._control is not None and self._control.state != "ended"

    def left(self) -> TimeLeft | None:
        """Return how long the taking of images still takes; None while that is not known."""
        return None if self._clock is None else self._clock.left(time.monotonic())

    # before

    def check(self, choices: ScanChoices) -> None:
        """Connect the rig, if it is not, and find everything that would prevent the scan; nothing moves, nothing is written."""
        self._wanted = None
        self._check(choices)

    def start(self, choices: ScanChoices) -> None:
        """Check, and start the scan if nothing prevents it."""
        self._wanted, self._passed = choices, False
        self._check(choices)

    def _check(self, choices: ScanChoices) -> None:
        if self._refuse_second():
            return
        self._rig.connect_rig()
        make, session = request_maker(choices, self._session), self._session
        job = self._runner.run("Checking the scan", lambda job: check_scan(job, choices, make, session), self._show_checked)
        job.ended.connect(self._start_checked)

    @Slot(object)
    def _show_checked(self, found: CheckedScan) -> None:
        self.checked.emit(found)
        self._passed = not found.problems
        if found.problems:
            self._session.tell(
                tr("{count} the scan.", count=several(len(found.problems), "thing prevents", "things prevent")),
                "See the list on the page Scan.",
                "warning",
            )

    @Slot()
    def _start_checked(self) -> None:
        """Start the scan that was wanted, unless its check has failed; the job of the check has ended."""
        wanted, self._wanted = self._wanted, None
        if wanted is not None and self._passed:
            self.run("Scan", request_maker(wanted, self._session))

    # the run

    def run(self, title: str, make: MakeRequest, subject: str = "scan") -> None:
        """Run the scan that ``make`` requests; ``subject`` is its word in messages."""
        if self._refuse_second():
            return
        from measureapp.acquire.control import RunControl

        self._subject, self._pauses_first, control = subject, False, RunControl()
        self._control = control
        self._session.set_run(RunNow("running"))
        events, session = self._events, self._session

        def work(job: Job) -> Outcome | None:
            from measureapp.pipeline.run import scan_into_project

            job.report(0, 1, "Preparing the scan")
            request = make(job)
            job.emit_event(_prepared(request))
            return scan_into_project(replace(request, language=job.language), events.sink(job), job, control, session.connection)

        job = self._runner.run(title, work, self._finish, on_event=self._apply, moves=True)
        job.ended.connect(self._ended)

    def _refuse_second(self) -> bool:
        """Say so where something else is running."""
        return self._session.refuse_during_job()

    @Slot(object)
    def _apply(self, event: Event | ScanPrepared) -> None:
        if isinstance(event, ScanPrepared):
            self._show_prepared(event)
            return
        self._count(event)
        self._events.apply(event)

    def _count(self, event: Event) -> None:
        """Let the clock of the run follow its events."""
        from measureapp.acquire.events import AcquisitionEvent, RunEnded, RunStarted
        from measureapp.acquire.time_left import RunClock, planned_seconds

        plan = self._session.plan
        if isinstance(event, RunStarted) and self._pauses_first:
            self._pauses_first = False
            self.pause()
        if isinstance(event, RunStarted) and plan is not None and self._session.rig is not None:
            wanted = [viewpoint for viewpoint in plan if viewpoint.id in event.viewpoint_ids]
            self._clock = RunClock(planned_seconds(plan, wanted, self._session.rig)) if wanted else None  # all may be stored
        elif isinstance(event, RunEnded):
            self._clock = None
        elif self._clock is not None and isinstance(event, AcquisitionEvent):
            self._clock.receive(event, time.monotonic())

    def _show_prepared(self, prepared: ScanPrepared) -> None:
        session, request = self._session, prepared.request
        if session.folder != request.folder or not session.viewpoints:
            session.open_project(prepared.name, prepared.part, request.folder)
        if session.rig != request.rig:
            session.set_rig(request.rig)
        session.set_plan(request.plan)
        if session.calibration is None and prepared.calibration is not None:
            session.set_calibration(prepared.calibration)

    @Slot(object)
    def _finish(self, outcome: Outcome | None) -> None:
        self._tell_outcome(outcome)
        folder = project_on_disk(self._session)
        if outcome is not None and folder is not None:
            keep = "Storing raw images as the project states"
            self._background.run(keep, lambda job: care_for_raw_images(folder, job), self._tell_raw, quiet=True)
        self.completed.emit(outcome)

    @Slot(object)
    def _tell_raw(self, words: str) -> None:
        if words:
            self._session.tell(words, "", "done")

    def _tell_outcome(self, outcome: Outcome | None) -> None:
        if outcome is None:
            self._session.tell(NOT_PROCESSED, CALIBRATE_IT, "warning")
            return
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        inspection = outcome.measurement.inspection
        verdicts = [str(dimension.verdict) for dimension in inspection.dimensions] if inspection else []
        words = tr("The {subject} is complete.", subject=self._subject)
        if not verdicts or part_verdict(verdicts) == "pass":
            self._session.tell(f"{words} {summary_words(verdicts)}" if verdicts else words, "", "done")
        else:
            self._session.tell(
                f"{words} {summary_words(verdicts)}", "The page Inspect shows the worst dimension first.", "warning", cause=MOMENT
            )

    @Slot()
    def _ended(self) -> None:
        self._control = self._clock = None
        self._session.set_run(RunNow())
        self._rig.refresh()  # where it stands, and whether it was stopped
        self.ended.emit()

    # during

    @Slot()
    def pause(self) -> None:
        """Pause as soon as the rig is safe; before the first viewpoint, when the scan begins."""
        control = self._control
        if control is not None and control.state == "idle":  # the rig is being connected or calibrated
            self._pauses_first = True
            self._session.set_run(RunNow("pausing", PAUSES_FIRST))
        elif control is not None and self._ask(control.pause):
            self._session.set_run(RunNow("pausing"))

    @Slot()
    def resume(self) -> None:
        """Go on after a pause."""
        if self._control is not None:
            self._ask(self._control.resume)

    def skip(self, viewpoint_id: str | None = None) -> None:
        """Skip a viewpoint, or the present one."""
        control = self._control
        if control is not None:
            self._ask(lambda: control.skip(viewpoint_id))

    def retake(self, viewpoint_id: str) -> None:
        """Take a viewpoint again: at the end of the run, or at once where none runs."""
        control = self._control
        if control is not None:
            self._ask(lambda: control.retake(viewpoint_id))
            return
        folder, plan, rig = project_on_disk(self._session), self._session.plan, self._session.rig
        if folder is not None and plan is not None and rig is not None:
            self.run("Scan", lambda _job: _stored_request(plan, rig, folder, retake=(viewpoint_id,)))

    def _ask(self, request: Callable[[], None]) -> bool:
        """Make a request of the run; say why where it makes no sense."""
        try:
            request()
        except InputError as error:
            self._session.tell(error.message, error.hint, "warning")
            return False
        return True

    # an interrupted scan

    @property
    def missing(self) -> tuple[str, ...]:
        """Viewpoints of the open project whose images are not stored."""
        session = self._session
        if session.plan is None or project_on_disk(session) is None:
            return ()
        known = session.viewpoints
        return tuple(one.id for one in session.plan if one.id not in known or known[one.id].status in {"waiting", "skipped"})

    @Slot()
    def take_up(self) -> None:
        """Take the missing viewpoints of the open project."""
        folder, plan, rig = project_on_disk(self._session), self._session.plan, self._session.rig
        if folder is not None and plan is not None and rig is not None:
            begun = not self._session.calibration and (folder / "calibration" / "views").is_dir()  # with its calibration
            self.run("Scan", lambda _job: _stored_request(plan, rig, folder, calibrate=begun))


def care_for_raw_images(folder: Path, job: Job) -> str:
    """Compress or drop the raw images of a project as it states, and say what was done; runs on a job's thread."""
    from measureapp.pipeline.raw_keeping import apply_raw_policy
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    if project.storage_rules().raw == "keep":
        return ""
    return apply_raw_policy(project, job).sentence


def _prepared(request: ScanRequest) -> ScanPrepared:
    """Return what the window shows of a scan that begins; runs on a job's thread."""
    from measureapp.project.folder import ProjectFolder

    calibrated = request.calibrated or request.folder
    calibration = ProjectFolder.open(calibrated).calibration() if (calibrated / "project.json").is_file() else None
    if request.created is not None:
        return ScanPrepared(request, request.created.name, request.created.part, calibration)
    project = ProjectFolder.open(request.folder)
    return ScanPrepared(request, project.name, project.settings.part, calibration)


def _stored_request(
    plan: ScanPlan, rig: RigDescription, folder: Path, *, calibrate: bool = False, retake: tuple[str, ...] = ()
) -> ScanRequest:
    """Return the request that takes the missing viewpoints of a stored project, and those of ``retake``; runs on a job's thread."""
    from measureapp.pipeline.run import ScanRequest

    return ScanRequest(plan, rig, folder, resume=True, retake=retake, calibrate=calibrate)


def check_scan(job: Job, choices: ScanChoices, make: MakeRequest, session: Session) -> CheckedScan:
    """Check a scan on the connected rig; runs on a job's thread."""
    from measureapp.pipeline.run import rehearse
    from measureapp.project.folder import ProjectFolder

    job.report(0, 1, "Checking the scan")
    try:
        request = make(job)
        found = rehearse(request, session.connection, job)
        stored = len(ProjectFolder.open(request.folder).stored_viewpoints()) if choices.is_existing else 0
    except MeasureError as error:
        return CheckedScan(choices, problem=error)
    return CheckedScan(choices, found, stored, len(request.plan))
