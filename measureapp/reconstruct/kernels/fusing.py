"""Compiled loops that decide about pixels whose candidates all cameras look at: which one they agree on, and the depth they give together."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.looking import hidden, see
from measureapp.reconstruct.kernels.seen import BLANK, REPEATS, SEEN

VALID, NO_PHASE, UNMATCHED, AMBIGUOUS, CONTRADICTED = (
    np.uint8(state)
    for state in (PointState.VALID, PointState.NO_PHASE, PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED)
)
BOTH, NONE = np.uint8(3), np.uint8(0)
ZERO = np.float32(0)
EXCESS, ALONG, GAIN, NOISE, HERE, LINE = range(6)  # what is known of a candidate as another camera sees it
BLOCK = 64  # pixels of a row that are looked at together for one that is still open


@njit(**INLINE)
def cover(z: Any, there: Any, covered: Any) -> None:
    """Note which pixels of another camera take part in the points of a row."""
    for x in range(len(z)):
        if z[x] > ZERO:
            covered[np.uint32(there[x])] = 1


@njit(**INLINE)
def take_over(z: Any, skip: Any, there: Any, fate: Any, bits: Any, covered: Any) -> None:
    """Write fate and cameras of the pixels of a row that `fuse_both` solved, and which pixels of both other cameras take part."""
    for x in range(len(z)):
        fate[x] = skip[x]
    solved = np.int32(0)
    for x in range(len(z)):
        solved += z[x] > ZERO
    for x in range(len(z)):
        bits[x] = BOTH if z[x] > ZERO else NONE
    if solved > 0:
        for k in range(len(covered)):
            cover(z, there[k], covered[k])


@njit(**INLINE)
def choose_single(z: Any, z_sigma: Any, bits: Any, skip: Any, sampled: Any, every: Any, column: int, singly: Any) -> int:
    """List the pixels of a row that are fused one by one: those not solved yet, and samples of all others; returns how many."""
    left = 0
    for first in range(0, len(z), BLOCK):
        z_part, skip_part = z[first : first + BLOCK], skip[first : first + BLOCK]
        some = sampled
        for i in range(len(z_part)):
            some |= (skip_part[i] == 0) & (z_part[i] == ZERO)
        if not some:
            continue
        for x in range(first, min(first + BLOCK, len(z))):
            if skip[x] == 0 and (z[x] == ZERO or (sampled and (column + x) % every == 0)):
                singly[left] = x
                left += 1
                z[x] = 0
                z_sigma[x] = 0
                bits[x] = 0
    return left


@njit(**INLINE)
def look_with_all(
    singly: Any, left: Any, rays: Any, phase: Any, depth: Any, gain: Any, variance: Any, others: Any, sights: Any, seen: Any
) -> None:
    """Look at every candidate of the chosen pixels of a row with every other camera; a candidate's own camera sees what it matched."""
    for c in range(len(others)):
        other = others[c]
        for k in range(len(others)):
            for i in range(left):
                x = singly[i]
                sights[k, c, i] = BLANK
                if depth[k, x] <= 0:
                    continue
                if c == k:
                    sights[k, c, i] = SEEN
                    seen[EXCESS, k, c, i], seen[GAIN, k, c, i], seen[NOISE, k, c, i] = 0.0, gain[k, x], variance[k, x]
                    continue
                sight, over, along, rise, noise, here, _there, line = see(phase[x], rays[x, 0], rays[x, 1], depth[k, x], other)
                sights[k, c, i] = sight
                seen[EXCESS, k, c, i], seen[ALONG, k, c, i], seen[GAIN, k, c, i] = over, along, rise
                seen[NOISE, k, c, i], seen[HERE, k, c, i], seen[LINE, k, c, i] = noise, here, line


@njit(**INLINE)
def spread_of(seen: Any, k: Any, c: Any, i: Any, own: Any) -> Any:
    """Return the variance of what camera c sees in excess at the candidate of camera k, which has the noise of both phases in it."""
    ratio = seen[GAIN, k, c, i] / seen[GAIN, k, k, i]
    return seen[NOISE, k, c, i] + own * (ratio - 1) ** 2 + seen[NOISE, k, k, i] * ratio**2


@njit(**INLINE)
def best_candidate(i: Any, phase: Any, own: Any, sights: Any, seen: Any, tables: Any, limits: Any, agrees: Any) -> int:
    """Return the candidate that most cameras agree with and none contradicts, −1 for none; ``agrees`` (M, M): who agrees with which."""
    count = len(tables)
    sigmas, tolerance_px = limits
    best, best_support = -1, 0
    for k in range(count):
        if sights[k, k, i] != SEEN:
            continue
        support = 0
        for c in range(count):
            agrees[k, c] = c == k
            support += c == k
            if c == k or sights[k, c, i] != SEEN:
                continue
            excess, slope = seen[EXCESS, k, c, i], seen[ALONG, k, c, i]
            if abs(excess) <= sigmas * np.sqrt(spread_of(seen, k, c, i, own)) + tolerance_px * abs(slope):
                support += 1
                agrees[k, c] = True
            elif not hidden(phase + excess, seen[HERE, k, c, i], seen[LINE, k, c, i], *tables[c]):
                support = -100
        if support > best_support:
            best_support = support
            best = k
    return best


