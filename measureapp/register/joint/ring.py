"""How well the pairs close around the part: one figure for what adds up from view to view.

The views are taken once around by pairs; where they come back to the first view, its points should lie where they were. Where the common
surface of a pair holds, the pair leads from view to view; in directions that it leaves open the joint estimate leads on, which closes by
itself; between the two each counts as far as the pair knows better than the axes. So only what pairs contradict each other by leaves a gap.
Were it the axes that lead on, an error of theirs that all views share would show as well: half corrected in one pair and not in the next,
it leaves a gap, though it cancels in the joint estimate (decision 11).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import RingClosure
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import edge_error, moved_to, turned
from measureapp.register.pairs.icp import PairMeasurement, stepped

LARGEST_STEP_RAD = 0.7 * np.pi  # a ring has at least three views
LEAST_COST_MM2 = 1e-30  # a link without cost is a link all the same


@dataclass(frozen=True, slots=True, eq=False)
class _Link:
    """A pair with what the axes add to it."""

    target: int
    source: int
    target_from_source: RigidTransform
    centre_mm: FloatArray  # (3,), in the part's frame
    scatter: FloatArray  # (6, 6), covariance of its correction by the pair's own errors, about the centre in the part's frame
    gain: FloatArray  # (6, 6N), how its correction follows the errors of the poses it starts from
    cost: float  # mean square that it moves points of the part by, mm²

    def from_to(self, start: int) -> RigidTransform:
        """Return start_from_other."""
        return self.target_from_source if start == self.target else self.target_from_source.inverse()


def largest_gap(
    poses: Sequence[RigidTransform],
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
    poses : N poses part_from_camera by the joint estimate of ``pairs`` and axes
    centres_mm, radii_mm : (N, 3) in the part's frame and (N,), the middle of each view and how far its points lie from there
    by_axes : (6N, 6N), covariance of the poses by the axes, as motions about the centres in the part's frame
    names : of the N viewpoints
    """
    links = [_link(pair, poses, centres_mm, radii_mm, by_axes) for pair in pairs]
    azimuth = _azimuth_rad(poses, centres_mm)
    rings = {_from_least(ring) for start in range(len(poses)) if (ring := _best_ring(start, links, azimuth))}
    jointly = _estimated(pairs, poses, centres_mm, by_axes) if rings else by_axes
    closed = [_closed(ring, links, poses, centres_mm, radii_mm, jointly, names) for ring in sorted(rings)]
    return max(closed, key=lambda one: one.gap_mm, default=None)


def _rows(pair: PairMeasurement) -> IntArray:
    return np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])


def _estimated(
    pairs: Sequence[PairMeasurement], poses: Sequence[RigidTransform], centres_mm: FloatArray, by_axes: FloatArray
) -> FloatArray:
    """Return the covariance (6N, 6N) of the joint estimate, as motions about the centres in the part's frame."""
    matrix = np.linalg.inv(by_axes)
    for pair in pairs:
        _, by_target, by_source = edge_error(poses, pair, centres_mm)
        both = np.hstack([by_target, by_source])
        matrix[np.ix_(_rows(pair), _rows(pair))] += both.T @ pair.information @ both
    return np.asarray(np.linalg.inv(matrix))


def _link(
    pair: PairMeasurement, poses: Sequence[RigidTransform], centres_mm: FloatArray, radii_mm: FloatArray, by_axes: FloatArray
) -> _Link:
    error, by_target, by_source = edge_error(poses, pair, centres_mm)
    rows = _rows(pair)
    both = np.hstack([by_target, by_source])
    axes = both @ by_axes[np.ix_(rows, rows)] @ both.T
    known = np.linalg.solve(np.eye(6) + axes @ pair.information, axes)  # (H + A⁻¹)⁻¹, also where H or A is singular
    share = known @ pair.information
    target = poses[pair.target]
    between = stepped(target.inverse() @ poses[pair.source], -share @ error, pair.centre_mm)
    turn = turned(target.rotation)
    gain = np.zeros((6, len(by_axes)))
    gain[:, rows] = turn @ share @ both
    lengths = np.array([1.0] * 3 + [float(radii_mm[pair.target])] * 3)
    return _Link(
        pair.target, pair.source, between, target.apply(pair.centre_mm), turn @ share @ known @ turn.T, gain, float(lengths**2 @ np.diag(known))
    )  # fmt: skip


