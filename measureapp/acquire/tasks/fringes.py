"""Task: all patterns at all exposures, as a scan takes them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.session import RigSession
from measureapp.acquire.stale_images import StaleImages
from measureapp.acquire.steady_light import check_light
from measureapp.acquire.task import Visit
from measureapp.arrays import ImageArray, read_only
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.devices.rig import Rig
from measureapp.errors import DecodeError, FrameError
from measureapp.fringe.checks.exposures import check_exposures
from measureapp.fringe.checks.stack import check_stack
from measureapp.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class ExposureTaken:
    """All images of one exposure of a viewpoint, available before the other exposures are taken."""

    viewpoint_id: str
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # of the whole bracket
    level: int  # index into `exposures_us`
    images: Mapping[str, ImageArray]  # camera -> (patterns, height, width), read-only
    saturation: int


class Sink(Protocol):
    """Consumer of the images of a scan."""

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Accept all images of one exposure; must return quickly, because the rig waits."""

    def drop(self, viewpoint_id: str) -> None:
        """Discard the exposures of a viewpoint that failed, was cancelled or is taken again."""

    def store(self, stack: FringeStack) -> None:
        """Store ``stack`` permanently; raises StorageError."""


class FringeTask:
    """Takes a pattern set with an exposure bracket and passes the stacks to a sink.

    Parameters
    ----------
    pattern_images : (patterns, height, width) uint8, images of the projector
    """

    def __init__(self, patterns: PatternSet, exposures_us: tuple[int, ...], pattern_images: ImageArray, sink: Sink) -> None:
        self._patterns, self._exposures_us, self._pattern_images = patterns, exposures_us, pattern_images
        self._sink = sink
        self._stale = StaleImages()

    def prepare(self, session: RigSession) -> None:
        """Load the patterns into the projector."""
        session.load(self._pattern_images)

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> FringeStack:
        """Take the stack; raises FrameError where its images contradict the patterns or repeat earlier ones."""
        stack = take_stack(session, visit, self._patterns, self._exposures_us, on_event, progress, self._sink.exposure_taken)
        check_images(stack)
        self._stale.check(stack)
        return stack

    def keep(self, result: FringeStack) -> None:
        """Store the stack."""
        self._sink.store(result)

    def drop(self, viewpoint_id: str) -> None:
        """Discard the exposures that were passed on."""
        self._sink.drop(viewpoint_id)


def take_stack(
    session: RigSession,
    visit: Visit,
    patterns: PatternSet,
    exposures_us: tuple[int, ...],
    on_event: Callable[[AcquisitionEvent], None],
    progress: Progress,
    on_exposure: Callable[[ExposureTaken], None] = lambda _: None,
) -> FringeStack:
    """Take all patterns at all exposures; the patterns must be loaded already, ``on_exposure`` is called with each complete exposure."""
    rig, count = session.rig, patterns.count
    images = empty_stacks(rig, len(exposures_us), count)
    saturation = min(camera.saturation for camera in rig.description.cameras)
    missing = dict.fromkeys(exposures_us, count)
    for taken, shot in enumerate(session.shots(range(count), exposures_us)):
        level = exposures_us.index(shot.exposure_us)
        progress.report(
            taken, len(exposures_us) * count, f"{visit.viewpoint_id}: image {taken % count + 1} at {shot.exposure_us / 1000:g} ms"
        )
        for name, frame in shot.frames.items():
            images[name][level, shot.pattern] = frame.pixels
            if shot.pattern == 0:
                on_event(ImageTaken(visit.viewpoint_id, name, shot.exposure_us, read_only(frame.pixels)))
        missing[shot.exposure_us] -= 1
        if not missing[shot.exposure_us]:
            of_level = {name: read_only(stack[level]) for name, stack in images.items()}
            on_exposure(ExposureTaken(visit.viewpoint_id, patterns, exposures_us, level, of_level, saturation))
    return FringeStack(
        viewpoint_id=visit.viewpoint_id,
        patterns=patterns,
        exposures_us=exposures_us,
        images={name: read_only(stack) for name, stack in images.items()},
        saturation=saturation,
        readback=visit.readback,
        conditions=session.conditions(),
        approach=visit.approach,
    )


def empty_stacks(rig: Rig, exposures: int, patterns: int) -> dict[str, ImageArray]:
    """Return room for the images of all cameras, (exposures, patterns, height, width) each."""
    return {
        name: np.empty((exposures, patterns, camera.height_px, camera.width_px), np.uint8 if camera.bit_depth == 8 else np.uint16)
        for name, camera in rig.cameras.items()
    }


def check_images(stack: FringeStack) -> None:
    """Raise FrameError where images contradict the patterns they should show: a wrong, torn, repeated, or wrongly exposed or lit one."""
    try:
        check_stack(stack)
        check_exposures(stack)
    except DecodeError as error:
        raise FrameError(error.message, "Check projector, trigger lines and ambient light.") from error
    check_light(stack)
