"""Predicted performance of a pattern set on a projector: range, guard band, phase noise, probability of a wrong order."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import erfc, exp, pi, sqrt, tau

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import Direction, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.exposures.weights import exposure_weights
from measureapp.fringe.noise.model import CameraNoise, phase_sigma
from measureapp.fringe.patterns.draw import check_covers, check_determines_phase
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import LEAST_GUARD, extent_px, plan_heterodyne

LEAST_MODULATION_GREY = 1e-3  # far below what any camera distinguishes; squares of what follows from less would overflow
EDGE_MARGIN_PX = 2.0  # decoded positions this far outside the projector still count
DEFAULT_MEAN, DEFAULT_MODULATION = 110.0, 80.0  # an ordinary pixel of an 8-bit image
MILLION = 1_000_000  # shares of an exposure as whole numbers


@dataclass(frozen=True, slots=True)
class Contrast:
    """Mean and modulation of the patterns in a camera image at the longest exposure, in grey levels, and the exposures that are combined."""

    mean_grey: float = DEFAULT_MEAN  # A
    modulation_grey: float = DEFAULT_MODULATION  # B
    noise: CameraNoise = field(default_factory=CameraNoise)
    saturation: int = 255
    exposures: tuple[float, ...] = (1.0,)  # unsaturated ones, relative to the longest

    def summed_variance(self, grey: float) -> float:
        """Return the variance in grey levels² of the sum over the exposures, of a pixel with this mean at the longest one."""
        shares, counts = self._bracket()
        return float((counts**2 * self.noise.variance(grey * shares, self.saturation)).sum())

    def summed_modulation(self) -> float:
        """Return the modulation of that sum."""
        shares, counts = self._bracket()
        return self.modulation_grey * float((counts * shares).sum())

    def _bracket(self) -> tuple[FloatArray, FloatArray]:
        """Return the exposures from long to short, and the weights of their images in `decode`."""
        shares = np.sort(np.array(self.exposures))[::-1]
        least = DecodeSettings().min_modulation_grey(self.saturation)
        counts = exposure_weights(tuple(round(MILLION * share) for share in shares), self.noise, self.saturation, least)
        return shares, np.array(counts, float)


@dataclass(frozen=True, slots=True)
class OrderDecision:
    """One rounding on the way from the coarsest phase to the finest, or the reading of the bits."""

    what: str
    amplification: float  # noise of the decision over that of one wrapped phase; 0 for bits
    error_probability: float  # of a pixel somewhere on the projector


@dataclass(frozen=True, slots=True)
class DirectionCheck:
    """Predicted performance of the fringes of one direction."""

    direction: Direction
    method: str
    extent_px: int
    range_px: float
    guard_px: float  # range beyond the extent
    phase_sigma_rad: tuple[float, ...]  # of every phase-shift group, wrapped
    column_sigma_px: float  # of the result, all pitches averaged
    decisions: tuple[OrderDecision, ...]
    order_error_probability: float  # sum over the decisions, at most 1
    modulation_for: dict[str, float | None]  # probability wanted -> B in grey levels that reaches it at the same A; None: none does


def check_patterns(patterns: PatternSet, width_px: int, height_px: int, contrast: Contrast | None = None) -> tuple[DirectionCheck, ...]:
    """Predict the performance of a pattern set on a projector, for each direction of its fringes.

    The phase of N steps has σφ = √(2/N) σ_I / B; several exposures of shares e have the weights n of decoding (`exposure_weights`):
    Σ n² σ_I²(e A) instead of σ_I², Σ n e B instead of B. An order decision whose weights on the wrapped phases are w is wrong when
    its noise √(Σ w² σφ²) exceeds half a period [1]_: P = erfc(π / (√2 √(Σ w² σφ²))); 46 σφ for the pitches 32 and 33.

    Raises
    ------
    DecodeError
        The set does not determine the phase over the projector, its range has too small a guard band, or the numbers of
        ``contrast`` are not positive.

    References
    ----------
    .. [1] J. Li, L. G. Hassebrook, C. Guan, Optimized two-frequency phase-measuring-profilometry light-sensor temporal-noise
       sensitivity, JOSA A 20(1), 106-115, 2003.
    """
    contrast = contrast or Contrast()
    _check_contrast(contrast)
    check_determines_phase(patterns)
    checks = []
    for direction in patterns.directions:
        alone, _ = patterns.subset(direction)
        check_covers(alone, width_px if direction == "vertical" else height_px, direction)
        checks.append(_check_direction(alone, direction, contrast))
    return tuple(checks)


def wrapped_sigmas(patterns: PatternSet, contrast: Contrast) -> FloatArray:
    """Return the standard deviation of each phase-shift group's wrapped phase, (G,) rad."""
    grey_sigma, modulation = np.sqrt(contrast.summed_variance(contrast.mean_grey)), np.asarray(contrast.summed_modulation())
    groups = [group for group in patterns.groups if isinstance(group, PhaseShiftGroup)]
    return np.array([float(phase_sigma(group.steps, grey_sigma, modulation)) for group in groups])


