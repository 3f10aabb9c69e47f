"""Measured features: point selection, fit with outlier rejection, and plausibility check."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import MeasuredFeature
from measureapp.data.view_errors import ViewErrors
from measureapp.errors import FitError
from measureapp.geometry.contours import fit_contour, is_contour
from measureapp.inspection.features.cut import NominalFeature, cut_points, nominal_features
from measureapp.inspection.features.feature_errors import (
    NOISE,
    Errors,
    ErrorSource,
    estimate_view_errors,
    noise_errors,
    propagate_point_errors,
)
from measureapp.inspection.features.shapes import signed_distances
from measureapp.inspection.features.surface_point import QUADRIC, fit_surface_point, linearise_surface_point
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.uncertainty import PLANE, correlation_factor, effective_views

MAD_TO_SIGMA = 1.4826
TRIM_ROUNDS = 3
CONTOUR = 5  # most unknowns of a contour
LEAST_KNOWN = 0.1  # relative standard deviation of a radius above which a contour is not determined
GREATEST_TILT_DEG = 20.0


@dataclass(frozen=True, slots=True, eq=False)
class EdgeProfile:
    """Points of an edge, one for each section along it."""

    points_mm: FloatArray  # (K, 3)
    noise_mm: FloatArray  # (K,), standard deviation in the least certain direction across the edge


@dataclass(frozen=True, slots=True, eq=False)
class FoundFeature:
    """A feature found on the part, or the reason why it was not found."""

    name: str
    feature: Feature | None
    reason: str = ""
    correlation_factor: float = 1.0  # factor of the standard deviations by correlated neighbouring points
    views: float = 1.0  # effective number of views
    points_mm: FloatArray = field(default_factory=lambda: np.empty((0, 3)))  # the fitted points
    nominal: Feature | None = None  # as designed
    hole: bool = field(default=False, kw_only=True)  # material outside
    other_errors: Errors = field(
        default_factory=dict, kw_only=True
    )  # beyond noise: by its views and by edges; of a constructed feature all errors
    view: IntArray | None = field(default=None, kw_only=True)  # (N,), the view of each of its points
    view_errors: ViewErrors | None = field(default=None, kw_only=True)  # of those views; None where not known
    edge_profile: EdgeProfile | None = field(default=None, kw_only=True)  # points along an edge, for its straightness
    draws: int = field(default=0, kw_only=True)  # Monte Carlo draws of its covariance; 0: law of propagation

    @property
    def errors(self) -> Errors:
        """All errors by source; empty for a feature that was not found."""
        if self.feature is None or len(self.points_mm) == 0:
            return self.other_errors
        return {ErrorSource(NOISE, self.name): noise_errors(self.feature, self.correlation_factor), **self.other_errors}

    @property
    def direction_sigma(self) -> float:
        """Standard deviation of the direction in rad, with correlated errors."""
        return self._sigma("direction_rad")

    @property
    def radius_sigma(self) -> float:
        """Standard deviation of the radius in mm, with correlated errors."""
        return self._sigma("radius_mm")

    @property
    def half_angle_sigma(self) -> float:
        """Standard deviation of a cone's half angle in rad, with correlated errors."""
        return self._sigma("half_angle_rad")

    def _sigma(self, key: str) -> float:
        return 0.0 if self.feature is None else self.feature.standard_deviations.get(key, 0.0) * self.correlation_factor


def find_feature(
    described: MeasuredFeature, points: MeasuredPoints, edges: cKDTree | None, settings: InspectionSettings
) -> Mapping[str, FoundFeature]:
    """Find a feature, or all copies of its pattern, on ``points`` (in the nominal's frame)."""
    return {nominal.feature.name: _find_copy(nominal, points, edges, settings) for nominal in nominal_features(described)}


def _find_copy(nominal: NominalFeature, points: MeasuredPoints, edges: cKDTree | None, settings: InspectionSettings) -> FoundFeature:
    return fit_feature(nominal, points, cut_points(points, nominal, edges), settings, nominal.feature)


