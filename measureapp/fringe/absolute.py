"""What turns the sums of one camera into absolute phase: the unwrapping, its origin, the thresholds."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.compiled.buffer_pool import BufferPool, aligned_empty
from measureapp.data.phase import PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.kernels.records import CHUNK, RESIDUAL_SCALE, ROWS, SPACING, Layout, Maps, Model, Work, in_chunks
from measureapp.fringe.recipe import Recipe
from measureapp.fringe.unwrap import HeterodynePlan, extent_px, plan_heterodyne

RANGE_MARGIN_PX = 2.0
GRAY_GATE_CYCLES, GRAY_SLACK_CYCLES = 0.5, 0.75
LEAST_TRANSITIONS = 200
JUMP_CYCLES = 0.01  # about the jump of the wrapped phase: above the rounding of eight bits, a small share of the pixels
NEIGHBOURS = 2  # px: a pixel between them may lie on the jump
ORIGINS = (0.0, -0.5)  # cycles: the patterns start with a crest, or with a trough
LUT_LENGTH = 1024
NORMAL_QUANTILE = 3.09  # one pixel without fringes in a thousand is taken for one with fringes
SAMPLED_CHUNKS = (8, 128, 2048)  # the fewest are enough unless the part fills little of the image
LEAST_SAMPLED = 1000  # usable pixels
GOLDEN_RATIO = (1 + sqrt(5)) / 2  # multiples of it, without their whole part, fill an interval evenly however many they are
USABLE = np.isin(np.arange(len(PixelState)), (PixelState.VALID, PixelState.ORDER_CONFLICT, PixelState.OUT_OF_RANGE))  # by state

Solve = Callable[[Model, Layout], Maps]  # returns the maps of a sample: whole chunks, one after the other


def make_model(recipe: Recipe, plan: HeterodynePlan | None, decides_later: bool) -> Model:
    """Return what turns sums into phase, with the origin at a crest."""
    groups, saturation = recipe.groups, recipe.saturation
    pitches = np.array([group.pitch_px for group in groups])
    scales, steps = pitches.min() / pitches, np.array([group.steps for group in groups])
    frequencies = np.array(plan.frequencies if plan else [1.0])
    combinations = np.array(plan.combinations if plan else np.empty((0, len(groups))))
    return Model(
        sine_sign=np.float32(-recipe.patterns.shift_sign),
        origin=np.float32(0),
        combinations=combinations.astype(np.float32),
        alone=np.array([_alone(combination) for combination in combinations], np.int64),
        ratios=np.concatenate([[1.0], frequencies[1:] / frequencies[:-1]]).astype(np.float32),
        watched=-1 if plan else 0,
        guard=np.float32(plan.guard if plan else 0.0),
        complementary=bool(recipe.gray_code and recipe.gray_code.complementary),
        finest=recipe.finest,
        scales=scales.astype(np.float32),
        norms=(4 / steps**2).astype(np.float32),
        shares=(2 * scales**2 / steps).astype(np.float32),
        pulls=(2 * scales / steps).astype(np.float32),
        correction=_correction_table(recipe),
        **_of_exposures(recipe),
        beyond=np.float32(min(saturation * max(recipe.exposures_us) / min(recipe.exposures_us), 65535.0)),
        least_modulation=np.float32(recipe.settings.min_modulation_grey(saturation)),
        one_gain=np.float32(1 / recipe.noise.electrons_per_grey(saturation)),
        one_floor=np.float32(recipe.noise.floor_variance(saturation)),
        sure=np.float32(_sure_variance(recipe, plan, scales)),
        weak_variance=np.float32(recipe.settings.max_sigma_rad**2),
        dark_variance=np.float32(sigma_of_nothing(scales) ** 2),
        zero_is_dark=recipe.settings.rule == "paper",
        lowest=np.float32(-RANGE_MARGIN_PX / pitches.min()),
        highest=np.float32((extent_px(recipe.patterns) + RANGE_MARGIN_PX) / pitches.min()),
        gate=np.float32(recipe.settings.residual_gate if plan else GRAY_GATE_CYCLES),
        undecided=decides_later,
    )


def _alone(combination: FloatArray) -> int:
    """Return the group that a combination of phases consists of, -1 where it takes more than its phase once."""
    groups = np.flatnonzero(combination)
    return int(groups[0]) if len(groups) == 1 and combination[groups[0]] == 1 else -1


def _sure_variance(recipe: Recipe, plan: HeterodynePlan | None, scales: FloatArray) -> float:
    """Return the variance of the absolute phase, rad², up to which faint pixels may make up for their modulation by many exposures."""
    if not recipe.settings.joint:
        return -1.0  # groups of different exposures have no common noise
    if plan is None or plan.amplification == 0:
        return recipe.settings.max_sigma_rad**2
    return plan.sure_sigma_rad**2 / float((scales**2).sum())


def _of_exposures(recipe: Recipe) -> dict[str, FloatArray | IntArray | int]:
    """Tabulate by set of exposures, bit e for exposure e, what the solver needs of it."""
    noise, saturation = recipe.noise, recipe.saturation
    light, weight = np.array(recipe.exposures_us, float), np.array(recipe.weights, float)
    sets = np.arange(1 << len(light))
    members = (sets[:, None] >> np.arange(len(light))) & 1 == 1
    total = np.where(members.any(axis=1), members @ (weight * light), np.inf)
    first = np.where(members.any(axis=1), members.argmax(axis=1), -1)
    shot = members @ (weight**2 * light) / total  # noise of the sum over that of an image as bright
    return {
        "black": (members @ weight * noise.black_grey).astype(np.float32),
        "gain": (shot / noise.electrons_per_grey(saturation)).astype(np.float32),
        "floor": (members @ weight**2 * noise.floor_variance(saturation)).astype(np.float32),
        "to_longest": (light[0] / total).astype(np.float32),
        "to_brightest": (np.where(first >= 0, light[first], 0.0) / total).astype(np.float32),
        "first": first.astype(np.int8),
        "exposures": len(light),
    }


def sigma_of_nothing(scales: FloatArray) -> float:
    """Return the phase's standard deviation in radians above which the modulation cannot be told from noise.

    Without fringes (B/σ_B)² of a group has the χ² distribution of two degrees of freedom, and 1/σ² is their sum weighted by the
    squared ``scales`` (frequency over the finest). Its quantile of one in a thousand is taken by moments [1]_ and [2]_.

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


