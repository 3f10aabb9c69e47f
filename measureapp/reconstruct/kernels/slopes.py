"""Compiled loop over a phase map: how the phase changes from pixel to pixel, and between which pixels it can be interpolated.

Loops over arithmetic alone run on one scratch array at constant offsets: only then does the compiler know that nothing overlaps,
and uses SIMD instructions.
"""
# One loop over pixels, as in the other kernels.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.map_memory import LINE
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.scratch import GROUP, join_4, join_4_past_caches, stack_float32

CHUNK, PAD = 512, 16  # all lanes stay in the first cache of a processor
LENGTH = CHUNK + 2 * PAD
REACH = 3  # pixels to either side over which a slope is taken
ROWS = (-3, -1, 0, 1, 3)
P_UP3, P_UP, P, P_DOWN, P_DOWN3 = (k * LENGTH + PAD for k in range(5))
M_UP3, M_UP, M, M_DOWN, M_DOWN3 = (k * LENGTH + PAD for k in range(5, 10))
OWN, GX, GY, SIGMA, QUAD = (k * LENGTH + PAD for k in range(10, 15))  # the first four make a record
SCRATCH = 15 * LENGTH
RECORDS = 4 * CHUNK
PHASE, SLOPE_X, SLOPE_Y, OWN_SIGMA = range(4)  # in the record of a pixel
ZERO, HALF, ONE, TWO, THREE = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2), np.float32(3)
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
            join_4_past_caches(out, np.uint32(4 * i), s, np.uint32(OWN + i), np.uint32(LENGTH))
    for i in range(done, n, GROUP):
        join_4(records, np.uint32(4 * i), s, np.uint32(OWN + i), np.uint32(LENGTH))
    for i in range(4 * done, 4 * n):
        out[i] = records[i]


@njit(**INLINE)
def load(s: Any, phase: Any, state: Any, y: int, first: int, n: int) -> None:
    """Load n pixels of a row, with those around them: phases, and 1 where there is one."""
    height, width = phase.shape
    low = min(PAD, first)
    high = min(PAD, width - first - n)
    for k in range(5):
        v = y + ROWS[k]
        p_row = k * LENGTH + PAD
        m_row = p_row + 5 * LENGTH
        mask = s[m_row - PAD : m_row + n + PAD]
        for i in range(n + 2 * PAD):
            mask[i] = ZERO
        if 0 <= v < height:
            length = low + n + high
            p_in, m_in = phase[v, first - low : first + n + high], state[v, first - low : first + n + high]
            p_out, m_out = s[p_row - low : p_row + n + high], s[m_row - low : m_row + n + high]
            for i in range(length):
                p_out[i] = p_in[i]
            for i in range(length):
                m_out[i] = ONE if m_in[i] == 0 else ZERO


@njit(**INLINE)
def take_slopes(s: Any, step: Any, n: int) -> None:
    """Take the slopes of n pixels: over three pixels to either side where that is one smooth surface, else over those next to it."""
    for i in range(n):
        p = s[P + i]
        right, left, down, up = s[P + i + 3], s[P + i - 3], s[P_DOWN3 + i], s[P_UP3 + i]
        rise_x, rise_y = right - left, down - up
        limit = BENT * (abs(rise_x) + abs(rise_y)) + BENT_SIGMAS * s[SIGMA + i]
        all_valid = s[M + i] * s[M + i + 3] * s[M + i - 3] * s[M_DOWN3 + i] * s[M_UP3 + i] > ZERO
        smooth = (abs(right + left - TWO * p) <= limit) & (abs(down + up - TWO * p) <= limit)
        r = s[P + i + 1] - p
        q = p - s[P + i - 1]
        d = s[P_DOWN + i] - p
        u = p - s[P_UP + i]
        wr = s[M + i + 1] if abs(r) < step else ZERO
        wq = s[M + i - 1] if abs(q) < step else ZERO
        wd = s[M_DOWN + i] if abs(d) < step else ZERO
        wu = s[M_UP + i] if abs(u) < step else ZERO
        narrow_x = (wr * r + wq * q) * (HALF if wr + wq > ONE else ONE)
        narrow_y = (wd * d + wu * u) * (HALF if wd + wu > ONE else ONE)
        wide = all_valid & smooth
        s[OWN + i] = p
        s[GX + i] = s[M + i] * (rise_x * PER_WIDE if wide else narrow_x)
        s[GY + i] = s[M + i] * (rise_y * PER_WIDE if wide else narrow_y)


@njit(**INLINE)
def tell_quads(s: Any, step: Any, n: int) -> None:
    """Tell between which four pixels the phase can be interpolated: WHOLE, TORN, BESIDE or 0."""
    for i in range(n):
        a, b, c, d = s[P + i], s[P + i + 1], s[P_DOWN + i], s[P_DOWN + i + 1]
        whole = s[M + i] * s[M + i + 1] * s[M_DOWN + i] * s[M_DOWN + i + 1]
        spread = max(max(a, b), max(c, d)) - min(min(a, b), min(c, d))  # noqa: PLW3301
        valid = s[M + i] + s[M + i + 1] + s[M_DOWN + i] + s[M_DOWN + i + 1]
        beside = THREE if valid >= TWO else ZERO
        s[QUAD + i] = (ONE if spread <= step else TWO) if whole > ZERO else beside


@njit(**LOOP)
def slopes(
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    state: Any,  # (H, W) uint8, 0 valid
    step: Any,  # float32, largest phase step between neighbours of one surface
    row_start: int,
    row_stop: int,
    pixels: Any,  # out (H, 4 W) float32, records of four: phase, slope in rad/px along x and y, (0, 0) where unknown, and sigma
    quad: Any,  # out (H, W) uint8, of the pixel with its right, lower and lower right neighbour: WHOLE, TORN, BESIDE or 0
) -> None:
    """Take slopes as central differences over the widest reach that is one smooth surface: three pixels, one, one to one side.

    A wide reach lowers the noise of a slope; near borders and bends a narrow one keeps it true.
    """
    width = phase.shape[1]
    s, records = stack_float32(SCRATCH), stack_float32(RECORDS)
    s[:] = ZERO
    for y in range(row_start, row_stop):
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            load(s, phase, state, y, first, n)
            noise = sigma[y, first : first + n]
            for i in range(n):
                s[SIGMA + i] = noise[i]
            take_slopes(s, step, n)
            tell_quads(s, step, n)
            quad_out = quad[y, first : first + n]
            for i in range(n):
                quad_out[i] = np.uint8(np.int32(s[QUAD + i]))
            write_records(s, records, n, pixels[y, 4 * first : 4 * (first + n)])
