"""Further viewpoints for a plan: repeats, places between its own, and new ones for what is still missing."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise

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


def _within(angle_deg: float, limits_deg: tuple[float, float]) -> float:
    """Return the same angle, by whole turns, within the limits where that is possible."""
    low, high = limits_deg
    return next((turned for turned in (angle_deg, angle_deg - TURN_DEG, angle_deg + TURN_DEG) if low <= turned <= high), angle_deg)
