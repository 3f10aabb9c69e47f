"""Images of a pattern set: sinusoids and Gray code planes; and whether a set determines the phase."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.fringe import Direction, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.patterns.gray_code import check_gray_code, gray_bits
from measureapp.fringe.patterns.response import ProjectorResponse
from measureapp.fringe.unwrap import extent_px, plan_heterodyne

WHITE = 255.0


def pattern_images(patterns: PatternSet, width_px: int, height_px: int, response: ProjectorResponse | None = None) -> ImageArray:
    """Draw the images of a pattern set, (P, height, width) uint8, in the order they are projected.

    Column c of a sinusoid of vertical fringes shows 127.5 · (1 + cos(2π c / pitch + shift_sign · 2π n / N)), horizontal fringes
    run over the rows instead; Gray planes are black or white.

    Parameters
    ----------
    response : of the projector; the sinusoids are distorted so that its light becomes sinusoidal. None: levels as above

    Raises
    ------
    DecodeError
        The set does not determine the phase over the projector, or the projector is larger than the set's range.
    """
    check_determines_phase(patterns)
    images = np.empty((patterns.count, height_px, width_px), np.uint8)
    for direction in patterns.directions:
        alone, where = patterns.subset(direction)
        shown_px = width_px if direction == "vertical" else height_px
        check_covers(alone, shown_px, direction)
        levels = np.array([row for group in alone.groups for row in _levels(group, alone, shown_px, response)])
        lines = np.rint(levels).astype(np.uint8)
        images[where] = lines[:, None, :] if direction == "vertical" else lines[:, :, None]
    return images


def check_covers(alone: PatternSet, shown_px: int, direction: Direction) -> None:
    """Raise DecodeError when a projector shows more columns (rows) than a set of vertical (horizontal) fringes is made for."""
    if shown_px > extent_px(alone):
        size, lines = ("wide", "columns") if direction == "vertical" else ("high", "rows")
        raise DecodeError(
            f"The projector is {shown_px} px {size}, the pattern set covers {extent_px(alone)} {lines}.",
            "Use a pattern set made for this projector.",
        )


def check_determines_phase(patterns: PatternSet) -> None:
    """Raise DecodeError with the reason when a set does not determine the phase over the projector, in each of its directions."""
    for direction in patterns.directions:
        alone, _ = patterns.subset(direction)
        if not alone.pitches_px:
            raise DecodeError(f"Pattern set {alone.name!r} has no sinusoids.", "Add a phase-shift group of at least three images.")
        gray = [group for group in alone.groups if isinstance(group, GrayCodeGroup)]
        if len(gray) > 1:
            raise DecodeError(f"Pattern set {alone.name!r} has {len(gray)} Gray codes.", "Put all Gray planes into one group.")
        if gray:
            check_gray_code(gray[0], alone)
        else:
            plan_heterodyne(alone)


def _levels(
    group: PhaseShiftGroup | GrayCodeGroup, patterns: PatternSet, shown_px: int, response: ProjectorResponse | None
) -> list[FloatArray]:
    """Return the grey levels 0…255 of each image of a group over the projector's columns or rows."""
    position_px = np.arange(shown_px, dtype=float)
    if isinstance(group, GrayCodeGroup):
        return [WHITE * bits for bits in gray_bits(group, patterns.finest_pitch_px, position_px)]
    phase = 2 * np.pi * position_px / group.pitch_px
    shifts = patterns.shift_sign * 2 * np.pi * np.arange(group.steps) / group.steps
    light = [(1 + np.cos(phase + shift)) / 2 for shift in shifts]
    return [WHITE * share if response is None else response.level_for(share) for share in light]
