"""Operator mode: from a part program over the serial number and the measurement to the filed verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers import operator_work as work
from ui.controllers.jobs import JobRunner
from ui.controllers.operator_codes import CodeFields, check_code, find_program
from ui.controllers.operator_nouns import Entered, Fault, Filed, ProgramCard, Step, ToMeasure, counted_run
from ui.controllers.operator_run import OperatorRun
from ui.controllers.operator_shelf import ShelfController
from ui.controllers.rig_control import BY_BUTTON, RigControl
from ui.controllers.scanning import ScanController
from ui.look.language.words import tr
from ui.look.wording import with_hint
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.part_program import PartProgramFacts
    from measureapp.data.series import SeriesRun
    from ui.workers.job import Job


class OperatorController(QObject):
    """Holds where the operator is, and takes him on. Everything slow runs in jobs of its own queue."""

    stepChanged = Signal(str)
    enteredChanged = Signal()  # what a scanned code states about the part
    obstaclesChanged = Signal()
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
        self.stock = ShelfController(session, reading, self)
        self.run = OperatorRun(session, self.stock, reading, scanning, rig, self)
        self.step: Step = "home"
        self.chosen: ProgramCard | None = None
        self.entered = Entered()
        self.obstacles: tuple[str, ...] | None = None  # None: not checked yet
        self.reason = ""  # why a part is measured again
        self.stock.changed.connect(self._keep_chosen)
        self.stock.said.connect(self.said)
        self.run.began.connect(lambda: self._go("run"))
        self.run.finished.connect(lambda: self._go("verdict"))
        session.rigChanged.connect(self.check)
        session.cellChanged.connect(self.obstaclesChanged)
        session.busyChanged.connect(self.obstaclesChanged)

    @property
    def shelf(self) -> work.Shelf | None:
        """Programs, runs and settings; None until they are read."""
        return self.stock.shelf

    @property
    def runs(self) -> tuple[SeriesRun, ...]:
        """All runs, in order of measurement."""
        return self.stock.runs

    @property
    def fault(self) -> Fault | None:
        """Why the last measurement ended early."""
        return self.run.fault

    @property
    def filed(self) -> Filed | None:
        """Where the last result was filed; None while it is not."""
        return self.run.filed

    @Slot()
    def _keep_chosen(self) -> None:
        """Take the chosen program as it was read now."""
        if self.chosen is not None and self.shelf is not None:
            path = self.chosen.path
            self.chosen = next((card for card in self.shelf.cards if card.path == path), self.chosen)

    @property
    def facts(self) -> PartProgramFacts | None:
        """Name, numbers and remarks of the chosen program."""
        return None if self.chosen is None or self.chosen.program is None else self.chosen.program.facts

    def runs_of(self, serial: str) -> tuple[SeriesRun, ...]:
        """Return the runs of one part by the chosen program."""
        facts = self.facts
        if facts is None or not serial:
            return ()
        return tuple(run for run in self.runs if run.program == facts.name and run.identification.serial_number == serial)

    # from step to step

    def _go(self, step: Step) -> None:
        self.step = step
        self.said.emit("", "info")
        self.stepChanged.emit(step)

    @Slot()
    def go_home(self) -> None:
        """Show the part programs."""
        self.chosen, self.reason, self.entered = None, "", Entered()
        self._go("home")
        self.stock.reload()

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
        """Take a scanned code: it chooses a program on the home screen, and identifies the part while one is chosen.

        Before the start it changes nothing any more, and must not press a button either: Enter at its end would start the measurement of
        another part than the one that was identified.
        """
        facts: list[PartProgramFacts | None] = (
            [] if self.shelf is None else [None if card.program is None else card.program.facts for card in self.shelf.cards]
        )
        if self.step == "home":
            self._find(text, facts)
        elif self.step == "identify":
            self._identify_by(text, facts)
        elif self.step == "load":
            self._compare(text, facts)

    def _find(self, text: str, facts: Sequence[PartProgramFacts | None]) -> None:
        meaning = find_program(text, facts)
        if meaning.kind == "known" and self.shelf is not None:
            self.choose(self.shelf.cards[meaning.program])
            self._take_fields(meaning.fields)
        elif meaning.kind == "ambiguous":
            self.said.emit(
                tr(
                    "The code {shown} fits several part programs: {list}. Choose one by its card.",
                    shown=shown(text),
                    list=", ".join(meaning.names),
                ),
                "error",
            )
        else:
            self.said.emit(
                tr("The code {shown} belongs to no part program. Choose the part by its card, or call the engineer.", shown=shown(text)),
                "error",
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
            words = tr(
                "Wrong part: the code is of part {part}, this program measures part {part_number}.",
                part=meaning.fields.part,
                part_number=mine.part_number,
            )
            self.said.emit(words, "error")
        else:
            self.said.emit(
                tr(
                    "The code {shown} is not one of part {value}. Nothing was entered.",
                    shown=shown(text),
                    value=mine.part_number or mine.name,
                ),
                "error",
            )

    def _compare(self, text: str, facts: Sequence[PartProgramFacts | None]) -> None:
        """Say whether a code is that of the part that was identified."""
        mine = self.facts
        if mine is None:
            return
        meaning = check_code(text, mine, facts)
        if meaning.kind == "known" and meaning.fields.serial in ("", self.entered.serial):
            self.said.emit("The code belongs to this part.", "info")
        else:
            self.said.emit(tr("The code {shown} was not entered. Press Back to identify another part.", shown=shown(text)), "error")

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
        if rig is None or card is None or card.program is None or shelf is None or self.run.waits:
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
        self._show_obstacles((with_hint(error.message, error.hint),))

    def why_not(self) -> tuple[str, ...]:
        """Return in sentences why a measurement cannot start now; empty: it can."""
        session = self._session
        if session.rig is None:
            return ("The rig is being loaded.",)
        found = []
        if session.cell.stopped and session.cell.stopped != BY_BUTTON:
            found.append(tr("The rig was stopped: {stopped} {call}", stopped=session.cell.stopped, call=work.CALL))
        running = self._jobs.queue.running
        if running is not None and not running.quiet and not self.run.waits:
            found.append(tr("{title} is still running.", title=running.title))
        if self.obstacles is None:
            return (*found, "The calibration and the disk are being checked.")
        return (*found, *self.obstacles)

    @property
    def is_checking(self) -> bool:
        """Whether a start waits only for what is still being looked up."""
        return (self._session.rig is None or self.obstacles is None) and len(self.why_not()) == 1

    @Slot()
    def start(self) -> None:
        """Measure the part in a new folder, or say what prevents it."""
        card, why = self.chosen, self.why_not()
        if card is None or card.program is None:
            return
        if why:
            self.said.emit("\n".join(why), "error")
        else:
            self.run.start(ToMeasure(card, card.program, self.entered, self.reason))

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
