"""Region growing by a surface that is fitted anew as the region grows.

P. J. Besl and R. C. Jain, Segmentation through variable-order surface fitting, IEEE PAMI 10(2), 1988: a small patch is
fitted, points that agree with it and hang together with the seed make a larger region, the next surface is fitted to that.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cut import Grow
from measureapp.data.feature import Feature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import fit
from measureapp.inspection.features.regions.neighbours import Neighbourhood, local_spacing
from measureapp.inspection.features.regions.surfaces import LocalSurface, Patch, ShapeSurface, measure_bending
from measureapp.inspection.measured_points import MeasuredPoints, thin_indices

FIRST_POINTS = 100
LEAST_POINTS = 30
MOST_POINTS = 60_000  # at once; a larger region is grown on an even choice of its points
FITTED_POINTS = 4_000
WIDER = 1.5  # of the sphere about the seed from round to round
ROUNDS, SETTLING = 60, 6
SIGMAS = 3.5
DETERMINED = 0.1  # relative standard deviation of a radius from which on the shape is known
COMPARABLE_FIT = 1.5  # the shape must fit a patch this well, compared with the quadric
WHOLE_PART = 0.95  # share of the part at which a region is no feature of it
BENT_SIGMAS = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Region:
    """The points of one shape about a seed."""

    indices: IntArray  # (K,), ascending, into the points it was grown on
    feature: Feature  # the shape as it was compared with at last
    noise_mm: float
    limit_mm: float  # greatest distance from the shape
    border_reasons: Mapping[str, float]  # why it stopped -> share of its border

    @property
    def stop_reason(self) -> str:
        """The ends in words, the most frequent first."""
        ordered = sorted(self.border_reasons.items(), key=lambda end: -end[1])
        return ", ".join(f"{share:.0%} {end}" for end, share in ordered if share >= 0.005)


BORDER, TILTED, DEPARTED = "where the measured points end", "where the surface turns away", "where it departs from the shape"


def grow_region(points: MeasuredPoints, allowed: BoolArray, shape: Shape, seed_mm: FloatArray, asked: Grow) -> Region:
    """Grow the region of ``shape`` about a seed.

    A point belongs when it lies within ``form_mm`` + 3.5 σ of the shape, the plane through its neighbours is turned
    against the shape by no more than ``turn_deg`` + 3.5 σ of such a plane, its own normal, if it has one, looks to the
    same side as the region's, and it hangs together with the seed by such points.

    Parameters
    ----------
    points : in the frame of the seed
    allowed : (N,), which of them may belong at all

    Raises
    ------
    InspectionError
        No surface at the seed, an edge there, another shape, or a region that runs over the whole part.
    """
    grower = _Grower.at(points, allowed, shape, seed_mm, asked)
    surface, chosen, region = grower.grow()
    indices = grower.at_full_density(surface, chosen, region)
    if len(indices) > WHOLE_PART * len(points):
        raise InspectionError(
            f"the region that grows from its seed runs over the whole part ({len(indices)} of {len(points)} points)",
            "Limit it by x_mm, y_mm or z_mm of its cut, or take the points around a nominal.",
        )
    if len(indices) < LEAST_POINTS:
        raise InspectionError(f"only {len(indices)} points grow from its seed as one {shape}, {LEAST_POINTS} are needed")
    return Region(indices, surface.feature, grower.noise_mm, grower.limit_mm, grower.border_reasons(surface, chosen, region))


@dataclass(frozen=True, slots=True, eq=False)
class _Grower:
    points: MeasuredPoints
    away_mm: FloatArray  # (N,), distances from the seed; infinite where a point is not allowed
    shape: Shape
    asked: Grow
    start: int  # index of the point at the seed
    facing: FloatArray | None  # (3,), normal of the point at the seed
    patch: Patch
    radius_mm: float  # of the sphere that holds the first patch
    spacing_mm: float
    noise_mm: float

    @classmethod
    def at(cls, points: MeasuredPoints, allowed: BoolArray, shape: Shape, seed_mm: FloatArray, asked: Grow) -> _Grower:
        away = np.where(allowed, np.linalg.norm(points.points_mm - seed_mm, axis=1), np.inf)
        start = int(away.argmin())
        if not away[start] <= asked.reach_mm:
            raise InspectionError(f"no measured surface lies within {asked.reach_mm:g} mm of its seed")
        away = np.where(allowed, np.linalg.norm(points.points_mm - points.points_mm[start], axis=1), np.inf)
        first = np.argsort(away, kind="stable")[: FIRST_POINTS + 1] if len(away) <= FIRST_POINTS else np.argpartition(away, FIRST_POINTS)
        first = first[: FIRST_POINTS + 1]
        first = first[np.isfinite(away[first])]
        if len(first) < LEAST_POINTS:
            raise InspectionError(f"only {len(first)} points were measured about its seed, {LEAST_POINTS} are needed")
        facing = None if points.normals is None else np.asarray(points.normals[start], float)
        patch = _first_patch(points, first, start, facing)
        radius = float(away[first].max())
        own = np.inf if points.sigma_mm is None else float(np.median(points.sigma_mm[first]))
        noise = asked.noise_mm or (patch.scatter_mm if not np.isfinite(own) else max(own, patch.scatter_mm))
        spacing = local_spacing(np.sort(away[first])[1:])
        return cls(points, away, shape, asked, start, facing, patch, radius, spacing, max(noise, 1e-6))

    @property
    def limit_mm(self) -> float:
        """Greatest distance of a point from the shape."""
        return self.asked.form_mm + SIGMAS * self.noise_mm

    def grow(self) -> tuple[ShapeSurface, Neighbourhood, BoolArray]:
        """Widen the sphere about the seed until the region ends within it."""
        surface: LocalSurface = self.patch
        radius, largest = self.radius_mm, float(self.away_mm[np.isfinite(self.away_mm)].max())
        for _ in range(ROUNDS):
            around, start = self._around(radius)
            region = self._select(surface, around, start)
            for _ in range(SETTLING):
                surface = self._refit(surface, around.points_mm[region])
                before, region = region, self._select(surface, around, start)
                if np.array_equal(before, region):
                    break
            reached = float(np.linalg.norm(around.points_mm[region] - around.points_mm[start], axis=1).max())
            if reached < radius - around.link_mm or radius > largest:
                if isinstance(surface, ShapeSurface):
                    self._refuse_another_shape(surface, around.points_mm, region)
                    return surface, around, region
                raise InspectionError(f"what grows from its seed is no {self.shape}, or too small a piece to determine one")
            radius *= WIDER
        raise InspectionError("its region did not come to an end", "Limit it by x_mm, y_mm or z_mm of its cut.")

    def _around(self, radius_mm: float) -> tuple[Neighbourhood, int]:
        near = np.flatnonzero(self.away_mm <= radius_mm)
        chosen = near[thin_indices(self.points.points_mm[near], MOST_POINTS)]
        spacing = self.spacing_mm * np.sqrt(len(near) / len(chosen))
        made = Neighbourhood.of(self.points.points_mm[chosen], spacing, self.noise_mm)
        return made, int(made.tree.query(self.points.points_mm[self.start])[1])

    def _select(self, surface: LocalSurface, around: Neighbourhood, start: int) -> BoolArray:
        distances = np.abs(surface.distances(around.points_mm))
        agreeing = distances <= self.limit_mm
        which = np.flatnonzero(agreeing)
        agreeing[which[self._is_tilted(surface, around, which)]] = False
        if not agreeing[start]:  # an outlier itself: the nearest point that agrees stands for it
            others = np.flatnonzero(agreeing)
            off = np.linalg.norm(around.points_mm[others] - around.points_mm[start], axis=1)
            if len(others) == 0 or off.min() > 2 * around.link_mm:
                raise InspectionError(
                    f"its seed lies on an edge, or the surface there is no {self.shape}", "Put it further inside the surface."
                )
            start = int(others[off.argmin()])
        return around.connected_component(agreeing, start)

    def _is_tilted(self, surface: LocalSurface, around: Neighbourhood, which: IntArray) -> BoolArray:
        """Which of some points lie where the surface is turned against the one compared with."""
        if len(which) == 0:
            return np.zeros(0, bool)
        most = np.radians(self.asked.turn_deg) + SIGMAS * around.tilt_sigma_rad
        beside = surface.normals(around.points_mm[which])
        return np.asarray(np.abs(np.einsum("nd,nd->n", beside, around.normals(which))) < np.cos(most))

    def _refit(self, surface: LocalSurface, region_mm: FloatArray) -> LocalSurface:
        used = region_mm[:: -(-len(region_mm) // FITTED_POINTS)]
        if len(used) < LEAST_POINTS:
            raise InspectionError(f"only {len(used)} points grow from its seed as one {self.shape}, {LEAST_POINTS} are needed")
        if isinstance(surface, ShapeSurface):
            return ShapeSurface(fit(self.shape, used, start=surface.feature))
        patch = Patch.fit(used, self.patch.axes[2], self.patch.point_mm)
        try:
            made = fit(self.shape, used)
        except FitError:
            return patch
        radius_sigma = made.standard_deviations.get("radius_mm", 0.0)
        known = made.radius_mm is None or radius_sigma < DETERMINED * made.radius_mm
        return (
            ShapeSurface(made)
            if known and made.rms_mm < COMPARABLE_FIT * max(patch.scatter_mm, self.noise_mm) + self.asked.form_mm
            else patch
        )

    def _refuse_another_shape(self, surface: ShapeSurface, points_mm: FloatArray, region: BoolArray) -> None:
        bent, noise = measure_bending(surface.feature, points_mm, region)
        if bent > self.asked.form_mm + BENT_SIGMAS * noise:
            raise InspectionError(
                f"the surface at its seed is no {self.shape}: over the region that grows there it bends away by {bent:.3f} mm",
                "Ask for another shape, or put the seed elsewhere.",
            )

    def at_full_density(self, surface: ShapeSurface, around: Neighbourhood, region: BoolArray) -> IntArray:
        """Return all points that agree with the shape and lie beside points of the region."""
        grown = around.points_mm[region]
        low, high = grown.min(axis=0) - around.link_mm, grown.max(axis=0) + around.link_mm
        near = np.flatnonzero(np.isfinite(self.away_mm) & np.all((self.points.points_mm > low) & (self.points.points_mm < high), axis=1))
        near = near[np.abs(surface.distances(self.points.points_mm[near])) <= self.limit_mm]
        if self.points.normals is not None and self.facing is not None and len(near):
            beside = surface.normals(self.points.points_mm[near])
            at_seed = surface.normals(self.points.points_mm[[self.start]])[0]
            same = np.sign(at_seed @ self.facing) * np.einsum("nd,nd->n", beside, np.asarray(self.points.normals, float)[near]) > 0
            near = near[same]
        off, _ = cKDTree(grown).query(self.points.points_mm[near], distance_upper_bound=0.6 * around.spacing_mm * np.sqrt(2))
        return near[np.isfinite(off)]

    def border_reasons(self, surface: ShapeSurface, around: Neighbourhood, region: BoolArray) -> Mapping[str, float]:
        """Return by which shares of its border the region ended why."""
        at_rim, outside = around.border(region)
        turned = self._is_tilted(surface, around, outside)
        counts = {BORDER: len(at_rim), TILTED: int(turned.sum()), DEPARTED: int((~turned).sum())}
        return {end: count / max(sum(counts.values()), 1) for end, count in counts.items()}


def _first_patch(points: MeasuredPoints, first: IntArray, start: int, facing: FloatArray | None) -> Patch:
    """Fit the points nearest the seed that make one smooth patch with it."""
    places = points.points_mm[first]
    if facing is not None and points.normals is not None:
        same = np.asarray(points.normals, float)[first] @ facing > np.cos(np.radians(60.0))
        places = places[same]
    if len(places) < LEAST_POINTS:
        raise InspectionError(
            f"only {len(places)} points about its seed make one surface, {LEAST_POINTS} are needed", "Put it further inside the surface."
        )
    normal = np.linalg.svd(places - places.mean(axis=0), full_matrices=False)[2][2]
    return Patch.fit(places, normal, points.points_mm[start])
