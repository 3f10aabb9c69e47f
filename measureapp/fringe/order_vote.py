"""Mending of fringe orders by their neighbourhood, and edges."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PixelState
from measureapp.fringe.kernels import orders
from measureapp.fringe.kernels.records import Maps

CERTAIN = 3.5  # standard deviations by which a rounding residual may miss the order that the window wants


@dataclass(frozen=True, slots=True)
class VoteLimits:
    """What the window may do.

    Attributes
    ----------
    radius : of the window, px; 0: no vote
    edge_step_rad : phase step between neighbours that marks an edge
    gate_cycles : largest rounding residual of an order without support
    amplification : noise of the order decision over that of the absolute phase
    slack_cycles : that a repaired pixel may be off in any case
    range_rad : smallest and largest phase on the projector, origin included
    order_steps_rad : what the absolute phase changes by with the order (`order_steps`)
    """

    radius: int
    edge_step_rad: float
    gate_cycles: float
    amplification: float
    slack_cycles: float
    range_rad: tuple[float, float]
    order_steps_rad: FloatArray


def order_steps(scales: FloatArray, steps: IntArray) -> FloatArray:
    """Return by how much the absolute phase changes when the order changes by -4 … 4, (9,) float32 radians.

    It is not whole periods: the absolute phase is the mean over all pitches, and a wrong order had the other pitches unwrapped to their
    period nearest to it, off by what their periods and those of the finest pitch differ by.

    Parameters
    ----------
    scales : (G,) frequency of every pitch over the finest
    steps : (G,) images of every pitch; pitches are taken to be modulated alike
    """
    shares = steps * scales**2 / (steps * scales**2).sum()
    change = np.arange(-orders.MOST_ORDERS, orders.MOST_ORDERS + 1)
    off = change[:, None] * scales
    return np.asarray(2 * pi * (change - (shares / scales * (off - np.rint(off))).sum(axis=1)), np.float32)


def settle_orders(maps: Maps, shape: tuple[int, int], limits: VoteLimits, memory: BufferPool) -> tuple[int, IntArray]:
    """Let the window decide doubtful orders and mark edges, in place.

    Only pixels in conflict with themselves or whose phase differs from their surroundings are looked at. A pixel changes its
    order only when its own rounding residual allows the new one at 3.5 standard deviations: nothing is invented.

    Returns
    -------
    repaired : how many pixels changed their order
    change : (8,) by how much the number of pixels of every state changed
    """
    phase, sigma, state = (array.reshape(shape) for array in (maps.phase, maps.sigma, maps.state))
    step = min(pi, limits.edge_step_rad) if limits.radius else limits.edge_step_rad
    doubtful = memory.empty(shape, np.uint8)

    def find(start: int, stop: int) -> IntArray:
        orders.find_doubtful(phase, state, np.float32(step), limits.radius, start, stop, doubtful)
        return np.flatnonzero(doubtful[start:stop].view(np.bool_)) + start * shape[1]

    places = np.concatenate(in_bands(find, shape[0]))
    before = np.bincount(maps.state[places], minlength=len(PixelState))
    repaired = 0
    if limits.radius:
        repaired, moved = _vote(places, phase, sigma, state, maps, limits)
        fresh = np.unique(_around(moved, shape))
        fresh = fresh[doubtful.reshape(-1)[fresh] == 0]
        before += np.bincount(maps.state[fresh], minlength=len(PixelState))
        places = np.concatenate([places, fresh])
    edge = np.empty(len(places), np.bool_)
    in_bands(lambda start, stop: orders.find_edges(places, phase, state, np.float32(limits.edge_step_rad), start, stop, edge), len(places))
    maps.state[places[edge]] = PixelState.EDGE
    lost = places[maps.state[places] != PixelState.VALID]
    maps.phase[lost] = 0
    maps.sigma[lost] = 0
    return repaired, np.bincount(maps.state[places], minlength=len(PixelState)) - before


def _vote(
    places: IntArray, phase: np.ndarray, sigma: np.ndarray, state: np.ndarray, maps: Maps, limits: VoteLimits
) -> tuple[int, IntArray]:
    verdicts = np.empty(len(places), np.int8)
    residual = maps.residual.reshape(phase.shape)
    gate, slack = np.float32(limits.gate_cycles), np.float32(limits.slack_cycles)
    allowance = np.float32(CERTAIN * limits.amplification / (2 * pi))
    in_bands(
        lambda start, stop: orders.vote(
            places, phase, sigma, state, residual, gate, allowance, slack, limits.radius, start, stop, verdicts
        ),
        len(places),
    )
    low, high = (np.float32(limit) for limit in limits.range_rad)
    work = in_bands(
        lambda start, stop: orders.apply_verdicts(places, verdicts, limits.order_steps_rad, low, high, start, stop, maps.phase, maps.state),
        len(places),
    )
    return sum(work), places[(verdicts != orders.STANDS) & (verdicts != orders.REFUSED)]


def _around(places: IntArray, shape: tuple[int, int]) -> IntArray:
    """Return the four neighbours of pixels that lie in the image, as flat indices."""
    y, x = np.divmod(places, shape[1])
    inside = [x > 0, x + 1 < shape[1], y > 0, y + 1 < shape[0]]
    offsets = [-1, 1, -shape[1], shape[1]]
    return np.concatenate([places[there] + offset for there, offset in zip(inside, offsets, strict=True)])