def _azimuth_rad(poses: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Return the direction (N,) of each camera about the normal of the plane in which they stand."""
    from_middle = np.stack([pose.translation_mm for pose in poses]) - centres_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(from_middle - from_middle.mean(axis=0))
    return np.arctan2(from_middle @ axes[1], from_middle @ axes[0])


def _best_ring(start: int, links: Sequence[_Link], azimuth: FloatArray) -> tuple[int, ...]:
    """Return the most certain way of links once around and back to ``start``, which it begins with; empty where there is none.

    The shortest path (Dijkstra's) over views in each of the turns -1, 0 and 1, from the start in turn 0 to the start in turn 1.
    """
    count = len(azimuth)
    costs = np.zeros((3 * count, 3 * count))  # zero: no link
    for link in links:
        between = azimuth[link.source] - azimuth[link.target] + np.pi
        if abs(np.remainder(between, 2 * np.pi) - np.pi) > LARGEST_STEP_RAD:
            continue
        over = int(np.floor(between / (2 * np.pi)))  # whole turns between the two directions as they are given
        for turn in range(max(0, over), min(3, 3 + over)):
            costs[turn * count + link.target, (turn - over) * count + link.source] = max(link.cost, LEAST_COST_MM2)
    _, before = dijkstra(csr_array(costs), directed=False, indices=count + start, return_predecessors=True)
    views, node = [], before[2 * count + start]
    while node >= 0:
        views.append(int(node) % count)
        node = before[node]
    return tuple(reversed(views))


def _from_least(ring: tuple[int, ...]) -> tuple[int, ...]:
    """Return the same ring, begun with its first view by number, so that rings found from several views are one."""
    first = ring.index(min(ring))
    return ring[first:] + ring[:first]


def _closed(
    ring: tuple[int, ...],
    links: Sequence[_Link],
    poses: Sequence[RigidTransform],
    centres_mm: FloatArray,
    radii_mm: FloatArray,
    jointly: FloatArray,
    names: Sequence[str],
) -> RingClosure:
    """Return the gap that a ring leaves at the points of its first view, and how large it is expected to be.

    Of the pairs' errors the joint estimate, which ``jointly`` is the covariance of, takes its part: it is less uncertain by as much as
    the gap would be by the pairs alone.
    """
    by_views = {frozenset((link.target, link.source)): link for link in links}
    around: RigidTransform | None = None
    scatter, gain = np.zeros((6, 6)), np.zeros((6, len(jointly)))
    first = ring[0]
    for start, end in pairwise((*ring, first)):
        link = by_views[frozenset((start, end))]
        step = link.from_to(start)
        around = step if around is None else around @ step
        carry = moved_to(centres_mm[first], link.centre_mm)
        scatter += carry @ link.scatter @ carry.T
        gain += (1 if start == link.target else -1) * carry @ link.gain
    assert around is not None
    centre = poses[first].inverse().apply(centres_mm[first])
    shift, turn = np.linalg.norm(around.apply(centre) - centre), around.angle_rad
    covariance = scatter - gain @ jointly @ gain.T
    # a turn moves points at the rms distance r from their centre by √(2/3) r |turn|, whatever its axis
    lengths = np.array([1.0] * 3 + [float(np.sqrt(2 / 3) * radii_mm[first])] * 3)
    return RingClosure(
        viewpoints=tuple(names[i] for i in ring),
        gap_mm=float(np.hypot(shift, lengths[3] * turn)),
        gap_deg=float(np.degrees(turn)),
        sigma_mm=float(np.sqrt(lengths**2 @ np.diag(covariance))),
    )
