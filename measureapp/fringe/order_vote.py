"""Repair of fringe orders by the vote of their neighbourhood, and edges."""

from __future__ import annotations

from math import pi, tau
from types import ModuleType

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.compiled.selection import use_reference
from measureapp.data.phase import PixelState
from measureapp.fringe.kernels import reference
from measureapp.fringe.kernels.structures import MOST_ORDERS, REFUSED, UNCHANGED, DecodeModel, PixelMaps, VoteLimits
from measureapp.fringe.settings import DecodeSettings

CERTAIN = 3.5  # standard deviations by which a rounding residual may miss the order of the window
GRAY_SLACK_CYCLES = 0.75


def vote_limits(settings: DecodeSettings, model: DecodeModel, steps: IntArray, amplification: float) -> VoteLimits:
    """Return what the window may decide.

    Parameters
    ----------
    steps : (G,) images of every pitch
    amplification : noise of the most delicate order decision over that of one wrapped phase; 0 for a Gray code
    """
    scales, limits, origin = model.pitches.scales.astype(float), model.limits, float(model.origin)
    of_absolute_phase = amplification * float(np.sqrt((scales**2).sum()))
    return VoteLimits(
        radius=settings.vote_radius,
        edge_step=np.float32(settings.edge_step_rad),
        gate=np.float32(limits.gate),
        allowance=np.float32(CERTAIN * of_absolute_phase / tau),
        slack=np.float32(0.0 if amplification else GRAY_SLACK_CYCLES),
        lowest=np.float32((float(limits.lowest) + origin) * tau),
        highest=np.float32((float(limits.highest) + origin) * tau),
        order_steps=order_steps(scales, steps),
    )


def order_steps(scales: FloatArray, steps: IntArray) -> FloatArray:
    """Return by how much the absolute phase changes when the order changes by -4 … 4, (9,) float32 radians.

    It is not whole periods: the absolute phase is the mean over all pitches, and a wrong order had the other pitches unwrapped to their
    period nearest to it, off by the difference of their periods and those of the finest pitch.

    Parameters
    ----------
    scales : (G,) frequency of every pitch over the finest
    steps : (G,) images of every pitch; pitches are assumed to have equal modulation
    """
    shares = steps * scales**2 / (steps * scales**2).sum()
    change = np.arange(-MOST_ORDERS, MOST_ORDERS + 1)
    off = change[:, None] * scales
    return np.asarray(2 * pi * (change - (shares / scales * (off - np.rint(off))).sum(axis=1)), np.float32)


def settle_orders(flat_maps: PixelMaps, shape: tuple[int, int], limits: VoteLimits, memory: BufferPool) -> tuple[int, IntArray]:
    """Let the window decide doubtful orders and mark edges, in place.

    Only pixels in conflict with themselves or whose phase differs from their surroundings are examined. A pixel changes its
    order only when its own rounding residual allows the new one at 3.5 standard deviations: nothing is invented.

    Returns
    -------
    repaired : how many pixels changed their order
    change : (8,) by how much the number of pixels of every state changed
    """
    kernels, maps = _kernels(), PixelMaps(*(each.reshape(shape) for each in flat_maps))
    step = np.float32(min(pi, limits.edge_step)) if limits.radius else limits.edge_step
    doubtful = memory.empty(shape, np.uint8)

    def find(start: int, stop: int) -> IntArray:
        kernels.find_doubtful(maps, step, limits.radius, start, stop, doubtful)
        return np.flatnonzero(doubtful[start:stop].view(np.bool_)) + start * shape[1]

    places = np.concatenate(in_bands(find, shape[0]))
    before = np.bincount(flat_maps.state[places], minlength=len(PixelState))
    repaired = 0
    if limits.radius:
        repaired, moved = _vote(places, maps, limits)
        refused = places[flat_maps.state[places] == PixelState.ORDER_CONFLICT]
        more, also = _vote(refused, maps, limits)  # again: their neighbours have found their orders since
        repaired, moved = repaired + more, np.concatenate([moved, also])
        fresh = np.unique(_neighbours(moved, shape))
        fresh = fresh[doubtful.reshape(-1)[fresh] == 0]
        before += np.bincount(flat_maps.state[fresh], minlength=len(PixelState))
        places = np.concatenate([places, fresh])
    edge = np.empty(len(places), np.bool_)
    in_bands(lambda start, stop: kernels.find_edges(places, maps, limits.edge_step, start, stop, edge), len(places))
    flat_maps.state[places[edge]] = PixelState.EDGE
    masked = places[flat_maps.state[places] != PixelState.VALID]
    flat_maps.phase[masked] = 0
    flat_maps.sigma[masked] = 0
    return repaired, np.bincount(flat_maps.state[places], minlength=len(PixelState)) - before


def _kernels() -> ModuleType:
    if use_reference():
        return reference
    from measureapp.fringe.kernels import vote

    return vote


def _vote(places: IntArray, maps: PixelMaps, limits: VoteLimits) -> tuple[int, IntArray]:
    """Return how many pixels changed their order, and which."""
    kernels, verdicts, count = _kernels(), np.empty(len(places), np.int8), len(places)
    in_bands(lambda start, stop: kernels.vote(places, maps, limits, start, stop, verdicts), count)
    repaired = in_bands(lambda start, stop: kernels.apply_verdicts(places, verdicts, limits, start, stop, maps), count)
    return sum(repaired), places[(verdicts != UNCHANGED) & (verdicts != REFUSED)]


def _neighbours(places: IntArray, shape: tuple[int, int]) -> IntArray:
    """Return the four neighbours of pixels that are inside the image, as flat indices."""
    y, x = np.divmod(places, shape[1])
    inside = [x > 0, x + 1 < shape[1], y > 0, y + 1 < shape[0]]
    offsets = [-1, 1, -shape[1], shape[1]]
    return np.concatenate([places[there] + offset for there, offset in zip(inside, offsets, strict=True)])
