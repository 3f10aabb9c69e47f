"""`plan make`: viewpoints that measure a nominal."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from measureapp.cli.plan.options import PoseFileOption, TurnOption, UpsideDownOption, pose_of_options
from measureapp.cli.reply import JsonOption, TerminalProgress, reply, triple
from measureapp.data.length_unit import LengthUnit, likely_unit
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.mesh import Mesh
    from measureapp.data.plan import ScanPlan
    from measureapp.planning.coverage.result import GeneratedPlan

SHOWN_AREAS = 8
ViewsOption = Annotated[
    int,
    typer.Option(
        min=1, max=10, help="From how many viewpoints each place is seen, where possible: clouds that overlap are joined more accurately."
    ),
]
MB = 1e6


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def make(
        nominal: Annotated[Path, typer.Argument(help="Nominal: STL, PLY, OBJ, or STEP (with the optional library cascadio).")],
        rig: Annotated[str, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")],
        out: Annotated[Path, typer.Option("--out", help="Plan to write: TOML or JSON, by its extension.", dir_okay=False)],
        viewpoints: Annotated[
            int | None, typer.Option(min=1, max=500, help="Exactly that many, with the best coverage. Default: as many as needed.")
        ] = None,
        coverage: Annotated[
            float, typer.Option(min=0.01, max=1.0, help="Required fraction of what the rig can measure of the part.")
        ] = 0.98,
        views: ViewsOption = 2,
        sigma: Annotated[float | None, typer.Option(min=1e-4, help="Required standard deviation of a point, in mm.")] = None,
        pose: PoseFileOption = None,
        turn_deg: TurnOption = None,
        upside_down: UpsideDownOption = False,
        brightness: Annotated[
            float,
            typer.Option(min=0.01, max=20.0, help="Grey level of the part under white light at the longest exposure; 1: just saturated."),
        ] = 1.0,
        samples: Annotated[int, typer.Option(min=50, max=50_000, help="Number of samples of the surface.")] = 5000,
        candidates: Annotated[
            int, typer.Option(min=24, max=20_000, help="Number of viewpoints to choose from; more take longer and may save one.")
        ] = 2600,
        seed: Annotated[int, typer.Option(min=0, help="Of the samples; the same seed gives the same plan.")] = 1,
        unit: Annotated[
            LengthUnit | None, typer.Option("--unit", help="Unit of the nominal: mm, inch, m, cm or um. Default: mm, if that is plausible.")
        ] = None,
        as_json: JsonOption = False,
    ) -> None:
        """Plan viewpoints by predicted visibility, and state coverage, time, disk space and what cannot be measured."""
        from measureapp.pipeline.plan_making import PlanContext, make_plan
        from measureapp.pipeline.prediction.light import PartLight
        from measureapp.planning.generate import GeneratorSettings
        from measureapp.project.atomic import require_writable
        from measureapp.project.plan_file import check_plan_name, write_plan
        from measureapp.project.rig_file import read_rig

        check_plan_name(out)
        require_writable(out)
        description = read_rig(rig)
        settings = GeneratorSettings(
            name=out.stem,
            coverage=coverage,
            viewpoints=viewpoints,
            views=views,
            sigma_mm=sigma,
            samples=samples,
            candidates=candidates,
            seed=seed,
        )
        mesh = _read_nominal(nominal, unit)
        context = PlanContext(pose_of_options(pose, turn_deg, upside_down), light=PartLight(white=brightness))
        made = make_plan(mesh, description, settings, context, TerminalProgress())
        write_plan(out, made.plan)
        reply({**_document(made), "files": {"plan": out}}, "\n".join([*_lines(made), f"Plan saved to {out}"]), as_json)


def _read_nominal(path: Path, unit: LengthUnit | None) -> Mesh:
    """Read the nominal; ask for its unit if its size in millimetres is implausible. Raises InputError."""
    from measureapp.project.geometry.files import read_mesh

    mesh = read_mesh(path, unit=unit or LengthUnit.MM)
    low, high = mesh.vertices_mm.min(axis=0), mesh.vertices_mm.max(axis=0)
    span = float((high - low).max())
    likely = likely_unit(span)
    if unit is None and likely is not LengthUnit.MM:
        raise InputError(
            f"{path} has a size of {span:.4g}: probably {likely.words}, that is {span * likely.in_mm:.4g} mm.",
            f"Confirm with `--unit {likely}`, or give `--unit mm` if it is in millimetres.",
        )
    return mesh


def _document(made: GeneratedPlan) -> dict[str, Any]:
    unreachable = [
        {"reason": str(area.cause), "area_mm2": area.area_mm2, "fraction": area.share, "place_mm": area.place_mm}
        for area in made.unreachable
    ]
    return {
        "viewpoints": _viewpoints(made.plan, made),
        "stations": made.stations,
        "candidates": made.candidates,
        "samples": len(made.samples),
        "coverage": {
            "predicted": made.planned_share,
            "measurable": made.allowed_share,
            "predicted_of_measurable": made.planned_of_allowed,
            "unreachable": unreachable,
        },
        "part_pose": None if made.plan.part_pose is None else made.plan.part_pose.model_dump(),
        "median_sigma_mm": float(np.nanmedian(made.sigma_mm)),
        "time_s": made.time_s,
        "moves_s": made.moves_s,
        "bytes": made.bytes,
        "problems": list(made.problems),
        "note": made.note,
    }


def _viewpoints(plan: ScanPlan, made: GeneratedPlan) -> list[dict[str, Any]]:
    areas = made.samples.areas_mm2 / made.samples.area_mm2
    return [
        {
            "id": one.id,
            "position_mm": one.flange.position_mm,
            "quaternion_wxyz": one.flange.quaternion_wxyz,
            "guide_mm": one.guide_mm,
            "table_deg": one.table_deg,
            "seen": float(areas[seen].sum()),
        }
        for one, seen in zip(plan, made.seen, strict=True)
    ]


def _lines(made: GeneratedPlan) -> list[str]:
    lost: dict[str, float] = defaultdict(float)
    for area in made.unreachable:
        lost[str(area.cause)] += area.share
    return [
        *([] if made.plan.part_pose is None else [f"The part stands {made.plan.part_pose.words}."]),
        f"{len(made.plan)} viewpoints from {made.stations} robot poses, chosen of {made.candidates}.",
        f"Predicted coverage: {made.planned_share:.1%} of the surface, {made.planned_of_allowed:.1%} of what this rig can measure.",
        *(f"Not measurable: {share:.1%}, {cause}." for cause, share in sorted(lost.items(), key=lambda entry: -entry[1])),
        *(_area_line(area.cause, area.area_mm2, area.place_mm) for area in made.unreachable[:SHOWN_AREAS]),
        f"Predicted standard deviation of a point, all views together: {np.nanmedian(made.sigma_mm):.4f} mm (median).",
        f"Time: about {made.time_s / 60.0:.0f} min, of which {made.moves_s / 60.0:.1f} min are moves. Images: {made.bytes / MB:.0f} MB.",
        *([made.note] if made.note else []),
        *made.problems,
    ]


def _area_line(cause: str, area_mm2: float, place_mm: tuple[float, float, float]) -> str:
    return f"  {area_mm2:.0f} mm² near {triple(place_mm, 0)} mm: {cause}"