def _correction_table(recipe: Recipe) -> FloatArray:
    """Tabulate −Σ a sin(kφ + p) in cycles over one period, (G, LUT_LENGTH + 1); (G, 0) where nothing is to be corrected."""
    given, groups = recipe.settings.phase_correction, len(recipe.groups)
    if not given:
        return np.empty((groups, 0), np.float32)
    if len(given) != groups:
        raise DecodeError(
            f"The phase correction is for {len(given)} pitches, pattern set {recipe.patterns.name!r} has {groups}.",
            "Estimate the projector's response with this pattern set.",
        )
    phase = np.linspace(-np.pi, np.pi, LUT_LENGTH + 1)
    table = np.zeros((groups, LUT_LENGTH + 1))
    for group, harmonics in enumerate(given):
        for order, amplitude, offset in harmonics:
            table[group] -= amplitude * np.sin(order * phase + offset)
    return (table / (2 * np.pi)).astype(np.float32)


def make_maps(dtype: np.dtype[np.unsignedinteger], pixels: int, memory: BufferPool) -> Maps:
    """Return room for the maps of one camera, in whole chunks."""
    pixels = in_chunks(pixels)
    return Maps(
        phase=memory.empty(pixels, np.float32),
        sigma=memory.empty(pixels, np.float32),
        modulation=memory.empty(pixels, dtype),
        grey=memory.empty(pixels, np.uint16),
        state=memory.empty(pixels, np.uint8),
        exposure=memory.empty(pixels, np.int8),
        residual=memory.empty(pixels, np.int8),
    )


def of_pixels(maps: Maps, pixels: int) -> Maps:
    """Return the maps without what fills up their last chunk."""
    return Maps(*(each[:pixels] for each in maps))


def make_work(groups: int) -> Work:
    """Return the arrays in which a block of pixels is solved."""
    return Work(
        phase=aligned_empty((groups * SPACING,), np.float32),
        power=aligned_empty((groups * SPACING,), np.float32),
        rows=aligned_empty((ROWS * SPACING,), np.float32),
        known=np.full(1, -1),
    )


