"""What the decoding kernels are given and fill: plain tuples of arrays and numbers, which compiled code can take."""

from __future__ import annotations

from typing import Any, NamedTuple

CHUNK = 512  # pixels that are summed and solved together; their images of one exposure stay in the L1 cache
STRETCH = 20 * CHUNK  # pixels whose sums of all exposures stay in the L2 cache, beside the images prefetched meanwhile
PREFETCHED_EXPOSURES = 3  # of the next stretch while one is solved: as many as the L2 cache holds
DIFFER, COMPLETE = -1, -2  # the pixels of a chunk took different exposures; and where one is enough, each has its one
# Of how many chunks one is counted that needs no further exposure: rarely a whole number of rows, so that they are all over the image.
LOOKED_AT = 59
PIXELS = 16  # in one vector; as float32 they fill a cache line
SPACING = CHUNK + 80  # no power of two: rows at such distances would share cache sets and evict each other
RESIDUAL_SCALE = 120.0  # a rounding residual of ±1 cycle in eight bits


def in_chunks(pixels: int) -> int:
    """Return so many pixels rounded up to whole chunks: room for them, as the kernels take and leave nothing less."""
    return -(-pixels // CHUNK) * CHUNK


class Layout(NamedTuple):
    """Which images belong together, and how they are weighted. G groups of sinusoids, P images, B Gray planes."""

    first_image: Any  # (G,) int64
    steps: Any  # (G,) int64
    sines: Any  # (P,) float32
    cosines: Any  # (P,) float32
    planes: Any  # (B,) int64, images of the Gray code, most significant first


class Sums(NamedTuple):
    """What is summed over the exposures taken, each times its weight; W pixels, M = 1 where all groups take the same exposures, otherwise G."""

    sine: Any  # (G, W) int16 or float32, Σ I sin
    cosine: Any  # (G, W) int16 or float32, Σ I cos
    total: Any  # (M, W) int16 or float32, Σ I of each group; where all take the same exposures only of the finest
    planes: Any  # (B, W) int16 or float32, Σ of every Gray plane
    taken: Any  # (M, W) uint16, bit e: exposure e is taken
    zero: Any  # (W,) uint8, 1: an image of the first exposure taken is 0
    bloomed: Any  # (W,) uint8, 1: an exposure was left out for a saturated neighbour only
    alike: Any  # (chunks,) int64, the exposures that all pixels of a chunk took, as bits; DIFFER or COMPLETE: see `taken`


class Rule(NamedTuple):
    """Which exposures a pixel takes."""

    finest: Any  # int, group of the finest pitch
    limit: Any  # of the images' type: largest grey level that is not saturated
    first_only: Any  # bool, the brightest exposure instead of all
    weights: Any  # (E,) uint8, how often an exposure counts in the sums


class Scratch(NamedTuple):
    """Arrays of one chunk for summing."""

    high: Any  # (M, CHUNK) of the images' type: brightest image of the groups that decide together
    low: Any  # (CHUNK,) of the images' type: darkest of all
    take: Any  # (CHUNK,) uint8, how often a pixel takes the exposure


class Model(NamedTuple):
    """What turns sums into absolute phase and reason."""

    sine_sign: Any  # float32, 1 where image n is A + B cos(phase - 2πn/N), -1 for the other sign
    origin: Any  # float32, phase at column 0 in cycles, 0 or -0.5
    combinations: Any  # (K, G) float32 integers; K = 0: numbered by Gray code
    alone: Any  # (K,) int64, the group that is a combination by itself; -1: none
    ratios: Any  # (K,) float32, frequency of a combination over that of the one before
    watched: Any  # int, the decision whose rounding residual is kept; -1: the largest of all
    guard: Any  # float32, share of the coarsest period kept below 0
    complementary: Any  # bool, the last Gray plane changes in the middle of the periods
    finest: Any  # int, group of the finest pitch
    scales: Any  # (G,) float32, frequency of a group over the finest
    norms: Any  # (G,) float32, squared modulation in grey levels over the power of the sums
    shares: Any  # (G,) float32, weight of a group's phase, on the scale of the finest, over the power of its sums
    pulls: Any  # (G,) float32, the same times what a cycle of the group is on that scale
    correction: Any  # (G, L + 1) float32, cycles to add to the wrapped phase at -0.5 … 0.5; (G, 0): none
    black: Any  # (2^E,) float32, grey levels of no light in the sum of a set
    gain: Any  # (2^E,) float32, variance of the sum of a set per grey level of it, shot noise
    floor: Any  # (2^E,) float32, variance of the sum of a set in the dark, grey levels squared
    to_longest: Any  # (2^E,) float32, the longest exposure over Σwt of a set
    to_brightest: Any  # (2^E,) float32, the longest exposure of a set over its Σwt
    first: Any  # (2^E,) int8, the longest exposure of a set, -1 for none
    exposures: Any  # int, E
    beyond: Any  # float32, grey of a pixel saturated in all exposures, scaled to the longest
    least_modulation: Any  # float32, grey levels
    one_gain: Any  # float32, variance of one image per grey level of it, shot noise
    one_floor: Any  # float32, variance of one image in the dark, grey levels squared
    sure: Any  # float32, variance in rad² below which no order is in doubt; negative: the modulation alone counts
    weak_variance: Any  # float32, rad²: more is too much
    dark_variance: Any  # float32, rad²: above it nothing can be told from noise
    zero_is_dark: Any  # bool, a pixel that is 0 in the exposure taken is not valid
    lowest: Any  # float32, cycles: smallest phase on the projector
    highest: Any  # float32, cycles
    gate: Any  # float32, cycles: largest rounding residual of an order that needs no support
    undecided: Any  # bool, doubtful orders keep their phase for the vote


class Maps(NamedTuple):
    """What comes out, flat arrays of N pixels."""

    phase: Any  # float32, rad
    sigma: Any  # float32, rad
    modulation: Any  # of the images' type
    grey: Any  # uint16
    state: Any  # uint8 of PixelState
    exposure: Any  # int8
    residual: Any  # int8, cycles × RESIDUAL_SCALE


class Work(NamedTuple):
    """Arrays of one chunk for solving, one row of SPACING numbers after the other."""

    phase: Any  # (G · SPACING,) float32, cycles from column 0
    power: Any  # (G · SPACING,) float32, squared modulations in the sums
    rows: Any  # (ROWS · SPACING,) float32
    known: Any  # (1,) int64, the exposures taken whose numbers the rows hold, as bits; -1 for those of pixels that differ


ROWS = 7
MODULATION, BLACK, GAIN, FLOOR, TO_BRIGHTEST, TO_LONGEST, LOST = (row * SPACING for row in range(ROWS))  # where they begin
