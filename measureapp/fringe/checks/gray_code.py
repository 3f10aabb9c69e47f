"""Whether Gray code planes are of the kind that their description states: plain or complementary, and none the inverse of another."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.data.fringe import GrayCodeGroup
from measureapp.errors import DecodeError
from measureapp.fringe.checks.sequence import ALWAYS, GRAY_STEP_PX, LEAST_FLIPS, LEAST_PIXELS, Name, lower_first, mark_changes, plane_bits
from measureapp.fringe.phase_shift import shift_weights

LEAST_LENGTH = 0.6  # of the mean of unit vectors: changes of a plane are at one phase
LEAST_COSINE = 0.7  # of the angle between two such means, which is 0 or π


def check_inverse(images: ImageArray, reference: FloatArray, row_px: int, name: Name) -> None:
    """Refuse planes of which the second half shows the first one inverted, as some projectors are programmed.

    Raises
    ------
    DecodeError
        Names the first inverse plane.
    """
    half = len(images) // 2
    if len(images) % 2 or half < 2:
        return
    bits, clear, _lit = plane_bits(images, reference, row_px)
    for plane in range(half):
        both = clear[plane] & clear[plane + half]
        if both.sum() < LEAST_PIXELS or (bits[plane] != bits[plane + half])[both].mean() < ALWAYS:
            return
    raise DecodeError(
        f"{name(half)} is the inverse of {lower_first(name(0))}, and so are all that follow: inverse Gray code planes number no periods.",
        f"Give the first {half} images of the Gray code only.",
    )


def check_kind(images: ImageArray, group: GrayCodeGroup, steps: ImageArray, reference: FloatArray, row_px: int, name: Name) -> None:
    """Refuse a plain code that is described as complementary, and the other way round.

    The planes of a plain code all change at the borders of the periods, thus at one phase of the sinusoids, whatever their origin. The
    last plane of a complementary one changes half a period from the phase at which all others do.

    Parameters
    ----------
    images : (planes, pixels) grey levels, whole rows one after the other
    steps : (N, pixels), the sinusoids whose periods the code numbers
    reference : of `mean_and_swing` of these, (2, pixels)

    Raises
    ------
    DecodeError
        Names the last plane.
    """
    if group.direction != "vertical" or row_px <= GRAY_STEP_PX or len(images) < 3:
        return
    bits, clear, lit = plane_bits(images, reference, row_px)
    sine, cosine = (weights @ steps for weights in shift_weights(len(steps), -1))  # or 1: only differences count
    turned = np.exp(1j * np.arctan2(sine, cosine)).reshape(-1, row_px)
    changes = [mark_changes(plane, sure, lit) for plane, sure in zip(bits, clear, strict=True)]
    last, others = (_mean_phase(marks, turned) for marks in (changes[-1], np.any(changes[:-1], axis=0)))
    if last is None or others is None:
        return
    cosine = (last * np.conj(others)).real
    if cosine < -LEAST_COSINE and not group.complementary:
        raise DecodeError(
            f"{name(len(images) - 1)} changes in the middle of the periods that the other Gray code planes number: the code is complementary, "
            "and its description does not state it.",
            "Add `complementary = true` to the group of the Gray code.",
        )
    if cosine > LEAST_COSINE and group.complementary:
        raise DecodeError(
            f"{name(len(images) - 1)} changes where the other Gray code planes do: the code is plain, and its description states a "
            "complementary one.",
            "Remove `complementary = true` from the group of the Gray code, or add the shifted last plane.",
        )


def _mean_phase(marks: BoolArray, turned: FloatArray) -> complex | None:
    """Return the direction of the mean phase at the middle of changes; None where there are too few, or they are at no one phase."""
    middle = GRAY_STEP_PX // 2
    found = turned[:, middle : middle + marks.shape[1]][marks]
    if len(found) < LEAST_FLIPS:
        return None
    mean = complex(found.mean())
    return mean / abs(mean) if abs(mean) > LEAST_LENGTH else None