def order_decisions(patterns: PatternSet, contrast: Contrast) -> tuple[OrderDecision, ...]:
    """Return every decision of a set with fringes of one direction, with its probability of error."""
    sigmas = wrapped_sigmas(patterns, contrast)
    gray = next((group for group in patterns.groups if isinstance(group, GrayCodeGroup)), None)
    if gray is not None:
        return _gray_decisions(gray, patterns, sigmas, contrast)
    plan = plan_heterodyne(patterns)
    noises = np.sqrt((plan.decision_weights**2 * sigmas**2).sum(axis=1))
    # half of the guard band is at either end; a phase that wraps from one half into the other is detected as outside
    unseen = max(0.0, 2 * plan.guard - EDGE_MARGIN_PX / extent_px(patterns) * plan.frequencies[0])
    first = OrderDecision("edge of the range", 0.0, _wraps(float(noises[0]) / tau, unseen, plan.frequencies[0]))
    later = [
        OrderDecision(f"{u:.3g} → {v:.3g} periods", amplification, _rounds_wrongly(float(noise)))
        for u, v, amplification, noise in zip(plan.frequencies[:-1], plan.frequencies[1:], plan.noise[1:], noises[1:], strict=True)
    ]
    return (first, *later)


def _check_contrast(contrast: Contrast) -> None:
    if not (contrast.exposures and min(contrast.exposures) >= 1 / MILLION and max(contrast.exposures) == 1):
        listed = ", ".join(f"{share:g}" for share in contrast.exposures)
        raise DecodeError(
            f"The exposures {listed} are not relative to the longest.", "Give 1 for the longest and fractions of it for the others."
        )
    if not (LEAST_MODULATION_GREY <= contrast.modulation_grey <= contrast.mean_grey and contrast.saturation > 0):
        raise DecodeError(
            f"A contrast of A = {contrast.mean_grey:g}, B = {contrast.modulation_grey:g} grey levels cannot be.",
            f"Give {LEAST_MODULATION_GREY:g} ≤ B ≤ A.",
        )
    if contrast.mean_grey + contrast.modulation_grey > contrast.saturation:
        raise DecodeError(
            f"A + B = {contrast.mean_grey + contrast.modulation_grey:g} exceeds the saturation of {contrast.saturation} grey levels.",
            "Give a contrast that the camera can see.",
        )


