"""Collecting views of the board for one calibration: taking or reading, removing and undoing, with a solution in the background."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QImage

from measureapp.errors import MeasureError
from ui.controllers import collecting_work as work
from ui.controllers.background_solver import BackgroundSolver
from ui.controllers.beginning import begin_with_images, begin_with_rig
from ui.controllers.collected_images import CollectedImages
from ui.controllers.collected_views import describe_view
from ui.controllers.collecting_nouns import CollectedView, Start, StoredSession
from ui.controllers.jobs import JobRunner
from ui.controllers.rig_capture import RigCapture
from ui.controllers.rig_connection import RigConnection
from ui.controllers.stored_sessions import newest_session, project_on_disk, sessions_folder
from ui.look.language.words import tr
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Kind
    from measureapp.calibration_session.observation import CollectedObservation
    from measureapp.calibration_session.session import CalibrationSession
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.data.rig import RigDescription


class CollectingController(QObject):
    """One calibration in the making. Pages watch `changed`; every change is on disk before the signal."""

    changed = Signal()  # views, guidance or the running task
    begun = Signal()  # there is a collection
    progressed = Signal(float, str)
    told = Signal(str, str, str)  # text, hint, level

    def __init__(self, kind: Kind, session: Session, collecting: JobRunner, solving: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self._session, self._collecting = session, collecting
        self.solver = BackgroundSolver(solving, self)
        self.solver.solved.connect(self._show_interim)
        self._job: Job | None = None  # taking or reading images
        self._held = ExitStack()  # the session's folder, while it is open
        self._forget()

    def _forget(self) -> None:
        self._held.close()
        self.solver.stop()
        self.collected: CalibrationSession | None = None
        self.now: Snapshot | None = None  # of it, as the pages show it
        self.capture = RigCapture(self, self._session)
        self.images = CollectedImages()
        self.views: tuple[CollectedView, ...] = ()

    # what there is

    @property
    def cameras(self) -> tuple[str, ...]:
        """The projector, if it is calibrated, and the cameras."""
        return () if self.collected is None else self.collected.setup.seeing

    @property
    def is_collecting(self) -> bool:
        """Whether images are being taken or read."""
        return self._job is not None

    @property
    def can_undo(self) -> bool:
        """Whether there is a change to undo."""
        return self.now is not None and self.now.can_undo

    @property
    def can_redo(self) -> bool:
        """Whether a change was undone that can be redone."""
        return self.now is not None and self.now.can_redo

    def image(self, id_: str, camera: str) -> np.ndarray | None:
        """Return the image of one camera in a view, or None where it has none (or it cannot be read)."""
        if self.collected is None:
            return None
        try:
            return self.images.full(self.collected, id_, camera)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")
            return None

    # beginning

    def kept(self) -> StoredSession | None:
        """Return the newest session of this kind that holds views."""
        return newest_session(sessions_folder(project_on_disk(self._session)), self.kind.name)

    def begin(self, start: Start) -> None:
        """Begin anew; recorded images are read at once."""
        try:
            if start.folder is None:
                self._take_over(*begin_with_rig(self.kind, start, self._session), {})
            else:
                self._begin_with_images(start, start.folder)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")

    def _begin_with_images(self, start: Start, folder: Path) -> None:
        collected, recorded = begin_with_images(self.kind, start, folder, self._session)
        self._take_over(collected, None, {})
        self.run(tr("Reading {name}", name=folder.name), lambda job: work.read(job, recorded, collected))

    def resume(self, folder: Path) -> None:
        """Continue a stored session."""
        self._collecting.run(
            "Opening the session", lambda job: work.open_session(job, folder), self._resume_stored, on_event=self._handle_event, quiet=True
        )

    @Slot(object)
    def _resume_stored(self, found: tuple[CalibrationSession, RigDescription | None, dict[tuple[str, str], QImage]]) -> None:
        try:
            self._take_over(*found)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")

    def _take_over(self, collected: CalibrationSession, rig: RigDescription | None, thumbnails: dict[tuple[str, str], QImage]) -> None:
        from measureapp.project.folder_lock import lock_folder

        capture = RigCapture(self, self._session, rig)
        self._forget()
        self._held.enter_context(lock_folder(collected.folder))
        self.collected, self.images = collected, CollectedImages(thumbnails)
        self.capture = capture
        self.begun.emit()
        self._after_change()

    # collecting

    def run(self, title: str, run: work.Work) -> None:
        """Take or read images in the background, as ``run`` does on its job."""
        self._job = self._collecting.run(
            title,
            run,
            self._end_collecting,
            on_event=self._handle_event,
            on_stopped=self._end_collecting,
            on_failed=self._tell_failure,
            moves=self.capture.rig is not None,
        )
        self._job.progressed.connect(self.progressed)
        self.changed.emit()

    def stop(self) -> None:
        """Stop taking or reading; what was collected is kept."""
        self.capture.stop()
        if self._job is not None:
            self._job.cancel()
            self.told.emit("Stopped.", "The views collected so far are kept.", "info")

    @Slot(object)
    def _handle_event(self, event: object) -> None:
        match event:
            case RigConnection():
                self.capture.connection = event
            case work.Skipped():
                self.told.emit(event.error.message, event.error.hint, "warning")
            case work.Added() if self.collected is not None:
                self.images.add(event)
                self._after_change()

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        self.told.emit(error.message, error.hint, "error")

    @Slot()
    @Slot(object)
    def _end_collecting(self, _nothing: object = None) -> None:
        self._job = None
        self.images.forget_newest()
        self._after_change()
        if self.now is not None and not self.now.usable:
            self._report_nothing_found(self.now)

    def _report_nothing_found(self, now: Snapshot) -> None:
        """Report that no view can be used, with the reason of one of them."""
        refusals = [refusal for one in now.observations if one.status == "no board" for refusal in one.refused.values()]
        seen = any(one.seen for one in now.observations)
        if refusals:
            what = "No view of the board shows the fringes" if seen else "No image shows the board"
            self.told.emit(f"{what}. {refusals[-1 if seen else 0].message}", refusals[-1 if seen else 0].hint, "error")

    # changes

    def remove(self, id_: str) -> None:
        """Remove a view; `undo` restores it."""
        collected = self.collected
        if collected is not None and collected.observation(id_).status != "removed":
            self._change(lambda: collected.remove(id_))

    def undo(self) -> None:
        """Undo the last change."""
        if self.collected is not None and self.can_undo:
            self._change(self.collected.undo)

    def redo(self) -> None:
        """Redo the change that was undone last."""
        if self.collected is not None and self.can_redo:
            self._change(self.collected.redo)

    def _change(self, change: Callable[[], object]) -> None:
        try:
            change()
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "warning")
        self._after_change()

    def _after_change(self) -> None:
        """Show the session as it is now, and solve it."""
        self._refresh()
        if self.now is not None:
            self.solver.solve(self.now, None if self.capture.viewpoints_left else self.capture.rig)
        self.changed.emit()

    def _refresh(self) -> None:
        self.now = None if self.collected is None else self.collected.snapshot()
        self.views = () if self.now is None else tuple(self._describe(one) for one in self.now.observations)

    def _describe(self, observation: CollectedObservation) -> CollectedView:
        known = self.images.thumbnails
        pictures = {camera: known[key] for camera in observation.images if (key := (observation.id, camera)) in known}
        return describe_view(observation, None if self.solver.interim is None else self.solver.interim.solved, pictures)

    @Slot()
    def _show_interim(self) -> None:
        if self.collected is not None and self.solver.interim is not None:
            self.collected.adopt(self.solver.interim.solved)
        self._refresh()
        self.changed.emit()
        if not self.is_collecting and not self.solver.is_running:
            self.capture.take_next()

    def close(self) -> None:
        """Stop the jobs of this wizard and disconnect the rig; everything collected is on disk."""
        if self._job is not None:
            self._job.cancel()
        self.capture.close()
        self._forget()
