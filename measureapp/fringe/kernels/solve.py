"""From sums over exposures to absolute phase, standard deviation and state; and the loop over the pixels of an image.

The sums of a stretch of pixels, and the images of one exposure at a time, stay in cache: the hardware prefetcher follows the images of one
exposure, but not those of all. Evaluation is written with SIMD vectors, because the compiler does not vectorise a plain loop over so many
arrays. The NumPy statements are in `reference`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import gather, load, store
from measureapp.fringe.kernels.accumulate import accumulate_chunk
from measureapp.fringe.kernels.structures import CHUNK, RESIDUAL_SCALE, SAMPLED_EVERY, STRETCH
from measureapp.fringe.kernels.unwrap import average_pitches, unwrap_gray, unwrap_heterodyne
from measureapp.fringe.kernels.wrap import TINY, wrap_groups

LANES = 16  # pixels in one vector
TAU = np.float32(2 * np.pi)
LEAST_SQUARE = np.float32(1e-30)  # keeps a reciprocal root finite
VALID, SATURATED, WEAK, SHADOW, CONFLICT, OUTSIDE, BLOOMING = (np.int32(state) for state in (0, 1, 2, 3, 4, 5, 7))  # of PixelState


@njit(**LOOP)
def decode_pixels(shown: Any, layout: Any, rule: Any, model: Any, pixels: Any, sums: Any, work: Any, maps: Any, counts: Any) -> None:
    """Add exposures of some pixels to their sums, and convert these to maps; maps without pixels: the sums are not solved.

    Sums and maps hold whole chunks; only the last chunk of the image may have fewer pixels that count. Where one exposure is enough,
    chunks whose pixels all use one are skipped, except for a sample that is counted.
    """
    for first in range(pixels.start, pixels.stop, STRETCH):
        last, place = min(first + STRETCH, pixels.stop), first - pixels.base if pixels.base >= 0 else 0
        for e in range(shown.images.shape[0]):
            exposure = shown.first + e
            for begin in range(first, last, CHUNK):
                here = place + begin - first
                sampled = np.int64(exposure > 0 and rule.first_only and sums.complete[here // CHUNK] != 0)
                if sampled and (begin // CHUNK) % SAMPLED_EVERY != 0:
                    continue
                images, at = (shown.images[e], begin) if last - begin >= CHUNK else (shown.tails[e], 0)
                near = shown.blocked[begin : begin + CHUNK]
                valid = accumulate_chunk(images, at, exposure, near, layout, rule, sums, here, work)
                counts.exposures[sampled, 0, exposure] += min(CHUNK, last - begin)
                counts.exposures[sampled, 1, exposure] += valid
        if maps.phase.shape[0] > 0:
            for begin in range(first, last, CHUNK):
                here = place + begin - first
                solve_chunk(sums, here, layout, model, work, begin, maps)
                count_states(sums, here, maps.state[begin : min(begin + CHUNK, last)], counts)


@njit(**INLINE)
def solve_chunk(sums: Any, place: int, layout: Any, model: Any, work: Any, begin: int, maps: Any) -> None:
    """Convert the sums of a chunk of pixels from ``place`` on to the maps of the pixels from ``begin`` on."""
    wrap_groups(sums, place, model, work)
    square_modulation(model, work)
    if sums.used.shape[0] > 1:
        weight_groups(sums, place, layout, model, work)
    if model.unwrapping.combinations.shape[0] > 0:
        unwrap_heterodyne(model, work)
    else:
        unwrap_gray(sums, place, layout, model, work)
    average_pitches(model, work)
    for j in range(0, CHUNK, LANES):
        evaluate(sums, place, j, layout, model, work, begin, maps)
    if sums.used.shape[0] > 1:
        write_exposures(sums, place, model, maps.exposure[begin : begin + CHUNK])


@njit(**INLINE)
def square_modulation(model: Any, work: Any) -> None:
    """Compute the least squared modulation of all groups, in grey levels of the sums."""
    for g in range(work.power.shape[0]):
        norm, power, square = model.pitches.norms[g], work.power[g], work.square
        for j in range(CHUNK):
            square[j] = norm * power[j] if g == 0 else min(square[j], norm * power[j])


@njit(**INLINE)
def weight_groups(sums: Any, place: int, layout: Any, model: Any, work: Any) -> None:
    """Divide the power of groups with different exposures by the variance of their sums, and scale their modulation to one exposure."""
    sets = model.sets
    for g in range(sums.used.shape[0]):
        steps, norm, power = np.float32(layout.steps[g]), model.pitches.norms[g], work.power[g]
        for j in range(CHUNK):
            used, scale = sums.used[g, place + j], sets.to_brightest[sums.used[g, place + j]]
            square = norm * power[j] * scale * scale
            work.square[j] = square if g == 0 else min(work.square[j], square)
            light = np.float32(sums.total[g, place + j]) / steps - sets.black[used]
            power[j] /= max(light, np.float32(0)) * sets.gain[used] + sets.floor[used] + TINY


@njit(**INLINE)
def evaluate(sums: Any, place: int, first: int, layout: Any, model: Any, work: Any, begin: int, maps: Any) -> None:
    """Compute standard deviation, modulation, grey level and state of a vector of pixels, and write their maps.

    States other than a doubtful fringe order are distinguished only where one of the pixels has another.
    """
    limits, here, finest, joint = model.limits, place + first, model.finest, sums.used.shape[0] == 1
    value, residual, square = load(work.value, first, LANES), load(work.residual, first, LANES), load(work.square, first, LANES)
    black, gain, floor, to_brightest, to_longest, exposure = look_up(model.sets, sums.used[0 if joint else finest], here)
    grey = convert(load(sums.total[0 if joint else finest], here, LANES), np.float32) * (np.float32(1) / np.float32(layout.steps[finest]))
    light = maximum(grey - black, np.float32(0))
    variance_of_sum = light * gain + floor
    variance = load(work.variance, first, LANES)
    modulation = positive_root(square)
    if joint:
        variance, modulation = variance * variance_of_sum, modulation * to_brightest
    else:  # the weights hold the noise, the squares the scale
        variance_of_sum, to_brightest = broadcast(np.float32(1), LANES), broadcast(np.float32(1), LANES)
    doubtful = abs(residual) > limits.gate
    state, kept = select(doubtful, broadcast(CONFLICT, LANES), VALID), ~doubtful | limits.keep_conflicts
    outside = (value < limits.lowest) | (value > limits.highest)
    faint = (modulation < limits.least_modulation) | (variance > min(limits.weak_variance, limits.shadow_variance))
    unusable = unusable_state(sums, here, limits.zero_is_dark)
    grey = grey * to_longest
    if any_lane(outside | faint | (unusable != VALID)):
        image_variance = light * to_brightest * limits.image_gain + limits.image_floor  # of one image at the longest exposure used
        least = limits.faint_modulation
        dim = modulation < limits.least_modulation
        poor = (square * image_variance < least * least * variance_of_sum) | (variance > limits.voted_variance)
        weak = (dim & poor) | (variance > limits.weak_variance) | (unusable == WEAK)
        state = select(dim & (variance > limits.sure_variance), CONFLICT, state)
        state = select(outside, OUTSIDE, state)
        state = select(weak, WEAK, state)
        state = select(variance > limits.shadow_variance, SHADOW, state)
        state = select((unusable == SATURATED) | (unusable == BLOOMING), unusable, state)
        kept = (state == VALID) | (((state == CONFLICT) | (state == OUTSIDE)) & limits.keep_conflicts)
        grey = select(to_longest == np.float32(0), limits.saturated_grey, grey)
    at = begin + first
    store(select(kept, (value + model.origin) * TAU, np.float32(0)), maps.phase, at)
    store(select(kept, positive_root(variance), np.float32(0)), maps.sigma, at)
    store(whole_number(modulation, maps.modulation), maps.modulation, at)
    store(whole_number(grey, maps.grey), maps.grey, at)
    store(convert(state, np.uint8), maps.state, at)
    store(exposure, maps.exposure, at)
    if limits.keep_conflicts:
        store(convert(convert(residual * np.float32(RESIDUAL_SCALE), np.int32), np.int8), maps.residual, at)


@njit(**INLINE)
def look_up(sets: Any, used: Any, here: int) -> Any:
    """Return what `ExposureSets` holds of the sets that pixels use; neighbours mostly use the same."""
    first, several = used[here], load(used, here, LANES)
    if any_lane(several != first):
        indices = convert(several, np.int32)
        return (
            gather(sets.black, indices),
            gather(sets.gain, indices),
            gather(sets.floor, indices),
            gather(sets.to_brightest, indices),
            gather(sets.to_longest, indices),
            gather(sets.longest, indices),
        )
    return (
        broadcast(sets.black[first], LANES),
        broadcast(sets.gain[first], LANES),
        broadcast(sets.floor[first], LANES),
        broadcast(sets.to_brightest[first], LANES),
        broadcast(sets.to_longest[first], LANES),
        broadcast(sets.longest[first], LANES),
    )


@njit(**INLINE)
def unusable_state(sums: Any, here: int, zero_is_dark: bool) -> Any:
    """Return the state of pixels without a usable exposure, VALID for all others."""
    dark = WEAK if zero_is_dark else VALID
    state = select(load(sums.has_zero, here, LANES) != 0, broadcast(dark, LANES), VALID)
    rejected = select(load(sums.bloomed, here, LANES) != 0, broadcast(BLOOMING, LANES), SATURATED)
    for d in range(sums.used.shape[0]):
        state = select(load(sums.used[d], here, LANES) == 0, rejected, state)
    return state


@njit(**INLINE)
def positive_root(square: Any) -> Any:
    """Return the square root of positive numbers, by way of its reciprocal, for which processors have a fast estimate."""
    return square * (np.float32(1) / sqrt(square + LEAST_SQUARE))


@njit(**INLINE)
def whole_number(values: Any, like: Any) -> Any:
    """Round positive numbers and limit them to what the type of an array holds."""
    largest = np.float32(255 if like.itemsize == 1 else 65535)
    return convert(convert(minimum(values + 0.5, largest), np.int32), like.dtype)


@njit(**INLINE)
def write_exposures(sums: Any, place: int, model: Any, exposure: Any) -> None:
    """Write the longest exposure that any group of a pixel uses, where groups use different ones."""
    for j in range(CHUNK):
        used = sums.used[0, place + j]
        for d in range(1, sums.used.shape[0]):
            used |= sums.used[d, place + j]
        exposure[j] = model.sets.longest[used]


@njit(**INLINE)
def count_states(sums: Any, place: int, state: Any, counts: Any) -> None:
    """Count pixels by state, and those with an exposure above zero in all groups."""
    rest = state.shape[0]
    for code in range(counts.states.shape[0]):
        if rest > 0:  # most chunks have valid pixels only
            count = np.uint16(0)
            for j in range(state.shape[0]):
                count = np.uint16(count + (state[j] == np.uint8(code)))
            counts.states[code] += count
            rest -= count
    complete, has_zero = np.uint16(0), sums.has_zero[place : place + CHUNK]
    if sums.complete[place // CHUNK]:
        for j in range(state.shape[0]):
            complete = np.uint16(complete + (has_zero[j] == 0))
    else:
        for j in range(state.shape[0]):
            lit = has_zero[j] == 0
            for d in range(sums.used.shape[0]):
                lit = lit and sums.used[d, place + j] != 0
            complete = np.uint16(complete + lit)
    counts.complete[0] += complete
