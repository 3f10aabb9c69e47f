"""Edits of a scan plan; each returns a new plan, and names what it cannot change.

Names are ids: of a single viewpoint, of a group, or of a viewpoint that a group makes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.plan import FlangePose, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.errors import PlanError
from measureapp.planning.plan_index import PlanIndex

COPY = "copy"
UNFIT = "string_pattern_mismatch"
LETTERS = "A name begins with a letter or digit, and has letters, digits, '.', '_' and '-' only."
T = TypeVar("T")
ItemT = TypeVar("ItemT", Viewpoint, ViewpointGroup)


def make_viewpoint(name: str, flange: FlangePose, guide_mm: float, table_deg: float) -> Viewpoint:
    """Return a viewpoint. Raises PlanError for a name that cannot be part of a file name."""
    return _checked(lambda: Viewpoint(id=name, flange=flange, guide_mm=guide_mm, table_deg=table_deg))


def add(plan: ScanPlan | None, viewpoint: Viewpoint, after: str | None = None, *, name: str = "plan") -> ScanPlan:
    """Add a single viewpoint after another one, or as the last single one; without a plan, begin one with this name."""
    if plan is None:
        return ScanPlan(name=name, viewpoints=(viewpoint,))
    place = None if after is None else PlanIndex(plan).find(after).viewpoint
    at = len(plan.viewpoints) if place is None else place + 1
    return _with(plan, viewpoints=(*plan.viewpoints[:at], viewpoint, *plan.viewpoints[at:]))


def remove(plan: ScanPlan, names: Iterable[str]) -> ScanPlan:
    """Remove single viewpoints, whole groups, and table angles or poses of groups.

    Raises
    ------
    PlanError
        Nothing would be left, or a group of several poses would lose some viewpoints of a pose or of an angle and keep others.
    """
    index, wanted = PlanIndex(plan), tuple(names)
    places = [index.find(name) for name in wanted]
    singles = {place.viewpoint for place in places if place.group is None}
    groups = []
    for number, group in enumerate(plan.groups):
        mine = [place for place in places if place.group == number]
        if any(place.angle is None for place in mine):
            continue
        rest = group if not mine else _reduced(group, {(place.pose, place.angle or 0) for place in mine})
        groups += [] if rest is None else [rest]
    left = tuple(viewpoint for number, viewpoint in enumerate(plan.viewpoints) if number not in singles)
    if not left and not groups:
        raise PlanError("A plan needs at least one viewpoint.", "Add another one before you remove the last.")
    return _with(plan, viewpoints=left, groups=tuple(groups))


def _reduced(group: ViewpointGroup, removed: set[tuple[int, int]]) -> ViewpointGroup | None:
    """Return a group without these poses and angles; None if nothing is left."""
    poses, angles = range(len(group.poses)), range(len(group.table_deg))
    kept = {(pose, angle) for pose in poses for angle in angles} - removed
    kept_poses, kept_angles = sorted({pose for pose, _ in kept}), sorted({angle for _, angle in kept})
    if len(kept) != len(kept_poses) * len(kept_angles):
        raise PlanError(
            f"Group {group.id} repeats {len(poses)} poses at {len(angles)} table angles; single ones of its viewpoints cannot be removed.",
            "Ungroup it first, or remove all viewpoints of a pose or of a table angle.",
        )
    if not kept:
        return None
    return group.model_copy(
        update={"poses": tuple(group.poses[pose] for pose in kept_poses), "table_deg": tuple(group.table_deg[a] for a in kept_angles)}
    )


def move(plan: ScanPlan, names: Iterable[str], by: int) -> ScanPlan:
    """Move single viewpoints and whole groups up (negative) or down by one place each, among their own kind."""
    index = PlanIndex(plan)
    places = [index.find(name) for name in names]
    singles = {place.viewpoint for place in places if place.viewpoint is not None}
    groups = {place.group for place in places if place.group is not None}
    return _with(plan, viewpoints=_shifted(plan.viewpoints, singles, by), groups=_shifted(plan.groups, groups, by))


def _shifted(items: Sequence[T], chosen: set[int], by: int) -> tuple[T, ...]:
    order = list(range(len(items)))
    for _ in range(abs(by)):
        places = range(len(order)) if by < 0 else range(len(order) - 1, -1, -1)
        for place in places:
            other = place + (-1 if by < 0 else 1)
            if order[place] in chosen and 0 <= other < len(order) and order[other] not in chosen:
                order[place], order[other] = order[other], order[place]
    return tuple(items[number] for number in order)


def reorder(plan: ScanPlan, names: Sequence[str]) -> ScanPlan:
    """Return the plan with all its viewpoints single, in this order. Raises PlanError where names are missing, strange or given twice."""
    made = {viewpoint.id: viewpoint for viewpoint in plan}
    if sorted(names) != sorted(made):
        odd = next((name for name in names if name not in made or list(names).count(name) > 1), None)
        missing = next((name for name in made if name not in names), "")
        what = f"{missing} is missing" if odd is None else f"{odd} is given twice" if odd in made else f"{odd} is not in the plan"
        raise PlanError(f"An order names every viewpoint once; {what}.", "Correct the order.")
    return _with(plan, viewpoints=tuple(made[name] for name in names), groups=())


def duplicate(plan: ScanPlan, names: Iterable[str]) -> tuple[ScanPlan, tuple[str, ...]]:
    """Copy single viewpoints and groups behind themselves; a viewpoint of a group becomes a single one. Returns the new names as well."""
    index = PlanIndex(plan)
    singles: dict[int, Viewpoint] = {}
    groups: dict[int, ViewpointGroup] = {}
    apart: list[Viewpoint] = []
    made: list[str] = []
    for name in dict.fromkeys(names):
        place, new = index.find(name), index.take_name(f"{name}-{COPY}")
        if place.viewpoint is not None:
            singles[place.viewpoint] = plan.viewpoints[place.viewpoint].model_copy(update={"id": new})
        elif place.group is not None and place.angle is None:
            groups[place.group] = plan.groups[place.group].model_copy(update={"id": new})
        else:
            apart.append(viewpoint_called(plan, name).model_copy(update={"id": new}))
        made.append(new)
    changed = _with(plan, viewpoints=(*_behind(plan.viewpoints, singles), *apart), groups=_behind(plan.groups, groups))
    return changed, tuple(made)


def _behind(items: Sequence[T], copies: Mapping[int, T]) -> tuple[T, ...]:
    return tuple(one for number, item in enumerate(items) for one in ((item, copies[number]) if number in copies else (item,)))


def repeat(plan: ScanPlan, names: Sequence[str], table_deg: Sequence[float], group_id: str) -> ScanPlan:
    """Replace single viewpoints by a group that repeats their poses at table angles; exposures and settling are those of the first."""
    index = PlanIndex(plan)
    numbers = [index.find(name).viewpoint for name in names]
    if not numbers or None in numbers:
        raise PlanError("Only single viewpoints can be made a group.", "Select single viewpoints, or ungroup first.")
    chosen = [plan.viewpoints[number] for number in numbers if number is not None]
    group = _checked(
        lambda: ViewpointGroup(
            id=group_id,
            poses=tuple(StationPose(flange=viewpoint.flange, guide_mm=viewpoint.guide_mm) for viewpoint in chosen),
            table_deg=tuple(table_deg) or tuple(dict.fromkeys(viewpoint.table_deg for viewpoint in chosen)),
            exposures_us=chosen[0].exposures_us,
            settle_s=chosen[0].settle_s,
        )
    )
    rest = tuple(viewpoint for number, viewpoint in enumerate(plan.viewpoints) if number not in numbers)
    return _with(plan, viewpoints=rest, groups=(*plan.groups, group))


def ungroup(plan: ScanPlan, name: str) -> ScanPlan:
    """Replace a group by its viewpoints as single ones, which come before all groups. ``name``: of the group or of one of its viewpoints."""
    place = PlanIndex(plan).find(name)
    if place.group is None:
        raise PlanError(f"{name} is a single viewpoint.", "Only groups can be ungrouped.")
    rest = tuple(group for number, group in enumerate(plan.groups) if number != place.group)
    return _with(plan, viewpoints=(*plan.viewpoints, *plan.groups[place.group].viewpoints()), groups=rest)


def change(
    plan: ScanPlan, names: Iterable[str], *, flange: FlangePose | None = None, guide_mm: float | None = None, table_deg: float | None = None
) -> ScanPlan:
    """Set the pose, the guide or the table of viewpoints. In a group this changes the pose, or the table angle, that they share."""
    index = PlanIndex(plan)
    moved = {name: value for name, value in (("flange", flange), ("guide_mm", guide_mm)) if value is not None}
    turned = {} if table_deg is None else {"table_deg": table_deg}
    singles: dict[int, dict[str, Any]] = {}
    groups: dict[int, dict[str, Any]] = {}
    for place in (index.find(name) for name in names):
        if place.viewpoint is not None:
            singles[place.viewpoint] = {**moved, **turned}
        elif place.group is not None:
            group = plan.groups[place.group]
            if place.angle is None and (len(group.poses) > 1 or turned):
                raise PlanError(f"Group {group.id} has several viewpoints.", "Choose one of them to change its pose or table angle.")
            values = groups.setdefault(place.group, {"poses": group.poses, "table_deg": group.table_deg})
            values["poses"] = _replaced(values["poses"], place.pose, values["poses"][place.pose].model_copy(update=moved))
            if table_deg is not None and place.angle is not None:
                values["table_deg"] = _replaced(values["table_deg"], place.angle, table_deg)
    return _changed(plan, singles, groups)


def _replaced(items: Sequence[T], at: int, new: T) -> tuple[T, ...]:
    return (*items[:at], new, *items[at + 1 :])


def set_exposures(plan: ScanPlan, names: Iterable[str], exposures_us: Sequence[int] | None) -> ScanPlan:
    """Set the exposures of viewpoints; of the whole group where they belong to one. None: those of the plan."""
    return _each(plan, names, {"exposures_us": None if exposures_us is None else tuple(exposures_us)})


def set_settle(plan: ScanPlan, names: Iterable[str], settle_s: float | None) -> ScanPlan:
    """Set the wait before images are taken; of the whole group where viewpoints belong to one. None: that of the plan."""
    return _each(plan, names, {"settle_s": settle_s})


def rename(plan: ScanPlan, name: str, new: str) -> ScanPlan:
    """Rename a single viewpoint or a group. Raises PlanError for a name that is taken or cannot be part of a file name."""
    index = PlanIndex(plan)
    place = index.find(name)
    if place.group is not None and place.angle is not None:
        raise PlanError(f"{name} is named after its group {plan.groups[place.group].id}.", "Rename the group, or ungroup it first.")
    if new != name and new in index:
        raise PlanError(f"The name {new} is taken.", "Choose another name.")
    return _each(plan, (name,), {"id": new})


def set_plan(plan: ScanPlan, **values: Any) -> ScanPlan:
    """Set fields of the plan as a whole: name, patterns, bracket, settle_s."""
    return _with(plan, **values)


def viewpoint_called(plan: ScanPlan, name: str) -> Viewpoint:
    """Return a viewpoint by its id; of a group the first. Raises PlanError if there is none."""
    place = PlanIndex(plan).find(name)
    if place.viewpoint is not None:
        return plan.viewpoints[place.viewpoint]
    group = plan.groups[place.group or 0]
    return group.viewpoints()[place.pose * len(group.table_deg) + (place.angle or 0)]


def _each(plan: ScanPlan, names: Iterable[str], values: Mapping[str, Any]) -> ScanPlan:
    index = PlanIndex(plan)
    places = [index.find(name) for name in names]
    singles = {place.viewpoint: values for place in places if place.viewpoint is not None}
    return _changed(plan, singles, {place.group: values for place in places if place.group is not None})


def _changed(plan: ScanPlan, singles: Mapping[int, Mapping[str, Any]], groups: Mapping[int, Mapping[str, Any]]) -> ScanPlan:
    """Set fields of single viewpoints and of groups, by their numbers."""
    viewpoints = [_edited(viewpoint, singles.get(number)) for number, viewpoint in enumerate(plan.viewpoints)]
    return _with(plan, viewpoints=tuple(viewpoints), groups=tuple(_edited(group, groups.get(n)) for n, group in enumerate(plan.groups)))


def _edited(item: ItemT, values: Mapping[str, Any] | None) -> ItemT:
    return item if not values else _checked(lambda: type(item).model_validate({**_fields(item), **values}))


def _with(plan: ScanPlan, **values: Any) -> ScanPlan:
    return _checked(lambda: ScanPlan.model_validate({**_fields(plan), **values}))


def _fields(model: ScanPlan | Viewpoint | ViewpointGroup) -> dict[str, Any]:
    return {name: getattr(model, name) for name in type(model).model_fields}


def _checked(make: Callable[[], T]) -> T:
    try:
        return make()
    except ValidationError as error:
        if error.errors()[0]["type"] == UNFIT:
            raise PlanError(f"{error.errors()[0]['input']!r} cannot be a name.", LETTERS) from error
        raise PlanError(f"This is impossible: {first_problem(error, 'the plan')}.", "Nothing was changed.") from error
