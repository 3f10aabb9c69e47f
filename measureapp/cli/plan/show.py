"""`plan show`: a plan as a table and as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.plan.options import NominalOption, PlanArgument, RigOption, read_part
from measureapp.cli.reply import JsonOption, UnitOption, reply
from measureapp.data.length_unit import LengthUnit

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan, Viewpoint
    from measureapp.data.rig import RigDescription

SHOWN = 100
HEADINGS = f"{'no.':>5}  {'viewpoint':<20} {'from':>7} {'elevation':>9} {'guide/mm':>9} {'table':>8}  exposures/ms"


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("show")
    def show_plan(
        plan: PlanArgument,
        rig: RigOption,
        out: Annotated[
            Path | None, typer.Option(help="Picture to write: top and side view with all viewpoints (PNG or SVG).", dir_okay=False)
        ] = None,
        nominal: NominalOption = None,
        unit: UnitOption = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Print the viewpoints of a plan, and draw them with the rig and the part."""
        from measureapp.pipeline.plan_check import PlanChecker
        from measureapp.planning.collision.build import PartSolid
        from measureapp.project.geometry.robot_file import arm_of
        from measureapp.project.plan_file import read_plan
        from measureapp.project.rig_file import read_rig
        from measureapp.report.plan_picture import write_plan_picture

        scan_plan, description = read_plan(plan), read_rig(rig)
        part = None if nominal is None else read_part(nominal, unit, scan_plan.part_pose)
        rows = [_row(scan_plan, viewpoint, description) for viewpoint in scan_plan]
        if out is not None:
            solid = None if part is None else PartSolid.of_points(part.vertices_mm)
            found = PlanChecker(description, arm_of(description), solid).check(scan_plan)
            write_plan_picture(out, scan_plan, description, part, frozenset(problem.viewpoint_id for problem in found.problems))
        groups = [{"name": group.id, "poses": len(group.poses), "table_deg": group.table_deg} for group in scan_plan.groups]
        document = {"name": scan_plan.name, "viewpoints": rows, "groups": groups, "files": {} if out is None else {"picture": out}}
        reply(document, "\n".join(_lines(scan_plan, rows, out)), as_json)


def _row(plan: ScanPlan, viewpoint: Viewpoint, rig: RigDescription) -> dict[str, Any]:
    from measureapp.planning.aim import aim_of

    aim = aim_of(viewpoint.flange, viewpoint.guide_mm, rig)
    return {
        "name": viewpoint.id,
        "azimuth_deg": aim.look_at.azimuth_deg,
        "elevation_deg": aim.look_at.elevation_deg,
        "guide_mm": viewpoint.guide_mm,
        "table_deg": viewpoint.table_deg,
        "exposures_us": plan.exposures_of(viewpoint),
        "settle_s": plan.settle_of(viewpoint),
    }


def _lines(plan: ScanPlan, rows: list[dict[str, Any]], out: Path | None) -> list[str]:
    lines = [f"{plan.name}: {len(rows)} viewpoints, patterns {plan.patterns.name}.", HEADINGS]
    for number, row in enumerate(rows[:SHOWN], 1):
        exposures = ", ".join(f"{exposure_us / 1000:g}" for exposure_us in row["exposures_us"])
        lines.append(
            f"{number:>5}  {row['name']:<20} {row['azimuth_deg']:6.1f}° {row['elevation_deg']:8.1f}° {row['guide_mm'] + 0.0:9.1f}"
            f" {row['table_deg']:7.1f}°  {exposures}"
        )
    if len(rows) > SHOWN:
        lines.append(f"  … and {len(rows) - SHOWN} more")
    lines += [f"Group {group.id}: {len(group.poses)} poses at {len(group.table_deg)} table angles." for group in plan.groups]
    return [*lines, *([] if out is None else [f"Picture: {out}"])]
