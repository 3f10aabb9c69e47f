"""Compiled loop over a phase map: how the phase changes from pixel to pixel, and between which pixels it can be interpolated."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import broadcast, maximum, minimum, select
from measureapp.compiled.simd.memory import load, store, store_records, store_records_streaming
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_uint8
from measureapp.reconstruct.kernels.streaming import write_row

CHUNK = 512  # after so many samples are written
REACH = 3  # pixels to either side over which a slope is taken
PITCH = 32  # of the copied surroundings of PIXELS: REACH more on all sides
MIDDLE = REACH * PITCH + REACH
COPIED = (2 * REACH + 1) * PITCH
ROWS = (-3, -1, 0, 1, 3)  # from which a slope is taken
PHASE, SLOPE_X, SLOPE_Y, OWN_SIGMA = range(4)  # in the record of a pixel
RECORD = 4
RECORDS = RECORD * PIXELS
OWN, GX, GY, SAMPLE = (k * CHUNK for k in range(4))
SCRATCH = 4 * CHUNK
ZERO, HALF, ONE, TWO = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2)
MISSING, VALID = np.uint8(1), np.uint8(0)
PER_WIDE = np.float32(1 / (2 * REACH))
BENT = np.float32(0.2)  # curvature, as a share of the rise over the window, beyond which a wide slope says nothing about its middle
BENT_SIGMAS = np.float32(4.0)

# four valid pixels of one surface; four valid pixels with a step between them; two or three valid ones beside a hole
WHOLE, TORN, BESIDE = np.uint8(1), np.uint8(2), np.uint8(3)


@njit(**INLINE)
def narrow(before: Any, behind: Any, no_before: Any, no_behind: Any, step: Any) -> Any:
    """Return the slope from the changes of the phase to both neighbours, or to the one that lies on the same surface."""
    first, second = ~no_before & (abs(before) < step), ~no_behind & (abs(behind) < step)
    return (select(first, before, ZERO) + select(second, behind, ZERO)) * select(first & second, HALF, broadcast(ONE, PIXELS))


@njit(**INLINE)
def slopes_at(phase: Any, state: Any, at: int, width: int, sigma: Any, step: Any) -> Any:
    """Return phases of PIXELS from ``at`` on in flat maps, and their slopes along x and y, 0 where they are not known."""
    own, hole = load(phase, at, PIXELS), load(state, at, PIXELS)
    left, right = load(phase, at - REACH, PIXELS), load(phase, at + REACH, PIXELS)
    above, below = load(phase, at - REACH * width, PIXELS), load(phase, at + REACH * width, PIXELS)
    holes = load(state, at - REACH, PIXELS) | load(state, at + REACH, PIXELS)
    holes = holes | load(state, at - REACH * width, PIXELS) | load(state, at + REACH * width, PIXELS)
    rise_x, rise_y = right - left, below - above
    limit = BENT * (abs(rise_x) + abs(rise_y)) + BENT_SIGMAS * sigma
    bend = maximum(abs(right + left - TWO * own), abs(below + above - TWO * own))
    wide = (holes | hole == VALID) & (bend <= limit)
    no_left, no_right = load(state, at - 1, PIXELS) != VALID, load(state, at + 1, PIXELS) != VALID
    no_up, no_down = load(state, at - width, PIXELS) != VALID, load(state, at + width, PIXELS) != VALID
    narrow_x = narrow(own - load(phase, at - 1, PIXELS), load(phase, at + 1, PIXELS) - own, no_left, no_right, step)
    narrow_y = narrow(own - load(phase, at - width, PIXELS), load(phase, at + width, PIXELS) - own, no_up, no_down, step)
    nothing = hole != VALID
    gx, gy = select(wide, PER_WIDE * rise_x, narrow_x), select(wide, PER_WIDE * rise_y, narrow_y)
    return own, select(nothing, ZERO, gx), select(nothing, ZERO, gy)


@njit(**INLINE)
def quads_at(phase: Any, state: Any, at: int, width: int, step: Any) -> Any:
    """Return what PIXELS from ``at`` on are together with their right, lower and lower right neighbours."""
    a, b = load(phase, at, PIXELS), load(phase, at + 1, PIXELS)
    c, d = load(phase, at + width, PIXELS), load(phase, at + width + 1, PIXELS)
    spread = maximum(maximum(a, b), maximum(c, d)) - minimum(minimum(a, b), minimum(c, d))
    first, second = load(state, at, PIXELS) == VALID, load(state, at + 1, PIXELS) == VALID
    third, fourth = load(state, at + width, PIXELS) == VALID, load(state, at + width + 1, PIXELS) == VALID
    above, below = first & second, third & fourth
    some = above | below | ((first | second) & (third | fourth))
    alone = broadcast(VALID, PIXELS)
    return select(above & below, select(spread <= step, WHOLE, broadcast(TORN, PIXELS)), select(some, BESIDE, alone))


@njit(**INLINE)
def copy_surroundings(maps: Any, height: int, width: int, y: int, first: int, n: int, copied: Any) -> None:
    """Copy n pixels of a row and what is around them, where the image ends in between: what lies outside is missing."""
    phase, sigma, state = maps
    phases, sigmas, states = copied
    states[:] = MISSING
    for row in ROWS:
        v = y + row
        if 0 <= v < height:
            for u in range(max(first - REACH, 0), min(first + n + REACH, width)):
                place = MIDDLE + row * PITCH + u - first
                phases[place], states[place] = phase[v * width + u], state[v * width + u]
    for i in range(n):
        sigmas[i] = sigma[y * width + first + i]


@njit(**INLINE)
def write(made: Any, sigma: Any, quad: Any, i: int, streaming: bool, pixels: Any, quads: Any) -> None:
    """Write records and quads of PIXELS from the i-th on."""
    own, gx, gy = made
    if streaming:  # for they are read when all others are written
        store_records_streaming((own, gx, gy, sigma), pixels, RECORD * i)
    else:
        store_records((own, gx, gy, sigma), pixels, RECORD * i)
    store(quad, quads, i)


@njit(**INLINE)
def keep(made: Any, i: int, s: Any) -> None:
    """Keep what goes into the samples of a chunk."""
    own, gx, gy = made
    store(own, s, OWN + i)
    store(gx, s, GX + i)
    store(gy, s, GY + i)


@njit(**INLINE)
def write_samples(s: Any, n: int, every: int, out: Any) -> None:
    """Write phase and slopes of every, or every second, of n pixels."""
    for k in range(3):
        if every == 1:
            write_row(s[OWN + k * CHUNK : OWN + k * CHUNK + n], out[k])
            continue
        half = (n + 1) // 2
        for i in range(half):
            s[SAMPLE + i] = s[OWN + k * CHUNK + 2 * i]
        write_row(s[SAMPLE : SAMPLE + half], out[k])


@njit(**LOOP)
def slopes(
    maps: Any,  # (H · W,): phase float32, sigma float32, state uint8, 0 valid
    height: int,
    width: int,
    step: Any,  # float32, largest phase step between neighbours of one surface
    every: int,  # 1 or 2
    row_start: int,
    row_stop: int,
    pixels: Any,  # out (4 H · W,) float32, records of four: phase, slope in rad/px along x and y, (0, 0) where unknown, and sigma
    quad: Any,  # out (H · W,) uint8, of the pixel with its right, lower and lower right neighbour: WHOLE, TORN, BESIDE or 0
    samples: Any,  # out (3, H / every, W / every), rounded up: phase and slopes of every so many pixels in both directions
) -> None:
    """Take slopes as central differences over the widest reach that is one smooth surface: three pixels, one, one to one side.

    A wide reach lowers the noise of a slope; near borders and bends a narrow one keeps it true.
    """
    phase, sigma, state = maps
    s, phases, states, sigmas = stack_float32(SCRATCH), stack_float32(COPIED), stack_uint8(COPIED), stack_float32(PIXELS)
    records, quads = stack_float32(RECORDS), stack_uint8(PIXELS)
    phases[:], sigmas[:] = ZERO, ZERO
    for y in range(row_start, row_stop):
        inside, sampled, row = REACH <= y < height - REACH, y % every == 0, y * width
        streaming = pixels[RECORD * row :].ctypes.data % CACHE_LINE_BYTES == 0
        for first in range(0, width, CHUNK):
            count = min(CHUNK, width - first)
            for x in range(first, first + count, PIXELS):
                at = row + x
                if inside and REACH <= x <= width - PIXELS - REACH:
                    noise = load(sigma, at, PIXELS)
                    made = slopes_at(phase, state, at, width, noise, step)
                    write(made, noise, quads_at(phase, state, at, width, step), at, streaming, pixels, quad)
                else:
                    n = min(PIXELS, width - x)
                    copy_surroundings(maps, height, width, y, x, n, (phases, sigmas, states))
                    noise = load(sigmas, 0, PIXELS)
                    made = slopes_at(phases, states, MIDDLE, PITCH, noise, step)
                    write(made, noise, quads_at(phases, states, MIDDLE, PITCH, step), 0, False, records, quads)
                    for i in range(RECORD * n):
                        pixels[RECORD * at + i] = records[i]
                    for i in range(n):
                        quad[at + i] = quads[i]
                if sampled:
                    keep(made, x - first, s)
            if sampled:
                write_samples(s, count, every, samples[:, y // every, first // every : (first + count + every - 1) // every])
