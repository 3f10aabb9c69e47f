"""What sharp edges do to a feature: the blur of images lifts or lowers the points near them, also beyond the distance that is cut off.

No residual of a narrow face shows it, as all of its points are near an edge. Yet the effect decreases with the distance, so that the points
farthest from edges lie off the fit to all of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray
from measureapp.data.feature_program import CONTOURS
from measureapp.data.inspection_program import MeasuredFeature
from measureapp.geometry.fits import point_sensitivities
from measureapp.inspection.features.feature_errors import EDGES, MOST_POINTS, ErrorSource
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.shapes import signed_distances

FARTHEST = 0.25  # least share of the points that counts as far from edges
BEYOND = 3.0  # spacings of points beyond the distance that is cut off: points there count as far, where a face is so wide
REST = (7 / 3) ** 0.5  # root mean square of 1 + r for an r evenly distributed from 0 to 1: what is left at the far points


def estimate_edge_effects(
    found: Mapping[str, FoundFeature], described: MeasuredFeature, edges: cKDTree | None
) -> Mapping[str, FoundFeature]:
    """Return a feature, or the copies of its pattern, with the error that edges cause.

    The points farthest from edges are compared with all: a difference δ of their mean distances from the fitted shape moves the shape by δ
    along its normals. The far points are near an edge too, only less: what is left there is taken as evenly distributed between nothing and
    as much again (JCGM 100, 4.3.7), so δ is not a correction but, times √(7/3), a standard uncertainty. All features share it: images of one
    blur lift all of them. The variance s² of δ by the noise of the points is that of the mean of the far points less that of all, of which
    they are a part (J. A. Hausman, Econometrica 46(6), 1251-1271, 1978). The true shift has the mean square δ² + s², so that √(7/3) s is a
    further uncertainty, of each feature by itself: a shift that noise hides is no shift of nothing.

    Parameters
    ----------
    found : by name, as `find_feature` returns them for ``described``
    edges : points along the sharp edges of the nominal, in its frame; None: not known, or there are none
    """
    if edges is None or described.shape == "surface_point" or described.shape in CONTOURS:  # a patch or a slice is cut where it is wanted
        return found
    return {name: _with_edge_errors(one, described.cut.edge_mm, edges) for name, one in found.items()}


def _with_edge_errors(found: FoundFeature, cut_mm: float, edges: cKDTree) -> FoundFeature:
    if found.feature is None:
        return found
    points_mm = found.points_mm[:: -(-len(found.points_mm) // MOST_POINTS)]
    shift_mm, sigma_mm = _shift(points_mm, signed_distances(found.feature, points_mm), cut_mm, edges, found.correlation_factor)
    columns = point_sensitivities(found.feature, points_mm).sum(axis=1, keepdims=True) * REST
    errors = {ErrorSource(EDGES): columns * shift_mm, ErrorSource(EDGES, found.name): columns * sigma_mm}
    return replace(found, other_errors={**found.other_errors, **errors})


def _shift(points_mm: FloatArray, distances_mm: FloatArray, cut_mm: float, edges: cKDTree, factor: float) -> tuple[float, float]:
    """Return the mean distance of the far points less that of all points, and its standard deviation by their noise; both mm."""
    spacing_mm = float(np.median(cKDTree(points_mm).query(points_mm, k=2)[0][:, 1]))
    from_edges, _ = edges.query(points_mm)
    far = from_edges >= min(cut_mm + BEYOND * spacing_mm, float(np.quantile(from_edges, 1 - FARTHEST)))
    shift_mm = float(np.mean(distances_mm[far]) - np.mean(distances_mm))
    variance = float(np.var(distances_mm)) * factor**2 * (1 / np.count_nonzero(far) - 1 / len(far))
    return shift_mm, float(np.sqrt(max(variance, 0.0)))
