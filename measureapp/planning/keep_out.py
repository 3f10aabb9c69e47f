"""Keep-out boxes of a rig: no part of the measuring head may enter one, neither at viewpoints nor on the straight way between them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import KeepOutBox, RigDescription
from measureapp.errors import PlanError
from measureapp.geometry.transform import RigidTransform

STEP_MM = 10.0  # between the places checked on a way


def check_keep_out(viewpoints: Iterable[Viewpoint], rig: RigDescription) -> None:
    """Refuse a plan at which the head enters a keep-out box.

    Checked are the flange, the cameras and the projector, as points, at every viewpoint and on the straight line from each to the next. A
    controller that moves its joints together deviates from that line, so boxes need a margin.

    Raises
    ------
    PlanError
        Naming the viewpoints and boxes.
    """
    boxes = rig.motion.keep_out
    if not boxes:
        return
    plan = tuple(viewpoints)
    places = [_head_points_mm(viewpoint.flange.transform(), viewpoint.guide_mm, rig) for viewpoint in plan]
    problems = [f"{viewpoint.id} in {box.name}" for viewpoint, points in zip(plan, places, strict=True) for box in _entered(points, boxes)]
    for (start, end), (first, last) in zip(pairwise(plan), pairwise(places), strict=True):
        entered = {box.name for points in _between(first, last) for box in _entered(points, boxes)}
        problems += [f"the way from {start.id} to {end.id} through {name}" for name in sorted(entered)]
    if problems:
        shown = "; ".join(problems[:5]) + (f"; and {len(problems) - 5} more" if len(problems) > 5 else "")
        raise PlanError(f"The measuring head would enter keep-out boxes: {shown}.", "Change these viewpoints; nothing was moved.")


def check_step(start: AxisReadback, goal: AxisReadback, rig: RigDescription) -> None:
    """Refuse a straight step by which the head enters a keep-out box; out of a box that it is in already, it may move.

    Raises
    ------
    PlanError
        Naming the box.
    """
    first, last = (_head_points_mm(place.base_from_flange, place.guide_mm, rig) for place in (start, goal))
    inside = {box.name for box in _entered(first, rig.motion.keep_out)}
    for points in (*_between(first, last), last):
        for box in _entered(points, rig.motion.keep_out):
            if box.name not in inside:
                raise PlanError(f"The measuring head would enter the keep-out box {box.name}.", "Move another way; nothing was moved.")


def _head_points_mm(base_from_flange: RigidTransform, guide_mm: float, rig: RigDescription) -> FloatArray:
    """Return flange, cameras and projector in the guide frame, (N, 3)."""
    base_from_head = base_from_flange @ rig.flange_from_head.transform("flange", "head")
    mounted = [camera.head_from_camera.position_mm for camera in rig.cameras] + [rig.projector.head_from_projector.position_mm]
    points = np.vstack([base_from_flange.translation_mm, base_from_head.apply(np.array(mounted, float))])
    return points + np.array([0.0, guide_mm, 0.0])


def _between(first: FloatArray, last: FloatArray) -> Iterator[FloatArray]:
    count = max(2, int(np.ceil(np.linalg.norm(last - first, axis=1).max() / STEP_MM)) + 1)
    for share in np.linspace(0.0, 1.0, count)[1:-1]:
        yield first + share * (last - first)


def _entered(points: FloatArray, boxes: Sequence[KeepOutBox]) -> Iterator[KeepOutBox]:
    for box in boxes:
        if np.any(np.all((points >= box.low_mm) & (points <= box.high_mm), axis=1)):
            yield box
