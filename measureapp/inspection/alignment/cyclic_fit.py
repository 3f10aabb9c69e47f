"""Best fit of a part that repeats about an axis: every position is tried, and whether they can be told apart is said."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.data.alignment_program import BestFit
from measureapp.data.measurement import Alignment
from measureapp.geometry.transform import RigidTransform, orthonormalise, rotation_about
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.alignment.point_to_plane import Registration, register
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.uncertainty import correlation_factor

SIGNIFICANT = 3.0  # standard deviations by which a position must fit better


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
    measured: MeasuredPoints, surface: NominalSurface, asked: BestFit, settings: InspectionSettings, frame: str = "part"
) -> Alignment:
    """Fit in all ``asked.fold`` positions about the axis, and take the best that can be told from the others.

    If the best position is the true one, another one adds the differences δ of the nominal to the errors e of the points, and
    the sum of their squares grows by Σδ² ± 2σ·sqrt(Σδ²). Two positions are told apart when that is more than three standard
    deviations (errors that neighbours share included), and when the rms of δ is more than `told_apart_mm`, which errors of
    the views and the facets of the mesh could feign. Of positions that cannot be told apart the one that turns the part least is taken.

    Raises
    ------
    InspectionError
        As `best_fit`.
    """
    assert asked.fold is not None
    first = best_fit(measured, surface, settings.alignment, frame)
    sample = measured.thin(settings.alignment.fine_points)
    positions = [_fit_position(sample, surface, asked, k, first.nominal_from_part.matrix, settings) for k in range(asked.fold)]
    best = min(positions, key=lambda position: position.rms_mm)
    alike = [one for one in positions if one is best or not _are_distinguishable(best, one, sample.points_mm, settings)]
    chosen = min(alike, key=lambda position: position.turn_rad)
    transform = RigidTransform(orthonormalise(chosen.fit.matrix), "nominal", frame)
    open_motions = chosen.fit.undetermined
    if len(alike) > 1:
        open_motions += (f"which of {len(alike)} positions about the axis",)
    name = f"best fit, {asked.fold} positions about the axis"
    fit = chosen.fit
    return Alignment(name, transform, fit.rms_mm, fit.overlap, open_motions, notes=(_describe(positions, best, alike, asked.fold),))


def _fit_position(
    sample: MeasuredPoints, surface: NominalSurface, asked: BestFit, k: int, matrix: FloatArray, settings: InspectionSettings
) -> _Position:
    point = np.asarray(asked.axis_point_mm, float)
    turn = np.eye(4)
    turn[:3, :3] = rotation_about(asked.axis, 2 * np.pi * k / (asked.fold or 1))
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


def _describe(positions: list[_Position], best: _Position, alike: list[_Position], fold: int) -> str:
    if len(alike) == 1:
        others = min(one.rms_mm for one in positions if one is not best)
        return f"Of {fold} positions about the axis one fits: {best.rms_mm:.4f} mm rms, the next best {others:.4f} mm"
    span = f"{min(one.rms_mm for one in alike):.4f} to {max(one.rms_mm for one in alike):.4f} mm rms"
    which = "They" if len(alike) == fold else f"{len(alike)} of them"
    return f"All {fold} positions about the axis were tried. {which} cannot be told apart ({span}); the one that turns the part least was taken"
