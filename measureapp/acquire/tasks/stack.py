"""Stacks of images: all patterns at all exposures, and the short probe from which exposures are chosen."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.acquire.events import AcquisitionEvent, ImageTaken
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.arrays import ImageArray, read_only
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.devices.rig import Rig
from measureapp.progress import Progress

PROBE_RATIO = 8  # between the two exposures of a probe


@dataclass(frozen=True, slots=True, eq=False)
class ExposureTaken:
    """All images of one exposure of a viewpoint, available before the other exposures are taken."""

    viewpoint_id: str
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # of the whole bracket
    level: int  # index into `exposures_us`
    images: Mapping[str, ImageArray]  # camera -> (patterns, height, width), read-only
    saturation: int


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


def take_probe(
    session: RigSession, visit: Visit, patterns: PatternSet, on_event: Callable[[AcquisitionEvent], None], progress: Progress
) -> FringeStack:
    """Take the finest pitch at the rig's longest exposure and an eighth of it; the patterns must be loaded already."""
    place, start = _finest(patterns)
    group = patterns.groups[place]
    longest = max(session.rig.description.exposures_us)
    exposures = (longest, max(1, longest // PROBE_RATIO))
    images = empty_stacks(session.rig, len(exposures), group.count)
    for taken, shot in enumerate(session.shots(range(start, start + group.count), exposures)):
        progress.report(taken, len(exposures) * group.count, f"probe: image {taken % group.count + 1} at {shot.exposure_us / 1000:g} ms")
        for name, frame in shot.frames.items():
            images[name][exposures.index(shot.exposure_us), shot.pattern - start] = frame.pixels
            if shot.pattern == start:
                on_event(ImageTaken(visit.viewpoint_id, name, shot.exposure_us, read_only(frame.pixels)))
    alone = patterns.model_copy(update={"name": f"{patterns.name}: probe", "groups": (group,)})
    saturation = min(camera.saturation for camera in session.rig.description.cameras)
    return FringeStack(visit.viewpoint_id, alone, exposures, {name: read_only(stack) for name, stack in images.items()}, saturation)


def _finest(patterns: PatternSet) -> tuple[int, int]:
    """Return the index of the group of the finest pitch, and of its first image."""
    starts = np.cumsum([0, *(group.count for group in patterns.groups)])
    sinusoids = [(group.pitch_px, number) for number, group in enumerate(patterns.groups) if isinstance(group, PhaseShiftGroup)]
    place = min(sinusoids)[1]
    return place, int(starts[place])
