"""Further viewpoints for a plan: repeats, places between its own, and new ones for what is still missing."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.reach import limit_violations

TURN_DEG = 360.0
LEAST_GAP_DEG = 2.0  # between angles of the table: closer viewpoints are repeats


def between_angles(viewpoints: Sequence[Viewpoint], rig: RigDescription, arm: ArmModel | None) -> tuple[Viewpoint, ...]:
    """Return viewpoints halfway between neighbouring angles of the table, from every robot pose of a plan, within reach."""
    places: dict[tuple[FlangePose, float], list[float]] = {}
    for viewpoint in viewpoints:
        places.setdefault((viewpoint.flange, viewpoint.guide_mm), []).append(viewpoint.table_deg)
    made: list[Viewpoint] = []
    for (flange, guide_mm), angles in places.items():
        around = sorted(set(angles))
        for first, second in pairwise([*around, around[0] + TURN_DEG]):
            if second - first >= 2 * LEAST_GAP_DEG:
                angle = _within(round((first + second) / 2, 3), rig.table.limits_deg)
                made.append(Viewpoint(id=f"between{len(made) + 1:03d}", flange=flange, guide_mm=guide_mm, table_deg=angle))
    return tuple(one for one in made if not limit_violations(one, rig, arm))


def repeats(viewpoints: Sequence[Viewpoint]) -> tuple[Viewpoint, ...]:
    """Return every viewpoint once more, under another id."""
    taken = {viewpoint.id for viewpoint in viewpoints}
    return tuple(viewpoint.model_copy(update={"id": free_id(f"{viewpoint.id[:90]}-again", taken)}) for viewpoint in viewpoints)


def free_id(wanted: str, taken: Collection[str]) -> str:
    """Return ``wanted``, or the first of its numbered forms that is not taken."""
    if wanted not in taken:
        return wanted
    number = 2
    while f"{wanted}{number}" in taken:
        number += 1
    return f"{wanted}{number}"


def numbered_id(prefix: str, taken: Collection[str]) -> str:
    """Return ``prefix`` with the first number that is not taken, from 01."""
    number = 1
    while f"{prefix}{number:02d}" in taken:
        number += 1
    return f"{prefix}{number:02d}"


def _within(angle_deg: float, limits_deg: tuple[float, float]) -> float:
    """Return the same angle, by whole turns, within the limits where that is possible."""
    low, high = limits_deg
    return next((turned for turned in (angle_deg, angle_deg - TURN_DEG, angle_deg + TURN_DEG) if low <= turned <= high), angle_deg)


@dataclass(frozen=True, slots=True)
class Gain:
    """A chosen candidate with the area it is expected to add when it is taken in this order."""

    candidate: int
    area_mm2: float


@dataclass(frozen=True, slots=True, eq=False)
class Holes:
    """What is missing of N samples, and what C candidates are expected to measure of it; those of negative overlap are left out."""

    areas_mm2: FloatArray  # (N,)
    missing: FloatArray  # (N,), 1 where nothing is measured, down to 0 where enough is
    chance: FloatArray  # (C, N), that a candidate measures a sample; 0 where it does not see it
    seen_mm2: FloatArray  # (C,), area that a candidate sees, measured or not
    overlap: FloatArray  # (C,), share of it that is measured already
    seconds: FloatArray  # (C,)


def choose_by_gain(holes: Holes, most: int, least_mm2: float, least_overlap: float) -> tuple[Gain, ...]:
    """Choose candidates greedily by the area they are expected to add for their time, each given those before it.

    Parameters
    ----------
    most : number of candidates
    least_mm2 : the choice ends when no candidate adds more
    least_overlap : candidates with less in common with what is measured, or expected from those before them, could not be registered
    """
    left, overlap, sees = holes.missing.copy(), holes.overlap.copy(), holes.chance > 0
    free = holes.overlap >= 0.0
    chosen: list[Gain] = []
    while len(chosen) < most:
        gains = holes.chance @ (holes.areas_mm2 * left)
        rates = np.where(free & (overlap >= least_overlap) & (gains > least_mm2), gains / holes.seconds, -1.0)
        best = int(np.argmax(rates)) if len(rates) else -1
        if best < 0 or rates[best] <= 0.0:
            break
        chosen.append(Gain(best, float(gains[best])))
        overlap += sees @ (holes.areas_mm2 * left * holes.chance[best]) / np.maximum(holes.seen_mm2, 1e-300)
        left *= 1.0 - holes.chance[best]
        free[best] = False
    return tuple(chosen)
