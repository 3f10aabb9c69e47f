"""The distance between two single measured points, as one clicks it in the picture."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.settings import UncertaintySettings
from measureapp.inspection.uncertainty import expanded


def point_distance(
    points_mm: FloatArray,
    sigmas_mm: tuple[float, float],
    same_view: bool,
    settings: UncertaintySettings = UncertaintySettings(),  # noqa: B008 - frozen
) -> tuple[float, float]:
    """Return the distance of two points in mm and its expanded uncertainty (k = 2).

    The noise of both points counts in full, as if the distance ran along their viewing rays; two views stand off
    independently of each other, one view alone does not change its own lengths. Which place of the surface was clicked
    is not part of it.

    Parameters
    ----------
    points_mm : (2, 3)
    sigmas_mm : standard deviation of each point along its viewing ray
    same_view : whether one view measured both points
    """
    length = float(np.linalg.norm(points_mm[1] - points_mm[0]))
    placed = 0.0 if same_view else np.sqrt(2.0) * settings.placement_mm
    return length, expanded(float(np.linalg.norm([*sigmas_mm, placed])), length, settings)
