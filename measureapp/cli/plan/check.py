"""`plan check`: what prevents the scan of a plan, what it would see, and what it costs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import typer

from measureapp.cli.main import DONE, OUT_OF_TOLERANCE
from measureapp.cli.plan.options import NominalOption, PlanArgument, RigOption
from measureapp.cli.reply import JsonOption, TerminalProgress, UnitOption, reply
from measureapp.data.length_unit import LengthUnit

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan
    from measureapp.pipeline.plan_check import PlanCheck

SHOWN = 20


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command("check")
    def check_plan(
        plan: PlanArgument,
        rig: RigOption,
        nominal: NominalOption = None,
        unit: UnitOption = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Check a plan against the rig: limits, joints, singularities, keep-out boxes, moves; with a nominal also the predicted coverage.

        Nothing is connected and nothing moves. The exit code is 1 if something prevents the scan.
        """
        from measureapp.pipeline.plan_check import check_plan_on_rig
        from measureapp.project.geometry.files import read_mesh
        from measureapp.project.geometry.robot_file import arm_of
        from measureapp.project.plan_file import read_plan
        from measureapp.project.rig_file import read_rig

        scan_plan, description = read_plan(plan), read_rig(rig)
        part = None if nominal is None else read_mesh(nominal, unit=unit)
        found = check_plan_on_rig(scan_plan, description, arm_of(description), TerminalProgress())
        del part
        reply(_document(scan_plan, found), "\n".join(_lines(scan_plan, found)), as_json)
        raise typer.Exit(OUT_OF_TOLERANCE if found.problems else DONE)


def _document(plan: ScanPlan, found: PlanCheck) -> dict[str, Any]:
    by_viewpoint: dict[str, list[str]] = {}
    for problem in found.problems:
        by_viewpoint.setdefault(problem.viewpoint_id, []).append(problem.sentence)
    return {
        "name": plan.name,
        "viewpoints": [
            {
                "name": viewpoint.id,
                "guide_mm": viewpoint.guide_mm,
                "table_deg": viewpoint.table_deg,
                "exposures_us": plan.exposures_of(viewpoint),
                "problems": by_viewpoint.get(viewpoint.id, []),
            }
            for viewpoint in plan
        ],
        "problems": [{"viewpoint": one.viewpoint_id or None, "kind": one.kind, "message": one.sentence} for one in found.problems],
        "time_s": found.time_s,
        "bytes": found.bytes,
        "coverage": None,
    }


def _lines(plan: ScanPlan, found: PlanCheck) -> list[str]:
    minutes = f"{found.time_s / 60:.0f} min" if found.time_s >= 120 else f"{found.time_s:.0f} s"
    lines = [f"{plan.name}: {len(plan)} viewpoints, at least {minutes}, {found.bytes / 1e9:.2f} GB of images."]
    lines += [f"  ✗ {problem}" for problem in found.problems[:SHOWN]]
    if len(found.problems) > SHOWN:
        lines.append(f"  … and {len(found.problems) - SHOWN} more problems")
    return [*lines, "Nothing prevents the scan." if not found.problems else f"{len(found.problems)} problems prevent the scan."]
