"""Sink of a scan: stores every stack, and computes its cloud while the scan goes on."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import CancelledError, Future
from dataclasses import replace
from functools import partial
from types import TracebackType

from measureapp.acquire.tasks.stack import ExposureTaken
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import RigCalibration
from measureapp.data.fringe import FringeStack
from measureapp.data.measurement import ViewResult
from measureapp.errors import DecodeError, ReconstructError, StorageError
from measureapp.pipeline.clock_watch import ClockWatch
from measureapp.pipeline.events import Event, ViewFailed, ViewReady
from measureapp.pipeline.live_decoding import LiveDecoding, LiveMaps
from measureapp.pipeline.measure import compute_cloud, stored_view
from measureapp.pipeline.noise import decode_settings_of
from measureapp.pipeline.watch import Stopwatch
from measureapp.pipeline.worker import LEAVE_S, STOPPED_WITHIN_S, Worker
from measureapp.progress import NoProgress, Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal.publish import vanished
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.register.joint.registration_cache import RegistrationCache

OnEvent = Callable[[Event], None]
LAST_IMAGE_TO_CLOUD = "last image to cloud"  # without the time for storing
MOST_MAPS = 2  # viewpoints whose maps wait in memory for their cloud; those of others are decoded again from the stored images
DECODED_WITHIN_S, STUCK_S, POLL_S = 120.0, 900.0, 0.1


class Processing:
    """Decodes while images are taken, stores every stack durably, and then computes its cloud on a thread of its own.

    The scan waits for storing alone. Images that are not decoded when too many viewpoints are behind, and those of earlier runs, are read
    back from the project. A context manager of its threads.
    """

    def __init__(
        self,
        project: ProjectFolder,
        calibration: RigCalibration | None,
        on_event: OnEvent,
        watch: Stopwatch,
        registration_cache: RegistrationCache | None = None,
    ) -> None:
        self.views: dict[str, ViewResult] = {}
        self.stored: set[str] = set()
        self._clock = ClockWatch()
        self._ended = False  # stopped: what is still computed is of no use to anybody
        self._project, self._calibration, self._on_event, self._watch = project, calibration, on_event, watch
        self._settings, self._registration_cache = decode_settings_of(project), registration_cache
        self._rectifier = None if calibration is None else Rectifier(calibration.cameras)
        self._live = LiveDecoding(self._settings)
        self._worker = Worker("clouds")
        self._memory = BufferPool()
        self._clouds: dict[str, Future[None]] = {}  # of the newest stack of each viewpoint
        self._with_maps: list[Future[None]] = []

    def __enter__(self) -> Processing:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        stuck, self._ended = self._worker.busy_s() > STUCK_S, error is not None
        self._worker.close(0.0 if stuck else LEAVE_S if error is None else STOPPED_WITHIN_S)
        self._live.__exit__(kind, error, trace)

    # sink

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Decode the exposure in the background."""
        if self._calibration is not None:
            self._live.exposure_taken(taken)

    def drop(self, viewpoint_id: str) -> None:
        """Discard a viewpoint that failed."""
        self._live.drop(viewpoint_id)

    def store(self, stack: FringeStack) -> None:
        """Store the raw images; then have them processed. Raises StorageError, after which nothing is forgotten."""
        if not (self._project.path / "project.json").is_file():
            raise vanished(self._project.path)
        started = time.monotonic()
        with self._watch.stage("storing"):
            self._project.frames.store(stack)
            self._clock.note(self._project.path)
        self.stored.add(stack.viewpoint_id)
        live = self._live.take(stack.viewpoint_id)
        if live is not None:
            live = replace(live, last_image_s=live.last_image_s + time.monotonic() - started)
        self._compute(stack, live)

    # clouds

    def keep(self, view: ViewResult) -> None:
        """Take a view of former results, whose images were dropped."""
        self._take(view)

    def compute_stored(self, viewpoint_id: str) -> None:
        """Have the cloud of stored images computed."""
        if self._calibration is not None:
            self._clouds[viewpoint_id] = self._worker.submit(partial(self._cloud, viewpoint_id, None, None))

    def _compute(self, stack: FringeStack, live: LiveMaps | None) -> None:
        """Have the cloud of a stack computed from its maps, or from its stored images where too many maps are waiting."""
        self._with_maps = [future for future in self._with_maps if not future.done()]
        if live is None or len(self._with_maps) >= MOST_MAPS or self._calibration is None:
            self.compute_stored(stack.viewpoint_id)
            return
        without_images = replace(stack, images={})
        future = self._worker.submit(partial(self._cloud, stack.viewpoint_id, without_images, live))
        self._clouds[stack.viewpoint_id] = future
        self._with_maps.append(future)

    def _cloud(self, viewpoint_id: str, stack: FringeStack | None, live: LiveMaps | None) -> None:
        """Compute one cloud; a view without points is reported by an event."""
        with self._watch.stage("clouds"):
            try:
                view = self._view(viewpoint_id, stack, live)
            except (DecodeError, ReconstructError, StorageError) as error:
                if self._ended:
                    return
                self._on_event(ViewFailed(viewpoint_id, str(error), damaged=isinstance(error, StorageError)))
                return
        if not self._ended:
            self._take(view)

    def _take(self, view: ViewResult) -> None:
        self.views[view.viewpoint_id] = view
        if self._registration_cache is not None and view.quality.accepted:
            self._registration_cache.add(view.cloud, view.part_from_camera)
        self._on_event(ViewReady(view))

    def _view(self, viewpoint_id: str, stack: FringeStack | None, live: LiveMaps | None) -> ViewResult:
        assert self._calibration is not None and self._rectifier is not None
        maps = None
        if live is not None:
            try:
                maps = live.wait(DECODED_WITHIN_S)
            except (TimeoutError, CancelledError):  # the decoder is stuck, but the images are stored
                live = None
        if stack is None or maps is None:
            stack = self._project.frames.load(viewpoint_id)
        view = compute_cloud(stack, self._calibration, NoProgress(), self._rectifier, maps, self._memory, self._settings)
        view = stored_view(self._project, view, self._calibration, self._settings)
        if live is None:
            return view
        return replace(view, timings_s={LAST_IMAGE_TO_CLOUD: time.monotonic() - live.last_image_s})

    def finish(self, progress: Progress) -> None:
        """Wait for all clouds; one that does not end is reported, and the others are computed without it. Raises what computing raised."""
        waiting = dict(self._clouds)
        total = len(waiting)
        while waiting:
            viewpoint_id, future = next(iter(waiting.items()))
            progress.report(total - len(waiting), total, f"Cloud of {viewpoint_id}")
            if self._wait(future, progress):
                del waiting[viewpoint_id]
                future.result()
                continue
            del waiting[viewpoint_id]
            self._on_event(ViewFailed(viewpoint_id, "Its processing did not end. Its images are stored: process the project again."))
            self._worker.close(0.0)
            self._worker = Worker("clouds")
            self._memory = BufferPool()
            for other in waiting:
                self.compute_stored(other)
            waiting = {name: self._clouds[name] for name in waiting}

    def _wait(self, future: Future[None], progress: Progress) -> bool:
        """Return whether a cloud was computed; False when it does not end."""
        while not future.done():
            progress.check()
            if self._worker.busy_s() > STUCK_S:
                return False
            time.sleep(POLL_S)
        return True
