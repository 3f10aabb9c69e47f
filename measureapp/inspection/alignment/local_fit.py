"""Local best fit of chosen features and regions, unaffected by a worn or bent remainder."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.alignment_program import BestFit, Region
from measureapp.data.inspection_program import InspectionProgram, MeasuredFeature
from measureapp.data.measurement import Alignment
from measureapp.errors import InspectionError
from measureapp.geometry.transform import orthonormalise
from measureapp.inspection.alignment.point_to_plane import register
from measureapp.inspection.features.cut import cut_points, nominal_features
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.progress import NoProgress, Progress

ROUNDS = 3  # the points are selected again after each fit


def local_fit(
    points: MeasuredPoints,
    program: InspectionProgram,
    requested: BestFit,
    start: Alignment,
    surface: NominalSurface,
    settings: InspectionSettings,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Alignment:
    """Fit the points of the chosen features and regions, beginning at ``start``, the best fit of all points.

    Raises
    ------
    InspectionError
        A feature is constructed, or too few points were selected.
    """
    placement = start.nominal_from_part
    edges = surface.sharp_edges
    measured = {
        nominal.feature.name: nominal
        for one in program.features
        if isinstance(one, MeasuredFeature) and one.grow is None
        for nominal in nominal_features(one)
    }
    if made := [name for name in requested.features if name not in measured]:
        raise InspectionError(
            f"A local best fit cannot use {made[0]}: its points are not cut around a nominal.", "Choose measured features."
        )
    for _ in range(ROUNDS):
        placed = points.seen_from(placement)
        chosen = np.zeros(len(points), bool)
        for name in requested.features:
            chosen[cut_points(placed, measured[name], edges)] = True
        for region in requested.regions:
            chosen |= _inside(placed.points_mm, region)
        if chosen.sum() < settings.least_points:
            raise InspectionError(
                f"Only {chosen.sum()} points lie in the features and regions of the local best fit, {settings.least_points} are needed.",
                "Scan these features, or choose others.",
            )
        thinned = points.where(chosen).thin(settings.alignment.fine_points)
        fine = register(thinned, surface, placement.matrix, settings.alignment, reach_mm=_reach(surface), progress=progress)
        placement = replace(placement, matrix=orthonormalise(fine.matrix))
    names = [*requested.features, *([f"{len(requested.regions)} regions"] if requested.regions else [])]
    return Alignment(f"local best fit ({', '.join(names)})", placement, fine.rms_mm, fine.overlap, fine.undetermined)


def _reach(surface: NominalSurface) -> float:
    return 0.02 * surface.diagonal_mm


def _inside(points_mm: FloatArray, region: Region) -> BoolArray:
    inside = np.ones(len(points_mm), bool)
    columns = (*points_mm.T, np.hypot(points_mm[:, 0], points_mm[:, 1]))
    for values, extent in zip(columns, (region.x_mm, region.y_mm, region.z_mm, region.radial_mm), strict=True):
        if extent is not None:
            inside &= (values > extent[0]) & (values < extent[1])
    return inside
