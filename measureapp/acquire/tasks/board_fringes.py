"""Task: fringes of both directions on the board, for the calibration of the projector."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.acquire.events import AcquisitionEvent
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.acquire.tasks.board import BOARD_SATURATED_SHARE
from measureapp.acquire.tasks.fringes import check_images
from measureapp.acquire.tasks.stack import take_stack
from measureapp.arrays import ImageArray
from measureapp.data.fringe import FringeStack, PatternSet
from measureapp.progress import PartOf, Progress

PROBE_SHARE = 0.1  # of the time


class BoardFringesTask:
    """Takes all patterns at the longest exposure without significant saturation.

    One exposure is enough: a board reflects diffusely, and its black squares need no phase.

    Parameters
    ----------
    pattern_images : (patterns, height, width) uint8, images of the projector
    keep : receives each stack once it is complete
    """

    def __init__(self, patterns: PatternSet, pattern_images: ImageArray, keep: Callable[[FringeStack], None]) -> None:
        self._patterns, self._pattern_images, self._keep = patterns, pattern_images, keep

    def prepare(self, session: RigSession) -> None:
        """Ask for the board on the table and load the patterns into the projector."""
        session.place_on_table("board")
        session.load(self._pattern_images)

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: Progress) -> FringeStack:
        """Choose the exposure by the first group, then take the stack."""
        exposure_us = self._well_exposed_us(session, PartOf(progress, 0.0, PROBE_SHARE))
        return take_stack(session, visit, self._patterns, (exposure_us,), on_event, PartOf(progress, PROBE_SHARE, 1.0))

    def check(self, result: FringeStack) -> None:
        """Raise FrameError where the images contradict the patterns."""
        check_images(result)

    def keep(self, result: FringeStack) -> None:
        """Pass the stack on."""
        self._keep(result)

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was passed on."""

    def _well_exposed_us(self, session: RigSession, progress: Progress) -> int:
        """Return the longest exposure at which no camera saturates significantly in any image of the first group."""
        tried = session.rig.description.exposures_us
        for done, exposure_us in enumerate(tried[:-1]):
            progress.report(done, len(tried), f"exposure {exposure_us / 1000:g} ms")
            if self._saturated_share(session, exposure_us) <= BOARD_SATURATED_SHARE:
                return exposure_us
        return tried[-1]

    def _saturated_share(self, session: RigSession, exposure_us: int) -> float:
        """Return the largest share of a camera's pixels that are saturated in at least one image of the first group."""
        clipped: dict[str, np.ndarray] = {}
        for shot in session.shots(range(self._patterns.groups[0].count), (exposure_us,)):
            for name, frame in shot.frames.items():
                saturated = frame.pixels >= session.rig.description.camera(name).saturation
                clipped[name] = clipped[name] | saturated if name in clipped else saturated
        return max(float(mask.mean()) for mask in clipped.values())
