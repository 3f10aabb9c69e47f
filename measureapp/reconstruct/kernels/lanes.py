"""The lanes of a chunk of pixels that `matching` works on: what is taken into them from a row, kept for the next one, and written out."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.cache_hints import prefetch
from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import bitmask, convert, count_trailing_zeros
from measureapp.compiled.simd.memory import load, load_records, store
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.seen import MATCHED, REPEATS

CHUNK = 256  # all lanes stay in the L1 cache; behind the last pixel of a chunk they hold anything but WANTED and HELD
ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
WANTED, HELD, TWICE = np.float32(1), np.float32(MATCHED), np.float32(REPEATS)  # in CODE
NOWHERE = np.float32(-1000.0)
TWO = np.uint32(1)  # as a shift
NOTHING, NONE = np.uint8(0), np.uint32(0)

ROWS_AHEAD = 6  # prefetch distance

# The pixel that is matched, and what was found.
(PHASE, X, Y, DEPTH_SCALE, CODE, DEPTH, GAIN, VARIANCE) = (k * CHUNK for k in range(8))
# Where in the other camera it is looked for now and next, by how much x and y change with u and v there, and one over the area of both.
(U, V, NEXT_U, NEXT_V, A, B, C, D, PER_AREA) = (k * CHUNK for k in range(8, 17))
# What is there: four phases and what they are together, and of the nearest pixel the record and the rectified coordinates.
(P00, P01, P10, P11, QUAD, NEAR_PHASE, NEAR_GX, NEAR_GY, NEAR_SIGMA, NEAR_X, NEAR_Y) = (k * CHUNK for k in range(17, 28))
# What the row above came to: the nearest pixel, its phase, slopes and line, and by how much that changes.
(KEPT_U, KEPT_V, KEPT_PHASE, KEPT_GX, KEPT_GY, KEPT_Y, KEPT_C, KEPT_D) = (k * CHUNK for k in range(28, 36))
SCRATCH = 36 * CHUNK
(PLACE, NEAREST, COLUMN, UNSETTLED) = (k * CHUNK for k in range(4))
PLACES = 3 * CHUNK + CHUNK // PIXELS


@njit(**INLINE)
def in_groups(n: int) -> int:
    """Return n rounded up to whole groups."""
    return (n + PIXELS - 1) // PIXELS * PIXELS


@njit(**INLINE)
def count_wanted(skip: Any, n: int) -> Any:
    """Count those of n pixels that are not skipped."""
    wanted = np.int32(0)
    for i in range(n):
        wanted += skip[i] == 0
    return wanted


@njit(**INLINE)
def prefetch_pixels(phase: Any, lines: Any, rays: Any, skip: Any, start: int, n: int) -> None:
    """Prefetch n pixels from ``start`` on: hardware prefetchers do not follow a walk down the columns."""
    for i in range(0, n, CACHE_LINE_BYTES // 8):
        prefetch(lines, 2 * (start + i))
        prefetch(rays, 2 * (start + i))
    for i in range(0, n, CACHE_LINE_BYTES // 4):
        prefetch(phase, start + i)
    for i in range(0, n, CACHE_LINE_BYTES):
        prefetch(skip, start + i)


@njit(**INLINE)
def take_pixel(s: Any, at: Any, i: int, column: Any, phase: Any, lines: Any, rays: Any, turn: Any) -> None:
    """Take a pixel of a row into the i-th place of the lanes."""
    left, right = column << TWO, (column << TWO) + np.uint32(1)
    s[PHASE + i], s[X + i], s[Y + i] = phase[column], lines[left], lines[right]
    s[DEPTH_SCALE + i] = turn[0] * rays[left] + turn[1] * rays[right] + turn[2]
    at[COLUMN + i] = column


@njit(**INLINE)
def take_all(s: Any, at: Any, n: int, phase: Any, lines: Any, rays: Any, turn: Any, skip: Any) -> None:
    """Take n pixels of a row into the lanes; in CODE which of them are wanted."""
    whole = n - n % PIXELS
    for i in range(0, whole, PIXELS):
        x, y = load_records(lines, 2 * i, PIXELS, 2)
        ray_x, ray_y = load_records(rays, 2 * i, PIXELS, 2)
        store(load(phase, i, PIXELS), s, PHASE + i)
        store(x, s, X + i)
        store(y, s, Y + i)
        store(turn[0] * ray_x + turn[1] * ray_y + turn[2], s, DEPTH_SCALE + i)
        store(convert(load(skip, i, PIXELS) == NOTHING, np.float32), s, CODE + i)
    for i in range(whole, n):
        take_pixel(s, at, i, np.uint32(i), phase, lines, rays, turn)
        s[CODE + i] = WANTED if skip[i] == 0 else ZERO
    end_lanes(s, n)
    for i in range(n):
        at[COLUMN + i] = i


@njit(**INLINE)
def take_wanted(s: Any, at: Any, n: int, phase: Any, lines: Any, rays: Any, turn: Any, skip: Any) -> int:
    """Take those of n pixels of a row that are wanted into the lanes; returns how many they are."""
    wanted = 0
    for i in range(n):
        if skip[i] == 0:
            take_pixel(s, at, wanted, np.uint32(i), phase, lines, rays, turn)
            s[CODE + wanted] = WANTED
            wanted += 1
    end_lanes(s, wanted)
    return wanted


@njit(**INLINE)
def end_lanes(s: Any, n: int) -> None:
    """Let nothing be done with what lies behind the n-th pixel in its group."""
    for i in range(n, in_groups(n)):
        s[CODE + i] = ZERO


@njit(**INLINE)
def forget(s: Any) -> None:
    """Keep nothing of the row above."""
    for i in range(CHUNK):
        s[KEPT_U + i] = NOWHERE


class Found(NamedTuple):
    """What is found in another camera, of pixels (rows, columns) or of some in a row."""

    depth: Any  # float32, z in the camera's frame, 0 for none
    gain: Any  # float32, change of the other camera's phase with z, rad/mm
    variance: Any  # float32, of the other camera's phase
    there: Any  # int32, index of the other camera's pixel
    reason: Any  # uint8, MATCHED | WITHOUT_PARTNER | REPEATS


@njit(**INLINE)
def some_of(found: Found, row: int, first: int, n: int) -> Found:
    """Return the part for n pixels of a row from ``first`` on."""
    into = slice(first, first + n)
    return Found(found.depth[row, into], found.gain[row, into], found.variance[row, into], found.there[row, into], found.reason[row, into])


@njit(**INLINE)
def mark_unsettled(s: Any, at: Any, i: int, unsettled: Any, next_u: Any, next_v: Any) -> None:
    """Note which of a group need another step, and from where."""
    store(next_u, s, NEXT_U + i)
    store(next_v, s, NEXT_V + i)
    at[UNSETTLED + i // PIXELS] = bitmask(unsettled)


@njit(**INLINE)
def write_group(at: Any, i: int, depth: Any, gain: Any, variance: Any, code: Any, out: Found) -> None:
    """Write what was found of a group of pixels that lie side by side in the row."""
    store(depth, out.depth, i)
    store(gain, out.gain, i)
    store(variance, out.variance, i)
    store(load(at, NEAREST + i, PIXELS), out.there, i)
    store(convert(code, np.uint8), out.reason, i)


@njit(**INLINE)
def write_listed(s: Any, at: Any, i: int, n: int, depth: Any, gain: Any, variance: Any, code: Any, out: Found) -> None:
    """Write what was found of a group of pixels, each to its own column."""
    store(depth, s, DEPTH + i)
    store(gain, s, GAIN + i)
    store(variance, s, VARIANCE + i)
    store(code, s, CODE + i)
    for number in range(i, min(i + PIXELS, n)):
        k = np.uint32(number)
        column = np.uint32(at[COLUMN + k])
        out.depth[column], out.gain[column], out.variance[column] = s[DEPTH + k], s[GAIN + k], s[VARIANCE + k]
        out.there[column] = at[NEAREST + k]
        out.reason[column] = np.uint8(np.int32(s[CODE + k]))


@njit(**INLINE)
def keep_unsettled(s: Any, at: Any, n: int) -> int:
    """Move those of n pixels that need another step to the front of the lanes; returns how many they are."""
    left = 0
    for i in range(0, n, PIXELS):
        bits = np.uint32(at[UNSETTLED + i // PIXELS])
        while bits != NONE:
            # Unsigned, or numba would wrap negative indices to the end of the array.
            k, m = np.uint32(i + count_trailing_zeros(bits)), np.uint32(left)
            s[PHASE + m], s[X + m], s[Y + m], s[DEPTH_SCALE + m] = s[PHASE + k], s[X + k], s[Y + k], s[DEPTH_SCALE + k]
            s[U + m], s[V + m], s[CODE + m] = s[NEXT_U + k], s[NEXT_V + k], HELD
            at[COLUMN + m] = at[COLUMN + k]
            left += 1
            bits &= bits - np.uint32(1)
    end_lanes(s, left)
    return left
