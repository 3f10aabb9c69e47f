"""The automatic exposure bracket: which exposures make most of a scene decodable within a time, predicted from a probe."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ceil, floor

import numpy as np
from scipy.special import erf

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.fringe import GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.plan import ExposureBracket
from measureapp.data.scan_cost import READOUT_S, image_time_s
from measureapp.errors import DecodeError
from measureapp.fringe.exposures.probe import ProbedCamera
from measureapp.fringe.exposures.weights import exposure_weights
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import plan_heterodyne

GRID_RATIO = 2.0**0.25
SIGMA_WORTH = 0.02  # what e times less phase noise is worth, as a share of decodable pixels
TIME_WORTH = 0.004  # what the whole budget of time is worth, likewise
PAYS = 0.001  # least gain in worth by another exposure
CLIP_SIGMAS = 2.5  # noise above the brightest step that must stay below saturation
EVEN_STRIDES = (1, 2, 3, 4, 6, 8)  # steps of the grid between two exposures of a bracket to start from
EXCHANGES = 4  # rounds in which each exposure of a bracket may move


@dataclass(frozen=True, slots=True)
class BracketLimits:
    """Limits set by the rig and the user."""

    budget_s: float
    most: int = 5  # exposures
    readout_ms: float = 1e3 * READOUT_S  # after each exposure
    transfer_ms: float = 0.0  # of the images of all cameras, beside the next exposure
    shortest_us: int = 100
    longest_us: int = 500_000
    multiple_us: float | None = None  # exposures must be multiples of this: the projector's frame, or 10 000 µs against 50 Hz flicker

    def image_time_s(self, exposure_us: float) -> float:
        """Return the least time from an image to the next, in s."""
        return image_time_s(exposure_us, 1e-3 * self.readout_ms, 1e-3 * self.transfer_ms)


@dataclass(frozen=True, slots=True)
class BracketFigures:
    """Predicted performance of a bracket."""

    exposures_us: tuple[int, ...]  # long to short
    decodable: Mapping[str, float]  # camera -> share of the lit pixels expected to be decoded rightly
    sigma_rad: Mapping[str, float]  # camera -> median phase noise of the decodable pixels; 0 where there are none
    decodable_share: float  # over all cameras
    median_sigma_rad: float
    time_s: float
    worth: float  # what is maximised: share, less phase noise and time


@dataclass(frozen=True, slots=True)
class BracketProposal:
    """The proposed bracket, its predicted performance, and that of brackets with fewer or more exposures."""

    exposures_us: tuple[int, ...]
    figures: BracketFigures
    by_count: tuple[BracketFigures, ...]  # the best bracket of one, two, … exposures
    compared: Mapping[str, BracketFigures]  # name -> the paper's and other brackets on the same scene
    unknown_share: float  # of the lit pixels that the probe saturated at every exposure
    note: str

    @property
    def bracket(self) -> ExposureBracket:
        """The exposures as part of a plan."""
        return ExposureBracket(exposures_us=self.exposures_us)


def propose_bracket(
    probe: Mapping[str, ProbedCamera],
    patterns: PatternSet,
    limits: BracketLimits,
    settings: DecodeSettings | None = None,
    compare: Mapping[str, Sequence[int]] | None = None,
) -> BracketProposal:
    """Choose exposures for a scene.

    A pixel is decodable when an exposure leaves it unsaturated with enough modulation, or all that do are together as exact as one image of
    the faintest modulation and leave no order in doubt that neighbours could not decide about, and the noise of its phase over them,
    σφ² = (2/N) Σw²σ² / (ΣwB)² as `decode` weighs them, is below the limit; it counts with the probability
    that its order is right and its residual below the gate r, erf(2π r / (√2 a σφ)), with a the amplification of the set's
    most delicate order decision; repairs by the neighbourhood come on top.
    Brackets are grown by one exposure at a time on a grid of quarter octaves, from the last ones and from evenly spaced and
    known ones; after each, every exposure may move. Worth is the share of decodable pixels,
    less 2 % per factor e of phase noise and 0.4 % for the whole budget of time.

    Parameters
    ----------
    probe : of `read_probe`, by camera
    patterns : the set to be recorded
    compare : further brackets to predict, by name; the paper's is always there

    Raises
    ------
    DecodeError
        The budget does not even suffice for one exposure, or no exposure makes any pixel decodable.
    """
    settings = settings or DecodeSettings()
    scene = _Scene(tuple(probe.values()), patterns, limits, settings)
    grid = _grid(patterns, limits)
    others = {"paper": ExposureBracket().exposures_us, **(compare or {})}
    by_count: list[BracketFigures] = []
    chosen: tuple[int, ...] = ()
    for count in range(1, limits.most + 1):
        grown = [(*chosen, exposure) for exposure in grid if exposure not in chosen]
        known = [tuple(bracket) for bracket in others.values() if len(bracket) == count and _obeys(bracket, limits)]
        start = scene.best_of([*grown, *_evenly_spaced(grid, count), *known])
        if start is None:
            break
        chosen = scene.improve(start, grid)
        by_count.append(scene.figures(chosen))
    best = _smallest_worthwhile(by_count)
    if best.decodable_share == 0.0:
        raise DecodeError(
            f"No exposure up to {max(grid)} µs makes a pixel decodable.", "Allow longer exposures, open the apertures, or use more steps."
        )
    unknown = float(np.mean([camera.unknown_share for camera in probe.values()]))
    return BracketProposal(
        exposures_us=best.exposures_us,
        figures=best,
        by_count=tuple(by_count),
        compared={name: scene.figures(tuple(sorted(exposures, reverse=True))) for name, exposures in others.items()},
        unknown_share=unknown,
        note=_note(best, by_count, unknown, probe),
    )


def _evenly_spaced(grid: Sequence[int], count: int) -> list[tuple[int, ...]]:
    """Return the brackets of ``count`` evenly spaced places of the grid."""
    return [tuple(grid[first::stride][:count]) for stride in EVEN_STRIDES for first in range(len(grid) - stride * (count - 1))]


def _obeys(bracket: Sequence[int], limits: BracketLimits) -> bool:
    step = limits.multiple_us
    return all(
        limits.shortest_us <= exposure <= limits.longest_us and (step is None or abs(exposure / step - round(exposure / step)) * step < 1)
        for exposure in bracket
    )


def _smallest_worthwhile(by_count: Sequence[BracketFigures]) -> BracketFigures:
    most = max(figures.worth for figures in by_count)
    return next(figures for figures in by_count if figures.worth >= most - PAYS)


def _note(best: BracketFigures, by_count: Sequence[BracketFigures], unknown: float, probe: Mapping[str, ProbedCamera]) -> str:
    words = []
    if len(best.exposures_us) < len(by_count):
        words.append(f"more than {len(best.exposures_us)} exposures do not pay")
    if unknown > 0.02:
        shortest = min(camera.shortest_us for camera in probe.values())
        words.append(
            f"{unknown:.0%} of the lit pixels saturate at every probe exposure; probe with {max(1, shortest // 4)} µs to be sure of them"
        )
    return "; ".join(words)


def _grid(patterns: PatternSet, limits: BracketLimits) -> list[int]:
    """Return the exposures to choose from: quarter octaves from the shortest allowed to the longest that fits into the budget."""
    least_s = patterns.count * limits.image_time_s(limits.shortest_us)
    if least_s > limits.budget_s:
        raise DecodeError(
            f"{limits.budget_s:g} s do not suffice for one exposure of {patterns.count} images.", f"Allow at least {least_s:.2f} s."
        )
    longest = min(limits.longest_us, 1e6 * limits.budget_s / patterns.count - 1e3 * limits.readout_ms)
    count = ceil(np.log(longest / limits.shortest_us) / np.log(GRID_RATIO)) + 1
    exposures = longest / GRID_RATIO ** np.arange(count)
    if limits.multiple_us is None:
        return sorted({int(exposure) for exposure in exposures if exposure >= limits.shortest_us}, reverse=True)
    step = limits.multiple_us
    allowed = {floor(floor(exposure / step) * step) for exposure in exposures if exposure >= max(step, limits.shortest_us)}
    if not allowed:
        raise DecodeError(f"No multiple of {step:g} µs fits into the budget.", "Allow more time, or a finer multiple.")
    return sorted(allowed, reverse=True)


class _Scene:
    """Predicts brackets; what depends on a single exposure is computed once."""

    def __init__(self, cameras: tuple[ProbedCamera, ...], patterns: PatternSet, limits: BracketLimits, settings: DecodeSettings) -> None:
        self._cameras, self._limits, self._settings = cameras, limits, settings
        self._images = patterns.count
        alone = patterns.subset(patterns.directions[0])[0]
        sinusoids = [group for group in alone.groups if isinstance(group, PhaseShiftGroup)]
        self._steps = min(group.steps for group in sinusoids)
        finest = min(group.pitch_px for group in sinusoids)
        information = [group.steps / self._steps * (finest / group.pitch_px) ** 2 for group in sinusoids]
        self._averaged = float(np.sum(information)) ** -0.5  # the noise of the mean of all pitches over that of one
        gray = any(isinstance(group, GrayCodeGroup) for group in alone.groups)
        plan = None if gray else plan_heterodyne(alone)
        self._amplification = plan.amplification if plan else 0.0
        self._settled_sigma = plan.settled_sigma_rad(votes=settings.vote_radius > 0) if plan and plan.amplification else np.inf
        self._singles: dict[tuple[int, int], tuple[BoolArray, FloatArray, FloatArray]] = {}
        self._worths: dict[tuple[int, ...], float] = {}

    def time_s(self, exposures: Sequence[int]) -> float:
        return self._images * sum(self._limits.image_time_s(exposure) for exposure in exposures)

    def best_of(self, brackets: Sequence[tuple[int, ...]]) -> tuple[int, ...] | None:
        """Return the bracket of the highest worth that fits into the budget."""
        fitting = [bracket for bracket in brackets if self.time_s(bracket) <= self._limits.budget_s * (1 + 1e-9)]
        return max(fitting, key=self.worth, default=None)

    def improve(self, bracket: tuple[int, ...], grid: Sequence[int]) -> tuple[int, ...]:
        """Move one exposure at a time to where the worth of the bracket is highest."""
        for _ in range(EXCHANGES):
            before = bracket
            for place in range(len(bracket)):
                rest = bracket[:place] + bracket[place + 1 :]
                bracket = self.best_of([bracket, *((*rest, exposure) for exposure in grid if exposure not in rest)]) or bracket
            if set(before) == set(bracket):
                break
        return bracket

    def worth(self, bracket: tuple[int, ...]) -> float:
        """Return what is maximised, for a bracket in any order; a search asks for some thousand brackets, some of them again and again."""
        exposures = tuple(sorted(bracket, reverse=True))
        if exposures not in self._worths:
            self._worths[exposures] = self._judge(exposures, self._predict(exposures))
        return self._worths[exposures]

    def figures(self, bracket: tuple[int, ...]) -> BracketFigures:
        """Predict a bracket, in any order."""
        exposures = tuple(sorted(bracket, reverse=True))
        predicted = self._predict(exposures)
        names = [camera.camera for camera in self._cameras]
        shares = {name: float(chance.mean()) for name, (_, chance) in zip(names, predicted, strict=True)}
        medians = {name: _median(sigma, chance) for name, (sigma, chance) in zip(names, predicted, strict=True)}
        every, right = (np.concatenate(values) for values in zip(*predicted, strict=True))
        median = _median(np.minimum(every, self._settings.max_sigma_rad), right)
        share, worth = float(np.mean(list(shares.values()))), self._judge(exposures, predicted)
        return BracketFigures(exposures, shares, medians, share, median, self.time_s(exposures), worth)

    def _predict(self, exposures: tuple[int, ...]) -> list[tuple[FloatArray, FloatArray]]:
        return [self._pixels(number, exposures) for number in range(len(self._cameras))]

    def _judge(self, exposures: tuple[int, ...], predicted: Sequence[tuple[FloatArray, FloatArray]]) -> float:
        share = float(np.mean([chance.mean() for _, chance in predicted]))
        noise = np.concatenate([np.minimum(sigma, self._settings.max_sigma_rad) for sigma, _ in predicted])
        time = self.time_s(exposures)
        return share - SIGMA_WORTH * float(np.log(noise).mean()) - TIME_WORTH * time / self._limits.budget_s

    def _pixels(self, number: int, exposures: tuple[int, ...]) -> tuple[FloatArray, FloatArray]:
        """Return the phase noise of each pixel of a camera (infinite where it has none) and the probability that it is decoded rightly."""
        camera = self._cameras[number]
        size = len(camera.mean_rate)
        swing, variance, strongest, alone = np.zeros(size), np.zeros(size), np.zeros(size), np.ones(size)
        least = self._settings.min_modulation_grey(camera.saturation)
        weights = exposure_weights(exposures, camera.noise, camera.saturation, least)
        for exposure, weight in zip(exposures, weights, strict=True):
            clear, own_swing, own_variance = self._single(number, exposure)
            swing += weight * own_swing
            variance += weight**2 * own_variance
            np.copyto(alone, own_variance, where=clear & (strongest == 0))
            np.maximum(strongest, own_swing, out=strongest)
        sigma = np.full(size, np.inf)
        np.divide(np.sqrt(2.0 / self._steps * variance), swing, out=sigma, where=swing > 0)
        right = np.ones(size)
        if self._amplification > 0:
            allowed_rad = 2 * np.pi * self._settings.residual_gate
            right = erf(allowed_rad / (2.0**0.5 * self._amplification * np.maximum(sigma, 1e-12)))
        faintest = self._settings.faint_modulation_grey(camera.saturation)
        combined = (swing**2 * alone >= faintest**2 * variance) & (sigma <= self._settled_sigma)
        sigma *= self._averaged
        decodable = ((strongest >= least) | combined) & (sigma <= self._settings.max_sigma_rad)
        return sigma, np.asarray(np.where(decodable, right, 0.0))

    def _single(self, number: int, exposure: int) -> tuple[BoolArray, FloatArray, FloatArray]:
        """Return which pixels of a camera an exposure leaves unsaturated, with their modulation and variance; 0 elsewhere."""
        if (number, exposure) not in self._singles:
            camera = self._cameras[number]
            mean, swing = camera.mean_rate * exposure, camera.swing_rate * exposure
            peak = mean + swing
            clear = peak + CLIP_SIGMAS * np.sqrt(camera.noise.variance(peak, camera.saturation)) < camera.saturation
            variance = camera.noise.variance(mean, camera.saturation)
            self._singles[number, exposure] = (np.asarray(clear), np.where(clear, swing, 0.0), np.where(clear, variance, 0.0))
        return self._singles[number, exposure]


def _median(sigma: FloatArray, chance: FloatArray) -> float:
    """Return the median over the pixels that are more likely right than wrong; 0 where there are none."""
    return float(np.median(sigma[chance > 0.5])) if (chance > 0.5).any() else 0.0
