"""Decoding in a background thread while a scan takes images."""

from __future__ import annotations

import time
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import partial
from types import TracebackType

from measureapp.acquire.tasks.stack import ExposureTaken
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import StreamingDecoder
from measureapp.pipeline.worker import LEAVE_S, STOPPED_WITHIN_S, Worker

MOST_UNDECODED = 2  # viewpoints whose images are kept in memory until they are decoded


@dataclass(slots=True)
class _Viewpoint:
    decoder: StreamingDecoder
    sums: list[Future[None]] = field(default_factory=list)
    maps: Future[dict[str, PhaseMap]] | None = None
    last_image_s: float = 0.0  # of the monotonic clock
    dropped: bool = False

    @property
    def keeps_images(self) -> bool:
        """Whether images are still needed, and so kept in memory."""
        return not all(future.done() for future in self.sums) or (self.maps is None and not self.dropped)


@dataclass(frozen=True, slots=True, eq=False)
class LiveMaps:
    """The maps of a viewpoint, which may still be on their way, and the time of its last image."""

    sums: tuple[Future[None], ...]
    maps: Future[dict[str, PhaseMap]]
    last_image_s: float  # of the monotonic clock

    def wait(self, within_s: float) -> dict[str, PhaseMap]:
        """Return the maps. Raises DecodeError where there are none, TimeoutError where they take longer."""
        maps = self.maps.result(within_s)
        for future in self.sums:
            future.result(0)
        return maps


class LiveDecoding:
    """Accumulates every exposure as soon as it is complete, and computes the phase after the last; a context manager of its thread.

    A viewpoint that begins while two others are still being decoded is not decoded here: the scan never waits, and memory stays bounded.
    """

    def __init__(self, settings: DecodeSettings | None = None) -> None:
        self._settings, self._memory = settings, BufferPool()
        self._worker = Worker("live-decoding")
        self._viewpoints: dict[str, _Viewpoint] = {}
        self._undecoded: list[_Viewpoint] = []

    def __enter__(self) -> LiveDecoding:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._worker.close(LEAVE_S if error is None else STOPPED_WITHIN_S)

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Start to accumulate an exposure and return at once; the first one restarts a viewpoint. Raises DecodeError."""
        if taken.level == 0:
            self.drop(taken.viewpoint_id)
            self._begin(taken)
        viewpoint = self._viewpoints.get(taken.viewpoint_id)
        if viewpoint is None:
            return
        for camera, images in taken.images.items():
            viewpoint.sums.append(self._worker.submit(partial(viewpoint.decoder.add, camera, taken.level, images)))
        if taken.level == len(taken.exposures_us) - 1:
            viewpoint.last_image_s = time.monotonic()
            viewpoint.maps = self._worker.submit(viewpoint.decoder.finish)

    def _begin(self, taken: ExposureTaken) -> None:
        """Begin a viewpoint, unless others are behind."""
        self._undecoded = [other for other in self._undecoded if other.keeps_images]
        if len(self._undecoded) >= MOST_UNDECODED:
            return
        decoder = StreamingDecoder(taken.patterns, taken.exposures_us, taken.saturation, self._settings, taken.viewpoint_id, self._memory)
        self._viewpoints[taken.viewpoint_id] = _Viewpoint(decoder)
        self._undecoded.append(self._viewpoints[taken.viewpoint_id])

    def drop(self, viewpoint_id: str) -> None:
        """Discard the sums of a viewpoint that failed."""
        dropped = self._viewpoints.pop(viewpoint_id, None)
        if dropped is not None:
            dropped.dropped = True
            for future in dropped.sums:
                future.cancel()
            if dropped.maps is not None:
                dropped.maps.cancel()

    def take(self, viewpoint_id: str) -> LiveMaps | None:
        """Return the maps of a complete viewpoint, which is then forgotten here; None where it is not decoded here."""
        viewpoint = self._viewpoints.pop(viewpoint_id, None)
        if viewpoint is None or viewpoint.maps is None:
            return None
        return LiveMaps(tuple(viewpoint.sums), viewpoint.maps, viewpoint.last_image_s)
