"""One measurement of operator mode: from Start to the filed result, or to the fault that ended it."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers import operator_work as work
from ui.controllers.jobs import CANCELLED, JobRunner
from ui.controllers.operator_nouns import Fault, Filed, ToMeasure
from ui.controllers.operator_shelf import ShelfController
from ui.controllers.rig_connection import VIRTUAL
from ui.controllers.rig_control import ALL_STOPPED, BY_BUTTON, RigControl
from ui.controllers.scanning import ScanController
from ui.look.wording import with_hint
from ui.messages import STOPPED as MESSAGE_OF_STOP
from ui.messages import Message
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.measurement import Measurement
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.run import ScanRequest
    from ui.workers.job import Job

TITLE = "Measurement"
STORED = {"stored", "processed"}
STOPPED = "The measurement was stopped."


class OperatorRun(QObject):
    """Runs a measurement and files its result."""

    began = Signal()
    finished = Signal()  # verdict known
    filedChanged = Signal()
    faultChanged = Signal()

    def __init__(
        self,
        session: Session,
        shelf: ShelfController,
        reading: JobRunner,
        scanning: ScanController,
        rig: RigControl,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._session, self._shelf, self._reading = session, shelf, reading
        self._scanning, self._rig = scanning, rig
        self.fault: Fault | None = None
        self.filed: Filed | None = None
        self.waits = False  # for the end of a run
        self.calibrates = False  # before the scan; only a virtual rig does
        self.is_stopping = False  # at the operator's request
        self._hindrance = ""  # why the run was paused when it was stopped
        self._wanted: ToMeasure | None = None
        self._folder: Path | None = None
        self._began_s = 0.0
        self._told: list[Message] = []  # warnings and errors since the run began
        session.reportChanged.connect(self._take_result)
        session.runChanged.connect(self._follow)
        session.messageAdded.connect(self._keep_message)

    def start(self, wanted: ToMeasure) -> None:
        """Measure a part in a new folder."""
        shelf = self._shelf.shelf
        if shelf is None or self.waits:
            return
        self._wanted = wanted
        self._folder = work.next_run_folder(shelf.settings, wanted.program.facts.name, wanted.entered.serial)
        self._run()

    @Slot()
    def resume(self) -> None:
        """Go on with the viewpoints that are missing after a fault."""
        if not self.waits:
            self._run()

    def _run(self) -> None:
        wanted, shelf, rig, folder, session = self._wanted, self._shelf.shelf, self._session.rig, self._folder, self._session
        if wanted is None or shelf is None or rig is None or folder is None:
            return
        settings = shelf.settings
        self._release_virtual_rig(rig)
        if session.cell.stopped == BY_BUTTON:
            self._rig.reset()
        self.fault, self.filed, self._told = None, None, []
        self._began_s, self.waits, self.calibrates, self.is_stopping = time.monotonic(), True, False, False
        session.open_project(wanted.program.facts.name, wanted.program.facts.name, folder)

        def request(job: Job) -> ScanRequest:
            job.check()
            made = work.scan_request(rig, wanted.program, wanted.entered, settings, folder)
            self.calibrates = made.calibrate
            return made

        self.began.emit()
        self._scanning.run(TITLE, request, "measurement")
        self._follow()  # it may have been refused at once

    def _release_virtual_rig(self, rig: RigDescription) -> None:
        """Release a connected virtual rig, which has another part on its table."""
        if self._session.connection is not None and rig.driver == VIRTUAL:
            self._rig.disconnect_rig()

    @property
    def elapsed_s(self) -> float:
        """Time since the run began."""
        return time.monotonic() - self._began_s

    @Slot()
    def pause(self) -> None:
        """Pause at the end of the present viewpoint."""
        self._scanning.pause()

    @Slot()
    def go_on(self) -> None:
        """Go on after a pause."""
        self._scanning.resume()

    @Slot()
    def stop(self) -> None:
        """Stop everything that moves."""
        self.is_stopping = True
        self._hindrance = self._session.run.cause
        self._rig.stop()
        self.faultChanged.emit()

    @Slot(object)
    def _keep_message(self, message: Message) -> None:
        if self.waits and message.level in ("warning", "error"):
            self._told.append(message)

    @Slot()
    def _follow(self) -> None:
        """Show a fault when a run has ended without a result."""
        if self.waits and self._session.run.state == "idle":
            self.waits = False
            fault = self.fault = self._fault()
            self.faultChanged.emit()
            folder = self._folder
            if fault.stored and folder is not None:  # by a job: a disk that does not answer must not stop the window
                title = "Looking for what is stored"
                self._reading.run(title, lambda _job: (fault, work.is_stored(folder)), self._show_stored, quiet=True)

    @Slot(object)
    def _show_stored(self, found: tuple[Fault, bool]) -> None:
        fault, is_stored = found
        if fault is self.fault and not is_stored:
            self.fault = replace(fault, is_lost=True)
            self.faultChanged.emit()

    def _fault(self) -> Fault:
        states = {id_: state.status for id_, state in self._session.viewpoints.items()}
        stored = sum(status in STORED for status in states.values())
        following = next((id_ for id_, status in states.items() if status not in STORED), "")
        errors = [message for message in self._told if message.level == "error"]
        if self.is_stopping and not errors:
            unconfirmed = [message.text for message in self._told if message.cause == MESSAGE_OF_STOP and message.text != ALL_STOPPED]
            return Fault(STOPPED, " ".join(filter(None, (self._hindrance, *unconfirmed))), stored, len(states), following)
        told = errors or [message for message in self._told if message.text != CANCELLED]
        cause, remedy = (told[-1].text, told[-1].hint) if told else (STOPPED, "")
        return Fault(cause, remedy, stored, len(states), following)

    @Slot()
    def _take_result(self) -> None:
        session, wanted, measurement = self._session, self._wanted, self._session.measurement
        if not self.waits or measurement is None or session.folder is None or session.folder != self._folder or wanted is None:
            return
        self.waits = False
        seconds, folder = self.elapsed_s, session.folder
        self.finished.emit()
        self._file(wanted, folder, measurement)
        self._remember(wanted, seconds, folder)

    def _file(self, wanted: ToMeasure, folder: Path, measurement: Measurement) -> None:
        program, reason = wanted.program, wanted.reason
        self._reading.run(
            "Filing the result",
            lambda job: work.file_finished(job, folder, measurement, program, reason),
            self._show_filed,
            on_failed=self._filing_failed,
            quiet=True,
        )

    def _remember(self, wanted: ToMeasure, seconds: float, folder: Path) -> None:
        """Store how long the run took, who measured, and for the virtual rig which calibration is used from now on."""
        shelf, rig = self._shelf.shelf, self._session.rig
        if shelf is not None and rig is not None:
            settings = shelf.settings.with_duration(wanted.program.facts.name, seconds)
            settings = settings.model_copy(update={"operator": wanted.entered.operator})
            self._shelf.store_settings(settings, wanted.card, folder if rig.driver == VIRTUAL else None)

    @Slot(object)
    def _show_filed(self, filed: Filed) -> None:
        self.filed = filed
        self.filedChanged.emit()
        self._shelf.reload()

    @Slot(object)
    def _filing_failed(self, error: MeasureError) -> None:
        self._show_filed(Filed(problem=with_hint(error.message, error.hint)))
