"""Operator mode: from a part program over the serial number and the measurement to the filed verdict."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers import operator_work as work
from ui.controllers.jobs import JobRunner
from ui.controllers.operator_codes import CodeFields, check_code, find_program
from ui.controllers.operator_nouns import Entered, Fault, Filed, ProgramCard, ShiftCount, Step, count_shift, counted_run
from ui.controllers.rig_connection import VIRTUAL
from ui.controllers.rig_control import BY_BUTTON, RigControl
from ui.controllers.scanning import ScanController
from ui.session import Message, Session

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgramFacts
    from measureapp.data.rig import RigDescription
    from measureapp.data.series import SeriesRun
    from measureapp.pipeline.run import ScanRequest
    from measureapp.project.operator_settings import OperatorSettings
    from ui.workers.job import Job

TITLE = "Measurement"
STORED = {"stored", "processed"}
STOPPED = Fault("The measurement was stopped.", "What was measured so far is kept.", 0, 0)


class OperatorController(QObject):
    """Holds where the operator is, and takes him on. Everything slow runs in jobs of its own queue."""

    stepChanged = Signal(str)
    shelfChanged = Signal()  # programs, runs, settings
    enteredChanged = Signal()  # what a scanned code states about the part
    obstaclesChanged = Signal()
    finished = Signal()  # verdict known
    filedChanged = Signal()
    faultChanged = Signal()
    said = Signal(str, str)  # words, level

    def __init__(
        self,
        session: Session,
        reading: JobRunner,
        jobs: JobRunner,
        scanning: ScanController,
        rig: RigControl,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._session, self._reading, self._jobs = session, reading, jobs
        self._scanning, self._rig = scanning, rig
        self.step: Step = "home"
        self.shelf: work.Shelf | None = None
        self.chosen: ProgramCard | None = None
        self.entered = Entered()
        self.obstacles: tuple[str, ...] | None = None  # None: not checked yet
        self.fault: Fault | None = None
        self.filed: Filed | None = None
        self.reason = ""  # why a part is measured again
        self._folder: Path | None = None
        self._began_s = 0.0
        self._waits = False  # for the end of a run
        self._told: list[Message] = []  # warnings and errors since the run began
        self._offered: Path | None = None  # project with the calibration that the engineer left open
        session.reportChanged.connect(self._take_result)
        session.runChanged.connect(self._follow_run)
        session.messageAdded.connect(self._keep_message)
        session.rigChanged.connect(self.check)
        session.cellChanged.connect(self.obstaclesChanged)
        session.busyChanged.connect(self.obstaclesChanged)

    # programs and runs

    @Slot()
    def reload(self) -> None:
        """Read the part programs and the runs again."""
        from measureapp.project.operator_settings import operator_file

        file = operator_file()
        self._reading.run(
            "Reading the part programs", lambda job: work.read_shelf(job, file), self._show_shelf, on_failed=self._fail, quiet=True
        )

    @Slot(object)
    def _show_shelf(self, shelf: work.Shelf) -> None:
        self.shelf = shelf
        if self.chosen is not None:
            path = self.chosen.path
            self.chosen = next((card for card in shelf.cards if card.path == path), self.chosen)
        if self._offered is not None and str(self._offered) != shelf.settings.calibrated:
            self.store_settings(shelf.settings.model_copy(update={"calibrated": str(self._offered)}))
        self._offered = None
        self.shelfChanged.emit()
        for problem in shelf.problems:
            self.said.emit(problem, "error")

    @Slot(object)
    def _fail(self, error: MeasureError) -> None:
        self.said.emit(f"{error.message} {error.hint}".strip(), "error")

    @property
    def facts(self) -> PartProgramFacts | None:
        """Name, numbers and remarks of the chosen program."""
        return None if self.chosen is None or self.chosen.program is None else self.chosen.program.facts

    @property
    def runs(self) -> tuple[SeriesRun, ...]:
        """All runs, in order of measurement."""
        return () if self.shelf is None else self.shelf.runs

    def runs_of(self, serial: str) -> tuple[SeriesRun, ...]:
        """Return the runs of one part by the chosen program."""
        facts = self.facts
        if facts is None or not serial:
            return ()
        return tuple(run for run in self.runs if run.program == facts.name and run.identification.serial_number == serial)

    def shift(self) -> ShiftCount:
        """Return the numbers of this shift."""
        from datetime import datetime

        if self.shelf is None:
            return ShiftCount()
        return count_shift(self.shelf.runs, self.shelf.settings.shift_start(datetime.now().astimezone()))

    @Slot()
    def take_calibration(self) -> None:
        """Let the calibration of the project that is open now be the one in use from here on, if it has one."""
        self._offered = self._session.folder if self._session.calibration is not None else None

    # from step to step

    def _go(self, step: Step) -> None:
        self.step = step
        self.said.emit("", "info")
        self.stepChanged.emit(step)

    @Slot()
    def go_home(self) -> None:
        """Show the part programs."""
        self.chosen, self.fault, self.reason, self.entered = None, None, "", Entered()
        self._go("home")
        self.reload()

    @Slot()
    def go_back(self) -> None:
        """Go one step back; not out of a running measurement."""
        if self.step == "load":
            self._go("identify")
        elif self.step == "identify":
            self.go_home()

    def choose(self, card: ProgramCard) -> None:
        """Choose a part program; a damaged one is not taken."""
        if card.program is None:
            self.said.emit(card.problem, "error")
            return
        self.chosen, self.reason = card, ""
        self.entered = Entered(operator="" if self.shelf is None else self.shelf.settings.operator)
        self.check()
        self._go("identify")

    def scan_code(self, text: str) -> None:
        """Take a scanned code: it chooses a program on the home screen, and identifies the part while one is chosen."""
        facts: list[PartProgramFacts | None] = (
            [] if self.shelf is None else [None if card.program is None else card.program.facts for card in self.shelf.cards]
        )
        if self.step == "home":
            self._find(text, facts)
        elif self.step == "identify":
            self._identify_by(text, facts)

    def _find(self, text: str, facts: Sequence[PartProgramFacts | None]) -> None:
        meaning = find_program(text, facts)
        if meaning.kind == "known" and self.shelf is not None:
            self.choose(self.shelf.cards[meaning.program])
            self._take_fields(meaning.fields)
        elif meaning.kind == "ambiguous":
            self.said.emit(
                f"The code {shown(text)} fits several part programs: {', '.join(meaning.names)}. Choose one by its card.", "error"
            )
        else:
            self.said.emit(
                f"The code {shown(text)} belongs to no part program. Choose the part by its card, or call the engineer.", "error"
            )

    def _identify_by(self, text: str, facts: Sequence[PartProgramFacts | None]) -> None:
        mine = self.facts
        if mine is None:
            return
        meaning = check_code(text, mine, facts)
        if meaning.kind == "known":
            self.said.emit("", "info")
            self._take_fields(meaning.fields)
        elif meaning.kind == "wrong part":
            words = f"Wrong part: the code is of part {meaning.fields.part}, this program measures part {mine.part_number}."
            self.said.emit(words, "error")
        else:
            self.said.emit(f"The code {shown(text)} is not one of part {mine.part_number or mine.name}. Nothing was entered.", "error")

    def _take_fields(self, fields: CodeFields) -> None:
        self.entered = replace(self.entered, serial=fields.serial or self.entered.serial, order=fields.order or self.entered.order)
        self.enteredChanged.emit()

    def identify(self, entered: Entered, reason: str = "") -> None:
        """Take what the operator stated; ``reason`` where the part was measured before."""
        self.entered, self.reason = entered, reason
        self._go("load")
        self.check()

    # before the start

    @Slot()
    def check(self) -> None:
        """Find what prevents the start."""
        rig, card, shelf = self._session.rig, self.chosen, self.shelf
        if rig is None or card is None or card.program is None or shelf is None or self._waits:
            return
        program, settings = card.program, shelf.settings
        self.obstacles = None
        self.obstaclesChanged.emit()

        def find(job: Job) -> tuple[str, ...]:
            return work.find_obstacles(job, work.rig_of(rig, program, settings), program, settings)

        self._reading.run("Checking before the start", find, self._show_obstacles, on_failed=self._show_check_failed, quiet=True)

    @Slot(object)
    def _show_obstacles(self, found: tuple[str, ...]) -> None:
        self.obstacles = found
        self.obstaclesChanged.emit()

    @Slot(object)
    def _show_check_failed(self, error: MeasureError) -> None:
        self._show_obstacles((f"{error.message} {error.hint}".strip(),))

    def why_not(self) -> tuple[str, ...]:
        """Return in sentences why a measurement cannot start now; empty: it can."""
        session = self._session
        if session.rig is None:
            return ("The rig is being loaded.",)
        found = []
        if session.cell.stopped and session.cell.stopped != BY_BUTTON:
            found.append(f"The rig was stopped: {session.cell.stopped} {work.CALL}")
        running = self._jobs.queue.running
        if running is not None and not running.quiet and not self._waits:
            found.append(f"{running.title} is still running.")
        if self.obstacles is None:
            return (*found, "The calibration and the disk are being checked.")
        return (*found, *self.obstacles)

    # the measurement

    @Slot()
    def start(self) -> None:
        """Measure the part in a new folder."""
        card, shelf = self.chosen, self.shelf
        if card is None or card.program is None or shelf is None or self._waits or self.why_not():
            return
        self._folder = work.next_run_folder(shelf.settings, card.name, self.entered.serial)
        self._run()

    @Slot()
    def resume(self) -> None:
        """Go on with the viewpoints that are missing after a fault."""
        if self._folder is not None and not self._waits:
            self._run()

    @Slot()
    def start_again(self) -> None:
        """Measure the part from the beginning after a fault."""
        self.start()

    def _run(self) -> None:
        card, shelf, rig, folder, session = self.chosen, self.shelf, self._session.rig, self._folder, self._session
        if card is None or card.program is None or shelf is None or rig is None or folder is None:
            return
        program, entered, settings = card.program, self.entered, shelf.settings
        self._release_virtual_rig(rig)
        if session.cell.stopped == BY_BUTTON:
            self._rig.reset()
        self.fault, self.filed, self._told = None, None, []
        self._began_s, self._waits = time.monotonic(), True
        session.open_project(card.name, program.facts.name, folder)

        def request(job: Job) -> ScanRequest:
            job.check()
            return work.scan_request(rig, program, entered, settings, folder)

        self._go("run")
        self._scanning.run(TITLE, request, "measurement")
        self._follow_run()  # it may have been refused at once

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
        self._rig.stop()

    @Slot(object)
    def _keep_message(self, message: Message) -> None:
        if self._waits and message.level in ("warning", "error"):
            self._told.append(message)

    @Slot()
    def _follow_run(self) -> None:
        """Show a fault when a run has ended without a result."""
        if self._waits and self._session.run.state == "idle":
            self._waits = False
            self.fault = self._fault()
            self.faultChanged.emit()

    def _fault(self) -> Fault:
        session = self._session
        states = {id_: state.status for id_, state in session.viewpoints.items()}
        stored = sum(status in STORED for status in states.values())
        following = next((id_ for id_, status in states.items() if status not in STORED), "")
        errors = [message for message in self._told if message.level == "error"] or self._told
        cause, remedy = (errors[-1].text, errors[-1].hint) if errors else (STOPPED.cause, STOPPED.remedy)
        if cause == "Cancelled.":
            cause, remedy = STOPPED.cause, STOPPED.remedy
        return Fault(cause, remedy, stored, len(states), following)

    # the result

    @Slot()
    def _take_result(self) -> None:
        session, card = self._session, self.chosen
        measurement = session.measurement
        if not self._waits or measurement is None or session.folder != self._folder or card is None or card.program is None:
            return
        self._waits = False
        seconds, folder, program, reason = self.elapsed_s, session.folder, card.program, self.reason
        assert folder is not None
        self.finished.emit()
        self._go("verdict")
        self._reading.run(
            "Filing the result",
            lambda job: work.file_finished(job, folder, measurement, program, reason),
            self._show_filed,
            on_failed=self._filing_failed,
            quiet=True,
        )
        self._remember(seconds, folder)

    def _remember(self, seconds: float, folder: Path) -> None:
        """Store how long the run took, who measured, and for the virtual rig which calibration is used from now on."""
        shelf, rig, card = self.shelf, self._session.rig, self.chosen
        if shelf is None or rig is None or card is None:
            return
        settings = shelf.settings.with_duration(card.name, seconds).model_copy(update={"operator": self.entered.operator})
        self.store_settings(settings, folder if rig.driver == VIRTUAL else None)

    def store_settings(self, settings: OperatorSettings, calibrated: Path | None = None) -> None:
        """Store settings; ``calibrated``: a project whose calibration is used unless the present one fits the rig."""
        from measureapp.project.operator_settings import operator_file

        file, rig, card = operator_file(), self._session.rig, self.chosen
        program = None if card is None else card.program

        def store(job: Job) -> OperatorSettings:
            return work.store_settings(job, file, settings, rig, program, calibrated)

        self._reading.run("Storing the settings", store, self._take_settings, on_failed=self._fail, quiet=True)

    @Slot(object)
    def _take_settings(self, settings: OperatorSettings) -> None:
        if self.shelf is not None:
            self.shelf = replace(self.shelf, settings=settings)

    @Slot(object)
    def _show_filed(self, filed: Filed) -> None:
        self.filed = filed
        self.filedChanged.emit()
        self.reload()

    @Slot(object)
    def _filing_failed(self, error: MeasureError) -> None:
        self._show_filed(Filed(problem=f"{error.message} {error.hint}".strip()))

    def counts(self) -> bool:
        """Whether the run just filed is the one that counts for its part."""
        runs = self.runs_of(self.entered.serial)
        filed = None if self.filed is None else self.filed.run
        return filed is None or not runs or counted_run(runs).run_id == filed.run_id

    @Slot()
    def next_part(self) -> None:
        """Measure the next part by the same program."""
        card = self.chosen
        if card is None:
            self.go_home()
            return
        order, operator = self.entered.order, self.entered.operator
        self.choose(card)
        self.entered = replace(self.entered, order=order, operator=operator)
        self.enteredChanged.emit()

    def repeat(self, reason: str) -> None:
        """Measure the same part again; both runs are kept."""
        self.reason = reason
        self._go("load")
        self.check()


def shown(text: str) -> str:
    """Return a scanned text for a message: without control characters, and short."""
    plain = "".join(letter if letter.isprintable() else " " for letter in text).strip()
    return f"“{plain[:40]}…”" if len(plain) > 40 else f"“{plain}”"
