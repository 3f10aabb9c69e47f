"""Loop closure around the part: gap at the first view after chaining pairs once around.

Each step combines the pair with the joint estimate by their information: determined directions follow the pair, undetermined ones the
joint estimate, which closes exactly. Only contradictions between pairs leave a gap. With the kinematic poses in place of the joint
estimate, a kinematic error shared by all views would show as well: corrected in one pair and not in the next, it leaves a gap, though it
cancels in the joint estimate (decision 11).

The expected gap contains everything the error model states: noise and smooth errors of the pairs, the kinematic poses, and what all clouds
have alike (camera calibration, systematic errors), of which chained pairs add up what the joint estimate distributes (decision 49).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra
from scipy.special import chdtrc

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import LoopClosure
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import linearise_edge, twist_rotation, twist_shift
from measureapp.register.pairs.icp import PairMeasurement, apply_motion

LARGEST_STEP_RAD = 0.7 * np.pi  # a loop has at least three views
LEAST_COST_MM2 = 1e-30  # a link without cost is a link all the same
LEAST_SIGMA_MM = 1e-12


@dataclass(frozen=True, slots=True, eq=False)
class _Link:
    """A pair combined with the joint estimate."""

    target: int
    source: int
    target_from_source: RigidTransform
    centre_mm: FloatArray  # (3,), in the part's frame
    follow: FloatArray  # (6, 6), derivative of its correction with respect to the measured motion, about the centre in the part's frame
    scatter: FloatArray  # (6, 6), covariance of its correction from the pair's own errors, likewise
    gain: FloatArray  # (6, 6N), derivative of its correction with respect to the errors of the initial poses
    cost: float  # mean squared uncertainty of points of the part, mm²

    def from_to(self, start: int) -> RigidTransform:
        """Return start_from_other."""
        return self.target_from_source if start == self.target else self.target_from_source.inverse()


@dataclass(frozen=True, slots=True, eq=False)
class SharedMotions:
    """What errors that all clouds share (K, one standard deviation each) do to pairs and to the joint estimate."""

    of_pairs: FloatArray  # (E, 6, K), motions of the measured source about the pair's centre, in the target's frame
    of_views: FloatArray  # (6N, K), motions about the centres in the part's frame


def find_worst_loop(
    poses: Sequence[RigidTransform],
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
    radii_mm: FloatArray,
    kinematic_covariance: FloatArray,
    names: Sequence[str],
    shared: SharedMotions | None = None,
) -> LoopClosure | None:
    """Return the least probable closure among the most certain loops through each view; None without a loop around the part.

    Around means: about the normal of the plane of the cameras, through the centre of the views.

    Parameters
    ----------
    poses : N poses part_from_camera of the joint estimate of ``pairs`` and kinematic poses
    centres_mm, radii_mm : (N, 3) in the part's frame and (N,), centre and rms radius of each view
    kinematic_covariance : (6N, 6N), of the kinematic poses, as motions about the centres in the part's frame
    names : of the N viewpoints
    shared : None: no such errors
    """
    if shared is None:
        shared = SharedMotions(np.zeros((len(pairs), 6, 0)), np.zeros((len(kinematic_covariance), 0)))
    links = [_make_link(pair, poses, centres_mm, radii_mm, kinematic_covariance) for pair in pairs]
    azimuth = _azimuth_rad(poses, centres_mm)
    loops = {_rotate_to_smallest(loop) for start in range(len(poses)) if (loop := _find_best_loop(start, links, azimuth))}
    jointly = _joint_covariance(pairs, poses, centres_mm, kinematic_covariance) if loops else kinematic_covariance
    closed = [_evaluate_loop(loop, links, poses, centres_mm, radii_mm, jointly, shared) for loop in sorted(loops)]
    worst = min(closed, key=lambda one: (_probability(one), -one.gap_mm), default=None)
    return worst and replace(worst, viewpoints=tuple(names[int(i)] for i in worst.viewpoints), loops=len(closed))


def _probability(loop: LoopClosure) -> float:
    """Return the probability of so large a gap: a scaled chi-square with the mean and variance of the weighted squares (Satterthwaite)."""
    return float(chdtrc(loop.freedom, loop.freedom * (loop.gap_mm / max(loop.sigma_mm, LEAST_SIGMA_MM)) ** 2))


def _rows(pair: PairMeasurement) -> IntArray:
    return np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])


def _joint_covariance(
    pairs: Sequence[PairMeasurement], poses: Sequence[RigidTransform], centres_mm: FloatArray, kinematic_covariance: FloatArray
) -> FloatArray:
    """Return the covariance (6N, 6N) of the joint estimate, as motions about the centres in the part's frame."""
    matrix = np.linalg.inv(kinematic_covariance)
    for pair in pairs:
        _, by_target, by_source = linearise_edge(poses, pair, centres_mm)
        both = np.hstack([by_target, by_source])
        matrix[np.ix_(_rows(pair), _rows(pair))] += both.T @ pair.information @ both
    return np.asarray(np.linalg.inv(matrix))


