"""Compiled loop over a phase map: how the phase changes from pixel to pixel, and between which pixels it can be interpolated.

Loops over arithmetic alone write to one scratch array at constant offsets: only then does the compiler know that nothing overlaps,
and uses SIMD instructions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.map_memory import LINE
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.past_caches import write_row
from measureapp.reconstruct.kernels.scratch import GROUP, join_4, join_4_past_caches, stack_float32, stack_uint8

CHUNK = 512  # all lanes stay in the first cache of a processor
REACH = 3  # pixels to either side over which a slope is taken
EDGE = (
    32  # columns, or up to twice as many, that are taken by themselves at either border, where some lack neighbours; half fill a cache line
)
LENGTH = CHUNK + 2 * REACH
ROWS = (-3, -1, 0, 1, 3)
NEIGHBOURS = 5 * LENGTH
(OWN, GX, GY, SIGMA, QUAD, SAMPLE) = (k * CHUNK for k in range(6))  # the first four make a record
SCRATCH = 6 * CHUNK
RECORDS = 4 * CHUNK
PHASE, SLOPE_X, SLOPE_Y, OWN_SIGMA = range(4)  # in the record of a pixel
ZERO, HALF, ONE, TWO, THREE = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2), np.float32(3)
MISSING = np.uint8(1)
PER_WIDE = np.float32(1 / (2 * REACH))
BENT = np.float32(0.2)  # curvature, as a share of the rise over the window, beyond which a wide slope says nothing about its middle
BENT_SIGMAS = np.float32(4.0)

# four valid pixels of one surface; four valid pixels with a step between them; two or three valid ones beside a hole
WHOLE, TORN, BESIDE = np.uint8(1), np.uint8(2), np.uint8(3)


@njit(**INLINE)
def write_records(s: Any, records: Any, n: int, out: Any) -> None:
    """Write n records: past the caches, where they begin with a line of them, for they are read when all others are written."""
    done = 0
    if out.ctypes.data % LINE == 0:
        done = n - n % GROUP
        for i in range(0, done, GROUP):
            join_4_past_caches(out, np.uint32(4 * i), s, np.uint32(OWN + i), np.uint32(CHUNK))
    for i in range(done, n, GROUP):
        join_4(records, np.uint32(4 * i), s, np.uint32(OWN + i), np.uint32(CHUNK))
    for i in range(4 * done, 4 * n):
        out[i] = records[i]


@njit(**INLINE)
def copy_neighbours(phase: Any, state: Any, y: int, first: int, n: int, phases: Any, states: Any) -> None:
    """Copy what `five_rows` returns, where the image ends in between: what lies outside is missing."""
    height, width = phase.shape
    low, high = max(REACH - first, 0), min(width - first + REACH, n + 2 * REACH)
    for i in range(len(states)):
        states[i] = MISSING
    for k in range(5):
        v = y + ROWS[k]
        if 0 <= v < height:
            for i in range(low, high):
                phases[k * LENGTH + i] = phase[v, first - REACH + i]
                states[k * LENGTH + i] = state[v, first - REACH + i]


@njit(**INLINE)
def five_rows(image: Any, y: int, first: int, n: int) -> Any:
    """Return n pixels of a row from ``first`` on with REACH more at either side, from the rows 3 and 1 above, their own, 1 and 3 below."""
    part = slice(first - REACH, first + n + REACH)
    return image[y - 3, part], image[y - 1, part], image[y, part], image[y + 1, part], image[y + 3, part]


@njit(**INLINE)
def five_parts(copied: Any) -> Any:
    """Return the same from what `copy_neighbours` made."""
    return (
        copied[0:LENGTH],
        copied[LENGTH : 2 * LENGTH],
        copied[2 * LENGTH : 3 * LENGTH],
        copied[3 * LENGTH : 4 * LENGTH],
        copied[4 * LENGTH : 5 * LENGTH],
    )


@njit(**INLINE)
def take_slopes(s: Any, n: int, phases: Any, states: Any, noise: Any, step: Any) -> None:
    """Take the slopes of n pixels."""
    up3, up, here, down, down3 = phases
    no_up3, no_up, none, no_down, no_down3 = states
    for i in range(n):
        k = i + REACH
        p, sigma = here[k], noise[i]
        right, left, below, above = here[k + 3], here[k - 3], down3[k], up3[k]
        rise_x, rise_y = right - left, below - above
        limit = BENT * (abs(rise_x) + abs(rise_y)) + BENT_SIGMAS * sigma
        all_valid = (none[k] | none[k + 3] | none[k - 3] | no_down3[k] | no_up3[k]) == 0
        smooth = (abs(right + left - TWO * p) <= limit) & (abs(below + above - TWO * p) <= limit)
        r, q, d, u = here[k + 1] - p, p - here[k - 1], down[k] - p, p - up[k]
        wr = ONE if (none[k + 1] == 0) & (abs(r) < step) else ZERO
        wq = ONE if (none[k - 1] == 0) & (abs(q) < step) else ZERO
        wd = ONE if (no_down[k] == 0) & (abs(d) < step) else ZERO
        wu = ONE if (no_up[k] == 0) & (abs(u) < step) else ZERO
        narrow_x = (wr * r + wq * q) * (HALF if wr + wq > ONE else ONE)
        narrow_y = (wd * d + wu * u) * (HALF if wd + wu > ONE else ONE)
        wide = all_valid & smooth
        gx, gy = rise_x * PER_WIDE if wide else narrow_x, rise_y * PER_WIDE if wide else narrow_y
        s[OWN + i], s[SIGMA + i] = p, sigma
        s[GX + i] = gx if none[k] == 0 else ZERO
        s[GY + i] = gy if none[k] == 0 else ZERO


@njit(**INLINE)
def take_quads(s: Any, n: int, phases: Any, states: Any, step: Any) -> None:
    """Say of n pixels what they are together with their right, lower and lower right neighbour."""
    here, down, none, no_down = phases[2], phases[3], states[2], states[3]
    for i in range(n):
        k = i + REACH
        a, b, c, d = here[k], here[k + 1], down[k], down[k + 1]
        spread = max(max(a, b), max(c, d)) - min(min(a, b), min(c, d))  # noqa: PLW3301
        above = (ONE if none[k] == 0 else ZERO) + (ONE if none[k + 1] == 0 else ZERO)
        below = (ONE if no_down[k] == 0 else ZERO) + (ONE if no_down[k + 1] == 0 else ZERO)
        beside = THREE if above + below >= TWO else ZERO
        s[QUAD + i] = (ONE if spread <= step else TWO) if above + below > THREE else beside


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
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    state: Any,  # (H, W) uint8, 0 valid
    step: Any,  # float32, largest phase step between neighbours of one surface
    every: int,  # 1 or 2
    row_start: int,
    row_stop: int,
    pixels: Any,  # out (H, 4 W) float32, records of four: phase, slope in rad/px along x and y, (0, 0) where unknown, and sigma
    quad: Any,  # out (H, W) uint8, of the pixel with its right, lower and lower right neighbour: WHOLE, TORN, BESIDE or 0
    samples: Any,  # out (3, H / every, W / every), rounded up: phase and slopes of every so many pixels in both directions
) -> None:
    """Take slopes as central differences over the widest reach that is one smooth surface: three pixels, one, one to one side.

    A wide reach lowers the noise of a slope; near borders and bends a narrow one keeps it true.
    """
    height, width = phase.shape
    last_edge = (width - EDGE) // EDGE * EDGE
    s, records = stack_float32(SCRATCH), stack_float32(RECORDS)
    copied, missing = stack_float32(NEIGHBOURS), stack_uint8(NEIGHBOURS)
    copied[:] = ZERO
    for y in range(row_start, row_stop):
        first = 0
        while first < width:
            inside = 0 < first < last_edge
            n = min(CHUNK, last_edge - first) if inside else (width - first if first > 0 else min(EDGE, width))
            noise = sigma[y, first : first + n]
            if inside and REACH <= y < height - REACH:
                phases, states = five_rows(phase, y, first, n), five_rows(state, y, first, n)
                take_slopes(s, n, phases, states, noise, step)
                take_quads(s, n, phases, states, step)
            else:
                copy_neighbours(phase, state, y, first, n, copied, missing)
                take_slopes(s, n, five_parts(copied), five_parts(missing), noise, step)
                take_quads(s, n, five_parts(copied), five_parts(missing), step)
            quad_out = quad[y, first : first + n]
            for i in range(n):
                quad_out[i] = np.uint8(np.int32(s[QUAD + i]))
            if y % every == 0:
                write_samples(s, n, every, samples[:, y // every, first // every : (first + n + every - 1) // every])
            write_records(s, records, n, pixels[y, 4 * first : 4 * (first + n)])
            first += n
