"""Distances between bodies at one placement, and along a move by conservative advancement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray
from measureapp.planning.collision.bodies import Body, BodyTable, Kind, Pair, pairs_of
from measureapp.planning.collision.distance import distance_mm
from measureapp.planning.collision.motion import CHANGES, Mechanism, Placement, samples

STEP_MM = 2.0  # nothing travels further between two samples of a move: a clearance may be less than found by as much
SUBJECTS = (Kind.HEAD, Kind.ARM, Kind.ROUGH, Kind.OBSTACLE, Kind.GROUND, Kind.KEEP_OUT)  # which of two bodies is said to meet the other
COARSE = 8  # samples of a move at a time, to find the pairs that stay far apart
LEAVING_MM = 0.5  # rounding, by which a pair that is too close already may come closer


@dataclass(frozen=True, slots=True)
class Encounter:
    """Two bodies that are too close to each other."""

    first: str
    second: str
    distance_mm: float  # 0: they touch or overlap
    share: float  # of the move, where it happens first
    kept_mm: float  # what they have to keep
    enters: bool = False  # the second is a keep-out box
    axis: str = "robot"  # that moves

    def words(self) -> str:
        """Describe it, as part of a sentence."""
        if self.distance_mm > 0.0:
            return f"the {self.first} would come within {self.distance_mm:.0f} mm of the {self.second} (at least {self.kept_mm:g} mm)"
        if self.enters:
            return f"the {self.first} would enter the {self.second}"
        return f"the {self.first} would collide with the {self.second}"


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """Bodies, the pairs of them that may meet, and how they move."""

    bodies: tuple[Body, ...]
    pairs: tuple[Pair, ...]
    table: BodyTable
    mechanism: Mechanism
    travels: FloatArray  # (pairs, 10), see `Mechanism.travels`

    @classmethod
    def of(cls, bodies: Sequence[Body], clearance_mm: float, mechanism: Mechanism) -> Scene:
        """Return the scene of these bodies, which keep ``clearance_mm``."""
        pairs = pairs_of(bodies, clearance_mm)
        travels = [mechanism.travels(bodies[pair.first], bodies[pair.second]) for pair in pairs]
        return cls(tuple(bodies), pairs, BodyTable(bodies, pairs), mechanism, np.array(travels).reshape(-1, CHANGES))


class Sweep:
    """Distances of all pairs along one move, calculated where they are needed."""

    def __init__(self, scene: Scene, start: Placement, end: Placement) -> None:
        self._bodies, self._pairs = scene.bodies, scene.pairs
        self._travels_mm = scene.travels @ scene.mechanism.changes(start, end)
        self.shares = samples(float(self._travels_mm.max(initial=0.0)), STEP_MM)
        self._frames = scene.mechanism.frames(start, end, self.shares)
        self._apart_mm = np.array([pair.apart_mm for pair in scene.pairs])
        self._near = self._candidates(scene.table)
        self._bounds_mm = scene.table.lower_bounds_mm(self._frames, self._near)

    def first_encounter(self, *, leaving: bool = False) -> Encounter | None:
        """Return what comes too close first along the move; None if nothing does.

        Parameters
        ----------
        leaving : pairs that are too close at its start may move apart; those that overlap there are not asked
        """
        found: tuple[int, float, Pair] | None = None
        for column, number in enumerate(self._near.tolist()):
            hit = self._first(number, self._bounds_mm[:, column], leaving, len(self.shares) if found is None else found[0])
            if hit is not None:
                found = (*hit, self._pairs[number])
        if found is None:
            return None
        index, gap_mm, pair = found
        moving, other = sorted((self._bodies[pair.second], self._bodies[pair.first]), key=lambda body: SUBJECTS.index(body.kind))
        share = float(self.shares[index])
        return Encounter(moving.name, other.name, max(0.0, gap_mm), share, pair.apart_mm, other.kind is Kind.KEEP_OUT)

    def distances_mm(self) -> FloatArray:
        """Return the distance of every pair at the start of the move, (pairs,); not above 0 where they touch or overlap."""
        return np.array([self._distance_mm(pair, 0) for pair in self._pairs])

    def _candidates(self, table: BodyTable) -> npt.NDArray[np.intp]:
        """Return the numbers of the pairs that may come too close, judged by few samples and the ways between them."""
        coarse = self._frames[::COARSE]
        travelled_mm = self._travels_mm * (COARSE / max(1, len(self.shares) - 1))
        bounds_mm = table.lower_bounds_mm(coarse, np.arange(len(self._pairs))) - travelled_mm
        return np.flatnonzero((bounds_mm <= self._apart_mm).any(axis=0))

    def _first(self, number: int, bounds_mm: FloatArray, leaving: bool, before: int) -> tuple[int, float] | None:
        """Return the first sample before ``before`` at which a pair is too close, and its distance there."""
        pair, travel_mm = self._pairs[number], float(self._travels_mm[number])
        apart_mm, step_mm = pair.apart_mm, travel_mm / max(1, len(self.shares) - 1)
        last = before if travel_mm > 0.0 else min(before, 1)
        near = np.flatnonzero(bounds_mm[:last] <= apart_mm)
        if leaving and len(near) and (now := self._distance_mm(pair, 0)) <= apart_mm:
            if now <= 0.0:
                return None
            apart_mm = now - LEAVING_MM
        place = 0
        while place < len(near):
            index = int(near[place])
            gap_mm = self._distance_mm(pair, index)
            if gap_mm < apart_mm or gap_mm <= 0.0:
                return index, gap_mm
            ahead = max(1, int((gap_mm - apart_mm) / step_mm)) if step_mm > 0.0 else len(self.shares)
            place = int(np.searchsorted(near, index + ahead))
        return None

    def _distance_mm(self, pair: Pair, index: int) -> float:
        """Return the distance of a pair at one sample, margins included; not above 0 where they touch or overlap."""
        one, other = self._bodies[pair.first], self._bodies[pair.second]
        poses = [self._frames[index, body.carrier] @ body.carrier_from_solid for body in (one, other)]
        return distance_mm(one.solid, poses[0], other.solid, poses[1]) - one.solid.margin_mm - other.solid.margin_mm
