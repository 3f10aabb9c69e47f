"""Plans of temporal unwrapping: heterodyne of any number of pitches, hierarchical sets included."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, pairwise, product
from math import comb, pi

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.fringe import PatternSet
from measureapp.errors import DecodeError

BEAT_TOLERANCE = 1e-6
LEAST_GUARD = 1 / 64  # of the projector, by which the coarsest period should exceed it, so that noise does not turn one edge into the other
PRICE_OF_GUARD = 1.25  # how much noisier the worst decision may become for it
SURE = 4.5  # standard deviations that half a period must be worth
PLURALITY = 0.7  # standard deviations that half a period must be worth for a vote: about half of the neighbours then have the right order
MOST_PITCHES = 24
MOST_STATIONS = 1000


@dataclass(frozen=True, slots=True)
class HeterodynePlan:
    """Chain of combinations of the wrapped phases to unwrap: from one period over the projector to the finest pitch."""

    combinations: tuple[tuple[int, ...], ...]  # integer factors of the groups' phases
    frequencies: tuple[float, ...]  # periods over the projector
    noise: tuple[float, ...]  # of each order decision over that of one wrapped phase; 0 for the first

    @property
    def amplification(self) -> float:
        """Noise of the most delicate order decision over the noise of one wrapped phase."""
        return max(self.noise)

    @property
    def sure_sigma_rad(self) -> float:
        """Noise of a wrapped phase up to which an order is wrong less than once in a hundred thousand pixels, by P = erfc(4.5 / √2)."""
        return pi / (SURE * self.amplification)

    def settled_sigma_rad(self, *, votes: bool) -> float:
        """Noise of a wrapped phase up to which an order is sure, or most neighbours have the right one, so that their vote settles it."""
        return pi / (PLURALITY * self.amplification) if votes else self.sure_sigma_rad

    @property
    def worst(self) -> int:
        """Index of the most delicate order decision."""
        return int(np.argmax(self.noise))

    @property
    def guard(self) -> float:
        """Half of the share of the coarsest period that is beyond the projector."""
        return max(0.0, (1.0 - self.frequencies[0]) / 2)

    @property
    def decision_weights(self) -> FloatArray:
        """Weights of the wrapped phases in each order decision, (K, G): F_v/F_u · u − v; for the first the coarsest combination itself."""
        factors, frequencies = np.array(self.combinations, float), np.array(self.frequencies)
        later = (frequencies[1:] / frequencies[:-1])[:, None] * factors[:-1] - factors[1:]
        return np.concatenate([factors[:1], later])


def extent_px(patterns: PatternSet) -> int:
    """Return the range of a set with fringes of one direction: the projector's columns, or its rows."""
    return (patterns.projector_rows if patterns.directions == ("horizontal",) else None) or patterns.projector_px


@lru_cache(maxsize=32)
def plan_heterodyne(patterns: PatternSet) -> HeterodynePlan:
    """Find the chain of combinations whose noisiest order decision is the least noisy.

    Sums and differences of the phases are the stations; one whose beat covers the projector can start (with a guard band, where that
    does not make the decisions much noisier), and an order
    decision from u to v has the noise |F_v/F_u · u − v|: 46 for the pitches 32 and 33, √5 where each pitch is half of the one
    before [1]_. With up to four pitches the factors reach ±2; with more, combinations are restricted so that their number stays
    below a thousand. Among the chains that are best by their noisiest decision, the one with the least sum of squares is chosen.

    Parameters
    ----------
    patterns : fringes of one direction (`PatternSet.along`)

    Raises
    ------
    DecodeError
        No combination's beat covers the projector, or there are more than 24 pitches.

    References
    ----------
    .. [1] C. Zuo et al., Temporal phase unwrapping algorithms for fringe projection profilometry, Optics and Lasers in
       Engineering 85, 84-103, 2016.
    """
    frequencies = extent_px(patterns) / np.array(patterns.pitches_px)
    stations = _stations(frequencies)
    beats = stations @ frequencies
    if beats[0] > 1 + BEAT_TOLERANCE:
        raise _undetermined_error(patterns, float(beats[0]))
    goal = np.arange(len(frequencies)) == int(np.argmax(frequencies))
    chain = _guarded_chain(_decision_noise(stations, beats), beats, int(np.flatnonzero((stations == goal).all(axis=1))[0]))
    plan = HeterodynePlan(
        tuple(tuple(int(factor) for factor in stations[i]) for i in chain), tuple(float(beats[i]) for i in chain), (0.0,) * len(chain)
    )
    noise = np.linalg.norm(plan.decision_weights[1:], axis=1)
    return HeterodynePlan(plan.combinations, plan.frequencies, (0.0, *(float(value) for value in noise)))


