"""Arguments of the decoding kernels: named tuples of arrays and numbers, which compiled code accepts."""

from __future__ import annotations

from typing import Any, NamedTuple

CHUNK = 512  # pixels that are summed and solved together; their images of one exposure stay in the L1 cache
ROW = CHUNK + 80  # length of a row of intermediate results; rows at a power of two apart would share cache sets
STRETCH = 20 * CHUNK  # pixels whose sums of all exposures stay in the L2 cache
# Of the chunks that need no further exposure, one in so many is still counted; seldom a whole number of rows, so that they are spread out.
SAMPLED_EVERY = 59
RESIDUAL_SCALE = 120.0  # a rounding residual of ±1 cycle in eight bits
MOST_ORDERS = 4  # a repair changes the order by at most so many
UNCHANGED, REFUSED = 0, 100  # verdicts of the window besides a change of order


def round_up_to_chunks(pixels: int) -> int:
    """Round a number of pixels up to whole chunks, as the kernels read and write nothing less."""
    return -(-pixels // CHUNK) * CHUNK


class ImageLayout(NamedTuple):
    """Which images belong together, and their weights. G groups of sinusoids, P images, B Gray code planes."""

    first_image: Any  # (G,) int64
    steps: Any  # (G,) int64
    sines: Any  # (P,) float32
    cosines: Any  # (P,) float32
    planes: Any  # (B,) int64, images of the Gray code, most significant bit first


class ExposureImages(NamedTuple):
    """Images of consecutive exposures."""

    images: Any  # (E, P, N); E = 0: none
    tails: Any  # (E, P, CHUNK) their last chunk where it is not a whole one, filled up with zeros
    first: Any  # int, number of the first exposure
    blocked: Any  # (N and more,) uint8, whole chunks, not 0: beside a saturated pixel; empty: no guard against blooming


class PixelRange(NamedTuple):
    """Pixels of an image to sum or solve."""

    start: Any  # int
    stop: Any  # int
    base: Any  # int, pixel that the sums begin with; -1: they hold one stretch, and are overwritten by the next


class Counts(NamedTuple):
    """Numbers of pixels, to be added to."""

    exposures: Any  # (2, 2, exposures) int64: pixels examined, and those of them above zero and unsaturated; of all, and of a sample
    states: Any  # (states,) int64, of PixelState
    complete: Any  # (1,) int64, with an exposure above zero in all groups


class ExposureRule(NamedTuple):
    """Which exposures a pixel uses."""

    finest: Any  # int, group of the finest pitch
    limit: Any  # of the images' type: largest grey level that is not saturated
    first_only: Any  # bool, the brightest unsaturated exposure instead of all
    weights: Any  # (E,) uint8, weight of an exposure in the sums


class ExposureSums(NamedTuple):
    """Weighted sums over the exposures that each pixel uses; W pixels, D decisions: 1 where all groups use the same exposures, else G."""

    sine: Any  # (G, W) int16 or float32, Σ I sin
    cosine: Any  # (G, W) int16 or float32, Σ I cos
    total: Any  # (D, W) int16 or float32, Σ I of each group; of the finest alone where all groups use the same exposures
    planes: Any  # (B, W) int16 or float32, Σ of every Gray code plane
    used: Any  # (D, W) uint16, set of exposures: bit e for exposure e
    has_zero: Any  # (W,) uint8, 1: an image of the first exposure used is 0
    bloomed: Any  # (W,) uint8, 1: an exposure was rejected because of a saturated neighbour alone
    complete: Any  # (chunks,) uint8, 1: every pixel of the chunk uses an exposure


class Pitches(NamedTuple):
    """The groups of sinusoids, (G,) float32 each."""

    scales: Any  # frequency over that of the finest pitch
    norms: Any  # squared modulation in grey levels over the power of the sums
    weights: Any  # weight of the group's phase, on the scale of the finest, over the power of its sums
    shifts: Any  # the same times the cycles of the finest pitch in one cycle of the group


class Unwrapping(NamedTuple):
    """Temporal unwrapping: a chain of K combinations of the wrapped phases, or a Gray code where K is 0."""

    combinations: Any  # (K, G) float32 integers
    ratios: Any  # (K,) float32, frequency of a combination over that of the one before
    watched: Any  # int, the order decision whose rounding residual is kept; -1: the largest of all
    guard: Any  # float32, share of the coarsest period kept below 0
    complementary: Any  # bool, the last Gray code plane changes in the middle of the periods


class ExposureSets(NamedTuple):
    """Properties of the sum over a set of exposures, tabulated by set (2^E,)."""

    black: Any  # float32, grey levels without light
    gain: Any  # float32, shot noise: variance per grey level
    floor: Any  # float32, variance in the dark, grey levels squared
    to_longest: Any  # float32, the longest exposure of all over the weighted sum of the set's
    to_brightest: Any  # float32, the longest exposure of the set over the same
    longest: Any  # int8, index of the longest exposure of the set, -1 for the empty set


class Limits(NamedTuple):
    """When a pixel is valid."""

    saturated_grey: Any  # float32, grey of a pixel saturated in all exposures, scaled to the longest
    least_modulation: Any  # float32, grey levels, where fringe orders may be in doubt
    faint_modulation: Any  # float32, grey levels, where they are not
    image_gain: Any  # float32, shot noise of a single image: variance per grey level
    image_floor: Any  # float32, variance of a single image in the dark, grey levels squared
    sure_variance: Any  # float32, rad²: below it no fringe order is in doubt; negative: the modulation alone counts
    voted_variance: Any  # float32, rad²: largest of a faint pixel whose order its neighbours may decide; `sure_variance`: they may not
    weak_variance: Any  # float32, rad²: largest of a valid pixel
    shadow_variance: Any  # float32, rad²: above it fringes cannot be distinguished from noise
    zero_is_dark: Any  # bool, a pixel with an image at 0 in the exposure used is not valid
    lowest: Any  # float32, cycles: smallest phase on the projector
    highest: Any  # float32, cycles
    gate: Any  # float32, cycles: largest rounding residual of a fringe order without support
    keep_conflicts: Any  # bool, pixels with a doubtful order keep their phase for the vote


class DecodeModel(NamedTuple):
    """How sums become absolute phase and state."""

    sine_sign: Any  # float32, 1 where image n is A + B cos(phase - 2πn/N), -1 for the other sign
    origin: Any  # float32, phase at column 0 in cycles, 0 or -0.5
    correction: Any  # (G, L + 1) float32, cycles to add to the wrapped phase at -0.5 … 0.5; (G, 0): none
    finest: Any  # int, group of the finest pitch
    pitches: Pitches
    unwrapping: Unwrapping
    sets: ExposureSets
    limits: Limits


class VoteLimits(NamedTuple):
    """What the window may decide about fringe orders."""

    radius: Any  # int, px; 0: no vote
    edge_step: Any  # float32, rad, phase step between neighbours that marks an edge
    gate: Any  # float32, cycles: largest rounding residual of an order without support
    allowance: Any  # float32, cycles of tolerance per radian of sigma
    slack: Any  # float32, cycles by which the residual of a repaired pixel may be off in any case
    lowest: Any  # float32, rad: smallest phase on the projector, origin included
    highest: Any  # float32, rad
    order_steps: Any  # (2 · MOST_ORDERS + 1,) float32, rad: change of the absolute phase with the order (`order_steps`)


class PixelMaps(NamedTuple):
    """Decoded maps, flat arrays of N pixels; (H, W) for the vote."""

    phase: Any  # float32, rad
    sigma: Any  # float32, rad
    modulation: Any  # of the images' type
    grey: Any  # uint16
    state: Any  # uint8 of PixelState
    exposure: Any  # int8
    residual: Any  # int8, cycles × RESIDUAL_SCALE


class Workspace(NamedTuple):
    """Intermediate results of one chunk; D decisions about exposures."""

    brightest: Any  # (D, CHUNK) of the images' type, brightest image of the groups that each decision covers
    darkest: Any  # (CHUNK,) of the images' type, darkest image of all groups
    weight: Any  # (D, CHUNK) uint8, weight of the exposure in the sums of each pixel
    phase: Any  # (G, ROW) float32, wrapped phases in cycles from column 0
    power: Any  # (G, ROW) float32, squared modulation of the sums; divided by the variance where groups use different exposures
    value: Any  # (ROW,) float32, absolute phase in cycles
    residual: Any  # (ROW,) float32, rounding residual of the order decisions, cycles
    combined: Any  # (ROW,) float32, combination of the wrapped phases
    variance: Any  # (ROW,) float32, variance of the absolute phase, rad², over that of the sums
    square: Any  # (ROW,) float32, least squared modulation of all groups
    code: Any  # (ROW,) int32, number read from the Gray code
