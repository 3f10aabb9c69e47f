"""Task: one pattern group at a long and a short exposure, from which exposures are chosen."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.acquire.tasks.fringes import empty_stacks
from measureapp.arrays import ImageArray, read_only
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.progress import Progress

PROBE_RATIO = 8  # between the two exposures


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
        place, start = _finest(self._patterns)
        group = self._patterns.groups[place]
        longest = max(session.rig.description.exposures_us)
        exposures = (longest, max(1, longest // PROBE_RATIO))
        images = empty_stacks(session.rig, len(exposures), group.count)
        for taken, shot in enumerate(session.shots(range(start, start + group.count), exposures)):
            progress.report(
                taken, len(exposures) * group.count, f"probe: image {taken % group.count + 1} at {shot.exposure_us / 1000:g} ms"
            )
            for name, frame in shot.frames.items():
                images[name][exposures.index(shot.exposure_us), shot.pattern - start] = frame.pixels
                if shot.pattern == start:
                    on_event(ImageTaken(visit.viewpoint_id, name, shot.exposure_us, read_only(frame.pixels)))
        alone = self._patterns.model_copy(update={"name": f"{self._patterns.name}: probe", "groups": (group,)})
        saturation = min(camera.saturation for camera in session.rig.description.cameras)
        return FringeStack("probe", alone, exposures, {name: read_only(stack) for name, stack in images.items()}, saturation)

    def keep(self, result: FringeStack) -> None:
        """Pass the stack on."""
        self._keep(result)

    def drop(self, viewpoint_id: str) -> None:
        """Nothing was passed on."""


def _finest(patterns: PatternSet) -> tuple[int, int]:
    """Return the index of the group of the finest pitch, and of its first image."""
    starts = np.cumsum([0, *(group.count for group in patterns.groups)])
    sinusoids = [(group.pitch_px, number) for number, group in enumerate(patterns.groups) if isinstance(group, PhaseShiftGroup)]
    place = min(sinusoids)[1]
    return place, int(starts[place])
