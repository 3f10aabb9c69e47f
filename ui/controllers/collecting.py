"""Collecting views of the board for one calibration: taking or reading them, taking them back, solving meanwhile."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from queue import SimpleQueue
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QImage

from measureapp.errors import MeasureError
from ui.controllers import collecting_work as work
from ui.controllers.beginning import begun_with_images, begun_with_rig
from ui.controllers.collected_images import CollectedImages
from ui.controllers.collecting_nouns import Kept, Kind, LiveImage, SeenView, Start
from ui.controllers.jobs import JobRunner
from ui.controllers.kept_sessions import newest_kept, project_on_disk, sessions_folder
from ui.controllers.rig_connection import RigConnection, truth_of
from ui.controllers.seen_views import seen_view
from ui.session import Session
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.plan import Viewpoint
    from measureapp.data.rig import RigDescription
    from measureapp.pipeline.collecting.collection import Collection
    from measureapp.pipeline.collecting.observation import Observation


class CollectingController(QObject):
    """One calibration in the making. Pages watch `changed`; every change is on disk before anybody hears of it."""

    changed = Signal()  # views, advice or what is being done
    begun = Signal()  # there is a collection
    progressed = Signal(float, str)
    told = Signal(str, str, str)  # text, hint, level

    def __init__(self, kind: Kind, session: Session, collecting: JobRunner, solving: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.kind = kind
        self._session, self._collecting, self._solving = session, collecting, solving
        self._job: Job | None = None  # that takes or reads images
        self._thinker: Job | None = None
        self._stale = False  # something changed since the solver began
        self._more = 0  # views beyond those planned that are still to be taken
        self._held = ExitStack()  # the session's folder, while it is open
        self._forget()

    def _forget(self) -> None:
        self._held.close()
        self._changes: work.Changes = SimpleQueue()
        self.collection: Collection | None = None
        self.thought: work.Thought | None = None
        self._rig: RigDescription | None = None
        self._connection: RigConnection | None = None
        self._images = CollectedImages()
        self.views: tuple[SeenView, ...] = ()

    # what there is

    @property
    def cameras(self) -> tuple[str, ...]:
        """Who sees the board: the cameras that are being collected from, and the projector before them where it is calibrated."""
        return () if self.collection is None else self.collection.setup.seeing

    @property
    def from_rig(self) -> bool:
        """Whether the rig takes the images."""
        return self._rig is not None

    @property
    def is_collecting(self) -> bool:
        """Whether images are being taken or read."""
        return self._job is not None

    @property
    def is_thinking(self) -> bool:
        """Whether a solution is being computed."""
        return self._thinker is not None

    @property
    def is_solved(self) -> bool:
        """Whether the views determine the result."""
        return self.thought is not None and self.thought.solved is not None

    @property
    def has_enough(self) -> bool:
        """Whether the coach asks for nothing more."""
        return self.is_solved and self.thought is not None and self.thought.advice.enough

    @property
    def is_good(self) -> bool:
        """Whether the views collected so far make a good calibration."""
        return self.thought is not None and self.thought.verdict is not None and self.thought.verdict.level == "good"

    @property
    def can_undo(self) -> bool:
        """Whether there is a change to take back."""
        return self.collection is not None and self.collection.can_undo

    @property
    def can_redo(self) -> bool:
        """Whether a change was taken back."""
        return self.collection is not None and self.collection.can_redo

    @property
    def truth(self) -> RigCalibration | None:
        """What the virtual rig really is; for showing beside a result, never for finding one."""
        if self.collection is None or self._rig is None:
            return None
        return truth_of(self._rig, self.collection.setup.board)

    @property
    def rig(self) -> RigDescription | None:
        """The rig that takes the images."""
        return self._rig

    @property
    def remaining(self) -> int:
        """How many views the rig has still to take."""
        return len(self._viewpoints_left())

    def newest_image(self, camera: str) -> LiveImage | None:
        """Return the newest image of a camera while its board is still looked for."""
        return self._images.newest(camera)

    def take_live(self) -> bool:
        """Take the newest images out of their mailbox; tells whether there were any."""
        return self._images.take_live()

    def image(self, id_: str, camera: str) -> np.ndarray | None:
        """Return the image of one camera in a view, or None where it has none (or it cannot be read)."""
        if self.collection is None:
            return None
        try:
            return self._images.full(self.collection, id_, camera)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")
            return None

    def size_px(self, camera: str) -> tuple[int, int] | None:
        """Return width and height of a camera's images."""
        return None if self.collection is None else self.collection.size_px(camera)

    # beginning

    def kept(self) -> Kept | None:
        """Return the newest session of this kind that holds views."""
        return newest_kept(sessions_folder(project_on_disk(self._session)), self.kind)

    def begin(self, start: Start) -> None:
        """Begin anew; recorded images are read at once."""
        try:
            if start.folder is None:
                self._take_over(*begun_with_rig(self.kind, start, self._session), {})
            else:
                self._begin_with_images(start, start.folder)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")

    def _begin_with_images(self, start: Start, folder: Path) -> None:
        collection, recorded = begun_with_images(self.kind, start, folder, self._session)
        self._take_over(collection, None, {})
        self._run(f"Reading {folder.name}", lambda job: work.read(job, recorded, collection, self._changes))

    def resume(self, folder: Path) -> None:
        """Go on with a session that was kept."""
        self._collecting.run(
            "Opening the session", lambda job: work.opened(job, folder), self._resumed, on_event=self._happened, quiet=True
        )

    @Slot(object)
    def _resumed(self, found: tuple[Collection, RigDescription | None, dict[tuple[str, str], QImage]]) -> None:
        try:
            self._take_over(*found)
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "error")

    def _take_over(self, collection: Collection, rig: RigDescription | None, thumbnails: dict[tuple[str, str], QImage]) -> None:
        from measureapp.project.folder_lock import lock_folder

        self._forget()
        self._held.enter_context(lock_folder(collection.folder))
        self.collection, self._rig, self._images = collection, rig, CollectedImages(thumbnails)
        self.begun.emit()
        self._after_change()

    # collecting

    @property
    def can_take_more(self) -> bool:
        """Whether the rig can take views beyond those planned that teach something."""
        return self.thought is not None and self.thought.suggestion is not None

    @property
    def can_collect(self) -> bool:
        """Whether views can be added, planned ones or others."""
        return bool(self.remaining) or self.can_take_more

    @property
    def took_more(self) -> bool:
        """Whether views beyond those planned were taken before."""
        return any(view.name.startswith(work.BEYOND_PLAN) for view in self.views)

    def take_more(self, count: int) -> None:
        """Let the rig take views beyond those planned, each where it teaches most after the one before was solved."""
        self._more = count
        self._take_suggested()

    def _take_suggested(self) -> None:
        suggestion = None if self.thought is None else self.thought.suggestion
        self._more = 0 if suggestion is None else self._more - 1
        if suggestion is not None:
            self._take((suggestion.viewpoint,))

    def take(self, most: int | None = None) -> None:
        """Let the rig take the planned views that are still missing, at most so many of them."""
        self._take(self._viewpoints_left()[:most])

    def _take(self, viewpoints: tuple[Viewpoint, ...]) -> None:
        collection, rig = self.collection, self._rig
        if collection is None or rig is None or self.is_collecting or not viewpoints:
            return
        connection, live, changes = self._connection, self._images.live, self._changes

        def run(job: Job) -> None:
            job.report(0, 1, "Connecting the rig")
            connected = connection or work.connected(job, rig, collection.setup.board)
            work.take(job, connected.rig, viewpoints, collection, live, changes)

        self._run("Taking images of the board", run)

    def _viewpoints_left(self) -> tuple[Viewpoint, ...]:
        if self.collection is None or self._rig is None:
            return ()
        taken = {image.name for view in self.collection.observations if view.standing != "removed" for image in view.images.values()}
        planned = work.viewpoints_of(self.kind, self._rig, self._session.plan)
        return tuple(viewpoint for viewpoint in planned if viewpoint.id not in taken)

    def _run(self, title: str, run: work.Work) -> None:
        self._job = self._collecting.run(
            title, run, self._collected, on_event=self._happened, on_stopped=self._stopped, on_failed=self._tell_failure
        )
        self._job.progressed.connect(self.progressed)
        self.changed.emit()

    def stop(self) -> None:
        """Stop taking or reading; what was collected is kept."""
        self._more = 0
        if self._job is not None:
            self._job.cancel()

    @Slot(object)
    def _happened(self, event: object) -> None:
        match event:
            case RigConnection():
                self._connection = event
            case work.Skipped():
                self.told.emit(event.error.message, event.error.hint, "warning")
            case work.Added() if self.collection is not None:
                self._images.add(event)
                self._after_change()

    @Slot(object)
    def _collected(self, _nothing: object) -> None:
        self._end_collecting()

    @Slot()
    def _stopped(self) -> None:
        self._end_collecting()

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        self.told.emit(error.message, error.hint, "error")

    def _end_collecting(self) -> None:
        self._job = None
        if self.collection is not None and not self.collection.usable:
            self._tell_nothing_found()
        self._images.forget_newest()
        work.make_changes(self._changes)
        self._after_change()

    def _tell_nothing_found(self) -> None:
        """Say why no view can be used, as the first of them puts it."""
        observations = () if self.collection is None else self.collection.observations
        refusals = [refusal for one in observations if one.standing == "no board" for refusal in one.refused.values()]
        seen = any(one.seen for one in observations)
        if refusals:
            what = "No view of the board shows the fringes" if seen else "No image shows the board"
            self.told.emit(f"{what}. {refusals[-1 if seen else 0].message}", refusals[-1 if seen else 0].hint, "error")

    # changes

    def remove(self, id_: str) -> None:
        """Take a view out by hand; `undo` brings it back."""
        collection = self.collection
        if collection is not None and collection.observation(id_).standing != "removed":
            self._change(lambda: collection.remove(id_))

    def undo(self) -> None:
        """Take the last change back."""
        if self.collection is not None and self.collection.can_undo:
            self._change(self.collection.undo)

    def redo(self) -> None:
        """Make the change that was taken back again."""
        if self.collection is not None and self.collection.can_redo:
            self._change(self.collection.redo)

    def _change(self, change: work.Change) -> None:
        """Change at once, or between two views while they are being added."""
        if self.is_collecting:
            self._changes.put(change)
            return
        try:
            change()
        except MeasureError as error:
            self.told.emit(error.message, error.hint, "warning")
        self._after_change()

    def _after_change(self) -> None:
        self._look_again()
        if self._thinker is not None:
            self._stale = True
        else:
            self._think()
        self.changed.emit()

    def _look_again(self) -> None:
        collection = self.collection
        self.views = () if collection is None else tuple(self._seen(one) for one in collection.observations)

    def _seen(self, observation: Observation) -> SeenView:
        known = self._images.thumbnails
        pictures = {camera: known[key] for camera in observation.images if (key := (observation.id, camera)) in known}
        return seen_view(observation, None if self.thought is None else self.thought.solved, pictures)

    # solving meanwhile

    def _think(self) -> None:
        """Solve what there is and ask the coach, on a thread of their own; the newest answer wins."""
        self._stale = False
        if self.collection is not None:
            snapshot, rig = self.collection.snapshot(), None if self._viewpoints_left() else self._rig
            self._thinker = self._solving.run(
                "Solving", lambda job: work.thought(job, snapshot, rig), self._show_thought, on_stopped=self._thinking_stopped, quiet=True
            )

    @Slot(object)
    def _show_thought(self, found: work.Thought) -> None:
        self._thinker, self.thought = None, found
        if self.collection is not None:
            self.collection.adopt(found.solved)
        self._go_on()

    @Slot()
    def _thinking_stopped(self) -> None:
        self._thinker = None
        self._go_on()

    def _go_on(self) -> None:
        if self._stale:
            self._think()
        self._look_again()
        self.changed.emit()
        if self._more and not self._stale and not self.is_collecting and not self.is_thinking:
            self._take_suggested()

    def close(self) -> None:
        """End what runs for this wizard and let the rig go; everything collected is on disk."""
        for job in (self._job, self._thinker):
            if job is not None:
                job.cancel()
        if self._connection is not None:
            self._connection.rig.close()
        self._forget()
