"""Task: one pattern group at a long and a short exposure, from which exposures are chosen."""

from __future__ import annotations

from collections.abc import Callable

from measureapp.acquire.events import AcquisitionEvent
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.acquire.tasks.stack import take_probe
from measureapp.arrays import ImageArray
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.progress import Progress


class ProbeTask:
    """Takes the finest pitch at the rig's longest exposure and an eighth of it.

    Parameters
    ----------
    pattern_images : (patterns, height, width) uint8, images of the projector for the whole set
    keep : receives the stack once it is complete
    """

    def __init__(self, patterns: PatternSet, pattern_images: ImageArray, keep: Callable[[FringeStack], None]) -> None:
        self._patterns, self._pattern_images, self._keep = patterns, pattern_images, keep

    def prepare(self, session: RigSession) -> None:
        """Load the patterns into the projector; they remain there."""
        session.load(self._pattern_images)

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> FringeStack:
        """Take both exposures."""
        return take_probe(session, visit, self._patterns, on_event, progress)

    def check(self, result: FringeStack) -> None:
        """Nothing to compare: the task evaluates its images while it takes them."""

    def keep(self, result: FringeStack) -> None:
        """Pass the stack on."""
        self._keep(result)

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was passed on."""
