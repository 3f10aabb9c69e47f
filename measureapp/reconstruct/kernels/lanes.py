"""The lanes of a chunk of pixels that `matching` works on: what is taken into them from a row, kept for the next one, and written out."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.machine_memory import will_read
from measureapp.map_memory import LINE as CACHE_LINE
from measureapp.reconstruct.kernels.options import INLINE
from measureapp.reconstruct.kernels.scratch import GROUP, equal_bits, lowest_bit
from measureapp.reconstruct.kernels.seen import MATCHED

CHUNK = 256  # all lanes stay in the first cache of a processor
ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
HELD = np.float32(MATCHED)
LOST = np.float32(100.0)
NOWHERE = np.float32(-1000.0)
TWO = np.uint32(1)  # as a shift
NOTHING = np.uint32(0)

(PHASE, X, Y, DEPTH_SCALE, U, V, QUAD, LEFT, NOISE, Z, GAIN, NEXT_U, NEXT_V, CODE, KEPT_U, KEPT_V) = (k * CHUNK for k in range(16))
SCRATCH = 16 * CHUNK
(PLACE, NEAREST, COLUMN, SOME) = (k * CHUNK for k in range(4))
PLACES = 4 * CHUNK


@njit(**INLINE)
def in_groups(n: int) -> int:
    """Return n rounded up to whole groups: arithmetic on what lies behind the n-th pixel does no harm, and leaves nothing to single steps."""
    return (n + GROUP - 1) // GROUP * GROUP


@njit(**INLINE)
def count_wanted(skip: Any, n: int) -> Any:
    """Count those of n pixels that are not skipped."""
    wanted = np.int32(0)
    for i in range(n):
        wanted += skip[i] == 0
    return wanted


@njit(**INLINE)
def ask_for(phase: Any, lines: Any, rays: Any, skip: Any, start: int, n: int) -> None:
    """Ask for n pixels from ``start`` on: down the columns every row lies elsewhere, which the processor's own prediction does not follow."""
    for i in range(0, n, CACHE_LINE // 8):
        will_read(lines, 2 * (start + i))
        will_read(rays, 2 * (start + i))
    for i in range(0, n, CACHE_LINE // 4):
        will_read(phase, start + i)
    for i in range(0, n, CACHE_LINE):
        will_read(skip, start + i)


@njit(**INLINE)
def load(s: Any, n: int, phase: Any, lines: Any, rays: Any, turn: Any, skip: Any) -> None:
    """Take n pixels of a row into the scratch array; in CODE which of them are wanted."""
    t0, t1, t2 = turn
    for i in range(n):
        s[CODE + i] = ONE if skip[i] == 0 else ZERO
    for i in range(n):
        s[PHASE + i] = phase[i]
    for i in range(n):
        s[X + i] = lines[2 * i]
        s[Y + i] = lines[2 * i + 1]
    for i in range(n):
        s[DEPTH_SCALE + i] = t0 * rays[2 * i] + t1 * rays[2 * i + 1] + t2


@njit(**INLINE)
def list_wanted(at: Any, n: int, skip: Any) -> int:
    """List those of n pixels that are wanted; returns how many they are."""
    wanted = 0
    for i in range(n):
        at[COLUMN + wanted] = i
        wanted += skip[i] == 0
    return wanted


@njit(**INLINE)
def load_listed(s: Any, at: Any, n: int, phase: Any, lines: Any, rays: Any, turn: Any) -> None:
    """Take the n pixels of a row that are listed into the scratch array."""
    t0, t1, t2 = turn
    for i in range(n):
        k = np.uint32(at[COLUMN + i])
        left, right = k << TWO, (k << TWO) + np.uint32(1)
        s[PHASE + i], s[X + i], s[Y + i] = phase[k], lines[left], lines[right]
        s[DEPTH_SCALE + i] = t0 * rays[left] + t1 * rays[right] + t2
        s[CODE + i] = ONE


@njit(**INLINE)
def forget(s: Any) -> None:
    """Keep nothing of the row above."""
    for i in range(CHUNK):
        s[KEPT_U + i] = NOWHERE


@njit(**INLINE)
def keep_nearest(s: Any, n: int) -> None:
    """Keep where the pixels nearest to the matches are, whose records stay where they are: the next row's matches lie beside them."""
    for i in range(in_groups(n)):
        s[KEPT_U + i] = np.float32(np.int32(s[U + i] + HALF)) if s[LEFT + i] < LOST else NOWHERE
        s[KEPT_V + i] = np.float32(np.int32(s[V + i] + HALF))


@njit(**INLINE)
def list_marked(s: Any, at: Any, n: int) -> int:
    """List those of n pixels that are marked by LEFT; returns how many they are."""
    listed = 0
    for i in range(0, n, GROUP):
        bits = equal_bits(s, np.uint32(LEFT + i), ONE)
        if n - i < GROUP:
            bits &= np.uint32((1 << (n - i)) - 1)
        while bits != NOTHING:
            at[SOME + listed] = i + np.int32(lowest_bit(bits))
            listed += 1
            bits &= bits - np.uint32(1)
    return listed


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
def store_all(s: Any, at: Any, n: int, found: Found) -> None:
    """Write what the first step found of all n pixels."""
    depth, gain, variance, there, reason = found
    for i in range(n):
        depth[i] = s[Z + i]
    for i in range(n):
        gain[i] = s[GAIN + i]
    for i in range(n):
        variance[i] = s[NOISE + i]
    for i in range(n):
        there[i] = at[NEAREST + i]
    for i in range(n):
        reason[i] = np.uint8(np.int32(s[CODE + i]))
    for i in range(n):
        at[COLUMN + i] = i


@njit(**INLINE)
def store_some(s: Any, at: Any, n: int, found: Found) -> None:
    """Write what a later step found of those that had not settled."""
    depth, gain, variance, there, reason = found
    for i in range(n):
        k = np.uint32(at[COLUMN + i])
        depth[k], gain[k], variance[k] = s[Z + i], s[GAIN + i], s[NOISE + i]
        there[k] = at[NEAREST + i]
        reason[k] = np.uint8(np.int32(s[CODE + i]))


@njit(**INLINE)
def keep_unsettled(s: Any, at: Any, n: int) -> int:
    """Move pixels that need another step to the front; returns how many they are."""
    left = list_marked(s, at, n)
    for i in range(left):
        k = np.uint32(at[SOME + i])
        at[COLUMN + i] = at[COLUMN + k]
        s[PHASE + i], s[X + i], s[Y + i], s[DEPTH_SCALE + i] = s[PHASE + k], s[X + k], s[Y + k], s[DEPTH_SCALE + k]
        s[U + i], s[V + i], s[CODE + i] = s[NEXT_U + k], s[NEXT_V + k], HELD
    return left


@njit(**INLINE)
def count_matched(reason: Any) -> Any:
    """Count the matched pixels of a row."""
    found = np.int32(0)
    for x in range(len(reason)):
        found += reason[x] == MATCHED
    return found
