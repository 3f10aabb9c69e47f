"""`plan check`: what prevents the scan of a plan, what it would see, and what it costs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import typer

from measureapp.cli.main import DONE, OUT_OF_TOLERANCE
from measureapp.cli.plan.options import NominalOption, PlanArgument, RigOption, read_part
from measureapp.cli.reply import JsonOption, TerminalProgress, UnitOption, reply
from measureapp.data.length_unit import LengthUnit
from measureapp.progress import PartOf

if TYPE_CHECKING:
    from measureapp.data.plan import ScanPlan
    from measureapp.pipeline.plan_check import PlanCheck
    from measureapp.pipeline.plan_coverage import PlanCoverage

SHOWN = 20
CHECKED = 0.7  # share of the progress


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
        """Check a plan against the rig: limits, joints, singularities, collisions at viewpoints and on the moves between them; with a nominal also the predicted coverage.

        Nothing is connected and nothing moves. The exit code is 1 if something prevents the scan.
        """
        from measureapp.pipeline.plan_check import PlanChecker
        from measureapp.pipeline.plan_coverage import predict_coverage
        from measureapp.planning.collision.build import PartSolid
        from measureapp.project.geometry.robot_file import arm_of
        from measureapp.project.plan_file import read_plan
        from measureapp.project.rig_file import read_rig

        scan_plan, description = read_plan(plan), read_rig(rig)
        part = None if nominal is None else read_part(nominal, unit, scan_plan.part_pose)
        solid = None if part is None else PartSolid.of_points(part.vertices_mm)
        found = PlanChecker(description, arm_of(description), solid).check(scan_plan, PartOf(TerminalProgress(), 0.0, CHECKED))
        blocked = frozenset(problem.viewpoint_id for problem in found.problems)
        coverage = (
            None if part is None else predict_coverage(scan_plan, part, description, blocked, PartOf(TerminalProgress(), CHECKED, 1.0))
        )
        reply(_document(scan_plan, found, coverage), "\n".join(_lines(scan_plan, found, coverage)), as_json)
        raise typer.Exit(OUT_OF_TOLERANCE if found.problems else DONE)


def _document(plan: ScanPlan, found: PlanCheck, coverage: PlanCoverage | None) -> dict[str, Any]:
    sentences = found.sentences()
    seen = [None] * len(plan) if coverage is None else [coverage.share(row) for row in coverage.seen]
    return {
        "name": plan.name,
        "viewpoints": [
            {
                "name": viewpoint.id,
                "guide_mm": viewpoint.guide_mm,
                "table_deg": viewpoint.table_deg,
                "exposures_us": plan.exposures_of(viewpoint),
                "sees": share,
                "problems": sentences.get(viewpoint.id, []),
            }
            for viewpoint, share in zip(plan, seen, strict=True)
        ],
        "problems": [{"viewpoint": one.viewpoint_id or None, "kind": one.kind, "message": one.sentence} for one in found.problems],
        "time_s": found.time_s,
        "images_s": found.images_s,
        "moves_s": found.moves_s,
        "note": found.note,
        "bytes": found.bytes,
        "coverage": None
        if coverage is None
        else {
            "predicted": coverage.predicted,
            "twice": coverage.twice,
            "unreachable": [
                {"reason": reason, "share": share, "by_any_viewpoint": by_any}
                for shares, by_any in ((coverage.unmeasurable(), True), (coverage.unseen(), False))
                for reason, share in shares.items()
            ],
        },
    }


def _lines(plan: ScanPlan, found: PlanCheck, coverage: PlanCoverage | None) -> list[str]:
    minutes = f"{found.time_s / 60:.0f} min" if found.time_s >= 120 else f"{found.time_s:.0f} s"
    lines = [f"{plan.name}: {len(plan)} viewpoints, at least {minutes}, {found.bytes / 1e9:.2f} GB of images."]
    lines += [found.note] if found.note else []
    if coverage is not None:
        lines.append(f"Predicted coverage {coverage.predicted:.1%}; {coverage.twice:.1%} are seen twice or more.")
        lines += [f"Not measurable: {share:.1%}, {cause}." for cause, share in coverage.unmeasurable().items()]
        lines += [
            f"  seen by no viewpoint of this plan, {share:.1%}: {reason} at the best one" for reason, share in coverage.unseen().items()
        ]
    lines += [f"  ✗ {problem}" for problem in found.problems[:SHOWN]]
    if len(found.problems) > SHOWN:
        lines.append(f"  … and {len(found.problems) - SHOWN} more")
    count = len(found.problems)
    return [*lines, "Nothing prevents the scan." if not count else f"{count} problem{'s prevent' if count > 1 else ' prevents'} the scan."]
