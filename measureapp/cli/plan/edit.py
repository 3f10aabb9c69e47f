"""`plan edit`: add, remove, move and repeat viewpoints, set exposures and waiting times."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.plan.options import PlanArgument
from measureapp.cli.reply import JsonOption, reply
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan

OF_PLAN = "plan"
ADD_HELP = (
    "Add NAME=TARGET:AZIMUTH,ELEVATION[,DISTANCE[,ROLL]] (repeatable): TARGET is x,y,z in mm from the centre of the table's top, "
    "azimuth from the robot's side. Needs --rig; guide and table by --guide and --table."
)
EXAMPLE = "such as top=0,0,40:0,60"


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("edit")
    def edit_plan(
        plan: PlanArgument,
        out: Annotated[Path, typer.Option(help="Plan to write (TOML or JSON); may be the plan itself.", dir_okay=False)],
        add: Annotated[list[str] | None, typer.Option(help=ADD_HELP)] = None,
        rig: Annotated[str | None, typer.Option(help="Rig description, for --add: a TOML file, or a name in resources/rigs.")] = None,
        guide: Annotated[float, typer.Option(help="Guide position in mm of what --add adds.")] = 0.0,
        table: Annotated[float, typer.Option(help="Table angle in degrees of what --add adds.")] = 0.0,
        remove: Annotated[list[str] | None, typer.Option(help="Remove a viewpoint or group (repeatable).")] = None,
        move: Annotated[list[str] | None, typer.Option(help="Move NAME:PLACES down, or up if negative (repeatable).")] = None,
        repeat: Annotated[
            list[str] | None,
            typer.Option(
                help="GROUP=NAME,NAME…:ANGLE,ANGLE…: make single viewpoints a group that repeats them at table angles (repeatable)."
            ),
        ] = None,
        ungroup: Annotated[list[str] | None, typer.Option(help="Replace a group by its viewpoints (repeatable).")] = None,
        exposures: Annotated[
            list[str] | None,
            typer.Option(help="NAME=MS,MS…: exposures in ms, long to short; `plan` for the whole plan, `default` for those of the plan."),
        ] = None,
        settle: Annotated[list[str] | None, typer.Option(help="NAME=SECONDS: wait before images; `plan`, `default` as above.")] = None,
        order: Annotated[str | None, typer.Option(help="NAME,NAME…: all viewpoints in this order; groups are dissolved.")] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Write a changed plan; the changes are made in the order of the options in this help."""
        from measureapp.planning import edit
        from measureapp.project.plan_file import read_plan, write_plan

        changed = _with_added(read_plan(plan), add or [], rig, (guide, table))
        changed = edit.remove(changed, remove) if remove else changed
        for text in move or ():
            name, places = _split(text, ":", "--move", "such as view03:-1")
            changed = edit.move(changed, (name,), int(_number(places, "--move")))
        changed = _with_groups(changed, repeat or [], ungroup or [])
        for text in exposures or ():
            changed = _with_exposures(changed, *_split(text, "=", "--exposures", "such as view03=80,20"))
        for text in settle or ():
            changed = _with_settle(changed, *_split(text, "=", "--settle", "such as view03=1.5"))
        changed = changed if order is None else edit.reorder(changed, [name.strip() for name in order.split(",")])
        write_plan(out, changed)
        reply(_document(changed, out), f"{out}: {len(changed)} viewpoints.", as_json)


def _document(plan: ScanPlan, out: Path) -> dict[str, Any]:
    return {
        "viewpoints": [{"name": viewpoint.id} for viewpoint in plan],
        "groups": [group.id for group in plan.groups],
        "files": {"plan": out},
    }


def _with_added(plan: ScanPlan, added: list[str], rig: str | None, axes: tuple[float, float]) -> ScanPlan:
    from measureapp.planning import edit
    from measureapp.planning.aim import Aim, flange_aimed
    from measureapp.planning.viewpoints import LookAt
    from measureapp.project.rig_file import read_rig

    if added and rig is None:
        raise InputError("--add needs --rig, from which the pose of the robot follows.", "Give the rig description.")
    for text in added:
        name, aim = _split(text, "=", "--add", EXAMPLE)
        target, view = _split(aim, ":", "--add", EXAMPLE)
        description = read_rig(rig or "")
        x, y, z = _numbers(target, "--add", range(3, 4))
        azimuth, elevation, *rest = _numbers(view, "--add", range(2, 5))
        distance = rest[0] if rest else description.standoff_mm
        aimed = Aim((x, y, z), LookAt(azimuth, elevation, distance, rest[1] if len(rest) > 1 else 0.0))
        plan = edit.add(plan, edit.make_viewpoint(name, flange_aimed(aimed, axes[0], description), *axes))
    return plan


def _with_groups(plan: ScanPlan, repeated: list[str], ungrouped: list[str]) -> ScanPlan:
    from measureapp.planning import edit

    for text in repeated:
        group, rest = _split(text, "=", "--repeat", "such as ring=view01:0,90,180,270")
        names, angles = _split(rest, ":", "--repeat", "such as ring=view01:0,90,180,270")
        plan = edit.repeat(plan, [name.strip() for name in names.split(",")], _numbers(angles, "--repeat", range(1, 100_000)), group)
    for name in ungrouped:
        plan = edit.ungroup(plan, name)
    return plan


def _with_exposures(plan: ScanPlan, name: str, text: str) -> ScanPlan:
    from measureapp.planning import edit

    if text == "default" and name != OF_PLAN:
        return edit.set_exposures(plan, (name,), None)
    exposures_us = [round(exposure_ms * 1000) for exposure_ms in _numbers(text, "--exposures", range(1, 100))]
    if name == OF_PLAN:
        return edit.set_plan(plan, bracket={"exposures_us": exposures_us})
    return edit.set_exposures(plan, (name,), exposures_us)


def _with_settle(plan: ScanPlan, name: str, text: str) -> ScanPlan:
    from measureapp.planning import edit

    settle_s = None if text == "default" else _number(text, "--settle")
    return edit.set_plan(plan, settle_s=settle_s) if name == OF_PLAN else edit.set_settle(plan, (name,), settle_s)


def _split(text: str, sign: str, option: str, example: str) -> tuple[str, str]:
    first, found, rest = text.partition(sign)
    if not (first.strip() and found and rest.strip()):
        raise InputError(f"{option} {text} cannot be read.", f"Write it {example}.")
    return first.strip(), rest.strip()


def _numbers(text: str, option: str, counts: range) -> list[float]:
    numbers = [_number(part, option) for part in text.split(",")]
    if len(numbers) not in counts:
        wanted = str(counts[0]) if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
        raise InputError(f"{option}: {text} has {len(numbers)} numbers.", f"Give {wanted}, separated by commas.")
    return numbers


def _number(text: str, option: str) -> float:
    from math import isfinite

    try:
        value = float(text)
    except ValueError:
        raise InputError(f"{option}: {text.strip()!r} is not a number.", "Write numbers with a decimal point.") from None
    if not isfinite(value):
        raise InputError(f"{option}: {text.strip()} is not a finite number.", "Write numbers with a decimal point.")
    return value
