"""The connected rig: connect, read, move by hand, live images, stop and reset."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.messages import DEVICES, SHOW_RIG, STOPPED
from ui.session import CellState, Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.acquire.events import AcquisitionEvent
    from measureapp.acquire.jog import Axis
    from measureapp.data.part_pose import PartPose
    from measureapp.data.plan import ScanPlan
    from measureapp.devices.rig import Rig
    from measureapp.planning.collision.build import PartSolid

ALL_STOPPED = "Everything was stopped."
BY_BUTTON = "Stop was pressed."


class RigControl(QObject):
    """Holds the connection of the rig and lets a person move it by hand. All calls of devices run in jobs, one after the other."""

    stepped = Signal()  # a step by hand has ended, well or not
    _stopped = Signal(str)  # devices that did not confirm; from the thread that stops

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._live = threading.Event()  # images are wanted
        self.live_exposure_us: int | None = None  # None: the longest of the rig
        self._part: tuple[tuple[Path | None, PartPose | None], PartSolid | None] | None = None  # of the open project, once it was needed
        self._stopped.connect(self._report_stop)

    @property
    def _rig(self) -> Rig | None:
        return self._session.connection

    @Slot(object)
    def choose(self, name_or_path: str | Path) -> None:
        """Read another rig description; the connected rig is released first."""
        from measureapp.errors import MeasureError
        from measureapp.project.rig_file import read_rig

        try:
            description = read_rig(name_or_path)
        except MeasureError as error:
            self._session.tell(error.message, error.hint, "error")
            return
        self.disconnect_rig()
        self._session.set_rig(description, file=name_or_path if isinstance(name_or_path, Path) else None)

    @Slot()
    def connect_rig(self) -> None:
        """Connect every device of the rig."""
        description = self._session.rig
        if description is None or self._rig is not None:
            return

        def work(job: Job) -> tuple[Rig, CellState]:
            from measureapp.devices.connect import connect_rig

            job.report(0, 1, "Connecting the devices")
            rig = connect_rig(description)
            return rig, _read(rig)

        self._runner.run(tr("Connecting {name}", name=description.name), work, self._connected)

    @Slot(object)
    def _connected(self, found: tuple[Rig, CellState]) -> None:
        self._session.connection, cell = found
        self._session.set_cell(cell)
        unready = [device.name for device in cell.devices if not device.status.ready]
        if unready:
            self._session.tell(
                tr("Connected, but not ready: {list}.", list=", ".join(unready)),
                "See the remedy in the table of devices.",
                "warning",
                cause=DEVICES,
                remedy=SHOW_RIG,
            )
        else:
            self._session.tell("All devices are connected and ready.", "", "done")

    @Slot()
    def disconnect_rig(self) -> None:
        """Release every device."""
        self._live.clear()
        rig, self._session.connection = self._rig, None
        if rig is None:
            return

        def work(job: Job) -> None:
            job.report(0, 1, "Disconnecting")
            rig.close()

        self._runner.run("Disconnecting the rig", work, self._released, quiet=True)

    @Slot(object)
    def _released(self, _nothing: object) -> None:
        if self._rig is None:
            self._session.set_cell(CellState())

    @Slot()
    def refresh(self) -> None:
        """Read the state of every device, if nothing else uses the rig."""
        rig = self._rig
        if rig is None or self._runner.queue.busy:
            return

        def work(job: Job) -> CellState:
            job.check()
            return _read(rig)

        self._runner.run("Reading the devices", work, self._show, quiet=True)

    def jog(self, axis: Axis, step: float) -> None:
        """Move one axis by a step (mm or degrees); `stepped` follows. Live images pause meanwhile."""
        rig = self._rig
        if rig is None:
            return
        wanted, folder, plan = self._pause_live(), self._session.folder, self._session.plan

        def work(job: Job) -> CellState:
            from measureapp.acquire.jog import jog

            jog(rig, axis, step, job, self._part_on(folder, plan))
            return _read(rig)

        self._move("Moving by hand", work, wanted)

    def _part_on(self, folder: Path | None, plan: ScanPlan | None) -> PartSolid | None:
        """Return the part of the open project, which a move by hand must not touch; read once, as a held button makes many steps."""
        from measureapp.pipeline.part_on_table import part_on_table
        from measureapp.project.folder import ProjectFolder

        if folder is None or not (folder / "project.json").is_file():
            return None
        project = ProjectFolder.open(folder)
        known = (project.nominal, None if plan is None else plan.part_pose)
        if self._part is None or self._part[0] != known:
            self._part = known, part_on_table(project)
        return self._part[1]

    @Slot()
    def find_references(self) -> None:
        """Let guide and table find their reference positions."""
        rig = self._rig
        if rig is None:
            return
        wanted = self._pause_live()

        def work(job: Job) -> CellState:
            from measureapp.acquire.jog import find_references

            job.report(0, 1, "Guide and table find their references")
            find_references(rig, job)
            return _read(rig)

        self._move("Finding the references", work, wanted, quiet=False)

    def _move(self, title: str, work: object, live: bool, *, quiet: bool = True) -> None:
        job = self._runner.run(title, work, self._show, on_stopped=self._halted, quiet=quiet, moves=True)  # type: ignore[arg-type]
        job.ended.connect(self.stepped)
        if live:
            self.show_live(True)

    @Slot(bool)
    def show_live(self, wanted: bool) -> None:
        """Show images of all cameras one after the other, or end that."""
        rig, session = self._rig, self._session
        if not wanted or rig is None:
            self._live.clear()
            return
        fallback_us = max(rig.description.exposures_us)
        self._live.set()

        def receive(event: AcquisitionEvent) -> None:
            session.images.put(event.camera, event)  # type: ignore[union-attr]

        def work(job: Job) -> CellState:
            from measureapp.acquire.jog import show_live

            show_live(rig, lambda: self.live_exposure_us or fallback_us, self._live.is_set, receive, job)
            return _read(rig)

        session.set_cell(replace(session.cell, live=True))
        self._runner.run("Live images", work, self._show, on_stopped=self._halted, quiet=True)

    def _pause_live(self) -> bool:
        """End the live images, and return whether they were wanted."""
        wanted = self._live.is_set()
        self._live.clear()
        return wanted

    @Slot()
    def stop(self) -> None:
        """Stop everything that moves: every job, and every device of the connected rig. Returns at once."""
        self._live.clear()
        self._runner.cancel()
        rig = self._rig
        if rig is not None:
            threading.Thread(target=self._abort, args=(rig,), name="stop the rig", daemon=True).start()

    def _abort(self, rig: Rig) -> None:
        from measureapp.acquire.stopping import abort

        report = abort(rig, BY_BUTTON)
        self._stopped.emit(report)

    @Slot(str)
    def _report_stop(self, report: str) -> None:
        self._session.set_cell(replace(self._session.cell, stopped=BY_BUTTON, live=False))
        self._session.tell(
            report or ALL_STOPPED,
            "Reset the stop on the Rig page before anything moves again.",
            "warning",
            cause=STOPPED,
            remedy=SHOW_RIG,
        )

    @Slot()
    def reset(self) -> None:
        """Let the stopped rig run again."""
        from measureapp.acquire.stopping import reset

        if self._rig is not None:
            reset(self._rig)
        self._session.set_cell(replace(self._session.cell, stopped=""))
        self.refresh()

    @Slot(object)
    def _show(self, cell: CellState) -> None:
        if self._rig is not None:
            self._session.set_cell(replace(cell, live=self._live.is_set()))

    @Slot()
    def _halted(self) -> None:
        """A job was cancelled or failed; every device was stopped."""
        self._live.clear()
        if self._rig is not None:
            self._session.set_cell(replace(self._session.cell, stopped=self._rig.latch.reason, live=False))

    def close(self) -> None:
        """Release the rig when the window is closed; its jobs have ended."""
        rig, self._session.connection = self._rig, None
        if rig is not None:
            rig.close()


def _read(rig: Rig) -> CellState:
    """Read every device; runs on a job's thread."""
    from measureapp.acquire.states import read_states
    from measureapp.errors import MeasureError

    try:
        readback = rig.readback()
    except MeasureError:  # the state of the axis says why
        readback = None
    return CellState(True, read_states(rig), readback, rig.latch.reason)