def fit_feature(
    expected: NominalFeature, points: MeasuredPoints, chosen: IntArray, settings: InspectionSettings, nominal: Feature | None
) -> FoundFeature:
    """Fit the shape of ``expected``, starting there, to the chosen points; ``drawn`` is its nominal, if there is one."""
    name = expected.feature.name
    if len(chosen) < settings.least_points:
        reason = f"{name}: only {len(chosen)} points were measured there, {settings.least_points} are needed"
        return FoundFeature(name, None, reason, nominal=nominal)
    if len(chosen) > settings.fit_points:
        chosen = chosen[:: -(-len(chosen) // settings.fit_points)]
    cut = points.where(chosen)
    try:
        feature, residuals, kept = _fit_with_trimming(expected, cut, settings)
    except FitError as error:
        return FoundFeature(name, None, f"{name}: {error.message}", nominal=nominal)
    if reason := _implausible(feature, expected):
        return FoundFeature(name, None, f"{name}: {reason}", nominal=nominal)
    used = cut.where(kept)
    factor = correlation_factor(used.points_mm, residuals, settings.uncertainty.correlation_mm, _unknowns(expected))
    views = effective_views(used.view)
    by_views = _estimate_view_errors(expected, feature, used, settings.uncertainty.placement_mm, views)
    return FoundFeature(
        name,
        feature,
        "",
        factor,
        views,
        used.points_mm,
        nominal,
        hole=expected.hole,
        other_errors=by_views,
        view=used.view,
        view_errors=used.errors,
    )


def _estimate_view_errors(nominal: NominalFeature, feature: Feature, used: MeasuredPoints, placement_mm: float, views: float) -> Errors:
    if nominal.surface_point and used.errors is not None and used.view is not None:
        return propagate_point_errors(*linearise_surface_point(nominal.feature, used))
    return estimate_view_errors(feature, used, _weights(used), placement_mm, views)


def _unknowns(expected: NominalFeature) -> int:
    if expected.surface_point:
        return QUADRIC
    return CONTOUR if is_contour(expected.feature) else PLANE


def _fit_with_trimming(nominal: NominalFeature, cut: MeasuredPoints, settings: InspectionSettings) -> tuple[Feature, FloatArray, IntArray]:
    """Iterative fit with outlier rejection; return feature, residuals, and indices of the points used."""
    kept = np.arange(len(cut))
    for _ in range(TRIM_ROUNDS):
        used = cut.where(kept)
        feature, distances = _fit(nominal, used, cut.points_mm)
        limit = settings.trim_sigma * MAD_TO_SIGMA * float(np.median(np.abs(distances[kept] - np.median(distances[kept]))))
        within = np.flatnonzero(np.abs(distances) <= max(limit, 1e-9))
        if len(within) == len(kept) or len(within) < settings.least_points:
            break
        kept = within
    feature, distances = _fit(nominal, cut.where(kept), cut.points_mm)
    made = replace(
        feature, name=nominal.feature.name, points=len(kept), left_out=len(cut) - len(kept), boundary_mm=_extent(cut.points_mm[kept])
    )
    return made, distances[kept], kept


def _fit(nominal: NominalFeature, used: MeasuredPoints, all_points_mm: FloatArray) -> tuple[Feature, FloatArray]:
    """Fit the shape to ``used``; return it with the nominal's orientation, and the distances of all points of the cut."""
    if nominal.surface_point:
        return fit_surface_point(nominal.feature, used, all_points_mm)
    if is_contour(nominal.feature):
        contour = fit_contour(nominal.feature, used.points_mm, _weights(used))
        return contour, signed_distances(contour, all_points_mm)
    from measureapp.geometry.fits import fit

    feature = fit(nominal.feature.shape, used.points_mm, weights=_weights(used), start=nominal.feature)
    expected = nominal.feature.direction
    if feature.direction is not None and expected is not None and feature.direction @ expected < 0 and feature.shape != "cone":
        feature = _flip_direction(feature)
    return feature, signed_distances(feature, all_points_mm)


def _flip_direction(feature: Feature) -> Feature:
    assert feature.direction is not None and feature.covariance is not None
    signs = np.where((np.arange(len(feature.covariance)) >= 3) & (np.arange(len(feature.covariance)) < 6), -1.0, 1.0)
    return replace(feature, direction=-feature.direction, covariance=feature.covariance * np.outer(signs, signs))


def _weights(used: MeasuredPoints) -> FloatArray | None:
    """Return weights from inverse variances, with median 1 and at most 4; None where unknown."""
    if used.sigma_mm is None:
        return None
    sigma_mm = np.asarray(used.sigma_mm, float)
    median = float(np.median(sigma_mm))
    return (median / np.maximum(sigma_mm, median / 2)) ** 2


def _implausible(feature: Feature, nominal: NominalFeature) -> str:
    expected = nominal.feature
    if feature.direction is not None and expected.direction is not None:
        tilt = np.degrees(np.arccos(np.clip(abs(float(feature.direction @ expected.direction)), 0, 1)))
        if tilt > GREATEST_TILT_DEG:
            return f"the fitted {expected.shape} is tilted by {tilt:.0f}° against its nominal"
    if feature.radius_mm is not None and expected.radius_mm is not None:
        if is_contour(feature) and feature.standard_deviations.get("radius_mm", 0.0) > LEAST_KNOWN * feature.radius_mm:
            return f"its points cover too small a part of the {expected.shape} to determine it at their noise"
        off = feature.radius_mm - expected.radius_mm
        if abs(off) > 2 * nominal.cut.band_mm:
            return f"the fitted radius differs by {off:+.1f} mm from its nominal"
    return ""


def _extent(points_mm: FloatArray) -> FloatArray:
    """Return the corners (2, 3) of the bounding box."""
    return np.stack([points_mm.min(axis=0), points_mm.max(axis=0)])
