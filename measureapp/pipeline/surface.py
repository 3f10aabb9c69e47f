"""The surface, computed beside the inspection: no dimension depends on it."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from types import TracebackType

from measureapp.data.cloud import StitchedCloud
from measureapp.data.mesh import Mesh
from measureapp.errors import RegistrationError
from measureapp.pipeline.events import Event, SurfaceFailed
from measureapp.progress import CallbackProgress, Cancelled, Progress
from measureapp.register.surface.closed import reconstruct_surface

POLL_S = 0.1


class SurfaceBeside:
    """Computes the surface of a cloud on a thread of its own, unless it is ``kept``. A context manager: an error within it ends the computation."""

    def __init__(self, stitched: StitchedCloud, kept: Mesh | None = None) -> None:
        self._stitched, self._kept = stitched, kept
        self._result: Future[Mesh] = Future()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._compute, name="surface", daemon=True)

    def __enter__(self) -> SurfaceBeside:
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._stop.set()
        self._thread.join()

    def wait(self, on_event: Callable[[Event], None], progress: Progress) -> Mesh | None:
        """Return the surface; None where it failed, for example for lack of memory, which is told by an event. Raises Cancelled."""
        while self._thread.is_alive():
            progress.report(0, 1, "reconstructing the surface")
            self._thread.join(POLL_S)
        try:
            return self._result.result()
        except RegistrationError as error:
            on_event(SurfaceFailed(error.message, error.hint))
            return None

    def _compute(self) -> None:
        try:
            kept = self._kept
            self._result.set_result(reconstruct_surface(self._stitched, progress=CallbackProgress(self._check)) if kept is None else kept)
        except BaseException as error:  # passed on to whoever waits
            self._result.set_exception(error)

    def _check(self, *_: object) -> None:
        if self._stop.is_set():
            raise Cancelled
