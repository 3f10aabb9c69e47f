"""Sequences: which pattern of which flash image follows which, and the tables that state it to the controller."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.errors import LimitError

from .registers import (
    DARK_GAP_US,
    INTERNAL_TRIGGER,
    MOST_IMAGES,
    MOST_PATTERNS,
    PATTERNS_PER_IMAGE,
    SHORTEST_EXPOSURE_US,
    WHITE_FIELD,
    WHITE_FIELD_BITS,
)

BUFFERED_IMAGES = 2  # the controller holds two images; a third is loaded from flash while the second is shown
HASH_CHARACTERS = 16


@dataclass(frozen=True, slots=True)
class PatternEntry:
    """One line of the controller's pattern table."""

    number: int  # which group of bit planes of the image: 0, 1, 2 are green, red and blue at 8 bits
    bits: int
    leds: int
    trigger: int = INTERNAL_TRIGGER
    black_after: bool = False
    swap: bool = False  # takes the next image of the image table

    def encode(self) -> bytes:
        """Return the three bytes of the line."""
        switches = self.black_after << 1 | self.swap << 2
        return bytes([self.number << 2 | self.trigger, self.leds << 4 | self.bits, switches])


@dataclass(frozen=True, slots=True)
class PatternSequence:
    """What the controller plays."""

    entries: tuple[PatternEntry, ...]
    images: tuple[int, ...]  # flash images in the order of use
    exposure_us: int
    period_us: int
    repeat: bool

    @property
    def bits(self) -> int:
        """Largest bit depth."""
        return max(entry.bits for entry in self.entries)

    def pattern_table(self) -> bytes:
        """Return the pattern table as it goes through the mailbox."""
        return b"".join(entry.encode() for entry in self.entries)

    def image_table(self) -> bytes:
        """Return the image table as it goes through the mailbox: a table of exactly two is stored in reverse order."""
        return bytes(self.images[::-1] if len(self.images) == 2 else self.images)


def pattern_hash(images: ImageArray) -> str:
    """Return the identity of a pattern set (count, height, width): the first 16 characters of its SHA-256, size included."""
    digest = hashlib.sha256("x".join(map(str, images.shape)).encode())
    digest.update(np.ascontiguousarray(images).data)
    return digest.hexdigest()[:HASH_CHARACTERS]


def hold_pattern(index: int, flash_images: Sequence[int], leds: int, cycle_us: int) -> PatternSequence:
    """Return the sequence that shows pattern ``index`` without end, one whole cycle of its bit planes after the other."""
    entry = PatternEntry(index % PATTERNS_PER_IMAGE, 8, leds, swap=True)
    return PatternSequence((entry,), (flash_images[index // PATTERNS_PER_IMAGE],), cycle_us, cycle_us, repeat=True)


def hold_white(leds: int, cycle_us: int, flash_image: int = 0) -> PatternSequence:
    """Return the sequence that lights all pixels without end."""
    return PatternSequence((PatternEntry(WHITE_FIELD, WHITE_FIELD_BITS, leds, swap=True),), (flash_image,), cycle_us, cycle_us, repeat=True)


def play_patterns(first: int, count: int, flash_images: Sequence[int], leds: int, *, exposure_us: int, period_us: int) -> PatternSequence:
    """Return the sequence that plays ``count`` patterns once, dark after each exposure."""
    entries: list[PatternEntry] = []
    images: list[int] = []
    for index in range(first, first + count):
        image = flash_images[index // PATTERNS_PER_IMAGE]
        swap = not images or index % PATTERNS_PER_IMAGE == 0
        if swap:
            images.append(image)
        entries.append(PatternEntry(index % PATTERNS_PER_IMAGE, 8, leds, black_after=True, swap=swap))
    return PatternSequence(tuple(entries), tuple(images), exposure_us, period_us, repeat=False)


def check_times(sequence: PatternSequence, name: str, load_s: Mapping[int, float]) -> None:
    """Refuse times and lengths that the controller cannot play.

    Parameters
    ----------
    load_s : by flash image, how long it takes to be loaded

    Raises
    ------
    LimitError
        The exposure is too short for the bit depth, leaves no dark gap, the tables are too long, or an image would come too late.
    """
    shortest = SHORTEST_EXPOSURE_US[sequence.bits]
    if sequence.exposure_us < shortest:
        raise LimitError(
            f"{name} cannot show patterns of {sequence.bits} bits for {sequence.exposure_us} µs.", f"Choose {shortest} µs or more."
        )
    if not sequence.repeat and sequence.exposure_us > sequence.period_us - DARK_GAP_US:
        raise LimitError(
            f"{name} cannot expose {sequence.exposure_us} µs in a period of {sequence.period_us} µs.",
            f"Choose a period of {sequence.exposure_us + DARK_GAP_US} µs or more.",
        )
    if len(sequence.entries) > MOST_PATTERNS or len(sequence.images) > MOST_IMAGES:
        raise LimitError(
            f"{name} plays at most {MOST_PATTERNS} patterns from {MOST_IMAGES} images at once, not {len(sequence.entries)} "
            f"from {len(sequence.images)}.",
            "Divide the pattern set.",
        )
    _check_loading(sequence, name, load_s)


def _check_loading(sequence: PatternSequence, name: str, load_s: Mapping[int, float]) -> None:
    """Refuse a period in which an image cannot be loaded while the one before it is shown."""
    shown = _patterns_per_image(sequence)
    for place in range(BUFFERED_IMAGES, len(sequence.images)):
        image = sequence.images[place]
        available_s = shown[place - 1] * sequence.period_us * 1e-6
        if load_s[image] > available_s:
            least = -(-round(load_s[image] * 1e6) // shown[place - 1])
            raise LimitError(
                f"{name} needs {load_s[image] * 1e3:.0f} ms to load flash image {image}, and shows the one before it for "
                f"{available_s * 1e3:.0f} ms only.",
                f"Choose a period of {least} µs or more, or a pattern set of at most {BUFFERED_IMAGES * PATTERNS_PER_IMAGE} images.",
            )


def _patterns_per_image(sequence: PatternSequence) -> list[int]:
    counts: list[int] = []
    for entry in sequence.entries:
        if entry.swap:
            counts.append(0)
        counts[-1] += 1
    return counts
