"""Predefined pattern sets, for a projector of any size."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from math import ceil, log2, sqrt
from types import MappingProxyType

from measureapp.data.fringe import Direction, GrayCodeGroup, PatternGroup, PatternSet, PhaseShiftGroup

KEPT_SIZES = 16  # of projectors, whose sets are kept
GUARD = 1 / 16  # guard band relative to the extent: 64 px of 1024
PAPER_GUARD = 1 / 32
FINE_PX, COARSE_PX = 16.0, 32.0  # the finest pitch that projector and lens usually show with full contrast, and the paper's
MIDDLE = 0.85  # of √(periods over the range): position of the second of three close pitches with the most robust fringe orders

Groups = Callable[[float, Direction], tuple[PatternGroup, ...]]


@lru_cache(maxsize=KEPT_SIZES)
def make_pattern_sets(width_px: int, height_px: int) -> Mapping[str, PatternSet]:
    """Return all predefined sets for a projector of this size; sets named ``…-both`` have vertical and horizontal fringes.

    Parameters
    ----------
    width_px, height_px : of the projector; the unambiguous range exceeds them by a guard band of at least 1/32
    """
    one = {name: _one_way(words, groups, width_px) for name, (words, groups) in _KINDS.items()}
    both = {f"{name}-both": _both_ways(*_KINDS[name], width_px, height_px) for name in _BOTH}
    return MappingProxyType({**one, **both})


def _one_way(words: str, groups: Groups, width_px: int) -> PatternSet:
    made = groups(width_px, "vertical")
    return PatternSet(name=words.format(**_pitches(made)), projector_px=width_px, groups=made)


def _both_ways(words: str, groups: Groups, width_px: int, height_px: int) -> PatternSet:
    upright, lying = groups(width_px, "vertical"), groups(height_px, "horizontal")
    name = f"{words.format(**_pitches(upright))}, both directions"
    return PatternSet(name=name, projector_px=width_px, projector_rows=height_px, groups=upright + lying)


def _pitches(groups: tuple[PatternGroup, ...]) -> dict[str, str]:
    """Return the pitches by the placeholders of titles."""
    pitches = [f"{group.pitch_px:.4g}" for group in groups if isinstance(group, PhaseShiftGroup)]
    return dict(zip("abcdefghijkl", pitches, strict=False))


def _sines(pitches_px: tuple[float, ...], steps: tuple[int, ...], direction: Direction) -> tuple[PatternGroup, ...]:
    return tuple(PhaseShiftGroup(pitch_px=pitch, steps=n, direction=direction) for pitch, n in zip(pitches_px, steps, strict=True))


def _two_close(steps: int) -> Groups:
    """Two-frequency heterodyne: integer pitches p and p + 1, whose beat p (p + 1) covers extent and guard band (32 and 33 px)."""

    def groups(extent_px: float, direction: Direction) -> tuple[PatternGroup, ...]:
        pitch = ceil(sqrt(extent_px * (1 + PAPER_GUARD) + 0.25) - 0.5 - 1e-9)
        return _sines((pitch, pitch + 1), (steps, steps), direction)

    return groups


def _three_close(steps: int) -> Groups:
    """Three-frequency heterodyne with pitches near 16 px, which all contribute to the resulting phase.

    With R periods of the finest over the range, the others have R − 0.85 √R and one period less: their beat is the range, and
    the beat with the finest lies in between, so that no step of the unwrapping amplifies noise by more than about 1.4 √R.
    """

    def groups(extent_px: float, direction: Direction) -> tuple[PatternGroup, ...]:
        reach = extent_px * (1 + GUARD)
        finest = reach / FINE_PX
        second = finest - MIDDLE * sqrt(finest)
        return _sines((FINE_PX, reach / second, reach / (second - 1)), (steps,) * 3, direction)

    return groups


def _three_wide(finest_px: float, steps: tuple[int, int, int]) -> Groups:
    """Hierarchical unwrapping with three pitches: the finest, one period over the range, and their geometric mean.

    Least noise amplification, but the resulting phase comes from the finest pitch alone.
    """

    def groups(extent_px: float, direction: Direction) -> tuple[PatternGroup, ...]:
        reach = extent_px * (1 + GUARD)
        return _sines((finest_px, sqrt(finest_px * reach), reach), steps, direction)

    return groups


def _halving(extent_px: float, direction: Direction) -> tuple[PatternGroup, ...]:
    """Hierarchical unwrapping by halving: one period over the range, then half of it, and so on down to about 16 px."""
    reach = extent_px * (1 + GUARD)
    count = 1 + round(log2(reach / FINE_PX))
    pitches = tuple(reach / 2**k for k in reversed(range(count)))
    return _sines(pitches, (4,) * count, direction)


def _gray(steps: int, complementary: bool) -> Groups:
    """A sinusoid of 16 px whose periods are numbered by a Gray code."""

    def groups(extent_px: float, direction: Direction) -> tuple[PatternGroup, ...]:
        planes = ceil(log2(extent_px / FINE_PX) - 1e-9) + int(complementary)
        return (*_sines((FINE_PX,), (steps,), direction), GrayCodeGroup(planes=planes, complementary=complementary, direction=direction))

    return groups


# name -> title with placeholders for the pitches, and its groups for an extent
_KINDS: dict[str, tuple[str, Groups]] = {
    "paper": ("paper: 4 steps at {a} and {b} px", _two_close(4)),
    "paper-8-step": ("8 steps at {a} and {b} px", _two_close(8)),
    "three-close": ("three close pitches: 4 steps at {a}, {b} and {c} px", _three_close(4)),
    "three-close-3-step": ("three close pitches: 3 steps at {a}, {b} and {c} px", _three_close(3)),
    "three-close-8-step": ("three close pitches: 8 steps at {a}, {b} and {c} px", _three_close(8)),
    "three-wide": ("three wide pitches: 4 steps at {a}, {b} and {c} px", _three_wide(FINE_PX, (4, 4, 4))),
    "three-wide-8-step": ("three wide pitches: 8, 4 and 4 steps at {a}, {b} and {c} px", _three_wide(FINE_PX, (8, 4, 4))),
    "three-wide-32": ("three wide pitches: 4 steps at {a}, {b} and {c} px", _three_wide(COARSE_PX, (4, 4, 4))),
    "hierarchical": ("hierarchical: 4 steps, each pitch half of the one before, from {a} px", _halving),
    "gray": ("Gray code: 4 steps at {a} px", _gray(4, complementary=False)),
    "complementary-gray": ("complementary Gray code: 4 steps at {a} px", _gray(4, complementary=True)),
    "complementary-gray-8-step": ("complementary Gray code: 8 steps at {a} px", _gray(8, complementary=True)),
}
_BOTH = ("paper", "three-close", "complementary-gray")

PATTERN_SETS = make_pattern_sets(1024, 768)  # the projector of the reference rig
PAPER_PATTERNS = PATTERN_SETS["paper"]
DEFAULT_NAME = "three-close"  # see resources/docs/decisions/0006-pattern-sets.md
BOTH_DIRECTIONS = f"{DEFAULT_NAME}-both"  # the same for vertical and horizontal fringes
DEFAULT_PATTERNS = PATTERN_SETS[DEFAULT_NAME]
