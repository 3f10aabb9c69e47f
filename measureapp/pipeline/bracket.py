"""Automatic choice of exposures by a rig, from a probe of the scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from measureapp.acquire.capture import SHOW_TIMEOUT_S, grab_checked, move_to, set_exposure
from measureapp.arrays import ImageArray, read_only
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.fringe.exposures import bracket
from measureapp.fringe.exposures.bracket import BracketLimits, BracketProposal
from measureapp.fringe.exposures.probe import read_probe
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.progress import NoProgress, Progress

PROBE_RATIO = 8  # between the two exposures of the probe


def propose_bracket(
    rig: Rig,
    patterns: PatternSet,
    limits: BracketLimits,
    viewpoint: Viewpoint | None = None,
    noise: Mapping[str, CameraNoise] | None = None,
    compare: Mapping[str, Sequence[int]] | None = None,
    progress: Progress | None = None,
) -> BracketProposal:
    """Take one pattern group at two exposures and propose an exposure bracket for the visible scene.

    The patterns remain loaded in the projector. The rig's default bracket is compared with the proposal.

    Parameters
    ----------
    limits : time for all images of one viewpoint, number of exposures, limits of the rig
    viewpoint : where to take the probe; None: at the present position
    noise : measured camera noise; the default model for other cameras
    compare : further brackets to predict, by name

    Raises
    ------
    DecodeError
        Nothing visible can be decoded: all dark, or saturated at the shortest probe exposure.
    DeviceError
        From the rig.
    """
    progress = progress or NoProgress()
    if viewpoint is not None:
        move_to(rig, viewpoint)
    probe = read_probe(probe_stack(rig, patterns, progress), noise or {})
    return bracket.propose_bracket(probe, patterns, limits, compare={"rig": rig.description.exposures_us, **(compare or {})})


def probe_stack(rig: Rig, patterns: PatternSet, progress: Progress) -> FringeStack:
    """Take the finest pitch at the rig's longest exposure and an eighth of it, at the present position."""
    place, start = _finest(patterns)
    group = patterns.groups[place]
    rig.projector.load(pattern_images(patterns, rig.projector.width_px, rig.projector.height_px))
    longest = max(rig.description.exposures_us)
    exposures = (longest, max(1, longest // PROBE_RATIO))
    taken: dict[str, list[ImageArray]] = {name: [] for name in rig.cameras}
    for level, exposure_us in enumerate(exposures):
        set_exposure(rig.cameras, exposure_us)
        for image in range(group.count):
            progress.report(
                level * group.count + image, len(exposures) * group.count, f"probe: image {image + 1} at {exposure_us / 1000:g} ms"
            )
            rig.projector.show(start + image, timeout_s=SHOW_TIMEOUT_S)
            for name, camera in rig.cameras.items():
                taken[name].append(grab_checked(camera, exposure_us, start + image))
    images = {name: read_only(np.reshape(stack, (len(exposures), group.count, *stack[0].shape))) for name, stack in taken.items()}
    alone = patterns.model_copy(update={"name": f"{patterns.name}: probe", "groups": (group,)})
    return FringeStack("probe", alone, exposures, images, min(camera.saturation for camera in rig.description.cameras))


def _finest(patterns: PatternSet) -> tuple[int, int]:
    """Return the index of the group of the finest pitch, and of its first image."""
    starts = np.cumsum([0, *(group.count for group in patterns.groups)])
    sinusoids = [(group.pitch_px, number) for number, group in enumerate(patterns.groups) if isinstance(group, PhaseShiftGroup)]
    place = min(sinusoids)[1]
    return place, int(starts[place])
