"""What the projector shows: sinusoids and Gray code planes; and whether a set determines the phase."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.fringe import GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.unwrap import plan_heterodyne

WHITE = 255.0


def pattern_images(patterns: PatternSet, width_px: int, height_px: int) -> ImageArray:
    """Draw the images of a pattern set, (P, height, width) uint8, in the order they are projected.

    Column c of a sinusoid shows 127.5 · (1 + cos(2π c / pitch + shift_sign · 2π n / N)); Gray planes are black or white.

    Raises
    ------
    DecodeError
        The set does not determine the phase over the projector, or the projector is wider than the set's range.
    """
    if width_px > patterns.projector_px:
        raise DecodeError(
            f"The projector is {width_px} px wide, the pattern set covers {patterns.projector_px} px.",
            "Use a pattern set made for this projector.",
        )
    check_determines_phase(patterns)
    rows = [row for group in patterns.groups for row in _rows(group, patterns, width_px)]
    return np.repeat(np.rint(np.array(rows)).astype(np.uint8)[:, None, :], height_px, axis=1)


def check_determines_phase(patterns: PatternSet) -> None:
    """Raise DecodeError with the reason when a set does not determine the phase over ``patterns.projector_px``."""
    if not patterns.pitches_px:
        raise DecodeError(f"Pattern set {patterns.name!r} has no sinusoids.", "Add a phase-shift group of at least three images.")
    gray = [group for group in patterns.groups if isinstance(group, GrayCodeGroup)]
    if len(gray) > 1:
        raise DecodeError(f"Pattern set {patterns.name!r} has {len(gray)} Gray codes.", "Put all Gray planes into one group.")
    if gray:
        _check_planes(gray[0], patterns)
    else:
        plan_heterodyne(patterns)


def _check_planes(group: GrayCodeGroup, patterns: PatternSet) -> None:
    planes = group.planes - int(group.complementary)
    covered = 2**planes * patterns.finest_pitch_px
    if covered < patterns.projector_px - 1e-6 * patterns.projector_px:
        raise DecodeError(
            f"{planes} Gray planes number {2**planes} periods of {patterns.finest_pitch_px:g} px: {covered:g} of {patterns.projector_px} columns.",
            "Add Gray planes, the most significant first, or a coarser pitch.",
        )


def _rows(group: PhaseShiftGroup | GrayCodeGroup, patterns: PatternSet, width_px: int) -> list[FloatArray]:
    columns = np.arange(width_px)
    if isinstance(group, PhaseShiftGroup):
        phase = 2 * np.pi * columns / group.pitch_px
        shifts = patterns.shift_sign * 2 * np.pi * np.arange(group.steps) / group.steps
        return [WHITE / 2 * (1 + np.cos(phase + shift)) for shift in shifts]
    divisor = patterns.finest_pitch_px / (2 if group.complementary else 1)
    number = np.floor(columns / divisor + 1e-9).astype(np.int64)
    code = number ^ (number >> 1)
    return [WHITE * ((code >> bit) & 1) for bit in range(group.planes - 1, -1, -1)]
