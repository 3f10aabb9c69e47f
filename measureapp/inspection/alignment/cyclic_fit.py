"""Best fit of a cyclic part: all positions about the axis are fitted, and tested for significance."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import BestFit
from measureapp.data.measurement import Alignment
from measureapp.geometry.transform import orthonormalise, rotation_about
from measureapp.inspection.alignment.point_to_plane import Registration, register
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.uncertainty import correlation_factor

SIGNIFICANT = 3.0  # in standard deviations: least difference between distinguishable positions


@dataclass(frozen=True, slots=True, eq=False)
class _Position:
    fit: Registration
    distances_mm: FloatArray  # (N,) of the points, signed, each truncated

    @property
    def rms_mm(self) -> float:
        return float(np.sqrt(np.mean(self.distances_mm**2)))

    @property
    def turn_rad(self) -> float:
        return float(Rotation.from_matrix(orthonormalise(self.fit.matrix)[:3, :3]).magnitude())


def cyclic_fit(
    measured: MeasuredPoints, surface: NominalSurface, requested: BestFit, start: Alignment, settings: InspectionSettings
) -> Alignment:
    """Fit all ``requested.fold`` positions about the axis, and choose the best among those that are distinguishable.

    If the best position is the true one, another position adds the differences δ of the nominal to the errors e of the points, and the
    sum of squares grows by Σδ² ± 2σ·sqrt(Σδ²). Two positions are distinguishable if this exceeds three standard deviations (with
    correlated errors), and if the rms of δ exceeds `told_apart_mm`, which errors of the views and mesh facets can cause. Of positions
    that are not distinguishable, the one with the smallest rotation is chosen.

    Parameters
    ----------
    start : best fit of the points
    """
    assert requested.fold is not None
    sample = measured.thin(settings.alignment.fine_points)
    positions = [_fit_position(sample, surface, requested, k, start.nominal_from_part.matrix, settings) for k in range(requested.fold)]
    best = min(positions, key=lambda position: position.rms_mm)
    equivalent = [one for one in positions if one is best or not _are_distinguishable(best, one, sample.points_mm, settings)]
    chosen = min(equivalent, key=lambda position: position.turn_rad)
    transform = replace(start.nominal_from_part, matrix=orthonormalise(chosen.fit.matrix))
    open_motions = chosen.fit.undetermined
    if len(equivalent) > 1:
        open_motions += (f"which of {len(equivalent)} positions about the axis",)
    name = f"best fit, {requested.fold} positions about the axis"
    fit = chosen.fit
    return Alignment(
        name, transform, fit.rms_mm, fit.overlap, open_motions, notes=(_describe(positions, best, equivalent, requested.fold),)
    )


def _fit_position(
    sample: MeasuredPoints, surface: NominalSurface, requested: BestFit, k: int, matrix: FloatArray, settings: InspectionSettings
) -> _Position:
    point = np.asarray(requested.axis_point_mm, float)
    turn = np.eye(4)
    turn[:3, :3] = rotation_about(requested.axis, 2 * np.pi * k / (requested.fold or 1))
    turn[:3, 3] = point - turn[:3, :3] @ point
    fit = register(sample, surface, turn @ matrix, settings.alignment, reach_mm=0.02 * surface.diagonal_mm)
    near = settings.alignment.near_share * surface.diagonal_mm
    moved = sample.points_mm @ fit.matrix[:3, :3].T + fit.matrix[:3, 3]
    return _Position(fit, np.clip(signed_distances(moved, surface), -near, near))


def _are_distinguishable(best: _Position, other: _Position, points_mm: FloatArray, settings: InspectionSettings) -> bool:
    squared = other.rms_mm**2 - best.rms_mm**2
    if squared <= settings.alignment.told_apart_mm**2:
        return False
    sigma = best.rms_mm * correlation_factor(points_mm, best.distances_mm, settings.uncertainty.correlation_mm)
    return bool(np.sqrt(squared * len(points_mm)) > SIGNIFICANT * 2 * sigma)


def _describe(positions: list[_Position], best: _Position, equivalent: list[_Position], fold: int) -> str:
    if len(equivalent) == 1:
        others = min(one.rms_mm for one in positions if one is not best)
        return f"One of {fold} positions about the axis fits: {best.rms_mm:.4f} mm rms, second best {others:.4f} mm"
    span = f"{min(one.rms_mm for one in equivalent):.4f} to {max(one.rms_mm for one in equivalent):.4f} mm rms"
    which = f"All {fold}" if len(equivalent) == fold else f"{len(equivalent)} of {fold}"
    return f"{which} positions about the axis are indistinguishable ({span}); the one with the smallest rotation was chosen"
