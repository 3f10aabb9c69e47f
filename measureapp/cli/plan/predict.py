"""`plan predict`: uncertainty of every dimension before the scan."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.pipeline.prediction.improvements import Advice
    from measureapp.pipeline.prediction.setup import PredictionSetup
    from measureapp.pipeline.prediction.uncertainty import Prediction


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def predict(
        plan: Annotated[Path, typer.Argument(help="Scan plan (TOML or JSON) with --rig and --program, or a project folder.")],
        rig: Annotated[str | None, typer.Option("--rig", help="Rig description: a TOML file, or a name in resources/rigs.")] = None,
        program: Annotated[Path | None, typer.Option("--program", help="Inspection program that names its nominal.")] = None,
        calibration: Annotated[
            Path | None, typer.Option("--calibration", help="Project whose calibration of this rig is used; default: a typical one.")
        ] = None,
        brightness: Annotated[
            float | None,
            typer.Option(
                "--brightness",
                min=0.01,
                max=20.0,
                help="Grey level of the part under white light at the longest exposure; 1: just saturated. Default: as measured, else 1.",
            ),
        ] = None,
        form_error: Annotated[
            float | None,
            typer.Option(
                "--form-error",
                min=0.0,
                max=1.0,
                help="Standard deviation of the smooth errors of a cloud, in mm. Default: as the last scan shows, else as usual rigs have.",
            ),
        ] = None,
        improve: Annotated[
            bool, typer.Option("--improve", help="Try further viewpoints and longer exposures, and state what each would gain.")
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Predict the uncertainty U (k = 2) of every dimension, with its budget, before the scan."""
        from measureapp.pipeline.prediction.improvements import advise
        from measureapp.pipeline.prediction.uncertainty import predict_uncertainty

        setup = _setup(plan, rig, program, calibration, brightness, form_error)
        found = predict_uncertainty(setup.plan, setup.scene, setup.job, TerminalProgress())
        advice = advise(setup.plan, setup.scene, setup.job, found, TerminalProgress()) if improve else None
        reply(_document(found, advice), "\n".join(_lines(found, advice)), as_json)


def _setup(
    plan: Path, rig: str | None, program: Path | None, calibration: Path | None, brightness: float | None, form_mm: float | None
) -> PredictionSetup:
    from measureapp.pipeline.prediction.light import PartLight
    from measureapp.pipeline.prediction.setup import setup_of_files, setup_of_project
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.plan_file import read_plan
    from measureapp.project.rig_file import read_rig

    light = None if brightness is None else PartLight(white=brightness)
    progress = TerminalProgress()
    if plan.is_dir():
        if rig is not None or program is not None or calibration is not None:
            hint = "Name the plan's file, or omit --rig, --program and --calibration for a project."
            raise InputError(f"{plan} is a folder; a project has its own rig, program and calibration.", hint)
        return setup_of_project(ProjectFolder.open(plan), progress, light, form_mm)
    if rig is None or program is None:
        missing = "--rig" if rig is None else "--program"
        raise InputError(f"{missing} is missing for the plan {plan}.", "Give --rig and --program, or name a project folder.")
    calibrated = None if calibration is None else ProjectFolder.open(calibration)
    return setup_of_files(read_plan(plan), read_rig(rig), program, progress, calibrated=calibrated, light=light, form_mm=form_mm)


def _document(found: Prediction, advice: Advice | None) -> dict[str, Any]:
    document: dict[str, Any] = {
        "calibration": found.source,
        "views": [{"name": view.viewpoint_id, "points": len(view.cloud)} for view in found.views],
        "dimensions": [_dimension(one) for one in found.dimensions],
    }
    return document if advice is None else document | advice.document()


def _dimension(one: Dimension) -> dict[str, Any]:
    return {
        "name": one.name,
        "nominal": one.nominal,
        "unit": one.unit,
        "uncertainty": one.uncertainty,
        "budget": dict(one.budget),
        "reason": one.reason,
    }


def _lines(found: Prediction, advice: Advice | None) -> list[str]:
    lines = [f"Predicted for {len(found.views)} view{'s' * (len(found.views) > 1)}; {found.source}."]
    for one in found.dimensions:
        if one.uncertainty is None:
            lines.append(f"  {one.name}: not measured, {one.reason}")
            continue
        shares = ", ".join(f"{name} {size:.4f}" for name, size in one.rank_contributions())
        lines.append(f"  {one.name}: U = {one.uncertainty:.4f} {one.unit} (k = 2): {shares}")
    return lines if advice is None else [*lines, *advice.sentences]
