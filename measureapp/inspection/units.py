"""Whether a cloud is in millimetres and of the size of its nominal."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import InspectionError

FACTORS = {"metres": 1e-3, "centimetres": 0.1, "inches": 1 / 25.4, "micrometres": 1e3}
UNIT_TOLERANCE = 0.2
LARGEST, SMALLEST = 1.6, 0.12


def robust_diagonal(points_mm: FloatArray) -> float:
    """Return the diagonal of the box that holds 99 % of the points along each principal axis."""
    centred = points_mm - points_mm.mean(axis=0)
    axes = np.linalg.svd(centred[:: max(1, len(centred) // 20_000)], full_matrices=False)[2]
    low, high = np.percentile(centred @ axes.T, [0.5, 99.5], axis=0)
    return float(np.linalg.norm(high - low))


def check_size(points_mm: FloatArray, nominal_vertices_mm: FloatArray) -> None:
    """Refuse clouds of another unit or of another size than the nominal.

    Raises
    ------
    InspectionError
        The sizes differ by the factor of a unit, which is named, or by so much that it cannot be this part.
    """
    cloud, nominal = robust_diagonal(points_mm), _diagonal(nominal_vertices_mm)
    ratio = cloud / nominal
    for unit, factor in FACTORS.items():
        if abs(ratio / factor - 1) < UNIT_TOLERANCE:
            raise InspectionError(
                f"The points span {cloud:.4g}, the nominal {nominal:.4g} mm: the points look like {unit}.",
                "Scale the cloud to millimetres.",
            )
        if abs(ratio * factor - 1) < UNIT_TOLERANCE:
            raise InspectionError(
                f"The points span {cloud:.4g} mm, the nominal {nominal:.4g}: the nominal looks like {unit}.",
                "Export the nominal in millimetres.",
            )
    if not SMALLEST < ratio < LARGEST:
        raise InspectionError(
            f"The points span {cloud:.4g} mm, the nominal {nominal:.4g} mm: this is not the part of the nominal.",
            "Choose the nominal of this part, or cut the surroundings out of the cloud.",
        )


def _diagonal(vertices_mm: FloatArray) -> float:
    centred = vertices_mm - vertices_mm.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2]
    return float(np.linalg.norm(np.ptp(centred @ axes.T, axis=0)))
