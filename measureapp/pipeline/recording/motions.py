"""What moves in a recording, and which board views can calibrate which link of the rig."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.calibrate.rig.joint import LEAST_OBSERVATIONS, LEAST_STROKE_MM, LEAST_SWEEP_RAD
from measureapp.data.calibration import SAME_STATION_MM, SAME_STATION_RAD
from measureapp.data.fringe import AxisReadback

LEAST_POSES = 3  # from which hand-eye, guide or axis can be solved
LEAST_TURN_RAD = np.deg2rad(2.0)  # of the robot, for hand-eye
Same = Callable[[AxisReadback, AxisReadback], bool]


@dataclass(frozen=True, slots=True, eq=False)
class BoardReadback:
    """Read-backs of one view of a board that does not move on its own."""

    id: str
    axes: AxisReadback
    on_table: bool  # else it stands in the cell


def same_robot(one: AxisReadback, other: AxisReadback) -> bool:
    """Whether the robot stands at one pose."""
    gap = one.base_from_flange.inverse() @ other.base_from_flange
    return bool(np.linalg.norm(gap.translation_mm) < SAME_STATION_MM and gap.angle_rad < SAME_STATION_RAD)


def same_guide(one: AxisReadback, other: AxisReadback) -> bool:
    """Whether the guide stands at one position."""
    return abs(one.guide_mm - other.guide_mm) < SAME_STATION_MM


def same_table(one: AxisReadback, other: AxisReadback) -> bool:
    """Whether the table stands at one angle."""
    return abs(one.table_rad - other.table_rad) < SAME_STATION_RAD


def moved_axes(readbacks: Sequence[AxisReadback]) -> frozenset[str]:
    """Return which of "robot", "guide", "table" move between these read-backs."""
    tests: dict[str, Same] = {"robot": same_robot, "guide": same_guide, "table": same_table}
    return frozenset(name for name, same in tests.items() if any(not same(readbacks[0], other) for other in readbacks[1:]))


def determines_rig(views: Sequence[BoardReadback]) -> bool:
    """Whether views on the table can be tried in one joint solution of hand-eye, guide and axis."""
    if any(not view.on_table for view in views) or len(views) < LEAST_OBSERVATIONS:
        return False
    at_one_angle = _largest(views, lambda one, other: same_table(one.axes, other.axes), lambda _: True)
    sweep = float(np.ptp([view.axes.table_rad for view in views]))
    return sweep >= LEAST_SWEEP_RAD and _count(at_one_angle, same_robot) >= LEAST_POSES and _turns(at_one_angle)


def hand_eye_views(views: Sequence[BoardReadback]) -> list[BoardReadback]:
    """Return the largest group of views with a board at rest and a turning robot; empty if there is none.

    The guide is at rest, too, in all of them if there is such a group.
    """

    def useful(group: Sequence[BoardReadback]) -> bool:
        return _count(group, same_robot) >= LEAST_POSES and _turns(group)

    at_one_place = _largest(views, lambda one, other: _at_rest(one, other) and same_guide(one.axes, other.axes), useful)
    return at_one_place or _largest(views, _at_rest, useful)


def guide_views(views: Sequence[BoardReadback]) -> list[BoardReadback]:
    """Return the largest group of views with a board at rest in the cell and a moving guide; empty if there is none."""

    def moves(group: Sequence[BoardReadback]) -> bool:
        stroke = float(np.ptp([view.axes.guide_mm for view in group]))
        return _count(group, same_guide) >= LEAST_POSES and stroke >= LEAST_STROKE_MM

    return _largest(views, _at_rest, moves)


def axis_views(views: Sequence[BoardReadback]) -> list[BoardReadback]:
    """Return the largest group of views with cameras at rest and a turning table; empty if there is none."""

    def at_rest(one: BoardReadback, other: BoardReadback) -> bool:
        return one.on_table and other.on_table and same_robot(one.axes, other.axes) and same_guide(one.axes, other.axes)

    def turns(group: Sequence[BoardReadback]) -> bool:
        sweep = float(np.ptp([view.axes.table_rad for view in group]))
        return group[0].on_table and _count(group, same_table) >= LEAST_POSES and sweep >= LEAST_SWEEP_RAD

    return _largest(views, at_rest, turns)


def _at_rest(one: BoardReadback, other: BoardReadback) -> bool:
    """Whether the board is at one place in the cell."""
    return one.on_table == other.on_table and (not one.on_table or same_table(one.axes, other.axes))


def _largest(
    views: Sequence[BoardReadback], alike: Callable[[BoardReadback, BoardReadback], bool], useful: Callable[[Sequence[BoardReadback]], bool]
) -> list[BoardReadback]:
    groups: list[list[BoardReadback]] = []
    for view in views:
        group = next((known for known in groups if alike(known[0], view)), None)
        if group is None:
            groups.append([view])
        else:
            group.append(view)
    return max((group for group in groups if useful(group)), key=len, default=[])


def _count(views: Sequence[BoardReadback], same: Same) -> int:
    """Number of different positions."""
    different: list[BoardReadback] = []
    for view in views:
        if not any(same(known.axes, view.axes) for known in different):
            different.append(view)
    return len(different)


def _turns(views: Sequence[BoardReadback]) -> bool:
    first = views[0].axes.base_from_flange.inverse()
    return any((first @ view.axes.base_from_flange).angle_rad >= LEAST_TURN_RAD for view in views[1:])
