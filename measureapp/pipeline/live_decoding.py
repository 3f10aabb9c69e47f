"""Decoding in a background thread while a scan takes images."""

from __future__ import annotations

import time
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from types import TracebackType

from measureapp.acquire.tasks.fringes import ExposureTaken
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.fringe import FringeStack
from measureapp.data.phase import PhaseMap
from measureapp.fringe.checks.stack import check_stack
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import StreamingDecoder


@dataclass(slots=True)
class _Viewpoint:
    decoder: StreamingDecoder
    sums: list[Future[None]] = field(default_factory=list)
    maps: Future[dict[str, PhaseMap]] | None = None
    last_image_s: float = 0.0  # of the monotonic clock


class LiveDecoding:
    """Accumulates every exposure as soon as it is complete, and computes the phase after the last; a context manager of its thread."""

    def __init__(self, settings: DecodeSettings | None = None) -> None:
        self._settings, self._memory = settings, BufferPool()
        self._pool = ThreadPoolExecutor(1, "live-decoding")
        self._viewpoints: dict[str, _Viewpoint] = {}

    def __enter__(self) -> LiveDecoding:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._pool.shutdown(wait=True, cancel_futures=True)

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Start to accumulate an exposure and return at once; the first one restarts a viewpoint. Raises DecodeError."""
        if taken.level == 0:
            decoder = StreamingDecoder(
                taken.patterns, taken.exposures_us, taken.saturation, self._settings, taken.viewpoint_id, self._memory
            )
            self._viewpoints[taken.viewpoint_id] = _Viewpoint(decoder)
        viewpoint = self._viewpoints[taken.viewpoint_id]
        for camera, images in taken.images.items():
            viewpoint.sums.append(self._pool.submit(viewpoint.decoder.add, camera, taken.level, images))
        if taken.level == len(taken.exposures_us) - 1:
            viewpoint.last_image_s = time.monotonic()
            viewpoint.maps = self._pool.submit(viewpoint.decoder.finish)

    def drop(self, viewpoint_id: str) -> None:
        """Discard the sums of a viewpoint that failed."""
        dropped = self._viewpoints.pop(viewpoint_id, None)
        if dropped is not None:
            for future in dropped.sums:
                future.cancel()

    def maps(self, stack: FringeStack) -> tuple[dict[str, PhaseMap], float] | None:
        """Return the maps of a stack that was decoded here, and the time of its last image; None for other stacks.

        Raises
        ------
        DecodeError
            The images contradict the pattern set.
        """
        viewpoint = self._viewpoints.pop(stack.viewpoint_id, None)
        if viewpoint is None or viewpoint.maps is None:
            return None
        check_stack(stack)
        for future in viewpoint.sums:
            future.result()
        return viewpoint.maps.result(), viewpoint.last_image_s
