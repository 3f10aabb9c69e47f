"""Gray code planes: what the projector shows, and how the bits number the periods of the finest sinusoid."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.fringe import GrayCodeGroup, PatternSet
from measureapp.errors import DecodeError
from measureapp.fringe.unwrap import extent_px

ROUNDING = 1e-9  # so that a border that falls on a pixel belongs to the period it begins


def gray_bits(group: GrayCodeGroup, pitch_px: float, position_px: FloatArray) -> BoolArray:
    """Return the bits of all planes at projector positions, (planes, ...), most significant first [1]_.

    A plain code numbers the periods of ``pitch_px``. A complementary one numbers their halves, so that its last plane changes in
    the middle of every period and never together with another plane.

    References
    ----------
    .. [1] Q. Zhang, X. Su, L. Xiang, X. Sun, 3-D shape measurement based on complementary Gray-code light, Optics and Lasers in
       Engineering 50(4), 574-579, 2012.
    """
    step_px = pitch_px / 2 if group.complementary else pitch_px
    number = np.floor(np.asarray(position_px) / step_px + ROUNDING).astype(np.int64)
    code = number ^ (number >> 1)
    return np.array([(code >> plane) & 1 for plane in range(group.planes - 1, -1, -1)], bool)


def period_numbers(bits: BoolArray, phase_rad: FloatArray, complementary: bool) -> IntArray:
    """Number the periods: the readable statement of what the kernel computes.

    Parameters
    ----------
    bits : (planes, ...), most significant first
    phase_rad : (...), wrapped phase counted from the border of the periods; used by a complementary code only
    complementary : the last plane changes in the middle of the periods

    Returns
    -------
    (...) int. With a complementary code the first quarter of a period takes its number from the halves counted up, the last from
    the halves counted down, and the middle from the plain planes, so that no bit is read where it changes.
    """
    number = np.zeros(bits.shape[1:], np.int64)
    bit = np.zeros(bits.shape[1:], bool)
    plain = number
    for plane in bits:
        plain = number
        bit = bit ^ plane
        number = 2 * number + bit
    if not complementary:
        return np.asarray(number)
    share = np.mod(phase_rad / (2 * np.pi), 1.0)
    upper = (number + 1) // 2
    return np.asarray(np.where(share < 0.25, upper, np.where(share >= 0.75, upper - 1, plain)))


def check_gray_code(group: GrayCodeGroup, patterns: PatternSet) -> None:
    """Raise DecodeError when the planes do not number all periods of the finest pitch over the projector."""
    planes = group.planes - int(group.complementary)
    extent = extent_px(patterns)
    covered = 2**planes * patterns.finest_pitch_px
    if covered < extent * (1 - 1e-6):
        lines = "rows" if patterns.directions == ("horizontal",) else "columns"
        raise DecodeError(
            f"{planes} Gray planes number {2**planes} periods of {patterns.finest_pitch_px:g} px: {covered:g} of {extent} {lines}.",
            "Add Gray planes, the most significant first, or a coarser pitch.",
        )
