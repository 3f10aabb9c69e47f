"""Reference spheres: found in a set-up by their diameter, and assigned to those of another set-up."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations, permutations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import StitchedCloud
from measureapp.errors import FitError, RegistrationError
from measureapp.geometry.fits import fit
from measureapp.geometry.transform import RigidTransform, orthonormalise

VOTE_CELLS = 4.0  # cells of the votes for a centre, per radius
LEAST_VOTES, LEAST_COVERED = 60, 0.08  # points of a sphere, and share of it that they cover
SHELL = 0.06  # of the radius: greatest distance of a point from the sphere it belongs to
FACING = 0.94  # cosine between normal and radius
RADIUS_WITHIN = 0.02  # relative error of a fitted radius
LARGEST_RMS_MM = 0.1
MOST_SPHERES = 12
LEAST_SPHERES = 3
LOOSE_MM = 1.5  # spheres are assigned if they fit within this …
SIGMAS, FLOOR_MM = 4.0, 0.03  # … and contradict each other beyond this many standard deviations and this
BLOCK_MM = 2.0  # patches of correlated residuals


@dataclass(frozen=True, slots=True, eq=False)
class Sphere:
    """A reference sphere found in a set-up."""

    centre_mm: FloatArray  # (3,)
    covariance_mm2: FloatArray  # (3, 3), by the noise of its points
    radius_mm: float
    points: IntArray  # indices in the stitched cloud

    @property
    def place(self) -> str:
        """Its centre in words."""
        return "(" + ", ".join(f"{value + 0.0:.1f}" for value in np.round(self.centre_mm, 1)) + ")"


@dataclass(frozen=True, slots=True, eq=False)
class SphereMatch:
    """Corresponding spheres of two set-ups."""

    target_from_source: FloatArray  # (4, 4)
    target: tuple[int, ...]
    source: tuple[int, ...]
    residuals_mm: FloatArray  # (N,), distances of the centres


def find_spheres(cloud: StitchedCloud, diameter_mm: float) -> list[Sphere]:
    """Find spheres of a known diameter: every point votes for the centre that its normal points away from; clusters are fitted."""
    radius = diameter_mm / 2
    points, normals = np.asarray(cloud.points_mm), np.asarray(cloud.normals, np.float64)
    centres = points - radius * normals
    cell = radius / VOTE_CELLS
    keys, inverse, votes = np.unique(np.floor(centres / cell).astype(np.int64), axis=0, return_inverse=True, return_counts=True)
    counts = np.asarray(votes, np.float64)
    means = np.column_stack([np.bincount(inverse.ravel(), axis, len(keys)) for axis in centres.T]) / counts[:, None]
    spacing = float(cloud.notes.get("spacing_mm", 1.0))
    least = max(LEAST_VOTES / 4, 0.2 * LEAST_COVERED * 4 * np.pi * radius**2 / spacing**2)
    found: list[Sphere] = []
    for number in np.argsort(-counts):
        if counts[number] < least or len(found) == MOST_SPHERES:
            break
        if all(np.linalg.norm(means[number] - other.centre_mm) > radius for other in found):
            sphere = _fit_sphere(points, normals, means[number], radius, spacing)
            if sphere is not None and all(np.linalg.norm(sphere.centre_mm - other.centre_mm) > radius for other in found):
                found.append(sphere)
    return found


def _fit_sphere(points: FloatArray, normals: FloatArray, start_mm: FloatArray, radius: float, spacing: float) -> Sphere | None:
    """Fit a sphere around a centre; None if the points there are not a sphere of this radius."""
    centre = np.asarray(start_mm)
    for shell in (4 * SHELL, SHELL):
        away = points - centre
        distance = np.linalg.norm(away, axis=1)
        facing = np.einsum("ij,ij->i", away, normals) > FACING * distance
        own = np.flatnonzero((np.abs(distance - radius) < shell * radius) & facing)
        if len(own) < LEAST_VOTES or len(own) * spacing**2 < LEAST_COVERED * 4 * np.pi * radius**2:
            return None
        try:
            feature = fit("sphere", points[own], robust=True)
        except FitError:
            return None
        centre = feature.point_mm
    if feature.radius_mm is None or feature.covariance is None or feature.rms_mm > LARGEST_RMS_MM:
        return None
    if abs(feature.radius_mm - radius) > RADIUS_WITHIN * radius:
        return None
    factor = _correlation_factor(points[own], np.linalg.norm(points[own] - centre, axis=1) - feature.radius_mm)
    return Sphere(centre, factor * feature.covariance[:3, :3], feature.radius_mm, own)


def _correlation_factor(points_mm: FloatArray, residuals_mm: FloatArray) -> float:
    """Return the variance factor by the correlation of neighbouring points: from the scatter of sums over patches, at least 1."""
    cells = np.unique(np.floor(points_mm / BLOCK_MM).astype(np.int64), axis=0, return_inverse=True)[1].ravel()
    sums = np.bincount(cells, residuals_mm)
    return max(1.0, float(sums @ sums) / max(float(residuals_mm @ residuals_mm), 1e-30))


def match_spheres(target: list[Sphere], source: list[Sphere], names: tuple[str, str]) -> list[SphereMatch]:
    """Assign the spheres of two set-ups to each other by their mutual distances; return all assignments of the greatest number.

    Raises
    ------
    RegistrationError
        A set-up has fewer than three spheres, fewer than three correspond, or they contradict each other.
    """
    for name, spheres in zip(names, (target, source), strict=True):
        if len(spheres) < LEAST_SPHERES:
            raise RegistrationError(
                f"Only {len(spheres)} reference spheres were found in {name}; at least {LEAST_SPHERES} are needed.",
                "Check their diameter, and scan every sphere in both set-ups.",
            )
    found = _assignments(target, source)
    if not found:
        raise RegistrationError(
            f"The reference spheres of {names[0]} and {names[1]} do not correspond: no three have the same distances within {LOOSE_MM} mm.",
            "Use the same spheres in both set-ups, and do not move them between the set-ups.",
        )
    most = max(len(one.target) for one in found)
    best = sorted((one for one in found if len(one.target) == most), key=lambda one: float(np.sum(one.residuals_mm**2)))
    consistent = [one for one in best if not _contradictions(one, target, source)]
    if not consistent:
        worst, off, limit = _contradictions(best[0], target, source)[0]
        raise RegistrationError(
            f"The reference spheres of {names[0]} and {names[1]} contradict each other: the sphere at {target[worst].place} mm is "
            f"{off:.3f} mm off the others, the limit is {limit:.3f} mm.",
            "A sphere was moved between the set-ups, or one of them is measured badly: fasten the spheres and scan again.",
        )
    return consistent


def _assignments(target: list[Sphere], source: list[Sphere]) -> list[SphereMatch]:
    """Return the distinct assignments by three spheres each, extended by all others that fit loosely."""
    ours, theirs = (np.array([one.centre_mm for one in spheres]) for spheres in (target, source))
    known: dict[tuple[tuple[int, int], ...], SphereMatch] = {}
    between = np.linalg.norm(ours[:, None] - ours, axis=2)
    across = np.linalg.norm(theirs[:, None] - theirs, axis=2)
    for i, j, k in combinations(range(len(ours)), 3):
        for a, b, c in permutations(range(len(theirs)), 3):
            gaps = (between[i, j] - across[a, b], between[j, k] - across[b, c], between[i, k] - across[a, c])
            if max(map(abs, gaps)) > LOOSE_MM:
                continue
            matrix = rigid_fit(ours[[i, j, k]], theirs[[a, b, c]], np.ones(3))
            match = _extend(matrix, ours, theirs)
            if len(match.target) >= LEAST_SPHERES:
                known.setdefault(tuple(zip(match.target, match.source, strict=True)), match)
    return list(known.values())


def _extend(matrix: FloatArray, ours: FloatArray, theirs: FloatArray) -> SphereMatch:
    moved = theirs @ matrix[:3, :3].T + matrix[:3, 3]
    apart = np.linalg.norm(ours[:, None] - moved, axis=2)
    pairs = [(i, int(apart[i].argmin())) for i in range(len(ours)) if apart[i].min() < LOOSE_MM]
    pairs = [(i, j) for i, j in pairs if int(apart[:, j].argmin()) == i]
    if len(pairs) < LEAST_SPHERES:
        return SphereMatch(matrix, (), (), np.empty(0))
    target, source = (tuple(column) for column in zip(*pairs, strict=True))
    fitted = rigid_fit(ours[list(target)], theirs[list(source)], np.ones(len(pairs)))
    left = ours[list(target)] - theirs[list(source)] @ fitted[:3, :3].T - fitted[:3, 3]
    return SphereMatch(fitted, target, source, np.linalg.norm(left, axis=1))


def _contradictions(match: SphereMatch, target: list[Sphere], source: list[Sphere]) -> list[tuple[int, float, float]]:
    """Return the spheres that are further off than their uncertainty explains: number, distance, limit (mm); worst first."""
    found = []
    for i, j, off in zip(match.target, match.source, match.residuals_mm, strict=True):
        sigma = float(np.sqrt(np.linalg.eigvalsh(target[i].covariance_mm2 + source[j].covariance_mm2)[-1]))
        limit = FLOOR_MM + SIGMAS * sigma
        if off > limit:
            found.append((i, float(off), limit))
    return sorted(found, key=lambda one: one[2] - one[1])


def rigid_fit(target_mm: FloatArray, source_mm: FloatArray, weights: FloatArray) -> FloatArray:
    """Least-squares rigid motion of points (N, 3): return (4, 4) target_from_source (W. Kabsch, Acta Cryst. A32, 922, 1976)."""
    share = weights / weights.sum()
    ours, theirs = share @ target_mm, share @ source_mm
    u, _, vt = np.linalg.svd((target_mm - ours).T @ ((source_mm - theirs) * share[:, None]))
    rotation = u @ np.diag([1.0, 1.0, np.linalg.det(u @ vt)]) @ vt
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, ours - rotation @ theirs
    return matrix


def as_transform(match: SphereMatch, to_frame: str, from_frame: str) -> RigidTransform:
    """Return the position of a match as a transform."""
    return RigidTransform(orthonormalise(match.target_from_source), to_frame, from_frame)
