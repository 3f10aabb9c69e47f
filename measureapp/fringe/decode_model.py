"""How the sums of one camera become absolute phase: tables and limits for the kernels, and the arrays that they work on."""

from __future__ import annotations

from math import sqrt

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.compiled.buffer_pool import BufferPool, aligned_empty
from measureapp.errors import DecodeError
from measureapp.fringe.decode_plan import DecodePlan
from measureapp.fringe.kernels.structures import (
    CHUNK,
    ROW,
    DecodeModel,
    ExposureSets,
    Limits,
    Pitches,
    PixelMaps,
    Unwrapping,
    Workspace,
    round_up_to_chunks,
)
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.unwrap import PLURALITY, SURE, HeterodynePlan, extent_px, plan_heterodyne

RANGE_MARGIN_PX = 2.0
GRAY_GATE_CYCLES = 0.5
LUT_LENGTH = 1024
NORMAL_QUANTILE = 3.09  # one pixel in a thousand without fringes passes for one with fringes


def make_model(plan: DecodePlan, chain: HeterodynePlan | None, votes: bool, noise: CameraNoise) -> DecodeModel:
    """Return how sums become phase, with the origin at a crest.

    Parameters
    ----------
    chain : None where a Gray code numbers the periods
    votes : doubtful orders keep their phase for the vote
    noise : of the camera; the weights of the sums are those of the plan's, with which the images were added
    """
    pitches = np.array([group.pitch_px for group in plan.groups])
    scales, steps = pitches.min() / pitches, np.array([group.steps for group in plan.groups])
    return DecodeModel(
        sine_sign=np.float32(-plan.patterns.shift_sign),
        origin=np.float32(0),
        correction=_correction_table(plan),
        finest=plan.finest,
        pitches=Pitches(
            scales=scales.astype(np.float32),
            norms=(4 / steps**2).astype(np.float32),
            weights=(2 * scales**2 / steps).astype(np.float32),
            shifts=(2 * scales / steps).astype(np.float32),
        ),
        unwrapping=_unwrapping(plan, chain),
        sets=_exposure_sets(plan, noise),
        limits=_limits(plan, chain, scales, votes, noise),
    )


def _unwrapping(plan: DecodePlan, chain: HeterodynePlan | None) -> Unwrapping:
    frequencies = np.array(chain.frequencies if chain else [1.0])
    combinations = np.array(chain.combinations if chain else np.empty((0, len(plan.groups))))
    return Unwrapping(
        combinations=combinations.astype(np.float32),
        ratios=np.concatenate([[1.0], frequencies[1:] / frequencies[:-1]]).astype(np.float32),
        watched=-1 if chain else 0,
        guard=np.float32(chain.guard if chain else 0.0),
        complementary=bool(plan.gray_code and plan.gray_code.complementary),
    )


def _limits(plan: DecodePlan, chain: HeterodynePlan | None, scales: FloatArray, votes: bool, noise: CameraNoise) -> Limits:
    settings, saturation, finest_px = plan.settings, plan.saturation, plan.patterns.finest_pitch_px
    sure_variance = _sure_variance(plan, chain, scales)
    by_vote = votes and sure_variance > 0.0 and settings.rule != "paper"
    voted_variance = sure_variance * (SURE / PLURALITY) ** 2 if by_vote else sure_variance
    weak_variance = min(settings.max_sigma_rad**2, voted_variance) if by_vote else settings.max_sigma_rad**2
    return Limits(
        saturated_grey=np.float32(min(saturation * max(plan.exposures_us) / min(plan.exposures_us), 65535.0)),
        least_modulation=np.float32(settings.min_modulation_grey(saturation)),
        faint_modulation=np.float32(settings.faint_modulation_grey(saturation)),
        image_gain=np.float32(1 / noise.electrons_per_grey(saturation)),
        image_floor=np.float32(noise.floor_variance(saturation)),
        sure_variance=np.float32(sure_variance),
        voted_variance=np.float32(voted_variance),
        weak_variance=np.float32(weak_variance),
        shadow_variance=np.float32(shadow_sigma(scales) ** 2),
        zero_is_dark=settings.rule == "paper",
        lowest=np.float32(-RANGE_MARGIN_PX / finest_px),
        highest=np.float32((extent_px(plan.patterns) + RANGE_MARGIN_PX) / finest_px),
        gate=np.float32(settings.residual_gate if chain else GRAY_GATE_CYCLES),
        keep_conflicts=votes,
    )


def _sure_variance(plan: DecodePlan, chain: HeterodynePlan | None, scales: FloatArray) -> float:
    """Return the variance of the absolute phase, rad², up to which many exposures may compensate for a low modulation."""
    if not plan.settings.joint:
        return -1.0  # groups of different exposures have no common noise
    if chain is None or chain.amplification == 0:
        return plan.settings.max_sigma_rad**2
    return chain.sure_sigma_rad**2 / float((scales**2).sum())


