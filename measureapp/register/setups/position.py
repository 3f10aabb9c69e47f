"""Position of one set-up relative to another by overlapping surface: found, checked, and refused where it is not unique."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.register.pairs.icp import PairMeasurement, register_pair
from measureapp.register.setups.coarse import CoarseCandidate, contradicted, differ, improve, match_sample
from measureapp.register.setups.setup_cloud import PreparedSetUp

MOST_CANDIDATES = 24  # refined
PROMISING = 0.7  # of the best coarse score
NEAR_MM, GOOD_MM = 3.0, 0.15  # surfaces of one part at the same place differ by less than the latter (limit of a cloud's noise)
SIDEWAYS = 1.2  # in voxels
LEAST_OVERLAP = 0.03  # of the smaller set-up
LEAST_AGREEMENT = 0.75  # least share of the common surface that fits
MOST_CONTRADICTED = 0.04  # greatest share of points in space that the other set-up saw as empty; borders and thin walls give up to 0.025
EQUAL_OVERLAP, EQUAL_RESIDUAL = 0.9, 1.3  # positions within these are not distinguishable
HINT_WITHIN_DEG, HINT_APART_DEG = 30.0, 5.0  # a rough rotation is at most this wrong; the second position is further away than the first


@dataclass(frozen=True, slots=True, eq=False)
class Position:
    """A checked position of one set-up relative to another."""

    pair: PairMeasurement  # target_from_source with its information
    overlap: float  # share of the smaller set-up's points that fit the other
    agreement: float  # share of the surface at the same place that fits
    contradicted: float  # share of points where the other set-up saw empty space

    @property
    def matrix(self) -> FloatArray:
        """The position (4, 4), target_from_source."""
        return self.pair.target_from_source.matrix

    @property
    def is_possible(self) -> bool:
        """Whether the surfaces fit and nothing contradicts."""
        return self.overlap >= LEAST_OVERLAP and self.agreement >= LEAST_AGREEMENT and self.contradicted <= MOST_CONTRADICTED


def find_position(target: PreparedSetUp, source: PreparedSetUp, starts: Iterable[FloatArray], rough: FloatArray | None = None) -> Position:
    """Find the position of ``source`` relative to ``target`` by their common surface.

    Parameters
    ----------
    starts : (4, 4) each, target_from_source
    rough : (3, 3), rough rotation target_from_source, to choose among the positions of a symmetric part

    Raises
    ------
    RegistrationError
        There is too little common surface, the set-ups contradict each other (different parts), or several positions fit equally well.
    """
    found = [refine(target, source, one) for one in _promising(improve(target, source, starts))]
    possible = [one for one in found if one.is_possible]
    if not possible:
        raise _refusal(target, source, found)
    return _choose(target, source, _equal_to_best(possible), rough)


def refine(target: PreparedSetUp, source: PreparedSetUp, coarse: CoarseCandidate) -> Position:
    """Register a coarse candidate finely and check it."""
    start = RigidTransform(orthonormalise(coarse.matrix), target.name, source.name)
    pair = register_pair(target.prepared, source.prepared, start, (0, 1), NEAR_MM)
    return check(target, source, pair)


def check(target: PreparedSetUp, source: PreparedSetUp, pair: PairMeasurement) -> Position:
    """Check a position: overlap, agreement of the common surface, and contradictions with space seen as empty."""
    matrix, voxel = pair.target_from_source.matrix, target.prepared.voxel_mm
    good = max(GOOD_MM, 4.0 * pair.residual_mm if pair.residual_mm < GOOD_MM / 3 else GOOD_MM)
    shares, agreements = [], []
    inverse = np.linalg.inv(matrix)
    for one, other, placed in ((target, source, matrix), (source, target, inverse)):
        matched = match_sample(one, other, placed, max(NEAR_MM, 2 * voxel))
        along = np.abs(matched.distance_mm)
        sideways = np.sqrt(np.maximum(np.where(matched.near, matched.apart_mm, 0.0) ** 2 - along**2, 0.0))
        near = matched.near & (along < NEAR_MM) & (sideways < SIDEWAYS * voxel)
        fits = near & (along < good)
        shares.append(float(fits.mean()))
        agreements.append(float(fits.sum() / max(near.sum(), 1)))
    return Position(pair, max(shares), min(agreements), contradicted(target, source, matrix))


def weakest_information(pair: PairMeasurement, radius_mm: float) -> float:
    """Return the information of a pair (1/mm²) about the motion that it determines worst, rotations at ``radius_mm``."""
    length = np.array([1.0, 1.0, 1.0, 1 / radius_mm, 1 / radius_mm, 1 / radius_mm])
    return float(np.linalg.eigvalsh(pair.information * np.outer(length, length))[0])


def _promising(candidates: list[CoarseCandidate]) -> list[CoarseCandidate]:
    """Return the candidates to be refined: those nearly as good as the best, and the largest overlaps for a reason of refusal."""
    if not candidates:
        return []
    limit = PROMISING * max(candidates[0].score, 0.0)
    return [one for number, one in enumerate(candidates[:MOST_CANDIDATES]) if number < 2 or one.score >= limit]


def _equal_to_best(possible: list[Position]) -> list[Position]:
    """Return the distinct positions that are not worse than the best one within what can be distinguished."""
    best = max(possible, key=lambda one: one.overlap)
    equal = [
        one
        for one in possible
        if one.overlap >= EQUAL_OVERLAP * best.overlap and one.pair.residual_mm <= EQUAL_RESIDUAL * max(best.pair.residual_mm, 0.01)
    ]
    distinct: list[Position] = []
    for one in sorted(equal, key=lambda position: -position.overlap):
        if all(differ(one.matrix, other.matrix) for other in distinct):
            distinct.append(one)
    return distinct


def _choose(target: PreparedSetUp, source: PreparedSetUp, equal: list[Position], rough: FloatArray | None) -> Position:
    """Return the only position, or the one nearest to the rough rotation."""
    if rough is None:
        if len(equal) > 1:
            raise RegistrationError(
                f"{len(equal)} positions of {source.name} relative to {target.name} fit equally well: the part is symmetric.",
                f"State roughly how the part was turned, for example --turned {source.name}=180,0,0 (about x, y, z), or use reference spheres.",
            )
        return equal[0]
    away = sorted((float(np.degrees(Rotation.from_matrix(one.matrix[:3, :3] @ rough.T).magnitude())), n) for n, one in enumerate(equal))
    for (nearest, number), (second, _) in pairwise([*away, (np.inf, -1)]):
        if nearest > HINT_WITHIN_DEG:
            raise RegistrationError(
                f"No position of {source.name} fits near the stated rotation; the nearest is {nearest:.0f}° away from it.",
                f"Correct --turned {source.name}=…: the rotation of the part about x, then y, then z, from the first set-up.",
            )
        if second - nearest < HINT_APART_DEG:
            raise RegistrationError(
                f"Two positions of {source.name} fit equally well, {nearest:.0f}° and {second:.0f}° away from the stated rotation.",
                f"State the rotation --turned {source.name}=… more precisely.",
            )
        return equal[number]
    raise AssertionError("unreachable: there is at least one position")


def _refusal(target: PreparedSetUp, source: PreparedSetUp, found: list[Position]) -> RegistrationError:
    """Return the reason why no position is possible."""
    overlapping = [one for one in found if one.overlap >= LEAST_OVERLAP]
    names = f"{target.name} and {source.name}"
    if not overlapping:
        most = max((one.overlap for one in found), default=0.0)
        return RegistrationError(
            f"{names} have too little surface in common: at most {most:.1%} of the smaller one, {LEAST_OVERLAP:.0%} are needed.",
            "Scan more of the surface in both set-ups, join them by reference spheres, or check that both are of one part.",
        )
    best = max(overlapping, key=lambda one: one.overlap * one.agreement - one.contradicted)
    if best.contradicted > MOST_CONTRADICTED:
        reason = f"{best.contradicted:.0%} of the points of one are where the other one saw empty space"
    else:
        reason = f"only {best.agreement:.0%} of the surface at the same place fits within {GOOD_MM} mm"
    return RegistrationError(
        f"{names} do not fit in any position: {reason}.",
        "Check that both are of the same part and that it was not changed between the set-ups; remove fixtures from the clouds.",
    )