@njit(**INLINE)
def note_shifts(i: Any, own: Any, sights: Any, seen: Any, shifts: Any, row: Any, column: Any) -> None:
    """Note where other cameras see the phases of the candidates, in px along the epipolar line, and the variance of it."""
    count = len(shifts)
    for k in range(count):
        for c in range(count):
            if c == k or sights[k, c, i] != SEEN:
                continue
            slope = seen[ALONG, k, c, i]
            shifts[k, row, column, 0] = seen[EXCESS, k, c, i] / slope
            shifts[k, row, column, 1] = spread_of(seen, k, c, i, own) / slope**2


@njit(**INLINE)
def why_none(i: Any, x: Any, sights: Any, reason: Any) -> Any:
    """Return the fate of a pixel without a candidate that is left."""
    fate = UNMATCHED
    for k in range(len(reason)):
        if reason[k, x] == REPEATS:
            fate = AMBIGUOUS
    for k in range(len(reason)):
        if sights[k, k, i] == SEEN:
            fate = CONTRADICTED
    return fate


@njit(**INLINE)
def solve(i: Any, own: Any, agrees: Any, best: Any, seen: Any) -> Any:
    """Return what to add to the depth of a candidate, its standard deviation (0 where there is no solution) and the cameras in it."""
    zz, zd, dd = 0.0, 0.0, 1.0 / (own + 1e-20)
    rz, rd = 0.0, 0.0
    taking = 0
    for c in range(len(agrees)):
        if not agrees[best, c]:
            continue
        excess, gain = seen[EXCESS, best, c, i], seen[GAIN, best, c, i]
        weight = 1.0 / (seen[NOISE, best, c, i] + 1e-20)
        zz += weight * gain * gain
        zd -= weight * gain
        dd += weight
        rz -= weight * gain * excess
        rd += weight * excess
        taking |= 1 << c
    determinant = zz * dd - zd * zd
    if determinant <= 0:
        return 0.0, 0.0, taking
    return (rz * dd - zd * rd) / determinant, np.sqrt(dd / determinant), taking


@njit(**ALLOCATING_LOOP)
def fuse(
    rays: Any,
    phase: Any,
    sigma: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to fuse, else their fate
    found: Any,  # what `match` found, (M, rows, columns) each, one per other camera: depth, gain, variance, there, reason
    others: Any,  # per other camera: what `see` needs of it
    tables: Any,  # per other camera: (table of this camera, its lines, its frame, lowest, per_rad)
    limits: Any,  # (standard deviations, px along the epipolar line) that cameras may differ
    sample: int,  # every so many pixels the shifts between the cameras are noted
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
    z: Any,  # in and out (H, W) float32, what `fuse_both` made, else 0
    z_sigma: Any,  # in and out (H, W) float32
    bits: Any,  # out (H, W) uint8, bit i: camera i of the others takes part
    fate: Any,  # out (H, W) uint8 of PointState
    pair_gain: Any,  # out (H, W) float32 with one other camera: change of its phase with z, rad/mm; (0, 0) with more
    covered: Any,  # out per other camera (H · W,) uint8, 1 for its pixels that take part
    shifts: Any,  # out (M, rows of samples, columns of samples, 2) float32, shift in the others in px and its variance; 0, 0 for none
) -> None:
    """Choose the candidate no camera contradicts and most agree with; the depth is the least-squares solution of all that agree.

    Unknowns are z and the projector's true phase; one equation per camera.
    """
    depth, gain, variance, there, reason = found
    count, columns = len(others), column_stop - column_start
    agrees = np.zeros((count, count), np.bool_)
    singly = np.zeros(columns, np.int32)
    sights, seen = np.zeros((count, count, columns), np.uint8), np.zeros((6, count, count, columns))
    part = slice(column_start, column_stop)
    for y in range(row_start, row_stop):
        row = y - row_start
        take_over(z[y, part], skip[y, part], there[:, row], fate[y, part], bits[y, part], covered)
        sampled = y % sample == 0
        left = choose_single(z[y, part], z_sigma[y, part], bits[y, part], skip[y, part], sampled, sample, column_start, singly)
        look_with_all(singly, left, rays[y, part], phase[y, part], depth[:, row], gain[:, row], variance[:, row], others, sights, seen)
        for i in range(left):
            at, x = singly[i], column_start + singly[i]
            own = sigma[y, x] * sigma[y, x]
            if sampled and x % sample == 0:
                note_shifts(i, own, sights, seen, shifts, y // sample, x // sample)
            best = best_candidate(i, phase[y, x], own, sights, seen, tables, limits, agrees)
            if best < 0:
                fate[y, x] = why_none(i, at, sights, reason[:, row])
                continue
            step, deviation, taking = solve(i, own, agrees, best, seen)
            for c in range(count):
                if agrees[best, c] and depth[c, row, at] > 0:
                    covered[c][there[c, row, at]] = 1
            if deviation <= 0:
                fate[y, x] = AMBIGUOUS
                continue
            z[y, x] = depth[best, row, at] + step
            z_sigma[y, x] = deviation
            bits[y, x] = taking
            fate[y, x] = VALID
            if count == 1:
                pair_gain[y, x] = seen[GAIN, 0, 0, i]