def plan_of(recipe: Recipe) -> HeterodynePlan | None:
    """Return the chain of pitches, or None where a Gray code numbers the periods."""
    return None if recipe.gray_code else plan_heterodyne(recipe.patterns)


def sampled_chunks(pixels: int, number: int) -> list[tuple[int, int]]:
    """Return first pixel and end of about so many chunks that tell where the fringes start, all over the image.

    Steps of one length could be whole rows, and all chunks lie in one column of the image.
    """
    chunks = -(-pixels // CHUNK)
    chosen = np.unique((np.arange(number) * GOLDEN_RATIO % 1.0 * chunks).astype(int)) if number < chunks else np.arange(chunks)
    return [(begin, min(begin + CHUNK, pixels)) for begin in (chosen * CHUNK).tolist()]


def with_origin(model: Model, plan: HeterodynePlan | None, layout: Layout, solve: Solve) -> tuple[Model, bool]:
    """Return the model with the phase at which the fringes start, and whether the sample of the image shows enough to tell it.

    Raises
    ------
    DecodeError
        The phase runs against the Gray code: the shift sign of the images is wrong.
    """
    looking = model._replace(undecided=True)
    if plan is None:
        planes = layout.planes[:-1] if model.complementary else layout.planes
        maps = solve(looking._replace(complementary=False), layout._replace(planes=planes))
        chunks = range(0, len(maps.state), CHUNK)
        numbered, usable = ([every[begin : begin + CHUNK] for begin in chunks] for every in (maps.phase, USABLE[maps.state]))
        origin = _gray_origin(numbered, usable)
        return model._replace(origin=np.float32(origin or 0.0)), origin is not None
    spread, enough = [], True
    for origin in ORIGINS:
        maps = solve(looking._replace(origin=np.float32(origin), watched=len(plan.combinations) - 1), layout)
        left = np.abs(maps.residual[USABLE[maps.state]].astype(np.float32))
        spread.append(float(left.mean()) / RESIDUAL_SCALE if left.size else 0.0)
        enough &= left.size >= LEAST_SAMPLED
    return model._replace(origin=np.float32(ORIGINS[int(np.argmin(spread))])), enough


def _gray_origin(numbered: list[FloatArray], usable: list[BoolArray]) -> float | None:
    """Return the phase in cycles at which the Gray code counts on, None where too few periods end to tell it.

    Raises DecodeError when phase and code run against each other.

    Where the wrapped phase jumps, rounding alone decides on which side of the jump a pixel lies, and so its period: neighbours are
    compared across such pixels, never with them. Borders that fall exactly on pixels would otherwise all be read wrongly.
    """
    parts = [_turns(phase[mask] / np.float32(2 * np.pi), np.flatnonzero(mask)) for phase, mask in zip(numbered, usable, strict=True)]
    before, step, count_on = (np.concatenate(column) for column in zip(*parts, strict=True))
    smooth = np.abs(step) < 0.25
    border = smooth & (np.abs(count_on) == 1)
    if int(border.sum()) < LEAST_TRANSITIONS:
        return None
    if float(np.sign(count_on[border]).mean()) * float(np.sign(step[smooth]).mean()) < -0.25:
        raise DecodeError(
            "The phase runs against the Gray code.", "Change the sign of `shift_sign`, or reverse the order of the shifted images."
        )
    return 0.0 if float(np.cos(2 * np.pi * before[border]).mean()) >= 0 else -0.5


def _turns(cycles: FloatArray, place: IntArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return for neighbouring pixels the share of a period before the step, the step of it, and by how many periods the code counts on.

    Parameters
    ----------
    cycles : (n,) phase in cycles of usable pixels
    place : (n,) where they stand in a row of pixels
    """
    sure = np.abs(cycles - np.rint(cycles)) > JUMP_CYCLES
    cycles, place = cycles[sure], place[sure]
    near = np.diff(place) <= NEIGHBOURS
    period = np.floor(cycles)
    share = cycles - period
    turn = np.diff(share)
    return share[:-1][near], (turn - np.rint(turn))[near], np.diff(period)[near]