def _exposure_sets(plan: DecodePlan, noise: CameraNoise) -> ExposureSets:
    """Tabulate the properties of the sum over every set of exposures, bit e for exposure e."""
    saturation = plan.saturation
    time, weight = np.array(plan.exposures_us, float), np.array(plan.weights, float)
    members = (np.arange(1 << len(time))[:, None] >> np.arange(len(time))) & 1 == 1
    occupied = members.any(axis=1)
    total = np.where(occupied, members @ (weight * time), np.inf)
    longest = np.where(occupied, members.argmax(axis=1), -1)
    shot = members @ (weight**2 * time) / total  # noise of the sum over that of an image as bright
    return ExposureSets(
        black=(members @ weight * noise.black_grey).astype(np.float32),
        gain=(shot / noise.electrons_per_grey(saturation)).astype(np.float32),
        floor=(members @ weight**2 * noise.floor_variance(saturation)).astype(np.float32),
        to_longest=(time[0] / total).astype(np.float32),
        to_brightest=(np.where(occupied, time[longest], 0.0) / total).astype(np.float32),
        longest=longest.astype(np.int8),
    )


def shadow_sigma(scales: FloatArray) -> float:
    """Return the phase's standard deviation in radians above which fringes cannot be distinguished from noise.

    Without fringes (B/σ_B)² of a group has the χ² distribution of two degrees of freedom, and 1/σ² is their sum weighted by the
    squared ``scales`` (frequency over the finest). Its quantile of one in a thousand follows from its moments [1]_ and [2]_.

    References
    ----------
    .. [1] F. E. Satterthwaite, Biometrics Bulletin 2(6), 110-114, 1946.
    .. [2] E. B. Wilson, M. M. Hilferty, PNAS 17(12), 684-688, 1931.
    """
    square, fourth = float((scales**2).sum()), float((scales**4).sum())
    freedom = 2 * square**2 / fourth
    spread = 2 / (9 * freedom)
    quantile = fourth / square * freedom * (1 - spread + NORMAL_QUANTILE * sqrt(spread)) ** 3
    return 1 / sqrt(quantile)


def _correction_table(plan: DecodePlan) -> FloatArray:
    """Tabulate −Σ a sin(kφ + p) in cycles over one period, (G, LUT_LENGTH + 1); (G, 0) where nothing is to be corrected."""
    given, groups = plan.settings.phase_correction, len(plan.groups)
    if not given:
        return np.empty((groups, 0), np.float32)
    if len(given) != groups:
        raise DecodeError(
            f"The phase correction is for {len(given)} pitches, pattern set {plan.patterns.name!r} has {groups}.",
            "Estimate the projector's response with this pattern set.",
        )
    phase = np.linspace(-np.pi, np.pi, LUT_LENGTH + 1)
    table = np.zeros((groups, LUT_LENGTH + 1))
    for group, harmonics in enumerate(given):
        for order, amplitude, offset in harmonics:
            table[group] -= amplitude * np.sin(order * phase + offset)
    return (table / (2 * np.pi)).astype(np.float32)


def make_maps(dtype: np.dtype[np.unsignedinteger], pixels: int, memory: BufferPool) -> PixelMaps:
    """Allocate the maps of one camera, in whole chunks."""
    pixels = round_up_to_chunks(pixels)
    return PixelMaps(
        phase=memory.empty(pixels, np.float32),
        sigma=memory.empty(pixels, np.float32),
        modulation=memory.empty(pixels, dtype),
        grey=memory.empty(pixels, np.uint16),
        state=memory.empty(pixels, np.uint8),
        exposure=memory.empty(pixels, np.int8),
        residual=memory.empty(pixels, np.int8),
    )


def crop(maps: PixelMaps, pixels: int) -> PixelMaps:
    """Return the maps without the padding of their last chunk."""
    return PixelMaps(*(each[:pixels] for each in maps))


def make_workspace(dtype: np.dtype[np.unsignedinteger], groups: int, decisions: int) -> Workspace:
    """Allocate the intermediate results of one chunk."""
    grey, rows = aligned_empty((decisions + 1, CHUNK), dtype), aligned_empty((2 * groups + 5, ROW), np.float32)
    weight, code = aligned_empty((decisions, CHUNK), np.uint8), aligned_empty((ROW,), np.int32)
    return Workspace._make([grey[:-1], grey[-1], weight, rows[:groups], rows[groups : 2 * groups], *rows[2 * groups :], code])


def find_chain(plan: DecodePlan) -> HeterodynePlan | None:
    """Return the chain of pitches, or None where a Gray code numbers the periods."""
    return None if plan.gray_code else plan_heterodyne(plan.patterns)
