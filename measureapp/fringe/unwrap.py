"""From wrapped phases to the absolute phase: heterodyne of any number of pitches, Gray code, complementary Gray code."""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from itertools import pairwise, product

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import PatternSet
from measureapp.errors import DecodeError

LARGEST_FACTOR = 2
BEAT_TOLERANCE = 1e-6


@dataclass(frozen=True, slots=True)
class HeterodynePlan:
    """In which order combinations of the wrapped phases are unwrapped: from one period over the projector to the finest pitch."""

    combinations: tuple[tuple[int, ...], ...]  # integer factors of the groups' phases
    frequencies: tuple[float, ...]  # periods over the projector
    noise: tuple[float, ...]  # of each order decision over that of one wrapped phase; 0 for the first

    @property
    def amplification(self) -> float:
        """Noise of the most delicate order decision over the noise of one wrapped phase."""
        return max(self.noise)

    @property
    def worst(self) -> int:
        """Which decision that is."""
        return int(np.argmax(self.noise))

    @property
    def guard(self) -> float:
        """Half of the share of the coarsest period that lies beyond the projector."""
        return max(0.0, (1.0 - self.frequencies[0]) / 2)


def plan_heterodyne(patterns: PatternSet) -> HeterodynePlan:
    """Find the chain of combinations whose noisiest order decision is the least noisy.

    Combinations with factors up to ±2 are the stations; one whose beat covers the projector can start, and an order
    decision from u to v has the noise |F_v/F_u · u − v|: 46 for the pitches 32 and 33.

    Raises
    ------
    DecodeError
        No combination's beat covers the projector.

    References
    ----------
    .. [1] C. Zuo et al., Temporal phase unwrapping algorithms for fringe projection profilometry, Optics and Lasers in
       Engineering 85, 84-103, 2016.
    """
    frequencies = patterns.projector_px / np.array(patterns.pitches_px)
    stations = _stations(frequencies)
    goal = tuple(int(i == int(np.argmax(frequencies))) for i in range(len(frequencies)))
    starts = [station for station, frequency in stations.items() if frequency <= 1 + BEAT_TOLERANCE]
    if not starts:
        raise _undetermined(patterns, min(stations.values()))
    chain = _quietest_chain(stations, starts, goal)
    noise = [0.0] + [_decision_noise(u, v, stations) for u, v in pairwise(chain)]
    return HeterodynePlan(tuple(chain), tuple(stations[station] for station in chain), tuple(noise))


def _stations(frequencies: FloatArray) -> dict[tuple[int, ...], float]:
    factors = range(-LARGEST_FACTOR, LARGEST_FACTOR + 1)
    groups = len(frequencies)
    if groups > 4:
        raise DecodeError(f"{groups} pitches are more than four.", "Leave pitches out: three are enough for any projector.")
    every = {station: float(np.dot(station, frequencies)) for station in product(factors, repeat=groups)}
    return {station: frequency for station, frequency in every.items() if frequency > 1e-3}


def _decision_noise(known: tuple[int, ...], next_one: tuple[int, ...], stations: dict[tuple[int, ...], float]) -> float:
    ratio = stations[next_one] / stations[known]
    return float(np.linalg.norm(ratio * np.array(known) - np.array(next_one)))


def _quietest_chain(stations: dict[tuple[int, ...], float], starts: list[tuple[int, ...]], goal: tuple[int, ...]) -> list[tuple[int, ...]]:
    """Dijkstra's search for the path with the smallest largest step; fewer stations win a tie."""
    queue = [(0.0, 0, [start]) for start in sorted(starts, key=lambda s: float(np.linalg.norm(s)))]
    heapq.heapify(queue)
    settled: set[tuple[int, ...]] = set()
    while True:
        worst, length, chain = heapq.heappop(queue)
        here = chain[-1]
        if here == goal:
            return chain
        if here in settled:
            continue
        settled.add(here)
        for station, frequency in stations.items():
            if station not in settled and frequency > stations[here]:
                heapq.heappush(queue, (max(worst, _decision_noise(here, station, stations)), length + 1, [*chain, station]))


def _undetermined(patterns: PatternSet, lowest: float) -> DecodeError:
    pitches = ", ".join(f"{pitch:g}" for pitch in patterns.pitches_px)
    beat = patterns.projector_px / lowest
    if len(patterns.pitches_px) == 1:
        return DecodeError(
            f"A single pitch of {pitches} px repeats over the {patterns.projector_px} columns of the projector.",
            "Add a second pitch or a Gray code that numbers the periods.",
        )
    return DecodeError(
        f"The beat of the pitches {pitches} px is {beat:.0f} px, shorter than the {patterns.projector_px} columns of the projector.",
        "Choose pitches closer to each other, add a third pitch or a Gray code.",
    )
