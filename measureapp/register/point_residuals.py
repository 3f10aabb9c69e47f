"""Residuals of single points after registration: signed distances from the merged surface."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import StitchedCloud

REACH_MM = 2.0  # points farther from the merged cloud have no residual


class MergedSurface:
    """The merged cloud with a search tree."""

    def __init__(self, stitched: StitchedCloud) -> None:
        self.stitched = stitched
        self._tree = cKDTree(stitched.points_mm)

    def residuals(self, points_mm: FloatArray) -> tuple[FloatArray, IntArray]:
        """Return point-to-plane distances from the merged surface, and the index of the nearest merged point.

        The distance is taken along the normal of the nearest merged point, so that the point spacing does not contribute.

        Parameters
        ----------
        points_mm : (N, 3), in the part's frame

        Returns
        -------
        residuals_mm : (N,), positive outside; NaN without a merged point within `REACH_MM`
        nearest : (N,) index into the merged cloud; its length where there is none
        """
        _, nearest = self._tree.query(points_mm, distance_upper_bound=REACH_MM, workers=-1)
        found = nearest < len(self.stitched)
        residuals = np.full(len(points_mm), np.nan)
        place = nearest[found]
        away = points_mm[found] - self.stitched.points_mm[place]
        residuals[found] = np.einsum("nd,nd->n", away, self.stitched.normals[place].astype(np.float64))
        return residuals, np.asarray(nearest)

    def rms_per_point(self, residuals_mm: FloatArray, nearest: IntArray) -> FloatArray:
        """Return the rms (M,) of the residuals assigned to each merged point; NaN where there are none."""
        known = np.isfinite(residuals_mm)
        count = np.bincount(nearest[known], minlength=len(self.stitched))
        squares = np.bincount(nearest[known], weights=residuals_mm[known] ** 2, minlength=len(self.stitched))
        return np.asarray(np.where(count > 0, np.sqrt(squares / np.maximum(count, 1)), np.nan))
