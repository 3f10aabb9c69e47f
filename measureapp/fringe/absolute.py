"""The unwrapping of one camera's wrapped phases: which method applies, where the phase starts, what the window votes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet
from measureapp.errors import DecodeError
from measureapp.fringe import kernels
from measureapp.fringe.exposure import WrappedPhases
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import HeterodynePlan, plan_heterodyne

GRAY_SLACK_CYCLES = 0.75
LEAST_TRANSITIONS = 200
SAMPLED_ROW = 4


@dataclass(frozen=True, slots=True, eq=False)
class AbsolutePhase:
    """Phase of the finest pitch, in the convention of the images: I₀ = A + B cos(phase)."""

    phase_rad: FloatArray  # (H, W) float32
    sigma_rad: FloatArray  # (H, W) float32
    conflict: BoolArray  # (H, W)
    repaired: int
    origin_rad: float  # phase at column 0: 0 where the patterns start with a crest, -π where with a trough
    amplification: float  # noise of the order decision over that of a wrapped phase; 0 for Gray codes


def unwrap(stack: FringeStack, camera: str, wrapped: WrappedPhases, usable: BoolArray, settings: DecodeSettings) -> AbsolutePhase:
    """Unwrap by Gray code where the set has one, otherwise by heterodyne; mend orders by vote; average all pitches.

    Parameters
    ----------
    usable : (H, W), pixels with light and modulation; others are computed but take no part in votes

    Raises
    ------
    DecodeError
        The phase runs against the Gray code: the shift sign of the images is wrong.
    """
    gray = next((group for group in stack.patterns.groups if isinstance(group, GrayCodeGroup)), None)
    plan = None if gray else plan_heterodyne(stack.patterns)
    amplification = plan.amplification if plan else 0.0
    if gray:
        absolute, residual, origin = _by_gray_code(stack, camera, wrapped, gray, usable)
    else:
        assert plan is not None
        absolute, residual, origin = _by_heterodyne(plan, wrapped, usable)
    finest = _finest(stack.patterns)
    slack = GRAY_SLACK_CYCLES if gray else 0.0
    gate = 0.5 if gray else settings.residual_gate
    variance = wrapped.variance[finest].reshape(usable.shape)
    voted, conflict, repaired = _vote(absolute, residual, variance, usable, settings.vote_radius, (gate, amplification, slack))
    sigma = _average(voted, wrapped, stack.patterns, origin)
    return AbsolutePhase(voted, sigma, conflict, repaired, origin, amplification)


def _finest(patterns: PatternSet) -> int:
    return int(np.argmin(patterns.pitches_px))


def _by_heterodyne(plan: HeterodynePlan, wrapped: WrappedPhases, usable: BoolArray) -> tuple[FloatArray, FloatArray, float]:
    """Unwrap with a crest at column 0, or with a trough where the rounding residuals then lie nearer to zero."""
    height, width = usable.shape
    combinations = np.array(plan.combinations, np.float32)
    frequencies = np.array(plan.frequencies)
    ratios = np.concatenate([[1.0], frequencies[1:] / frequencies[:-1]]).astype(np.float32)
    absolute = np.empty(height * width, np.float32)
    residual = np.empty(height * width, np.float32)

    def run(origin: float, decision: int, start: int, stop: int) -> None:
        kernels.heterodyne(
            wrapped.phase_rad,
            np.float32(origin),
            combinations,
            ratios,
            decision,
            np.float32(plan.guard),
            start,
            stop,
            absolute,
            residual,
        )

    origins = (0.0, -np.pi)
    bands = [(row * width, (row + 1) * width) for row in range(0, height, SAMPLED_ROW)]
    spread = []
    for origin in origins:
        for start, stop in bands:
            run(origin, len(ratios) - 1, start, stop)
        chosen = np.abs(residual.reshape(height, width)[::SAMPLED_ROW])[usable[::SAMPLED_ROW]]
        spread.append(float(np.mean(chosen)) if chosen.size else 0.0)
    origin = origins[int(np.argmin(spread))]
    in_bands(lambda start, stop: run(origin, plan.worst, start, stop), height * width)
    return absolute.reshape(height, width), residual.reshape(height, width), origin


def _by_gray_code(
    stack: FringeStack, camera: str, wrapped: WrappedPhases, group: GrayCodeGroup, usable: BoolArray
) -> tuple[FloatArray, FloatArray, float]:
    """Number the periods; their borders lie at a crest of the sinusoid, or at a trough where the images say so."""
    images = stack.images[camera]
    height, width = usable.shape
    flat = images.reshape(images.shape[0], images.shape[1], height * width).view()
    flat.flags.writeable = False
    finest = _finest(stack.patterns)
    planes = _plane_indices(stack.patterns, group)
    absolute = np.empty(height * width, np.float32)
    residual = np.empty(height * width, np.float32)

    def run(indices: IntArray, complementary: bool, origin: float, start: int, stop: int) -> None:
        kernels.gray_code(
            flat,
            indices,
            complementary,
            wrapped.phase_rad[finest],
            wrapped.mean_sum,
            wrapped.used[finest],
            np.float32(origin),
            start,
            stop,
            absolute,
            residual,
        )

    plain = planes[:-1] if group.complementary else planes
    in_bands(lambda start, stop: run(plain, False, 0.0, start, stop), height * width)
    origin = _gray_origin(absolute.reshape(height, width), wrapped.phase_rad[finest].reshape(height, width), usable)
    in_bands(lambda start, stop: run(planes, group.complementary, origin, start, stop), height * width)
    return absolute.reshape(height, width), residual.reshape(height, width), origin


def _plane_indices(patterns: PatternSet, wanted: GrayCodeGroup) -> IntArray:
    start = 0
    for group in patterns.groups:
        if group is wanted:
            return np.arange(start, start + group.count, dtype=np.int64)
        start += group.count
    return np.empty(0, np.int64)


def _gray_origin(numbered: FloatArray, phase: FloatArray, usable: BoolArray) -> float:
    """Return the phase at which the Gray code counts on; raises DecodeError when phase and code run against each other."""
    period = np.floor(numbered[::SAMPLED_ROW] / (2 * np.pi) + 1e-4).astype(np.int32)
    sampled = phase[::SAMPLED_ROW]
    both = usable[::SAMPLED_ROW, 1:] & usable[::SAMPLED_ROW, :-1]
    count_on = np.diff(period, axis=1)
    step = np.angle(np.exp(1j * np.diff(sampled, axis=1)))
    smooth = both & (np.abs(step) < np.pi / 2)
    border = smooth & (np.abs(count_on) == 1)
    if int(border.sum()) < LEAST_TRANSITIONS:
        return 0.0
    if float(np.sign(count_on[border]).mean()) * float(np.sign(step[smooth]).mean()) < -0.25:
        raise DecodeError(
            "The phase runs against the Gray code.", "Change the sign of `shift_sign`, or reverse the order of the shifted images."
        )
    at_border = np.exp(1j * sampled[:, :-1][border]).mean()
    return 0.0 if at_border.real >= 0 else -np.pi


def _vote(
    absolute: FloatArray, residual: FloatArray, variance: FloatArray, usable: BoolArray, radius: int, limits: tuple[float, float, float]
) -> tuple[FloatArray, BoolArray, int]:
    gate, amplification, slack = (np.float32(limit) for limit in limits)
    if radius == 0:
        return absolute, np.asarray(usable & (np.abs(residual) > gate)), 0
    voted = np.empty_like(absolute)
    conflict = np.empty(absolute.shape, np.bool_)

    def work(start: int, stop: int) -> int:
        return int(kernels.vote(absolute, residual, variance, usable, gate, amplification, slack, radius, start, stop, voted, conflict))

    return voted, conflict, sum(in_bands(work, len(absolute)))


def _average(absolute: FloatArray, wrapped: WrappedPhases, patterns: PatternSet, origin: float) -> FloatArray:
    """Average the pitches into ``absolute`` (in place) and return the standard deviation."""
    scales = (patterns.finest_pitch_px / np.array(patterns.pitches_px)).astype(np.float32)
    sigma = np.empty(absolute.size, np.float32)
    flat = absolute.reshape(-1)

    def work(start: int, stop: int) -> None:
        kernels.combine(flat, wrapped.phase_rad, wrapped.variance, scales, np.float32(origin), start, stop, sigma)

    in_bands(work, absolute.size)
    return sigma.reshape(absolute.shape)
