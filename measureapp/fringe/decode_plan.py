"""The decode plan: how the images of one camera and one fringe direction are summed over the exposures."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.fringe import Direction, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.exposures.weights import exposure_weights
from measureapp.fringe.kernels.structures import CHUNK, ExposureRule, ExposureSums, ImageLayout, round_up_to_chunks
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.phase_shift import shift_weights
from measureapp.fringe.settings import DecodeSettings

MOST_EXPOSURES = 16
LARGEST_SHORT = 32767


@dataclass(frozen=True, slots=True)
class DecodePlan:
    """How the images of one camera and one fringe direction are summed over the exposures.

    Attributes
    ----------
    patterns : the groups of this direction alone
    first : index of their first image in the whole set
    exposures_us : from long to short
    saturation : grey level from which a pixel counts as saturated
    """

    patterns: PatternSet
    direction: Direction
    first: int
    exposures_us: tuple[int, ...]
    saturation: float
    settings: DecodeSettings
    noise: CameraNoise

    @classmethod
    def of(
        cls,
        patterns: PatternSet,
        direction: Direction,
        bracket: tuple[tuple[int, ...], float],
        settings: DecodeSettings,
        camera: str,
    ) -> DecodePlan:
        """Return the plan of one direction of a set; ``bracket`` is the exposures and the saturation. Raises DecodeError."""
        exposures_us, saturation = bracket
        if len(exposures_us) > MOST_EXPOSURES:
            raise DecodeError(f"{len(exposures_us)} exposures are more than {MOST_EXPOSURES}.", "Remove exposures from the bracket.")
        if list(exposures_us) != sorted(exposures_us, reverse=True):
            raise DecodeError("The exposures are not in order from long to short.", "Sort the exposures of the stack.")
        alone, where = patterns.subset(direction)
        return cls(alone, direction, where.start, exposures_us, saturation, settings, settings.noise_of(camera))

    @property
    def groups(self) -> list[PhaseShiftGroup]:
        """Groups of sinusoids, in order."""
        return [group for group in self.patterns.groups if isinstance(group, PhaseShiftGroup)]

    @property
    def gray_code(self) -> GrayCodeGroup | None:
        """The Gray code, if there is one."""
        return next((group for group in self.patterns.groups if isinstance(group, GrayCodeGroup)), None)

    @property
    def finest(self) -> int:
        """Index of the group with the finest pitch."""
        return int(np.argmin([group.pitch_px for group in self.groups]))

    @property
    def weights(self) -> tuple[int, ...]:
        """Weight of each exposure in the sums."""
        if self.settings.rule == "paper":
            return (1,) * len(self.exposures_us)
        least = self.settings.min_modulation_grey(self.saturation)
        return exposure_weights(self.exposures_us, self.noise, self.saturation, least)

    def layout(self) -> ImageLayout:
        """Return which images of the whole set belong together."""
        firsts: list[int] = []
        planes: list[int] = []
        at = self.first
        sines, cosines = np.zeros(self.first + self.patterns.count), np.zeros(self.first + self.patterns.count)
        for group in self.patterns.groups:
            if isinstance(group, PhaseShiftGroup):
                firsts.append(at)
                sines[at : at + group.steps], cosines[at : at + group.steps] = shift_weights(group.steps, -1)
            else:
                planes += range(at, at + group.count)
            at += group.count
        return ImageLayout(
            np.array(firsts, np.int64),
            np.array([group.steps for group in self.groups], np.int64),
            sines.astype(np.float32),
            cosines.astype(np.float32),
            np.array(planes, np.int64),
        )

    def rule(self, dtype: np.dtype[np.unsignedinteger]) -> ExposureRule:
        """Return which exposures a pixel of images of this type uses."""
        top = min(int(np.ceil(self.saturation)) - 1, int(np.iinfo(dtype).max))
        return ExposureRule(self.finest, dtype.type(top), self.settings.rule == "paper", np.array(self.weights, np.uint8))

    def sums(self, dtype: np.dtype[np.unsignedinteger], pixels: int, memory: BufferPool) -> ExposureSums:
        """Allocate the sums of so many pixels, in whole chunks: 16-bit integers where these are exact and cannot overflow."""
        pixels = round_up_to_chunks(pixels)
        steps = [group.steps for group in self.groups]
        short = dtype == np.uint8 and set(steps) == {4} and 255 * 4 * sum(self.weights) <= LARGEST_SHORT
        kind, groups, decisions = np.int16 if short else np.float32, len(steps), 1 if self.settings.joint else len(steps)
        return ExposureSums(
            sine=memory.empty((groups, pixels), kind),
            cosine=memory.empty((groups, pixels), kind),
            total=memory.empty((decisions, pixels), kind),
            planes=memory.empty((self.gray_code.planes if self.gray_code else 0, pixels), kind),
            used=memory.empty((decisions, pixels), np.uint16),
            has_zero=memory.empty(pixels, np.uint8),
            bloomed=memory.empty(pixels, np.uint8),
            complete=np.zeros(pixels // CHUNK, np.uint8),
        )
