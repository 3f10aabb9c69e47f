"""Datum shift at maximum or least material condition (ISO 2692, ISO 5459).

A shaft smaller than its maximum material virtual size has play in a gauge of that size. The tolerance is evaluated in the best position
within this play: the axis of the datum may depart from its nominal by half the difference of the sizes, at both ends of its measured
length. Later datums are satisfied again after the shift.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.material import DatumMaterial
from measureapp.errors import InspectionError
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import DatumSystem, datum_system
from measureapp.inspection.tolerances.material import compute_bonus
from measureapp.inspection.value import require_direction

STEP_MM = 0.01  # of numerical derivatives: motions are linear within the play
ROUNDS = 100
EXACT_MM = 1e-9

Offsets = Callable[[DatumSystem], FloatArray]  # (M, 3): deviations of points from their nominal positions
System = Callable[[Sequence[Feature]], DatumSystem]


@dataclass(frozen=True, slots=True, eq=False)
class Play:
    """Permitted displacement of the axis of one datum, perpendicular to it at both ends."""

    number: int  # index of the datum
    ends_mm: FloatArray  # (2,), along its axis
    nominal: Feature
    radius_mm: Callable[[Feature], float]
    noise_mm: float  # standard uncertainty of that radius by noise

    @classmethod
    def of(cls, number: int, material: DatumMaterial, datum: FoundFeature, nominal: Feature, settings: InspectionSettings) -> Play:
        """Compute the play from the datum's size. Raises InspectionError if it has none."""
        bonus, noise = compute_bonus(material.condition, material.size_limits_mm, datum, settings)
        along = (datum.points_mm - nominal.point_mm) @ require_direction(nominal)
        return cls(number, np.array([along.min(), along.max()]), nominal, lambda feature: bonus(feature) / 2, noise / 2)

    def offsets(self, system: DatumSystem, feature: Feature) -> FloatArray:
        """Return the offsets (2, 3) of both ends of the measured axis from the nominal axis."""
        axis = require_direction(self.nominal)
        middle, direction = system.apply(feature.point_mm), system.rotate(require_direction(feature))
        heights = self.nominal.point_mm @ axis + self.ends_mm
        ends = middle + ((heights - middle @ axis) / (direction @ axis))[:, None] * direction
        return perpendicular_part(ends - self.nominal.point_mm, axis)


def perpendicular_part(offsets_mm: FloatArray, axis: FloatArray) -> FloatArray:
    """Return the component of offsets (N, 3) perpendicular to an axis."""
    return offsets_mm - np.outer(offsets_mm @ axis, axis)


def find_plays(
    materials: Sequence[DatumMaterial],
    names: Sequence[str],
    datums: Sequence[FoundFeature],
    nominals: Sequence[Feature],
    settings: InspectionSettings,
) -> tuple[Play, ...]:
    """Return the play of every datum with a material condition; ``names`` are those of the dimension, without copy numbers.

    Raises
    ------
    InspectionError
        Such a datum is not a measured cylinder, or too little of it was measured.
    """
    made = []
    for material in materials:
        number = list(names).index(material.datum)
        if nominals[number].shape != "cylinder" or len(datums[number].points_mm) == 0:
            raise InspectionError(
                f"{datums[number].name} is a {nominals[number].shape}: a material condition of a datum requires a measured cylinder"
            )
        made.append(Play.of(number, material, datums[number], nominals[number], settings))
    return tuple(made)


def shift_datum_system(
    nominals: Sequence[Feature], measured: Sequence[Feature], plays: Sequence[Play], offsets: Offsets, more_mm: float = 0.0
) -> DatumSystem:
    """Return the datum system shifted within all plays so that the greatest offset is minimal.

    If a datum violates its virtual size for any shift, for example by its tilt, nothing is shifted.

    Parameters
    ----------
    more_mm : added to the radius of every play, to propagate its uncertainty
    """
    start = datum_system(nominals, measured)
    radii = [max(play.radius_mm(measured[play.number]) + more_mm, 0.0) for play in plays]
    counts = [start.fixed[play.number].shape[1] for play in plays]

    def shifted(motion: FloatArray) -> DatumSystem:
        parts = np.split(motion, np.cumsum(counts)[:-1])
        return datum_system(nominals, measured, {play.number: part for play, part in zip(plays, parts, strict=True)})

    def off(system: DatumSystem) -> list[FloatArray]:
        return [offsets(system), *(play.offsets(system, measured[play.number]) for play in plays)]

    places = off(start)
    if not plays or any(np.linalg.norm(own, axis=1).max() > radius for own, radius in zip(places[1:], radii, strict=True)):
        return start
    moved = [off(shifted(STEP_MM * one)) for one in np.eye(sum(counts))]
    slopes = [np.stack([(step[k] - place) / STEP_MM for step in moved], axis=-1) for k, place in enumerate(places)]
    return shifted(_minimise_greatest_offset(places, slopes, radii))


def _minimise_greatest_offset(places: Sequence[FloatArray], slopes: Sequence[FloatArray], radii: Sequence[float]) -> FloatArray:
    """Return the motion (P,) that minimises the greatest offset of the first points (M, 3), with all others within their radii.

    A second-order cone program, small enough for sequential quadratic programming, with the greatest distance as an unknown.
    """
    scale = max(float(np.linalg.norm(places[0], axis=1).max()), *radii, EXACT_MM)
    limits = [None, *(radius / scale for radius in radii)]
    cones = [(place / scale, slope, limit) for place, slope, limit in zip(places, slopes, limits, strict=True)]

    def room(unknowns: FloatArray) -> FloatArray:
        left = [(unknowns[-1] if limit is None else limit) ** 2 - np.sum((at + by @ unknowns[:-1]) ** 2, axis=1) for at, by, limit in cones]
        return np.concatenate(left)

    def rates(unknowns: FloatArray) -> FloatArray:
        rows = []
        for at, by, limit in cones:
            turn = -2 * np.einsum("md,mdp->mp", at + by @ unknowns[:-1], by)
            rows.append(np.column_stack([turn, np.full(len(at), 2 * unknowns[-1] if limit is None else 0.0)]))
        return np.vstack(rows)

    size = slopes[0].shape[-1]
    start = np.append(np.zeros(size), np.linalg.norm(cones[0][0], axis=1).max())
    goal = np.append(np.zeros(size), 1.0)
    found = minimize(
        lambda unknowns: unknowns[-1],
        start,
        jac=lambda _: goal,
        constraints={"type": "ineq", "fun": room, "jac": rates},
        bounds=[(None, None)] * size + [(0.0, None)],
        method="SLSQP",
        options={"maxiter": ROUNDS, "ftol": 1e-10},
    )
    motion = np.asarray(found.x[:-1])
    better = np.linalg.norm(cones[0][0] + cones[0][1] @ motion, axis=1).max() < start[-1]
    return scale * motion if better else np.zeros(size)
