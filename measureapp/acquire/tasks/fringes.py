"""Task: all patterns at all exposures, as a scan takes them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from measureapp.acquire.events import AcquisitionEvent
from measureapp.acquire.session import RigSession
from measureapp.acquire.stale_images import StaleImages
from measureapp.acquire.steady_light import check_light
from measureapp.acquire.task import Visit
from measureapp.acquire.tasks.stack import ExposureTaken, take_probe, take_stack
from measureapp.arrays import ImageArray
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.errors import DecodeError, FrameError
from measureapp.fringe.checks.exposures import check_exposures
from measureapp.fringe.checks.stack import check_stack
from measureapp.progress import PartOf, Progress


class Sink(Protocol):
    """Consumer of the images of a scan."""

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Accept all images of one exposure; must return quickly, because the rig waits."""

    def drop(self, viewpoint_id: str) -> None:
        """Discard the exposures of a viewpoint that failed, was cancelled or is taken again."""

    def store(self, stack: FringeStack) -> None:
        """Store ``stack`` permanently; raises StorageError."""


ChooseExposures = Callable[[FringeStack, tuple[int, ...]], tuple[int, ...]]
PROBE_SHARE = 0.1  # of the progress of a viewpoint


class FringeTask:
    """Takes a pattern set with an exposure bracket and passes the stacks to a sink.

    Parameters
    ----------
    exposures_us : of viewpoints without exposures of their own
    pattern_images : (patterns, height, width) uint8, images of the projector
    choose : returns the exposures of a viewpoint from a probe that is taken there first, and those planned
    """

    def __init__(
        self,
        patterns: PatternSet,
        exposures_us: tuple[int, ...],
        pattern_images: ImageArray,
        sink: Sink,
        choose: ChooseExposures | None = None,
    ) -> None:
        self._patterns, self._exposures_us, self._pattern_images = patterns, exposures_us, pattern_images
        self._sink, self._choose = sink, choose
        self._stale = StaleImages()

    def prepare(self, session: RigSession) -> None:
        """Load the patterns into the projector."""
        session.load(self._pattern_images)

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> FringeStack:
        """Take the stack with the exposures of the viewpoint, or else those of the task; or those chosen from a probe taken here."""
        exposures_us = visit.exposures_us or self._exposures_us
        if self._choose is not None:
            probe = take_probe(session, visit, self._patterns, on_event, PartOf(progress, 0.0, PROBE_SHARE))
            exposures_us = self._choose(probe, exposures_us)
            progress = PartOf(progress, PROBE_SHARE, 1.0)
        return take_stack(session, visit, self._patterns, exposures_us, on_event, progress, self._sink.exposure_taken)

    def check(self, result: FringeStack) -> None:
        """Raise FrameError where the images contradict the patterns or repeat earlier ones."""
        check_images(result)
        self._stale.check(result)

    def keep(self, result: FringeStack) -> None:
        """Store the stack."""
        self._sink.store(result)

    def drop(self, viewpoint_id: str) -> None:
        """Discard the exposures that were passed on."""
        self._sink.drop(viewpoint_id)


def check_images(stack: FringeStack) -> None:
    """Raise FrameError where images contradict the patterns they should show: a wrong, torn, repeated, or wrongly exposed or lit one."""
    try:
        check_stack(stack)
        check_exposures(stack)
    except DecodeError as error:
        raise FrameError(error.message, "Check projector, trigger lines and ambient light.") from error
    check_light(stack)
