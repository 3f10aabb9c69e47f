"""How well the pairs close around the part: one figure for what adds up from view to view.

The views are taken once around by pairs alone; where they come back to the first view, its points should lie where they were. The axes
close by themselves, so that only what pairs change can leave a gap. Each pair counts with what it and the axes together know of the two
views, as in the joint estimate; in directions that the common surface leaves open the axes lead on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import RingClosure
from measureapp.geometry.transform import RigidTransform
from measureapp.register.icp import PairMeasurement, stepped
from measureapp.register.pose_graph import edge_error, moved_to, turned

LARGEST_STEP_RAD = 0.7 * np.pi  # a ring has at least three views
Node = tuple[int, int]  # view, whole turns


@dataclass(frozen=True, slots=True, eq=False)
class _Link:
    """A pair with what the axes add to it."""

    target: int
    source: int
    target_from_source: RigidTransform
    centre_mm: FloatArray  # (3,), in the part's frame
    scatter: FloatArray  # (6, 6), covariance of its correction by the pair's own errors, about the centre in the part's frame
    gain: FloatArray  # (6, 6N), how its correction follows the axes' errors
    cost: float  # mean square that it moves points of the part by, mm²

    def from_to(self, start: int) -> RigidTransform:
        """Return start_from_other."""
        return self.target_from_source if start == self.target else self.target_from_source.inverse()


def largest_gap(
    kinematic: Sequence[RigidTransform],
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
    radii_mm: FloatArray,
    by_axes: FloatArray,
    names: Sequence[str],
) -> RingClosure | None:
    """Return the ring that closes worst among the most certain rings through each view; None where no pairs lead around the part.

    Around: about the normal of the plane in which the cameras stand, through the middle of the views.

    Parameters
    ----------
    kinematic : N poses part_from_camera by the axes
    centres_mm, radii_mm : (N, 3) in the part's frame and (N,), the middle of each view and how far its points lie from there
    by_axes : (6N, 6N), covariance of the poses by the axes, as motions about the centres in the part's frame
    names : of the N viewpoints
    """
    links = [_link(pair, kinematic, centres_mm, radii_mm, by_axes) for pair in pairs]
    azimuth = _azimuth_rad(kinematic, centres_mm)
    rings = {_from_least(ring) for start in range(len(kinematic)) if (ring := _best_ring(start, links, azimuth))}
    closed = [_closed(ring, links, kinematic, centres_mm, radii_mm, by_axes, names) for ring in sorted(rings)]
    return max(closed, key=lambda one: one.gap_mm, default=None)


def _link(
    pair: PairMeasurement, kinematic: Sequence[RigidTransform], centres_mm: FloatArray, radii_mm: FloatArray, by_axes: FloatArray
) -> _Link:
    error, by_target, by_source = edge_error(kinematic, pair, centres_mm)
    rows = np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])
    both = np.hstack([by_target, by_source])
    axes = both @ by_axes[np.ix_(rows, rows)] @ both.T
    known = np.linalg.solve(np.eye(6) + axes @ pair.information, axes)  # (H + A⁻¹)⁻¹, also where H or A is singular
    share = known @ pair.information
    target = kinematic[pair.target]
    between = stepped(target.inverse() @ kinematic[pair.source], -share @ error, pair.centre_mm)
    turn = turned(target.rotation)
    gain = np.zeros((6, len(by_axes)))
    gain[:, rows] = turn @ share @ both
    lengths = np.array([1.0] * 3 + [float(radii_mm[pair.target])] * 3)
    return _Link(
        pair.target, pair.source, between, target.apply(pair.centre_mm), turn @ share @ known @ turn.T, gain, float(lengths**2 @ np.diag(known))
    )  # fmt: skip


def _azimuth_rad(kinematic: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Return the direction (N,) of each camera about the normal of the plane in which they stand."""
    from_middle = np.stack([pose.translation_mm for pose in kinematic]) - centres_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(from_middle - from_middle.mean(axis=0))
    return np.arctan2(from_middle @ axes[1], from_middle @ axes[0])


def _best_ring(start: int, links: Sequence[_Link], azimuth: FloatArray) -> tuple[int, ...]:
    """Return the most certain way of links once around and back to ``start``, which it begins with; empty where there is none.

    The shortest path over views and whole turns (E. W. Dijkstra, Numerische Mathematik 1, 269-271, 1959).
    """
    steps: dict[int, list[tuple[int, float]]] = {}
    for link in links:
        if abs(np.remainder(azimuth[link.source] - azimuth[link.target] + np.pi, 2 * np.pi) - np.pi) <= LARGEST_STEP_RAD:
            steps.setdefault(link.target, []).append((link.source, link.cost))
            steps.setdefault(link.source, []).append((link.target, link.cost))
    came: dict[Node, Node] = {}
    cost: dict[Node, float] = {(start, 0): 0.0}
    waiting: list[tuple[float, Node]] = [(0.0, (start, 0))]
    while waiting:
        so_far, node = heappop(waiting)
        if node == (start, 1):
            return _path(node, came)
        if so_far > cost[node]:
            continue
        view, turns = node
        for other, more in steps.get(view, []):
            over = np.floor(
                (azimuth[other] - azimuth[view] + np.pi) / (2 * np.pi)
            )  # whole turns between the two directions as they are given
            after = (other, turns - int(over))
            if abs(after[1]) <= 1 and so_far + more < cost.get(after, np.inf):
                cost[after], came[after] = so_far + more, node
                heappush(waiting, (so_far + more, after))
    return ()


def _path(last: Node, came: dict[Node, Node]) -> tuple[int, ...]:
    views = []
    while last in came:
        last = came[last]
        views.append(last[0])
    return tuple(reversed(views))


def _from_least(ring: tuple[int, ...]) -> tuple[int, ...]:
    """Return the same ring, begun with its first view by number, so that rings found from several views are one."""
    first = ring.index(min(ring))
    return ring[first:] + ring[:first]


def _closed(
    ring: tuple[int, ...],
    links: Sequence[_Link],
    kinematic: Sequence[RigidTransform],
    centres_mm: FloatArray,
    radii_mm: FloatArray,
    by_axes: FloatArray,
    names: Sequence[str],
) -> RingClosure:
    """Return the gap that a ring leaves at the points of its first view, and how large it is expected to be."""
    by_views = {frozenset((link.target, link.source)): link for link in links}
    around: RigidTransform | None = None
    scatter, gain = np.zeros((6, 6)), np.zeros((6, len(by_axes)))
    first = ring[0]
    for start, end in pairwise((*ring, first)):
        link = by_views[frozenset((start, end))]
        step = link.from_to(start)
        around = step if around is None else around @ step
        carry = moved_to(centres_mm[first], link.centre_mm)
        scatter += carry @ link.scatter @ carry.T
        gain += (1 if start == link.target else -1) * carry @ link.gain
    assert around is not None
    centre = kinematic[first].inverse().apply(centres_mm[first])
    shift, turn = np.linalg.norm(around.apply(centre) - centre), around.angle_rad
    covariance = scatter + gain @ by_axes @ gain.T
    # a turn moves points at the rms distance r from their centre by √(2/3) r |turn|, whatever its axis
    lengths = np.array([1.0] * 3 + [float(np.sqrt(2 / 3) * radii_mm[first])] * 3)
    return RingClosure(
        viewpoints=tuple(names[i] for i in ring),
        gap_mm=float(np.hypot(shift, lengths[3] * turn)),
        gap_deg=float(np.degrees(turn)),
        sigma_mm=float(np.sqrt(lengths**2 @ np.diag(covariance))),
    )
