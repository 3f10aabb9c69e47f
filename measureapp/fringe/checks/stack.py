"""Whether a stack of fringe images matches its pattern set: complete, in order, nothing twice."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternGroup, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.checks import gray_code as gray_checks
from measureapp.fringe.checks import sequence as sequence_checks
from measureapp.fringe.checks.sequence import LEAST_PIXELS, MOST_PIXELS, clear_range, lower_first

SAMPLED_ROWS, MOST_SAMPLED = 12, 8_000
BRIGHTNESS_TOLERANCE, LEAST_CORRELATION = 0.25, 0.9  # of the logarithm of the ratio of two exposures
BEYOND = 2.0  # times the saturation: levels that this bit depth cannot have


@dataclass(frozen=True, slots=True, eq=False)
class _Sample:
    """Some rows of all images of a camera."""

    camera: str
    pixels: ImageArray  # (exposures, patterns, pixels)
    row_px: int  # length of a row in pixels
    stack: FringeStack

    def place(self, exposure: int, image: int) -> str:
        """Name an image for a message."""
        return f"Image {image + 1} of camera {self.camera!r} at {self.stack.exposures_us[exposure]} µs"

    @property
    def least_range(self) -> float:
        """By how many grey levels a pixel with fringes must change."""
        return clear_range(self.stack.saturation)


def check_stack(stack: FringeStack) -> None:
    """Refuse a stack in which images are missing, repeated, blank or in the wrong order.

    Twelve rows of every image are examined, and only unsaturated pixels with fringes: a scene
    that is too dark or too bright for a statement passes, and noise, highlights and a projector without gamma correction
    pass too. Not detectable in the images of one camera: steps in exactly reversed or rotated order (another shift
    sign or origin; with three steps every exchange, with four that of opposite ones), and the cameras exchanged; both show
    in the geometry. Gray planes with only one or two stripes on the part may be black or white everywhere, and pass.

    Raises
    ------
    DecodeError
        Names camera, exposure and image, counted from 1.
    """
    check_shapes(stack)
    samples = [_sample_rows(stack, camera) for camera in stack.images]
    for sample in samples:
        _check_levels(sample)
        _check_copies(sample)
        for exposure in range(len(stack.exposures_us)):
            _check_sequence(sample, exposure)
        _check_brightness(sample)


def check_shapes(stack: FringeStack) -> None:
    """Raise DecodeError unless all cameras have as many images as the set says, and of one bit depth."""
    expected = (len(stack.exposures_us), stack.patterns.count)
    for camera, images in stack.images.items():
        if images.ndim != 4 or images.shape[:2] != expected:
            raise DecodeError(
                f"Camera {camera!r} has images of shape {images.shape}; the set needs {expected[0]} exposures of {expected[1]} images.",
                "Record every pattern at every exposure.",
            )
        if images.dtype not in (np.uint8, np.uint16):
            raise DecodeError(f"Camera {camera!r} has {images.dtype} images.", "Use 8- or 16-bit images without sign.")
    depths = {camera: 8 * images.dtype.itemsize for camera, images in stack.images.items()}
    if len(set(depths.values())) > 1:
        listed = ", ".join(f"{camera}: {depth} bit" for camera, depth in depths.items())
        raise DecodeError(f"The cameras have images of different bit depths ({listed}).", "Record all cameras with one bit depth.")


def _sample_rows(stack: FringeStack, camera: str) -> _Sample:
    images = stack.images[camera]
    height, width = images.shape[2:]
    rows = np.unique(np.linspace(0, height - 1, min(height, SAMPLED_ROWS) + 2).astype(int)[1:-1]) if height > SAMPLED_ROWS else slice(None)
    pixels = images[:, :, rows, :]
    step = max(1, pixels.shape[2] * width // MOST_SAMPLED)
    pixels = pixels[..., ::step]
    return _Sample(camera, pixels.reshape(*images.shape[:2], -1), pixels.shape[3], stack)


def _check_levels(sample: _Sample) -> None:
    """Levels far above saturation: 12-bit images among 10-bit ones."""
    if sample.pixels.dtype == np.uint8:
        return
    limit = BEYOND * (sample.stack.saturation + 1)
    for exposure, images in enumerate(sample.pixels):
        counts = (images > limit).sum(axis=1)
        if counts.max() > max(LEAST_PIXELS, 0.001 * images.shape[1]):
            image = int(counts.argmax())
            raise DecodeError(
                f"{sample.place(exposure, image)} has grey levels up to {int(images[image].max())}, "
                f"but the stack saturates at {sample.stack.saturation}.",
                "Record all cameras with one bit depth and give its saturation.",
            )


def _check_copies(sample: _Sample) -> None:
    """Two images that agree in every sampled pixel although the pixels around them have fringes."""
    seen: dict[bytes, tuple[int, int]] = {}
    for exposure, images in enumerate(sample.pixels):
        lit = np.flatnonzero(_lit(images, sample))
        if len(lit) < LEAST_PIXELS:
            continue
        varies = _must_differ(images[:, lit], sample)
        for image, pixels in enumerate(images):
            if not varies[image]:
                continue
            first = seen.setdefault(pixels.tobytes(), (exposure, image))
            if first != (exposure, image):
                raise DecodeError(
                    f"{sample.place(exposure, image)} is the same as {lower_first(sample.place(*first))}.",
                    "Record every pattern once; check that no file was copied over another.",
                )


def _must_differ(images: ImageArray, sample: _Sample) -> list[bool]:
    """Whether each image must differ from all others: a Gray plane may be all black or white on the part, and so may two."""
    bright = (images > images.max(axis=0) / 2.0 + images.min(axis=0) / 2.0).mean(axis=1)
    ranges = images.max(axis=1).astype(float) - images.min(axis=1)
    groups = [group for group in sample.stack.patterns.groups for _ in range(group.count)]
    return [
        bool(ranges[image] > sample.least_range if isinstance(group, PhaseShiftGroup) else 0.05 < bright[image] < 0.95)
        for image, group in enumerate(groups)
    ]


def _lit(images: ImageArray, sample: _Sample) -> np.ndarray:
    high, low = images.max(axis=0), images.min(axis=0)
    return np.asarray((high - low > sample.least_range) & (high < sample.stack.saturation))


@dataclass(frozen=True, slots=True, eq=False)
class _GroupImages:
    """The sampled images of one group at one exposure."""

    group: PatternGroup
    images: ImageArray
    name: Callable[[int], str]


def _check_sequence(sample: _Sample, exposure: int) -> None:
    """Check the groups of one exposure, each for itself and sinusoids also in pairs."""
    saturation = sample.stack.saturation
    groups = list(_groups(sample, exposure))
    steps = [one for one in groups if isinstance(one.group, PhaseShiftGroup)]
    for one in steps:
        sequence_checks.check_steps(one.images, saturation, one.name, _covers_phase_elsewhere(one, steps, saturation))
    for one, other in combinations(steps, 2):
        if one.group.count == other.group.count:
            sequence_checks.check_between_groups(one.images, other.images, saturation, one.name, other.name)
    for one in groups:
        if isinstance(one.group, GrayCodeGroup) and steps:
            reference = sequence_checks.mean_and_swing(steps[0].images, saturation)
            sequence_checks.check_planes(one.images, one.group, reference, sample.row_px, one.name)
            _check_gray_code(one, steps, sample)


def _check_gray_code(gray: _GroupImages, steps: list[_GroupImages], sample: _Sample) -> None:
    """Check of which kind a code is, by the finest sinusoids of its direction: those whose periods it numbers."""
    mine = [one for one in steps if one.group.direction == gray.group.direction]
    if not mine or not isinstance(gray.group, GrayCodeGroup):
        return
    finest = min(mine, key=_pitch_px)
    reference = sequence_checks.mean_and_swing(finest.images, sample.stack.saturation)
    gray_checks.check_inverse(gray.images, reference, sample.row_px, gray.name)
    gray_checks.check_kind(gray.images, gray.group, finest.images, reference, sample.row_px, gray.name)


def _groups(sample: _Sample, exposure: int) -> Iterator[_GroupImages]:
    start = 0
    for group in sample.stack.patterns.groups:
        yield _GroupImages(group, sample.pixels[exposure, start : start + group.count], _namer(sample, exposure, start))
        start += group.count


def _namer(sample: _Sample, exposure: int, start: int) -> Callable[[int], str]:
    return lambda image: sample.place(exposure, start + image)


def _covers_phase_elsewhere(own: _GroupImages, steps: list[_GroupImages], saturation: float) -> bool:
    """Whether another group of the same direction, no finer than this one, shows that the phase takes all values."""
    pitch = _pitch_px(own)
    return any(
        sequence_checks.phase_is_spread(other.images, saturation)
        for other in steps
        if other is not own and other.group.direction == own.group.direction and _pitch_px(other) >= 0.75 * pitch
    )


def _pitch_px(group_images: _GroupImages) -> float:
    assert isinstance(group_images.group, PhaseShiftGroup)
    return group_images.group.pitch_px


def _check_brightness(sample: _Sample) -> None:
    """The swing of the fringes must follow the exposure time."""
    exposures = sample.stack.exposures_us
    for first, second in pairwise(range(len(exposures))):
        found = _swing_ratio(sample, first, second)
        if found is None:
            continue
        expected = float(np.log(exposures[first] / exposures[second]))
        if abs(np.log(found) - expected) <= 0.5 * abs(expected) + BRIGHTNESS_TOLERANCE:
            continue
        swapped = abs(np.log(found) + expected) <= 0.5 * abs(expected) + BRIGHTNESS_TOLERANCE
        raise DecodeError(
            f"The images of camera {sample.camera!r} at {exposures[first]} µs are {found:.2f} times as bright as those at "
            f"{exposures[second]} µs, not {np.exp(expected):.2f} times.",
            "The two exposures appear to be exchanged: check their order."
            if swapped
            else "Check that the camera took every exposure, without automatic gain.",
        )


def _swing_ratio(sample: _Sample, first: int, second: int) -> float | None:
    """Return the ratio of the swings of two exposures over pixels that see fringes in both; None where it is not determined."""
    one, two = sample.pixels[first], sample.pixels[second]
    both = np.flatnonzero(_lit(one, sample) & _lit(two, sample))
    if len(both) < LEAST_PIXELS:
        return None
    both = both[:: max(1, len(both) // MOST_PIXELS)]
    swings = [images[:, both].astype(np.float32) for images in (one, two)]
    swings = [swing - swing.mean(axis=0) for swing in swings]
    power = [float(np.vdot(swing, swing)) for swing in swings]
    correlation = float(np.vdot(*swings)) / np.sqrt(power[0] * power[1])
    return float(np.sqrt(power[0] / power[1])) if correlation > LEAST_CORRELATION else None
