"""Ways from one placement to the next: direct, else with the head drawn back along its optical axis, else by the park pose."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import radians

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.leg import Axis
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.errors import LimitError
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.cell import ORDER, REST_RAD, Cell
from measureapp.planning.collision.clearance import Encounter
from measureapp.planning.collision.motion import Placement

OTHER_ORDERS: tuple[tuple[Axis, ...], ...] = (("robot", "table", "guide"), ("guide", "robot", "table"))
RETRACTS_MM = (100.0, 50.0)  # along the optical axis
CONFIGURATIONS = 4  # of a viewpoint that are tried, the preferred ones first
HINT = "Change this viewpoint or the order of the plan, or state a park pose that the robot reaches from both; nothing was moved."


@dataclass(frozen=True, slots=True, eq=False)
class RouteLeg:
    """A move of one axis."""

    axis: Axis
    goal: Placement  # of all axes after it


@dataclass(frozen=True, slots=True, eq=False)
class Route:
    """Checked moves from one placement to another; where an axis stays, there is no leg."""

    legs: tuple[RouteLeg, ...]
    end: Placement
    detour: str = ""  # in words; empty: direct


class NoRoute(LimitError):
    """Nothing may move: the goal, or every way to it, would bring bodies too close to each other."""


def find_route(cell: Cell, start: Placement, viewpoint: Viewpoint) -> Route:
    """Return the first free way to a viewpoint, in the configuration that is reached soonest if that can be.

    Bodies that are too close to each other at the start may move apart.

    Raises
    ------
    NoRoute
        Naming the bodies in the way, and where.
    """
    ends = cell.free_at(viewpoint, start.joints_rad)[:CONFIGURATIONS]
    if not ends:
        raise NoRoute(f"{viewpoint.id} cannot be approached: {cell.problem_at(viewpoint)}.", "Change this viewpoint; nothing was moved.")
    first: Encounter | None = None
    for route in _candidates(cell, start, ends):
        if (met := _encounter_on(cell, start, route)) is None:
            return route
        first = first or met
    assert first is not None
    raise NoRoute(f"There is no free way to {viewpoint.id}: on the direct one, {first.words()} {where(first)}.", HINT)


def where(encounter: Encounter) -> str:
    """Return where on its move an encounter happens, as part of a sentence."""
    return f"after {100.0 * encounter.share:.0f} % of the {encounter.axis}'s move"


def _candidates(cell: Cell, start: Placement, ends: Sequence[Placement]) -> Iterator[Route]:
    for end in ends:
        for order in (ORDER, *OTHER_ORDERS):
            yield _route(start, _in_order(end, order), "" if order == ORDER else f"in the order {', '.join(order)}")
    for end in ends:
        for distance_mm in RETRACTS_MM:
            back, before = (_drawn_back(cell, one, distance_mm) for one in (start, end))
            if back is not None and before is not None:
                yield _route(start, _past(back, before, end), f"drawn back by {distance_mm:g} mm")
    for end in ends:
        if (parked := _parked(cell, start)) is not None:
            before = _drawn_back(cell, end, RETRACTS_MM[0]) or end
            back = _drawn_back(cell, start, RETRACTS_MM[0]) or start
            yield _route(start, [("robot", back), *_past(parked, before, end)], "by the park pose")


def _in_order(end: Placement, order: Sequence[Axis]) -> list[tuple[Axis, Placement]]:
    return [(axis, end) for axis in order]


def _past(away: Placement, before: Placement, end: Placement) -> list[tuple[Axis, Placement]]:
    """Return the moves of an arm that waits at ``away`` while the other axes move, and approaches by ``before``."""
    return [("robot", away), ("table", end), ("guide", end), ("robot", before), ("robot", end)]


def _route(start: Placement, moves: Sequence[tuple[Axis, Placement]], detour: str) -> Route:
    legs, here = [], start
    for axis, goal in moves:
        there = here.moved(axis, goal)
        if not there.is_at(here):
            legs.append(RouteLeg(axis, there))
        here = there
    return Route(tuple(legs), here, detour)


def _encounter_on(cell: Cell, start: Placement, route: Route) -> Encounter | None:
    here = start
    for leg in route.legs:
        if met := cell.encounter_on(here, leg.goal, leaving=here is start):
            return replace(met, axis=leg.axis)
        here = leg.goal
    return None


def _drawn_back(cell: Cell, placement: Placement, distance_mm: float) -> Placement | None:
    """Return the placement with the head moved back along its optical axis; None where the robot cannot."""
    flange_from_head = cell.rig.flange_from_head.transform("flange", "head").matrix
    back = np.eye(4)
    back[2, 3] = -distance_mm
    return _with_flange(cell, placement, placement.base_from_flange @ flange_from_head @ back @ np.linalg.inv(flange_from_head))


def _parked(cell: Cell, placement: Placement) -> Placement | None:
    """Return the placement with the robot in its park pose, or at rest where the rig describes none."""
    if (park := cell.rig.motion.park) is not None:
        pose = FlangePose(position_mm=park.position_mm, quaternion_wxyz=park.quaternion_wxyz)
        return _with_flange(cell, placement, pose.transform().matrix)
    if cell.arm is None:
        return None
    return replace(placement, base_from_flange=cell.arm.forward_matrices(REST_RAD), joints_rad=REST_RAD)


def _with_flange(cell: Cell, placement: Placement, base_from_flange: FloatArray) -> Placement | None:
    try:
        return cell.nearest(RigidTransform(base_from_flange, "base", "flange"), placement)
    except LimitError:
        return None


def start_of(cell: Cell, viewpoints: Sequence[Viewpoint]) -> Placement | None:
    """Return where a scan is assumed to begin: the park pose, else the first viewpoint at which nothing touches; None if there is none."""
    if (park := cell.rig.motion.park) is not None:
        table_rad = radians(park.table_deg)
        if (parked := _parked(cell, Placement(np.eye(4), None, park.guide_mm, table_rad))) is not None:
            return parked
    return next((free[0] for viewpoint in viewpoints if (free := cell.free_at(viewpoint))), None)
