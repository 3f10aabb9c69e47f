"""Unit and size check of points and nominal; another unit is asked for, never assumed."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray
from measureapp.data.length_unit import OTHER_UNITS, LengthUnit
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError, UnitQuestion
from measureapp.inspection.measured_points import MeasuredPoints, sample_mesh
from measureapp.inspection.surface.nominal import NominalSurface

UNIT_TOLERANCE = 0.2
LARGEST, SMALLEST = 1.6, 0.12
FITS, BETTER = 0.5, 3.0  # least agreement in another unit, and its ratio to that in millimetres, for a question about the unit
SAMPLES = 2_000
NEAR_SHARE = 0.03  # of the nominal's diagonal


def robust_diagonal(points_mm: FloatArray) -> float:
    """Return the diagonal of the box that contains 99 % of the points along each principal axis."""
    centred = points_mm - points_mm.mean(axis=0)
    axes = np.linalg.svd(centred[:: max(1, len(centred) // 20_000)], full_matrices=False)[2]
    low, high = np.percentile(centred @ axes.T, [0.5, 99.5], axis=0)
    return float(np.linalg.norm(high - low))


def check_size(points_mm: FloatArray, nominal_vertices_mm: FloatArray) -> None:
    """Refuse clouds of another unit or size than the nominal.

    Raises
    ------
    InspectionError
        The sizes differ by the factor of a unit, which is asked for, or by so much that it must be another part.
    """
    cloud, nominal = robust_diagonal(points_mm), _diagonal(nominal_vertices_mm)
    ratio = cloud / nominal
    for unit in OTHER_UNITS:
        if abs(ratio * unit.in_mm - 1) < UNIT_TOLERANCE:
            raise ask_points_unit(unit, f"The points span {cloud:.4g}, the nominal {nominal:.4g} mm")
        if abs(ratio / unit.in_mm - 1) < UNIT_TOLERANCE:
            raise _ask_nominal_unit(unit, f"The points span {cloud:.4g} mm, the nominal {nominal:.4g}")
    if not SMALLEST < ratio < LARGEST:
        raise InspectionError(
            f"The points span {cloud:.4g} mm, the nominal {nominal:.4g} mm: they are not of the same part.",
            "Choose the nominal of this part, or crop the surroundings from the cloud.",
        )


def check_unit(agreeing: Callable[[float], float], what: str) -> None:
    """Ask for the unit of points that match their nominal much better in another unit.

    Parameters
    ----------
    agreeing : scale factor of the points -> agreement (0…1)
    what : what agrees, for the sentence: "of the features are found"

    Raises
    ------
    InspectionError
        Names the unit of agreement.
    """
    as_given = agreeing(1.0)
    if BETTER * as_given > 1:
        return
    shares = {unit: agreeing(unit.in_mm) for unit in OTHER_UNITS}
    unit = max(shares, key=lambda one: shares[one])
    if shares[unit] >= max(FITS, BETTER * as_given):
        raise ask_points_unit(unit, f"Read as {unit.words}, {shares[unit]:.0%} {what}; read as millimetres, {as_given:.0%}")


def check_unit_against(points: MeasuredPoints, surface: NominalSurface) -> None:
    """Ask for the unit of points that match and cover the nominal in another unit only. Raises InspectionError."""
    few = points.points_mm[:: -(-len(points) // SAMPLES)]
    places = sample_mesh(Mesh(surface.vertices_mm, surface.triangles, "nominal"), SAMPLES).points_mm
    near_mm = NEAR_SHARE * surface.diagonal_mm

    def agreeing(factor: float) -> float:
        distance, _ = cKDTree(factor * few).query(places, distance_upper_bound=near_mm)
        off = np.linalg.norm(factor * few - surface.closest(factor * few).points_mm, axis=1)
        return float(np.mean(np.isfinite(distance)) * np.mean(off < near_mm))

    check_unit(agreeing, "of the nominal and of the points match")


def ask_points_unit(unit: LengthUnit, finding: str) -> UnitQuestion:
    """Return the question whether the points are in ``unit``."""
    hint = f"If they are, use `--unit {unit}`; otherwise scale the cloud to millimetres."
    return UnitQuestion(f"{finding}: the points look like {unit.words}.", hint, "points", unit, finding)


def _ask_nominal_unit(unit: LengthUnit, finding: str) -> UnitQuestion:
    hint = f'If it is, use `--nominal-unit {unit}`, in a program `nominal_unit = "{unit}"`; otherwise export the nominal in millimetres.'
    return UnitQuestion(f"{finding}: the nominal looks like {unit.words}.", hint, "nominal", unit, finding)


def _diagonal(vertices_mm: FloatArray) -> float:
    centred = vertices_mm - vertices_mm.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2]
    return float(np.linalg.norm(np.ptp(centred @ axes.T, axis=0)))
