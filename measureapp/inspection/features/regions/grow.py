"""Region growing by iterative surface fitting.

P. J. Besl and R. C. Jain, Segmentation through variable-order surface fitting, IEEE PAMI 10(2), 1988: a small patch is fitted; the points
that agree with it and are connected to the seed form a larger region, to which the next surface is fitted.
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
MOST_POINTS = 60_000  # a larger region is grown on an even subsample
FITTED_POINTS = 4_000
WIDER = 1.5  # growth factor of the sphere about the seed
ROUNDS, SETTLING = 60, 6
SIGMAS = 3.5
DETERMINED = 0.1  # greatest relative standard deviation of the radius of a determined shape
COMPARABLE_FIT = 1.5  # greatest ratio of the residuals of the shape and of the quadric
WHOLE_PART = 0.95  # greatest share of the part in one region
BENT_SIGMAS = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Region:
    """The points of one shape connected to a seed."""

    indices: IntArray  # (K,), ascending indices of its points
    feature: Feature  # the shape in the last iteration
    noise_mm: float
    limit_mm: float  # greatest distance from the shape
    border_reasons: Mapping[str, float]  # reason -> share of the border

    @property
    def stop_reason(self) -> str:
        """The reasons in words, most frequent first."""
        ordered = sorted(self.border_reasons.items(), key=lambda end: -end[1])
        return ", ".join(f"{share:.0%} {end}" for end, share in ordered if share >= 0.005)


BORDER, TILTED, DEPARTED = "end of the measured points", "surface tilted", "deviation from the shape"


def grow_region(points: MeasuredPoints, allowed: BoolArray, shape: Shape, seed_mm: FloatArray, requested: Grow) -> Region:
    """Grow the region of ``shape`` about a seed.

    A point belongs to it if it lies within ``form_mm`` + 3.5 σ of the shape, the plane through its neighbours is tilted against the shape
    by at most ``turn_deg`` + 3.5 σ of such a plane, its own normal, if any, is on the side of the region's, and it is connected to the
    seed by such points.

    Parameters
    ----------
    points : in the frame of the seed
    allowed : (N,), mask of the points to consider

    Raises
    ------
    InspectionError
        No surface at the seed, an edge there, another shape, or a region that covers the whole part.
    """
    grower = _Grower.at(points, allowed, shape, seed_mm, requested)
    surface, chosen, region = grower.grow()
    indices = grower.at_full_density(surface, chosen, region)
    if len(indices) > WHOLE_PART * len(points):
        raise InspectionError(
            f"the region grown from its seed covers the whole part ({len(indices)} of {len(points)} points)",
            "Limit it by x_mm, y_mm or z_mm of its cut, or define a nominal.",
        )
    if len(indices) < LEAST_POINTS:
        raise InspectionError(f"only {len(indices)} points of one {shape} are connected to its seed, {LEAST_POINTS} are needed")
    return Region(indices, surface.feature, grower.noise_mm, grower.limit_mm, grower.border_reasons(surface, chosen, region))


@dataclass(frozen=True, slots=True, eq=False)
class _Grower:
    points: MeasuredPoints
    away_mm: FloatArray  # (N,), distances from the seed; infinite where a point is not allowed
    shape: Shape
    requested: Grow
    start: int  # index of the point at the seed
    facing: FloatArray | None  # (3,), normal of the point at the seed
    patch: Patch
    radius_mm: float  # of the sphere around the first patch
    spacing_mm: float
    noise_mm: float

    @classmethod
    def at(cls, points: MeasuredPoints, allowed: BoolArray, shape: Shape, seed_mm: FloatArray, requested: Grow) -> _Grower:
        away = np.where(allowed, np.linalg.norm(points.points_mm - seed_mm, axis=1), np.inf)
        start = int(away.argmin())
        if not away[start] <= requested.reach_mm:
            raise InspectionError(f"no measured surface lies within {requested.reach_mm:g} mm of its seed")
        away = np.where(allowed, np.linalg.norm(points.points_mm - points.points_mm[start], axis=1), np.inf)
        first = np.argsort(away, kind="stable")[: FIRST_POINTS + 1] if len(away) <= FIRST_POINTS else np.argpartition(away, FIRST_POINTS)
        first = first[: FIRST_POINTS + 1]
        first = first[np.isfinite(away[first])]
        if len(first) < LEAST_POINTS:
            raise InspectionError(f"only {len(first)} points were measured around its seed, {LEAST_POINTS} are needed")
        facing = None if points.normals is None else np.asarray(points.normals[start], float)
        patch = _first_patch(points, first, start, facing)
        radius = float(away[first].max())
        own = np.inf if points.sigma_mm is None else float(np.median(points.sigma_mm[first]))
        noise = requested.noise_mm or (patch.scatter_mm if not np.isfinite(own) else max(own, patch.scatter_mm))
        spacing = local_spacing(np.sort(away[first])[1:])
        return cls(points, away, shape, requested, start, facing, patch, radius, spacing, max(noise, 1e-6))

    @property
    def limit_mm(self) -> float:
        """Greatest distance of a point from the shape."""
        return self.requested.form_mm + SIGMAS * self.noise_mm

    def grow(self) -> tuple[ShapeSurface, Neighbourhood, BoolArray]:
        """Enlarge the sphere about the seed until the region ends within it."""
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
                raise InspectionError(f"the region grown from its seed is not a {self.shape}, or too small to determine one")
            radius *= WIDER
        raise InspectionError("its region did not converge", "Limit it by x_mm, y_mm or z_mm of its cut.")

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
        if not agreeing[start]:  # the seed point is an outlier: use the nearest point that agrees
            others = np.flatnonzero(agreeing)
            off = np.linalg.norm(around.points_mm[others] - around.points_mm[start], axis=1)
            if len(others) == 0 or off.min() > 2 * around.link_mm:
                raise InspectionError(
                    f"its seed lies on an edge, or the surface there is not a {self.shape}", "Move it further inside the surface."
                )
            start = int(others[off.argmin()])
        return around.connected_component(agreeing, start)

    def _is_tilted(self, surface: LocalSurface, around: Neighbourhood, which: IntArray) -> BoolArray:
        """Return the mask of points whose surface is tilted against the fitted one."""
        if len(which) == 0:
            return np.zeros(0, bool)
        most = np.radians(self.requested.turn_deg) + SIGMAS * around.tilt_sigma_rad
        beside = surface.normals(around.points_mm[which])
        return np.asarray(np.abs(np.einsum("nd,nd->n", beside, around.normals(which))) < np.cos(most))

    def _refit(self, surface: LocalSurface, region_mm: FloatArray) -> LocalSurface:
        used = region_mm[:: -(-len(region_mm) // FITTED_POINTS)]
        if len(used) < LEAST_POINTS:
            raise InspectionError(f"only {len(used)} points of one {self.shape} are connected to its seed, {LEAST_POINTS} are needed")
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
            if known and made.rms_mm < COMPARABLE_FIT * max(patch.scatter_mm, self.noise_mm) + self.requested.form_mm
            else patch
        )

    def _refuse_another_shape(self, surface: ShapeSurface, points_mm: FloatArray, region: BoolArray) -> None:
        bent, noise = measure_bending(surface.feature, points_mm, region)
        if bent > self.requested.form_mm + BENT_SIGMAS * noise:
            raise InspectionError(
                f"the surface at its seed is not a {self.shape}: it bends away by {bent:.3f} mm over the region",
                "Choose another shape, or another seed.",
            )

    def at_full_density(self, surface: ShapeSurface, around: Neighbourhood, region: BoolArray) -> IntArray:
        """Return all points, at full density, that agree with the shape and lie next to points of the region."""
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
        """Return the reasons why the region ended, as shares of its border."""
        at_rim, outside = around.border(region)
        turned = self._is_tilted(surface, around, outside)
        counts = {BORDER: len(at_rim), TILTED: int(turned.sum()), DEPARTED: int((~turned).sum())}
        return {end: count / max(sum(counts.values()), 1) for end, count in counts.items()}


def _first_patch(points: MeasuredPoints, first: IntArray, start: int, facing: FloatArray | None) -> Patch:
    """Fit a smooth patch to the points nearest the seed."""
    places = points.points_mm[first]
    if facing is not None and points.normals is not None:
        same = np.asarray(points.normals, float)[first] @ facing > np.cos(np.radians(60.0))
        places = places[same]
    if len(places) < LEAST_POINTS:
        raise InspectionError(
            f"only {len(places)} points around its seed form one surface, {LEAST_POINTS} are needed", "Move it further inside the surface."
        )
    normal = np.linalg.svd(places - places.mean(axis=0), full_matrices=False)[2][2]
    return Patch.fit(places, normal, points.points_mm[start])