def _check_direction(alone: PatternSet, direction: Direction, contrast: Contrast) -> DirectionCheck:
    extent = extent_px(alone)
    gray = next((group for group in alone.groups if isinstance(group, GrayCodeGroup)), None)
    if gray is not None:
        method = "complementary Gray code" if gray.complementary else "Gray code"
        reach = 2 ** (gray.planes - int(gray.complementary)) * alone.finest_pitch_px
    else:
        method = f"heterodyne of {len(alone.pitches_px)} pitches"
        reach = extent / plan_heterodyne(alone).frequencies[0]
        _check_guard(alone, extent, reach)
    sigmas = wrapped_sigmas(alone, contrast)
    made = order_decisions(alone, contrast)
    weights = (tau / (np.array(alone.pitches_px) * sigmas)) ** 2
    return DirectionCheck(
        direction=direction,
        method=method,
        extent_px=extent,
        range_px=reach,
        guard_px=reach - extent,
        phase_sigma_rad=tuple(float(sigma) for sigma in sigmas),
        column_sigma_px=float(1 / np.sqrt(weights.sum())),
        decisions=made,
        order_error_probability=min(1.0, sum(decision.error_probability for decision in made)),
        modulation_for={f"{wanted:.0e}": _modulation_for(alone, contrast, wanted) for wanted in (1e-3, 1e-6)},
    )


def _check_guard(alone: PatternSet, extent: int, reach: float) -> None:
    if reach - extent < LEAST_GUARD * extent:
        raise DecodeError(
            f"The range of {alone.name!r} is {reach:.1f} px for {extent} px of the projector: {reach - extent:.1f} px of guard band, "
            f"so that noise turns one edge into the other.",
            f"Choose pitches whose longest beat is at least {extent * (1 + LEAST_GUARD):.0f} px.",
        )


def _rounds_wrongly(noise_rad: float) -> float:
    return erfc(pi / (sqrt(2.0) * noise_rad)) if noise_rad > 0 else 0.0


def _wraps(noise_cycles: float, guard_cycles: float, covered_cycles: float) -> float:
    """Return the mean probability over the projector that noise moves a pixel past either end of the guarded range."""
    if noise_cycles <= 0:
        return 0.0
    z = guard_cycles / noise_cycles
    beyond = exp(-z * z / 2) / sqrt(tau) - z * erfc(z / sqrt(2.0)) / 2  # ∫ of the normal tail from z on
    return min(1.0, 2 * noise_cycles * beyond / covered_cycles)


def _gray_decisions(gray: GrayCodeGroup, patterns: PatternSet, sigmas: FloatArray, contrast: Contrast) -> tuple[OrderDecision, ...]:
    """Bits are compared with the mean of the finest sinusoids; borders of periods are where bits and phase must agree."""
    finest = int(np.argmin(patterns.pitches_px))
    steps = [group.steps for group in patterns.groups if isinstance(group, PhaseShiftGroup)][finest]
    threshold = contrast.summed_variance(contrast.mean_grey) / steps
    wrong = 0.0
    for level in (contrast.mean_grey - contrast.modulation_grey, contrast.mean_grey + contrast.modulation_grey):
        wrong += erfc(contrast.summed_modulation() / sqrt(2.0 * (contrast.summed_variance(level) + threshold))) / 4
    sigma = float(sigmas[finest])
    if gray.complementary:
        # the phase would have to be off by a quarter of a period before a bit is read where it changes
        border = OrderDecision("quarter of a period", 1.0, erfc(pi / 2 / (sqrt(2.0) * sigma)))
    else:
        # a phase within its noise of the border may fall on the other side of it than the bits: E|n| / 2π
        border = OrderDecision("border of a period", 1.0, sigma * sqrt(2 / pi) / tau)
    return OrderDecision(f"{gray.planes} bits", 0.0, min(1.0, gray.planes * wrong)), border


def _modulation_for(patterns: PatternSet, contrast: Contrast, wanted: float) -> float | None:
    """Return the B that reaches an order-error probability at the same mean A; None when no visible modulation does."""

    def probability(modulation: float) -> float:
        return sum(decision.error_probability for decision in order_decisions(patterns, replace(contrast, modulation_grey=modulation)))

    low, high = 1e-3, min(contrast.mean_grey, contrast.saturation - contrast.mean_grey)
    if probability(high) > wanted:
        return None
    for _ in range(60):
        middle = sqrt(low * high)
        low, high = (low, middle) if probability(middle) <= wanted else (middle, high)
    return high
