"""Whether the images of one pattern at several exposures show the same light: none is foreign, torn, or exposed or lit otherwise."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.data.fringe import FringeStack
from measureapp.errors import DecodeError
from measureapp.fringe.noise.model import CameraNoise

SAMPLED_ROWS, PIXELS_PER_ROW = 24, 200
LEAST_PIXELS, LEAST_OF_ROW = 200, 30
REFERENCE_LEVELS = (0.04, 0.98)  # relative to saturation: levels from which another exposure is predicted
CLEAR_LEVELS = (0.08, 0.90)  # predicted levels that are compared
TOLERANCE, SIGMAS = 0.12, 6.0  # of the predicted level of a pixel; no lamp, shutter or sensor is as far from linear
MOST_OFF, MOST_OFF_ROW = 0.08, 0.6  # share of the pixels of an image, or of a row, that may contradict: blooming around highlights
MOST_BRIGHTER = 0.08  # by which an image as a whole may differ from the others of its exposure, beyond what they have in common
MOVED_IMAGES, MOVED_EXPOSURES = 4, 3  # from so many on it is no single exchanged or torn image
MOST_IN_COMMON = 0.17  # by which all images of an exposure may: cameras bend by 12 %, the next exposure of a fine ladder is 20 % away


@dataclass(frozen=True, slots=True)
class _Finding:
    """How one image compares with the prediction from the other exposures."""

    level: int
    image: int
    off: float  # share of its pixels that contradict
    off_row: float  # the same in its worst row
    ratio: float  # median of level over predicted level
    common: float  # median of the ratios of all images of the exposure

    @property
    def contradicts(self) -> bool:
        return self.off > MOST_OFF or self.off_row > MOST_OFF_ROW or self.too_bright

    @property
    def too_bright(self) -> bool:
        """Whether the level of the image as a whole contradicts.

        A response that is not a straight line, or a lamp that is dimmer for a whole exposure, changes all its images alike: the phase
        stays, so that this alone is no reason to refuse them.
        """
        return abs(self.common - 1.0) > MOST_IN_COMMON or abs(self.ratio - self.common) > MOST_BRIGHTER * self.common

    @property
    def words(self) -> str:
        """What contradicts."""
        level = f"{self.ratio:.2f} times as bright as they predict, all images of its exposure {self.common:.2f} times"
        return f"in {self.off:.0%} of its pixels (it is {level})" if self.off >= 0.005 else f"as a whole: it is {level}"


def check_exposures(stack: FringeStack) -> None:
    """Refuse a stack in which an image contradicts the other exposures of its pattern.

    From every image the same pattern at another exposure follows by the ratio of the exposure times, where neither is dark or
    saturated. Found are a single image of another scene or pattern, a torn or half-transferred one, a wrong exposure, grey levels that
    wrapped, a lamp that changed by more than a tenth between images, and fringes that moved in several images. With a single exposure there is nothing to compare.

    Raises
    ------
    DecodeError
        Names camera, exposure and image, counted from 1.
    """
    if len(stack.exposures_us) < 2:
        return
    for camera, images in stack.images.items():
        wrong = [finding for finding in _compare(_sample(images), stack) if finding.contradicts]
        moved = [finding for finding in wrong if not finding.too_bright]
        if len(moved) >= MOVED_IMAGES and len({finding.level for finding in moved}) >= MOVED_EXPOSURES:
            worst = max(moved, key=lambda finding: finding.off)
            raise DecodeError(
                f"{len(moved)} images of camera {camera!r} contradict the other exposures, in up to {worst.off:.0%} of their pixels, although they "
                "are as bright as predicted: the fringes moved during the images, by vibration, or because a part or axis had not settled.",
                "Keep vibration away or wait longer after each move, and take the viewpoint again.",
            )
        if wrong:
            worst = max(wrong, key=lambda finding: (finding.off, abs(finding.ratio - 1.0)))
            raise DecodeError(
                f"Image {worst.image + 1} of camera {camera!r} at {stack.exposures_us[worst.level]} µs contradicts the other exposures "
                f"{worst.words}.",
                "Check the projector's lamp, the cameras' triggers and links, and ambient light.",
            )


def _sample(images: ImageArray) -> ImageArray:
    """Return evenly spaced pixels of every image, (exposures, patterns, rows, pixels of a row)."""
    height, width = images.shape[2:]
    return images[:, :, :: max(1, height // SAMPLED_ROWS), :: max(1, width // PIXELS_PER_ROW)]


def _compare(sample: ImageArray, stack: FringeStack) -> Iterator[_Finding]:
    """Compare every image that has enough clear pixels with what the other exposures predict."""
    levels = sample.astype(np.float32)
    times = np.array(stack.exposures_us, np.float32)
    low, high = (share * stack.saturation for share in REFERENCE_LEVELS)
    radiance = np.where((levels > low) & (levels < high), levels / times[:, None, None, None], np.nan)
    ordered = np.sort(radiance, axis=0)  # once for all exposures: sorting is most of the time
    for level, time in enumerate(times):
        predicted = median_of_others(radiance, ordered, level) * time
        clear = _is_clear(predicted, stack.saturation)
        off = clear & (np.abs(levels[level] - predicted) > _allowed(predicted, stack.saturation))
        counts, wrong = clear.sum(axis=-1), off.sum(axis=-1)
        rows = np.where(counts >= LEAST_OF_ROW, wrong / np.maximum(counts, 1), 0.0)
        known = np.flatnonzero(counts.sum(axis=-1) >= LEAST_PIXELS)
        ratios = [float(np.median(levels[level, image][clear[image]] / predicted[image][clear[image]])) for image in known]
        for image, ratio in zip(known, ratios, strict=True):
            share = float(wrong[image].sum() / counts[image].sum())
            yield _Finding(level, int(image), share, float(rows[image].max()), ratio, float(np.median(ratios)))


def median_of_others(radiance: FloatArray, ordered: FloatArray, level: int) -> FloatArray:
    """Return the median over the other exposures, (patterns, rows, pixels); NaN where none is usable. ``ordered``: all, NaN last."""
    own = radiance[level]
    known = np.isfinite(own)
    middle = np.maximum(np.isfinite(ordered).sum(axis=0) - known - 1, 0) // 2
    beside = known & ((ordered < own).sum(axis=0) <= middle)  # its own value lies before the one sought
    return np.take_along_axis(ordered, (middle + beside)[None], axis=0)[0]


def _is_clear(predicted: FloatArray, saturation: float) -> BoolArray:
    low, high = (share * saturation for share in CLEAR_LEVELS)
    return (predicted > low) & (predicted < high)


def _allowed(predicted: FloatArray, saturation: float) -> FloatArray:
    sigma = np.sqrt(CameraNoise().variance(np.nan_to_num(predicted), saturation))
    return TOLERANCE * np.nan_to_num(predicted) + SIGMAS * sigma
