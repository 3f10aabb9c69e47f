"""Datums at maximum or least material: within what their size leaves, the part may shift in them (ISO 2692, ISO 5459).

A shaft thinner than its maximum material virtual size lies loose in a gauge of that size. The part is judged where it then lies
best. The axis of the datum stays so near that of the drawing that its surface does not leave the virtual size: half the difference
of sizes, at both ends of what was measured of it. What later datums hold is held again after the shift.
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

STEP_MM = 0.01  # of a shift, for its effect: motions are linear over what a size leaves
ROUNDS = 100
EXACT_MM = 1e-9

Offsets = Callable[[DatumSystem], FloatArray]  # (M, 3): by how far places lie off those of the drawing
System = Callable[[Sequence[Feature]], DatumSystem]


@dataclass(frozen=True, slots=True, eq=False)
class Play:
    """How far the axis of one datum may move, measured across it at both its ends."""

    number: int  # which datum
    ends_mm: FloatArray  # (2,), along its axis
    nominal: Feature
    radius_mm: Callable[[Feature], float]
    noise_mm: float  # standard uncertainty of that radius by the noise of the means

    @classmethod
    def of(cls, number: int, material: DatumMaterial, datum: FoundFeature, nominal: Feature, settings: InspectionSettings) -> Play:
        """Take the play from the datum's size. Raises InspectionError where it has none."""
        bonus, noise = compute_bonus(material.condition, material.size_limits_mm, datum, settings)
        along = (datum.points_mm - nominal.point_mm) @ require_direction(nominal)
        return cls(number, np.array([along.min(), along.max()]), nominal, lambda feature: bonus(feature) / 2, noise / 2)

    def offsets(self, system: DatumSystem, feature: Feature) -> FloatArray:
        """Return by how far (2, 3) both ends of the measured axis lie beside that of the drawing."""
        axis = require_direction(self.nominal)
        middle, direction = system.apply(feature.point_mm), system.rotate(require_direction(feature))
        heights = self.nominal.point_mm @ axis + self.ends_mm
        ends = middle + ((heights - middle @ axis) / (direction @ axis))[:, None] * direction
        return perpendicular_part(ends - self.nominal.point_mm, axis)


def perpendicular_part(offsets_mm: FloatArray, axis: FloatArray) -> FloatArray:
    """Return offsets (N, 3) without their part along an axis."""
    return offsets_mm - np.outer(offsets_mm @ axis, axis)


def find_plays(
    materials: Sequence[DatumMaterial],
    names: Sequence[str],
    datums: Sequence[FoundFeature],
    nominals: Sequence[Feature],
    settings: InspectionSettings,
) -> tuple[Play, ...]:
    """Return the play of every datum that has a material condition; ``names`` are those of the dimension, before copies are counted.

    Raises
    ------
    InspectionError
        Such a datum is no measured cylinder, or too little of it was measured.
    """
    made = []
    for material in materials:
        number = list(names).index(material.datum)
        if nominals[number].shape != "cylinder" or len(datums[number].points_mm) == 0:
            raise InspectionError(
                f"{datums[number].name} is a {nominals[number].shape}: a datum shifts at its material size if it is a cylinder"
            )
        made.append(Play.of(number, material, datums[number], nominals[number], settings))
    return tuple(made)


def shift_datum_system(
    drawn: Sequence[Feature], measured: Sequence[Feature], plays: Sequence[Play], offsets: Offsets, more_mm: float = 0.0
) -> DatumSystem:
    """Return the datum system shifted within all plays so that the greatest of the offsets is as small as it can be.

    Where a datum leaves its virtual size whatever the shift, as by its tilt, nothing is shifted.

    Parameters
    ----------
    more_mm : added to the radius of every play, for its uncertainty
    """
    start = datum_system(drawn, measured)
    radii = [max(play.radius_mm(measured[play.number]) + more_mm, 0.0) for play in plays]
    counts = [start.fixed[play.number].shape[1] for play in plays]

    def shifted(motion: FloatArray) -> DatumSystem:
        parts = np.split(motion, np.cumsum(counts)[:-1])
        return datum_system(drawn, measured, {play.number: part for play, part in zip(plays, parts, strict=True)})

    def off(system: DatumSystem) -> list[FloatArray]:
        return [offsets(system), *(play.offsets(system, measured[play.number]) for play in plays)]

    places = off(start)
    if not plays or any(np.linalg.norm(own, axis=1).max() > radius for own, radius in zip(places[1:], radii, strict=True)):
        return start
    moved = [off(shifted(STEP_MM * one)) for one in np.eye(sum(counts))]
    slopes = [np.stack([(step[k] - place) / STEP_MM for step in moved], axis=-1) for k, place in enumerate(places)]
    return shifted(_minimise_greatest_offset(places, slopes, radii))


def _minimise_greatest_offset(places: Sequence[FloatArray], slopes: Sequence[FloatArray], radii: Sequence[float]) -> FloatArray:
    """Return the motion (P,) that makes the first places (M, 3) least far off while all others stay within their radii.

    A second-order cone program, small enough for sequential quadratic programming: the greatest distance itself is an unknown.
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
