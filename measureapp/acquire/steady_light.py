"""Whether the projector's light was on and steady while the images of a viewpoint were taken."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.errors import FrameError

SAMPLED_ROWS, SAMPLED_COLUMNS = 40, 200
LEAST_SWING = 0.05  # of a pixel with fringes, share of saturation
LEAST_PIXELS, LEAST_COMPARED = 10, 50
MOST_CHANGE = 0.05  # of the mean level from group to group; 0.003 on the virtual rig, whose lamp is steady


def check_light(stack: FringeStack) -> None:
    """Refuse a stack without fringes, or one in which the light changed between two groups of shifted patterns.

    The mean of equally shifted sinusoids is the same for every pitch, so that groups of one exposure can be compared, also where there is
    no second exposure. Not noticed: a lamp that is dimmer for a whole viewpoint, or for all patterns of its only exposure; it costs
    modulation and not accuracy. A change shorter than a group is found if it changes the group's mean by more than 5 %.

    Raises
    ------
    FrameError
        Says what the images show.
    """
    swings = [_swing(_sample(images)) > LEAST_SWING * stack.saturation for images in stack.images.values()]
    if max(int(lit.sum(axis=(1, 2)).max()) for lit in swings) < LEAST_PIXELS:
        raise FrameError(
            f"{stack.viewpoint_id}: no camera sees fringes: the projector was dark, or nothing is in view.",
            "Check the projector's lamp and lens cap, and the viewpoint.",
        )
    for (camera, images), lit in zip(stack.images.items(), swings, strict=True):
        for level, exposure_us in enumerate(stack.exposures_us):
            change = _change(_sample(images)[level], lit[level], stack.patterns, stack.saturation)
            if change > MOST_CHANGE:
                raise FrameError(
                    f"{stack.viewpoint_id}: the light changed by {change:.0%} between the patterns at {exposure_us} µs (camera {camera}).",
                    "Check the projector's lamp and ambient light.",
                )


def _sample(images: ImageArray) -> ImageArray:
    """Return evenly spaced pixels of every image, (exposures, patterns, rows, columns)."""
    height, width = images.shape[2:]
    return images[:, :, :: max(1, height // SAMPLED_ROWS), :: max(1, width // SAMPLED_COLUMNS)]


def _swing(sample: ImageArray) -> ImageArray:
    return np.asarray(sample.max(axis=1) - sample.min(axis=1))


def _change(sample: ImageArray, lit: ImageArray, patterns: PatternSet, saturation: int) -> float:
    """Return by how much the mean level of the groups differs, relative to the largest; 0 where too few pixels tell."""
    usable = lit & (sample.max(axis=0) < saturation)
    if usable.sum() < LEAST_COMPARED:
        return 0.0
    means = np.stack(list(_means(sample[:, usable].astype(np.float32), patterns)))
    ratios = np.median(means / means.max(axis=0), axis=1)
    return float(1.0 - ratios.min() / ratios.max())


def _means(pixels: FloatArray, patterns: PatternSet) -> Iterator[FloatArray]:
    """Yield the mean of every group of shifted patterns, (pixels,)."""
    start = 0
    for group in patterns.groups:
        if isinstance(group, PhaseShiftGroup):
            yield pixels[start : start + group.count].mean(axis=0)
        start += group.count
