"""Distance between two single measured points, with expanded uncertainty."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.view_errors import ViewErrors
from measureapp.inspection.settings import UncertaintySettings
from measureapp.inspection.uncertainty import COVERAGE_FACTOR, expand_uncertainty


def point_distance(
    points_mm: FloatArray,
    sigmas_mm: tuple[float, float],
    same_view: bool,
    settings: UncertaintySettings = UncertaintySettings(),  # noqa: B008 - frozen
    views: tuple[int, int] | None = None,
    errors: ViewErrors | None = None,
) -> tuple[float, float]:
    """Return the distance of two points in mm, and its expanded uncertainty (k = 2).

    The noise of both points counts fully, as if the distance were along their viewing rays. The relative position of two views follows
    from the error model of the stitched cloud; without one, the views are displaced independently. The choice of the points on the
    surface is not part of the uncertainty.

    Parameters
    ----------
    points_mm : (2, 3)
    sigmas_mm : standard deviation of each point along its viewing ray
    same_view : whether one view measured both points
    views, errors : numbers of the views of both points, and the error model of the stitched cloud; None where not known
    """
    length = float(np.linalg.norm(points_mm[1] - points_mm[0]))
    scale_mm = settings.scale_ppm * 1e-6 * length
    if errors is not None and views is not None and length > 0:
        along = np.tile((points_mm[1] - points_mm[0]) / length, (2, 1))
        contributions = {name: columns[1] - columns[0] for name, columns in errors.along(points_mm, along, np.array(views)).items()}
        known = [float(np.linalg.norm(change)) for change in contributions.values()]
        noise = float(np.linalg.norm([*sigmas_mm, *known, scale_mm]))
        return length, COVERAGE_FACTOR * noise if "calibration" in contributions else expand_uncertainty(noise, length, settings)
    placed = 0.0 if same_view else np.sqrt(2.0) * settings.placement_mm
    return length, expand_uncertainty(float(np.linalg.norm([*sigmas_mm, placed, scale_mm])), length, settings)