def _make_link(
    pair: PairMeasurement, poses: Sequence[RigidTransform], centres_mm: FloatArray, radii_mm: FloatArray, kinematic_covariance: FloatArray
) -> _Link:
    error, by_target, by_source = linearise_edge(poses, pair, centres_mm)
    rows = _rows(pair)
    both = np.hstack([by_target, by_source])
    axes = both @ kinematic_covariance[np.ix_(rows, rows)] @ both.T
    known = np.linalg.solve(np.eye(6) + axes @ pair.information, axes)  # (H + A⁻¹)⁻¹, also where H or A is singular
    share = known @ pair.information
    target = poses[pair.target]
    between = apply_motion(target.inverse() @ poses[pair.source], -share @ error, pair.centre_mm)
    turn = twist_rotation(target.rotation)
    gain = np.zeros((6, len(kinematic_covariance)))
    gain[:, rows] = turn @ share @ both
    lengths = np.array([1.0] * 3 + [float(radii_mm[pair.target])] * 3)
    cost = float(lengths**2 @ np.diag(known))
    scatter = turn @ share @ known @ turn.T
    return _Link(pair.target, pair.source, between, target.apply(pair.centre_mm), turn @ share, scatter, gain, cost)


def _azimuth_rad(poses: Sequence[RigidTransform], centres_mm: FloatArray) -> FloatArray:
    """Return the azimuth (N,) of each camera about the normal of the plane of the cameras."""
    from_middle = np.stack([pose.translation_mm for pose in poses]) - centres_mm.mean(axis=0)
    _, _, axes = np.linalg.svd(from_middle - from_middle.mean(axis=0))
    return np.arctan2(from_middle @ axes[1], from_middle @ axes[0])


def _find_best_loop(start: int, links: Sequence[_Link], azimuth: FloatArray) -> tuple[int, ...]:
    """Dijkstra's algorithm: return the most certain loop of links once around from ``start``; empty if there is none.

    The shortest path over views in each of the turns -1, 0 and 1, from the start in turn 0 to the start in turn 1
    (E. W. Dijkstra, Numerische Mathematik 1, 269-271, 1959).
    """
    count = len(azimuth)
    costs = np.zeros((3 * count, 3 * count))  # zero: no link
    for link in links:
        between = azimuth[link.source] - azimuth[link.target] + np.pi
        if abs(np.remainder(between, 2 * np.pi) - np.pi) > LARGEST_STEP_RAD:
            continue
        over = int(np.floor(between / (2 * np.pi)))  # whole turns between the two azimuths
        for turn in range(max(0, over), min(3, 3 + over)):
            costs[turn * count + link.target, (turn - over) * count + link.source] = max(link.cost, LEAST_COST_MM2)
    _, before = dijkstra(csr_array(costs), directed=False, indices=count + start, return_predecessors=True)
    views, node = [], before[2 * count + start]
    while node >= 0:
        views.append(int(node) % count)
        node = before[node]
    return tuple(reversed(views))


def _rotate_to_smallest(loop: tuple[int, ...]) -> tuple[int, ...]:
    """Return the same loop started at its smallest view number, so that loops found from several views are equal."""
    first = loop.index(min(loop))
    return loop[first:] + loop[:first]


def _evaluate_loop(
    loop: tuple[int, ...],
    links: Sequence[_Link],
    poses: Sequence[RigidTransform],
    centres_mm: FloatArray,
    radii_mm: FloatArray,
    jointly: FloatArray,
    shared: SharedMotions,
) -> LoopClosure:
    """Return the gap of a loop (over the numbers of its views) at the points of its first view, its expected size and degrees of freedom.

    The joint estimate, of covariance ``jointly``, is correlated with the pairs: its covariance is subtracted from that of the pairs.
    """
    by_views = {frozenset((link.target, link.source)): number for number, link in enumerate(links)}
    around: RigidTransform | None = None
    scatter, gain, moved = np.zeros((6, 6)), np.zeros((6, len(jointly))), np.zeros((6, shared.of_views.shape[1]))
    first = loop[0]
    for start, end in pairwise((*loop, first)):
        number = by_views[frozenset((start, end))]
        link = links[number]
        step = link.from_to(start)
        around = step if around is None else around @ step
        carry = twist_shift(centres_mm[first], link.centre_mm)
        forward = 1 if start == link.target else -1
        scatter += carry @ link.scatter @ carry.T
        gain += forward * carry @ link.gain
        moved += forward * carry @ link.follow @ shared.of_pairs[number]
    assert around is not None
    centre = poses[first].inverse().apply(centres_mm[first])
    shift, turn = np.linalg.norm(around.apply(centre) - centre), around.angle_rad
    moved -= gain @ shared.of_views
    # a rotation moves points at the rms distance r from their centre by √(2/3) r |turn|, for any axis
    lengths = np.array([1.0] * 3 + [float(np.sqrt(2 / 3) * radii_mm[first])] * 3)
    covariance = np.outer(lengths, lengths) * (scatter - gain @ jointly @ gain.T + moved @ moved.T)
    expected, squares = float(np.trace(covariance)), float(np.sum(covariance**2))
    return LoopClosure(
        viewpoints=tuple(map(str, loop)),
        gap_mm=float(np.hypot(shift, lengths[3] * turn)),
        gap_deg=float(np.degrees(turn)),
        sigma_mm=float(np.sqrt(expected)),
        freedom=expected**2 / max(squares, LEAST_SIGMA_MM**4),
    )
