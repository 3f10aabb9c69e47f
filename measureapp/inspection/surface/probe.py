"""Deviation at a clicked place: local plane through the deviations around it, with number of points and expanded uncertainty."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import InspectionError
from measureapp.geometry.shapes import tangents
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import UncertaintySettings
from measureapp.inspection.surface.deviation_index import SAME_SIDE, DeviationIndex
from measureapp.inspection.uncertainty import COVERAGE_FACTOR, correlation_factor

DEFAULT_SPACINGS = 5.0
UNKNOWNS, LEAST = 3, 8  # of the plane; points
REJECTED_SIGMAS, MAD_TO_SIGMA = 3.5, 1.4826


@dataclass(frozen=True, slots=True, eq=False)
class ProbeValue:
    """Deviation at one place."""

    value_mm: float
    uncertainty_mm: float  # expanded, k = 2
    points: int
    radius_mm: float
    point_mm: FloatArray  # (3,), the place, in the nominal's frame
    normal: FloatArray  # (3,), of the nominal there
    assumed: str = ""  # which contributions are assumed, for points without an error model


def probe_deviation(
    index: DeviationIndex,
    place_mm: FloatArray,
    radius_mm: float | None = None,
    measured: MeasuredPoints | None = None,
    settings: UncertaintySettings = UncertaintySettings(),  # noqa: B008 - frozen
) -> ProbeValue:
    """Fit a plane to the deviations within ``radius_mm`` of a place, and evaluate it there.

    Parameters
    ----------
    place_mm : (3,), near a measured point, in the nominal's frame
    radius_mm : None: five point spacings
    measured : the compared points in the nominal's frame, in the same order, for the errors of their views; None: these are assumed

    Raises
    ------
    InspectionError
        Too few points are measured there.
    """
    found = index.found
    radius = DEFAULT_SPACINGS * index.spacing_mm if radius_mm is None else radius_mm
    normal = np.asarray(found.nominal_normals[int(index.tree.query(place_mm)[1])], np.float64)
    near = np.array(index.tree.query_ball_point(place_mm, radius), dtype=np.int64)
    near = near[found.nominal_normals[near] @ normal > SAME_SIDE] if len(near) else near
    if len(near) < LEAST:
        raise InspectionError(
            f"Only {len(near)} points were measured within {radius:.2g} mm of this place, {LEAST} are needed.", "Click another place."
        )
    design = np.column_stack([np.ones(len(near)), (found.points_mm[near] - place_mm) @ tangents(normal).T])
    values, kept = _fit(design, found.distances_mm[near])
    near, design = near[kept], design[kept]
    rest = found.distances_mm[near] - design @ values
    inverse = np.linalg.pinv(design)
    factor = correlation_factor(found.points_mm[near], rest, settings.correlation_mm, UNKNOWNS)
    noise = float(np.sqrt(rest @ rest / max(len(near) - UNKNOWNS, 1))) * float(np.linalg.norm(inverse[0])) * factor
    others, words = _view_errors(measured, near, inverse[0], normal, settings)
    uncertainty = COVERAGE_FACTOR * float(np.hypot(noise, others))
    return ProbeValue(float(values[0]), uncertainty, len(near), radius, np.asarray(place_mm, float), normal, words)


def _fit(design: FloatArray, deviations_mm: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Fit by least squares, reject outliers once, and fit again; return coefficients and the mask of the points used."""
    values = np.linalg.lstsq(design, deviations_mm, rcond=None)[0]
    rest = deviations_mm - design @ values
    limit = REJECTED_SIGMAS * MAD_TO_SIGMA * float(np.median(np.abs(rest - np.median(rest))))
    kept = np.abs(rest - np.median(rest)) <= max(limit, 1e-9)
    if kept.all() or np.count_nonzero(kept) < LEAST:
        return values, np.ones(len(rest), np.bool_)
    return np.linalg.lstsq(design[kept], deviations_mm[kept], rcond=None)[0], kept


def _view_errors(
    measured: MeasuredPoints | None, near: IntArray, weights: FloatArray, normal: FloatArray, settings: UncertaintySettings
) -> tuple[float, str]:
    """Return the standard uncertainty by the errors of the views, and words where it is assumed."""
    if measured is None or measured.errors is None or measured.view is None:
        words = f"assumed: views ± {settings.placement_mm:g} mm and calibration ± {settings.systematic_mm:g} mm (k = 1)"
        return float(np.hypot(settings.placement_mm, settings.systematic_mm)), words
    used = measured.where(near)
    assert used.errors is not None and used.view is not None
    moved = used.errors.along(used.points_mm, np.tile(normal, (len(used), 1)), used.view)
    return float(np.linalg.norm([np.linalg.norm(weights @ columns) for columns in moved.values()])), ""