def _stations(frequencies: FloatArray) -> FloatArray:
    """Return the combinations (S, G) with a positive beat, from the lowest beat frequency to the highest."""
    groups = len(frequencies)
    if groups > MOST_PITCHES:
        raise DecodeError(f"{groups} pitches are more than {MOST_PITCHES}.", "Remove pitches: three are enough for any projector.")
    choices = [(2, groups), (2, 3), (1, 3), (2, 2), (1, 2)]  # largest factor, how many phases are combined
    largest, members = next((choice for choice in choices if _count(groups, *choice) <= MOST_STATIONS), choices[-1])
    factors = [factor for factor in range(-largest, largest + 1) if factor]
    every = []
    for size in range(1, min(members, groups) + 1):
        for chosen in combinations(range(groups), size):
            block = np.zeros((len(factors) ** size, groups))
            block[:, chosen] = list(product(factors, repeat=size))
            every.append(block)
    stations = np.concatenate(every)
    beats = stations @ frequencies
    ascending = np.argsort(beats, kind="stable")
    return stations[ascending[beats[ascending] > 1e-3]]


def _count(groups: int, largest: int, members: int) -> int:
    return sum(comb(groups, size) * (2 * largest) ** size for size in range(1, min(members, groups) + 1))


def _decision_noise(stations: FloatArray, beats: FloatArray) -> FloatArray:
    """Return |F_v/F_u · u − v| for all stations u (rows) and v (columns), infinite unless v is finer."""
    ratio = beats[None, :] / beats[:, None]
    squares = (stations**2).sum(axis=1)
    noise = np.sqrt(np.maximum(ratio**2 * squares[:, None] - 2 * ratio * (stations @ stations.T) + squares[None, :], 0.0))
    noise[ratio <= 1 + BEAT_TOLERANCE] = np.inf
    return np.asarray(noise)


def _guarded_chain(noise: FloatArray, beats: FloatArray, goal: int) -> list[int]:
    """Return the quietest chain, or one that starts with a guard band if that costs little."""
    quietest = _quietest_chain(noise, beats, beats <= 1 + BEAT_TOLERANCE, goal)
    guarded = beats <= 1 / (1 + LEAST_GUARD) + BEAT_TOLERANCE
    if guarded[quietest[0]] or not guarded.any():
        return quietest
    chain = _quietest_chain(noise, beats, guarded, goal)
    return chain if _worst(noise, chain) <= PRICE_OF_GUARD * _worst(noise, quietest) else quietest


def _worst(noise: FloatArray, chain: list[int]) -> float:
    return max((float(noise[u, v]) for u, v in pairwise(chain)), default=0.0)


def _quietest_chain(noise: FloatArray, beats: FloatArray, starts: BoolArray, goal: int) -> list[int]:
    """Return the stations from a start to the goal: least noisiest decision first, then least sum of squares.

    Stations are sorted by frequency and decisions lead upwards only, so one pass over them is Dijkstra's search.
    """
    worst = np.where(starts, 0.0, np.inf)
    for v in range(1, goal + 1):
        worst[v] = min(worst[v], float(np.maximum(worst[:v], noise[:v, v]).min()))
    allowed = noise <= worst[goal] * (1 + 1e-9)
    total = np.where(starts, 1e-6 * np.arange(len(beats)), np.inf)  # of equal chains the one that starts from the longest beat
    before = np.full(len(beats), -1)
    for v in range(1, goal + 1):
        cost = np.where(allowed[:v, v], total[:v] + noise[:v, v] ** 2, np.inf)
        u = int(np.argmin(cost))
        if cost[u] < total[v]:
            total[v], before[v] = cost[u], u
    chain = [goal]
    while before[chain[-1]] >= 0:
        chain.append(int(before[chain[-1]]))
    return chain[::-1]


def _undetermined_error(patterns: PatternSet, lowest: float) -> DecodeError:
    pitches = ", ".join(f"{pitch:g}" for pitch in patterns.pitches_px)
    extent = extent_px(patterns)
    lines = "rows" if patterns.directions == ("horizontal",) else "columns"
    if len(patterns.pitches_px) == 1:
        return DecodeError(
            f"A single pitch of {pitches} px repeats over the {extent} {lines} of the projector.",
            "Add a second pitch or a Gray code that numbers the periods.",
        )
    return DecodeError(
        f"The beat of the pitches {pitches} px is {extent / lowest:.0f} px, shorter than the {extent} {lines} of the projector.",
        "Choose pitches closer to each other, add a third pitch or a Gray code.",
    )
