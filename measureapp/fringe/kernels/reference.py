"""Readable NumPy statements of all decoding kernels, with the same arguments; selected by ``MEASUREAPP_KERNELS=reference``."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.data.phase import PixelState
from measureapp.fringe.kernels.structures import (
    CHUNK,
    MOST_ORDERS,
    REFUSED,
    RESIDUAL_SCALE,
    SAMPLED_EVERY,
    STRETCH,
    UNCHANGED,
    Counts,
    DecodeModel,
    ExposureImages,
    ExposureRule,
    ExposureSums,
    ImageLayout,
    Limits,
    PixelMaps,
    PixelRange,
    VoteLimits,
    Workspace,
)

TINY = 1e-12  # keeps denominators off zero
WITH_PHASE = (PixelState.VALID, PixelState.ORDER_CONFLICT, PixelState.OUT_OF_RANGE)  # before the vote


def decode_pixels(
    shown: ExposureImages,
    layout: ImageLayout,
    rule: ExposureRule,
    model: DecodeModel,
    pixels: PixelRange,
    sums: ExposureSums,
    work: Workspace,
    maps: PixelMaps,
    counts: Counts,
) -> None:
    """Add exposures of some pixels to their sums, and convert these to maps; see `solve.decode_pixels`."""
    del work  # of the compiled kernel
    for first in range(pixels.start, pixels.stop, STRETCH):
        last, place = min(first + STRETCH, pixels.stop), first - pixels.base if pixels.base >= 0 else 0
        chunks = slice(place // CHUNK, -(-(place + last - first) // CHUNK))
        part = ExposureSums._make([*(each[..., place : place + last - first] for each in sums[:-1]), sums.complete[chunks]])
        is_sample = np.arange(first, last) // CHUNK % SAMPLED_EVERY == 0
        for exposure, images in enumerate(shown.images[:, :, first:last], shown.first):
            is_served = np.repeat(part.complete == 1, CHUNK)[: last - first] & rule.first_only & (exposure > 0)
            valid = accumulate(images, exposure, shown.blocked[first:last], layout, rule, part)
            for sampled, examined in enumerate((~is_served, is_served & is_sample)):
                counts.exposures[sampled, :, exposure] += [np.count_nonzero(examined), np.count_nonzero(examined & valid)]
        if len(maps.phase):
            solve(part, layout, model, PixelMaps(*(each[first:last] for each in maps)), counts)


def accumulate(
    images: ImageArray, exposure: int, blocked: ImageArray, layout: ImageLayout, rule: ExposureRule, sums: ExposureSums
) -> BoolArray:
    """Add the images (P, N) of one exposure to the sums of pixels that use it; returns which are above zero and unsaturated."""
    if exposure == 0:
        for each in sums:
            each[...] = 0
    groups = [images[first : first + steps] for first, steps in zip(layout.first_image, layout.steps, strict=True)]
    brightest = np.array([group.max(axis=0) for group in groups])
    darkest = np.min([group.min(axis=0) for group in groups], axis=0)
    joint = len(sums.used) == 1
    for d, peak in enumerate(brightest.max(axis=0, keepdims=True) if joint else brightest):
        uses = (peak <= rule.limit) & ((sums.used[d] == 0) | (not rule.first_only))
        if len(blocked):
            sums.bloomed[uses & (blocked != 0)] = 1
            uses &= blocked == 0
        sums.has_zero[uses & (sums.used[d] == 0) & (darkest == 0)] = 1
        sums.used[d][uses] |= np.uint16(1 << exposure)
        weight = uses * int(rule.weights[exposure])
        for g, group in enumerate(groups):
            if joint or g == d:
                of_group = slice(layout.first_image[g], layout.first_image[g] + layout.steps[g])
                _add(sums.sine[g], weight * _weighted_sum(layout.sines[of_group], group, sums.sine.dtype))
                _add(sums.cosine[g], weight * _weighted_sum(layout.cosines[of_group], group, sums.sine.dtype))
                if g == rule.finest or not joint:
                    _add(sums.total[d], weight * group.sum(axis=0, dtype=np.int64))
        if joint or d == rule.finest:
            _add(sums.planes, weight * images[layout.planes].astype(np.int64))
    used = (sums.used != 0).all(axis=0)
    sums.complete[:] = np.logical_and.reduceat(used, np.arange(0, len(used), CHUNK))
    return np.asarray((brightest.max(axis=0) <= rule.limit) & (darkest > 0))


def _weighted_sum(weights: FloatArray, images: ImageArray, kind: np.dtype[np.generic]) -> FloatArray | IntArray:
    """Return Σ weight · image, in whole numbers where the sums are."""
    if len(weights) == 4:
        weights = np.rint(weights)
    return np.asarray(np.tensordot(weights, images.astype(float), 1)).astype(np.int64 if kind == np.int16 else float)


def _add(total: np.ndarray, term: np.ndarray) -> None:
    total += term.astype(total.dtype)


def solve(sums: ExposureSums, layout: ImageLayout, model: DecodeModel, maps: PixelMaps, counts: Counts) -> None:
    """Convert sums to phase, standard deviation, modulation, grey level and state, and count the states."""
    phases, power = wrap_groups(sums, model)
    joint, sets = len(sums.used) == 1, model.sets
    used, total = sums.used[0 if joint else model.finest], sums.total[0 if joint else model.finest].astype(float)
    grey = total / layout.steps[model.finest]
    light = np.maximum(grey - sets.black[used], 0)
    if joint:
        noise, scale = light * sets.gain[used] + sets.floor[used], sets.to_brightest[used].astype(float)
        square = (model.pitches.norms[:, None] * power).min(axis=0)
    else:
        mean = sums.total / layout.steps[:, None] - sets.black[sums.used]
        variance = np.maximum(mean, 0) * sets.gain[sums.used] + sets.floor[sums.used]
        noise, scale = np.ones(len(used)), np.ones(len(used))
        square = (model.pitches.norms[:, None] * power * sets.to_brightest[sums.used].astype(float) ** 2).min(axis=0)
        power = power / (variance + TINY)
    if len(model.unwrapping.combinations):
        value, residual = unwrap_heterodyne(phases, model)
    else:
        bright = sums.planes[: len(layout.planes)] * layout.steps[model.finest] > total
        value, residual = unwrap_gray(phases[model.finest], bright, model)
    value, variance = average_pitches(value, phases, power, model)
    variance = variance * noise
    modulation = np.sqrt(square) * scale
    limits = model.limits
    image_noise = light * scale * limits.image_gain + limits.image_floor
    dim = modulation < limits.least_modulation
    poor = (square * image_noise < limits.faint_modulation**2 * noise) | (variance > limits.voted_variance)
    doubtful = dim & (variance > limits.sure_variance) | (np.abs(residual) > limits.gate)
    state = classify(sums, value, doubtful, variance, dim & poor, limits)
    kept = np.isin(state, WITH_PHASE if limits.keep_conflicts else (PixelState.VALID,))
    maps.phase[:] = np.where(kept, (value + model.origin) * 2 * np.pi, 0)
    maps.sigma[:] = np.where(kept, np.sqrt(variance), 0)
    maps.modulation[:] = _whole_number(modulation, maps.modulation)
    maps.grey[:] = _whole_number(np.where(sets.to_longest[used] == 0, limits.saturated_grey, grey * sets.to_longest[used]), maps.grey)
    maps.state[:] = state
    maps.exposure[:] = sets.longest[np.bitwise_or.reduce(sums.used, axis=0)]
    if limits.keep_conflicts:
        maps.residual[:] = np.trunc(residual * RESIDUAL_SCALE)
    counts.states[:] += np.bincount(state, minlength=len(PixelState))
    counts.complete[:] += np.count_nonzero((sums.has_zero == 0) & (sums.used != 0).all(axis=0))


def _whole_number(values: FloatArray, like: ImageArray) -> FloatArray:
    return np.floor(np.minimum(values + 0.5, np.iinfo(like.dtype).max))


def wrap_groups(sums: ExposureSums, model: DecodeModel) -> tuple[FloatArray, FloatArray]:
    """Return the wrapped phases of all groups in cycles, and the squared modulations of their sums, (G, N) each."""
    sine, cosine = sums.sine.astype(float), sums.cosine.astype(float)
    phases = model.sine_sign * np.arctan2(sine, cosine) / (2 * np.pi) - model.origin
    for g, table in enumerate(model.correction):
        if len(table):
            turns = phases[g] + model.origin + 0.5
            phases[g] += np.interp((turns - np.floor(turns)) * (len(table) - 1), np.arange(len(table)), table)
    return phases, sine**2 + cosine**2


def unwrap_heterodyne(phases: FloatArray, model: DecodeModel) -> tuple[FloatArray, FloatArray]:
    """Unwrap from the coarsest combination of the phases (G, N) to the finest pitch: absolute phase and rounding residual, (N,) cycles."""
    chain = model.unwrapping
    combined = chain.combinations.astype(float) @ phases
    value, residual = combined[0] - np.floor(combined[0] + chain.guard), np.zeros(phases.shape[1])
    for k in range(1, len(combined)):
        decision = value * chain.ratios[k] - combined[k]
        order = np.floor(decision + 0.5)
        rounding = decision - order
        if chain.watched < 0:
            residual = np.where(np.abs(rounding) > np.abs(residual), rounding, residual)
        elif k == chain.watched:
            residual = rounding
        value = combined[k] + order
    return value, residual


def unwrap_gray(phase: FloatArray, bright: BoolArray, model: DecodeModel) -> tuple[FloatArray, FloatArray]:
    """Number the periods by the planes (B, N) of a Gray code; a complementary plane resolves the borders of the periods."""
    bits = np.bitwise_xor.accumulate(bright, axis=0)
    code = (1 << np.arange(len(bits))[::-1]) @ bits.astype(np.int64)
    share = phase - np.floor(phase)
    if not model.unwrapping.complementary:
        return code + share, 0.5 - share
    coarse, shifted = code // 2, (code + 1) // 2
    period = np.select([share < 0.25, share >= 0.75], [shifted, shifted - 1], coarse)
    return period + share, (np.abs(coarse - period) > 1).astype(float)


def average_pitches(value: FloatArray, phases: FloatArray, power: FloatArray, model: DecodeModel) -> tuple[FloatArray, FloatArray]:
    """Return the mean of the absolute phases of all pitches by inverse variance, and its variance over that of the sums."""
    pitches = model.pitches
    difference = phases - value * pitches.scales[:, None]
    difference -= np.floor(difference + 0.5)
    difference[model.finest] = 0
    variance = 1 / ((pitches.weights[:, None] * power).sum(axis=0) + TINY)
    return value + (pitches.shifts[:, None] * power * difference).sum(axis=0) * variance, variance


def classify(
    sums: ExposureSums, value: FloatArray, doubtful: BoolArray, variance: FloatArray, faint: BoolArray, limits: Limits
) -> IntArray:
    """Return the state of each pixel: the gravest of all that apply."""
    unused = (sums.used == 0).any(axis=0)
    dark = (sums.has_zero != 0) & limits.zero_is_dark
    conditions = {
        PixelState.BLOOMING: unused & (sums.bloomed != 0),
        PixelState.SATURATED: unused,
        PixelState.SHADOW: variance > limits.shadow_variance,
        PixelState.WEAK_MODULATION: faint | (variance > limits.weak_variance) | dark,
        PixelState.OUT_OF_RANGE: (value < limits.lowest) | (value > limits.highest),
        PixelState.ORDER_CONFLICT: doubtful,
    }
    return np.asarray(np.select(list(conditions.values()), list(conditions), PixelState.VALID), np.uint8)


def find_doubtful(maps: PixelMaps, step: float, reach: int, row_start: int, row_stop: int, doubtful: ImageArray) -> None:
    """Mark pixels (H, W) with a phase that are in conflict, or differ by more than ``step`` from one at distance 1 or ``reach``."""
    has_phase = np.isin(maps.state, WITH_PHASE)
    marked = maps.state == PixelState.ORDER_CONFLICT
    for shift in (1, max(reach, 1)):
        for axis in (0, 1):
            count = maps.phase.shape[axis] - shift
            one, other = _along(axis, slice(0, max(count, 0))), _along(axis, slice(shift, None))
            differs = has_phase[one] & has_phase[other] & (np.abs(maps.phase[one] - maps.phase[other]) > step)
            marked[one] |= differs
            marked[other] |= differs
    doubtful[row_start:row_stop] = marked[row_start:row_stop]


def _along(axis: int, part: slice) -> tuple[slice, slice]:
    return (part, slice(None)) if axis == 0 else (slice(None), part)


def vote(places: IntArray, maps: PixelMaps, limits: VoteLimits, start: int, stop: int, verdicts: IntArray) -> None:
    """Let the window decide the orders of doubtful pixels (D,); see `vote.vote`."""
    phase, state = maps.phase.reshape(-1), maps.state.reshape(-1)
    own = places[start:stop]
    residual = maps.residual.reshape(-1)[own] / np.float32(RESIDUAL_SCALE)
    trusted = (np.abs(residual) <= limits.gate) & (state[own] != PixelState.ORDER_CONFLICT)
    offsets = np.arange(-limits.radius, limits.radius + 1)
    change = np.full((len(own), len(offsets) ** 2), np.nan)  # of order, to that of each pixel of the window; NaN: none there
    for number, (down, right) in enumerate(np.array(np.meshgrid(offsets, offsets)).reshape(2, -1).T):
        other, is_there = _shift(own, int(down), int(right), maps.phase.shape)
        is_there &= np.isin(state[other], WITH_PHASE) & (other != own)
        change[is_there, number] = np.floor((phase[other] - phase[own])[is_there] / np.float32(2 * np.pi) + np.float32(0.5))
    others, same = np.count_nonzero(~np.isnan(change), axis=1), np.count_nonzero(change == 0, axis=1)
    steps = np.arange(-MOST_ORDERS, MOST_ORDERS + 1)
    tally = np.stack([np.count_nonzero(change == step, axis=1) * (step != 0) for step in steps], axis=1)
    best, most = steps[tally.argmax(axis=1)], tally.max(axis=1)
    outvoted = (most > same) & (2 * most > others)
    allowed = np.abs(residual - best) <= limits.slack + limits.allowance * maps.sigma.reshape(-1)[own]
    unsupported = (~trusted & ((same < 3) | (2 * same <= others))) | ((same == 0) & (others >= 4))
    verdict = np.where(outvoted, np.where(allowed, best, np.where(trusted, UNCHANGED, REFUSED)), np.where(unsupported, REFUSED, UNCHANGED))
    verdicts[start:stop] = np.where(np.isin(state[own], WITH_PHASE), verdict, UNCHANGED)


def _shift(places: IntArray, down: int, right: int, shape: tuple[int, ...]) -> tuple[IntArray, BoolArray]:
    """Return the flat indices of other pixels, and whether they are inside the image; outside of it the index is that of the pixel itself."""
    y, x = places // shape[1] + down, places % shape[1] + right
    is_inside = (y >= 0) & (y < shape[0]) & (x >= 0) & (x < shape[1])
    return np.where(is_inside, y * shape[1] + x, places), is_inside


def apply_verdicts(places: IntArray, verdicts: IntArray, limits: VoteLimits, start: int, stop: int, maps: PixelMaps) -> int:
    """Change orders and states as the window decided; returns how many pixels changed their order."""
    phase, state = maps.phase.reshape(-1), maps.state.reshape(-1)
    decided = np.isin(state[places[start:stop]], WITH_PHASE)
    own, verdict = places[start:stop][decided], verdicts[start:stop][decided]
    accepted, change = own[verdict != REFUSED], verdict[verdict != REFUSED].astype(int)
    state[own[verdict == REFUSED]] = PixelState.ORDER_CONFLICT
    phase[accepted] += np.where(change == UNCHANGED, np.float32(0), limits.order_steps[change + MOST_ORDERS])
    outside = (phase[accepted] < limits.lowest) | (phase[accepted] > limits.highest)
    state[accepted] = np.where(outside, PixelState.OUT_OF_RANGE, PixelState.VALID)
    return int(np.count_nonzero(change != UNCHANGED))


def find_edges(places: IntArray, maps: PixelMaps, step: float, start: int, stop: int, edge: BoolArray) -> None:
    """Mark (D,) valid pixels whose phase differs by more than ``step`` from a valid neighbour (left, right, above, below)."""
    phase, is_valid, own = maps.phase.reshape(-1), maps.state.reshape(-1) == PixelState.VALID, places[start:stop]
    edge[start:stop] = False
    for down, right in ((0, -1), (0, 1), (-1, 0), (1, 0)):
        other, _ = _shift(own, down, right, maps.phase.shape)
        edge[start:stop] |= is_valid[own] & is_valid[other] & (np.abs(phase[other] - phase[own]) > step)
