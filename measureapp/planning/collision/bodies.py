"""The cell as bodies: what each is, what carries it, and which pairs can meet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import combinations

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray
from measureapp.planning.collision.solids import Solid

FIXED, BASE, FLANGE, TABLE = -1, 0, 6, 7
"""Carriers: the guide frame; the robot's base (0), which slides along the guide; its links (1…6); the table, which turns."""

TABLE_NAME = "rotary table"


class Kind(Enum):
    """What a body belongs to."""

    ARM = "arm"
    ROUGH = "arm of unknown shape"
    HEAD = "head"
    GROUND = "ground"  # floor and guide beam, under the robot
    OBSTACLE = "obstacle"  # table, part, fixtures
    KEEP_OUT = "keep-out box"


LINKS = {Kind.ARM, Kind.ROUGH}


@dataclass(frozen=True, slots=True, eq=False)
class Body:
    """A solid and what carries it."""

    name: str
    kind: Kind
    carrier: int
    solid: Solid
    carrier_from_solid: FloatArray  # (4, 4); links: in the base frame while all joints are at 0

    @property
    def corners_mm(self) -> FloatArray:
        """Corners of its bounds in the frame of the carrier, without the margin, (8, 3)."""
        corners: FloatArray = self.solid.corners_mm @ self.carrier_from_solid[:3, :3].T + self.carrier_from_solid[:3, 3]
        return corners

    @property
    def placed(self) -> FloatArray:
        """The solid's geometry in the frame of the carrier, (4, 4)."""
        placed: FloatArray = self.carrier_from_solid @ self.solid.from_geometry
        return placed


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """Two bodies that may meet."""

    first: int  # index of the body that is carried nearer to the base
    second: int
    apart_mm: float  # least distance between them

    @classmethod
    def between(cls, bodies: Sequence[Body], first: int, second: int, clearance_mm: float) -> Pair:
        """Return the pair; keep-out boxes must not be entered, and links of the arm must not touch: more is not asked of them."""
        kinds = {bodies[first].kind, bodies[second].kind}
        if bodies[first].carrier > bodies[second].carrier:
            first, second = second, first
        return cls(first, second, 0.0 if Kind.KEEP_OUT in kinds or len(kinds & LINKS) == len(kinds) else clearance_mm)


def pairs_of(bodies: Sequence[Body], clearance_mm: float) -> tuple[Pair, ...]:
    """Return all pairs that can move against each other and do not touch by design."""
    return tuple(Pair.between(bodies, *pair, clearance_mm) for pair in _pairs(bodies))


def _pairs(bodies: Sequence[Body]) -> Iterator[tuple[int, int]]:
    for (first, one), (second, other) in combinations(enumerate(bodies), 2):
        if one.carrier != other.carrier and not _belong_together(one, other):
            yield first, second


def _belong_together(one: Body, other: Body) -> bool:
    """Whether two bodies are joined, or need not be kept apart."""
    low, high = sorted((one, other), key=lambda body: body.carrier)
    if high.carrier == TABLE:
        return low.carrier == FIXED and (low.kind in (Kind.KEEP_OUT, Kind.GROUND) or high.name == TABLE_NAME)
    if low.carrier == FIXED:
        stands = high.carrier == BASE or (high.carrier == 1 and low.kind is Kind.GROUND)  # link 1 turns, and comes no nearer to the ground
        return stands and low.kind is not Kind.OBSTACLE
    return high.carrier - low.carrier <= (2 if low.kind is high.kind is Kind.ROUGH else 1)


class BodyTable:
    """Bodies and pairs as arrays, for bounds of all distances at once."""

    def __init__(self, bodies: Sequence[Body], pairs: Sequence[Pair]) -> None:
        self.carriers = np.array([body.carrier for body in bodies])
        self._placed = np.array([body.carrier_from_solid for body in bodies])
        self._low, self._high = np.array([body.solid.low_mm for body in bodies]), np.array([body.solid.high_mm for body in bodies])
        corners = np.array([body.corners_mm for body in bodies])
        self._middles = np.concatenate([corners.mean(axis=1), np.ones((len(bodies), 1))], axis=1)
        self._radii_mm = np.linalg.norm(corners - self._middles[:, None, :3], axis=2).max(axis=1)
        self._margins_mm = np.array([body.solid.margin_mm for body in bodies])
        self._first, self._second = np.array([(pair.first, pair.second) for pair in pairs], int).reshape(-1, 2).T

    def lower_bounds_mm(self, frames: FloatArray, pairs: npt.NDArray[np.intp]) -> FloatArray:
        """Return what the distance of ``pairs`` (P,), by number, is at least, (N, P), for carriers at ``frames`` (N, 9, 4, 4).

        It is the distance of the sphere around one body from the bounds of the other, whichever way it is larger.
        """
        first, second = self._first[pairs], self._second[pairs]
        carried = frames[:, self.carriers]
        middles = np.einsum("nbij,bj->nbi", carried[:, :, :3], self._middles)
        poses = carried @ self._placed
        ways = (self._outside_mm(poses, middles, *pair) for pair in ((first, second), (second, first)))
        bounds: FloatArray = np.maximum(*ways) - self._margins_mm[first] - self._margins_mm[second]
        return bounds

    def _outside_mm(self, poses: FloatArray, middles: FloatArray, blocks: npt.NDArray[np.intp], balls: npt.NDArray[np.intp]) -> FloatArray:
        of_blocks = poses[:, blocks]
        local = np.einsum("npji,npj->npi", of_blocks[..., :3, :3], middles[:, balls] - of_blocks[..., :3, 3])
        outside = np.maximum(np.maximum(self._low[blocks] - local, local - self._high[blocks]), 0.0)
        distances: FloatArray = np.linalg.norm(outside, axis=2) - self._radii_mm[balls]
        return distances


def reach_mm(body: Body, origin_mm: FloatArray) -> float:
    """Return the largest distance of a body from a point (3,) of its carrier."""
    return float(np.linalg.norm(body.corners_mm - origin_mm, axis=1).max()) + body.solid.margin_mm
