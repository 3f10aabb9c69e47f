"""`demo`: complete measurement on the virtual rig."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, report_event
from measureapp.cli.reply import UNIT_HELP, JsonOption, LanguageOption, TerminalProgress, reply
from measureapp.data.length_unit import LengthUnit, likely_unit
from measureapp.data.sample_worlds import DEFAULT_WORLD
from measureapp.data.shown_number import shown_number
from measureapp.data.verdicts import has_passed
from measureapp.errors import InputError
from measureapp.language.languages import ENGLISH


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def demo(
        out: Annotated[
            Path | None, typer.Option("--out", help="Folder of the new project; default: demo-PART-RESOLUTION here.", file_okay=False)
        ] = None,
        part: Annotated[str, typer.Option(help="impeller, gypsum, gear, sphere_plate, flat, or a mesh file (STL, PLY, OBJ).")] = "gypsum",
        viewpoints: Annotated[int | None, typer.Option(help="Number of viewpoints; default: depends on the part.")] = None,
        resolution: Annotated[Literal["full", "half", "quarter"], typer.Option(help="Resolution of the cameras.")] = "half",
        seed: Annotated[int, typer.Option(min=0, help="Seed of the virtual rig's hidden errors and noise.")] = 1,
        patterns: Annotated[str, typer.Option(help="Pattern set, see `measureapp patterns list`.")] = "three-close",
        auto_bracket: Annotated[
            float | None,
            typer.Option("--auto-bracket", min=0.1, help="Choose the exposures by a probe, for this many seconds per viewpoint."),
        ] = None,
        through_drivers: Annotated[
            bool, typer.Option("--through-drivers", help="Move robot, guide and table through their drivers and virtual peers on loopback.")
        ] = False,
        turn_deg: Annotated[
            tuple[float, float, float],
            typer.Option("--turn-deg", help="Rotate the part about x, then y, then z, before it is put on the table: a set-up for `join`."),
        ] = (0.0, 0.0, 0.0),
        rig: Annotated[
            str,
            typer.Option(
                "--rig",
                help="How well rig and part are made: ideal, good, usual, bad, or a world's TOML file; "
                "`ideal` is what the program's model describes exactly.",
            ),
        ] = DEFAULT_WORLD,
        unit: Annotated[LengthUnit | None, typer.Option(help=UNIT_HELP)] = None,
        language: LanguageOption = ENGLISH,
        as_json: JsonOption = False,
    ) -> None:
        """Calibrate, scan, stitch, measure and report on the virtual rig, and compare with the ground truth."""
        from measureapp.demo import DemoRequest, run_demo

        if unit is None:
            _ask_unit(Path(part))
        folder = out or Path(f"demo-{Path(part).stem}-{resolution}")
        request = DemoRequest(
            folder, part, resolution, viewpoints, seed, patterns, unit or LengthUnit.MM, auto_bracket, through_drivers, turn_deg, rig
        )
        outcome = run_demo(replace(request, language=language), report_event, TerminalProgress())
        deviation = outcome.document["truth_deviation"]
        lines = [
            *measurement_lines(outcome.measurement),
            f"Against the true surface: rms {deviation['rms']:.3f} mm, 95 % within {deviation['p95']:.3f} mm, "
            f"bias {shown_number(deviation['bias'], signed=True)} mm (kinematic positions: rms {deviation['kinematic_only']['rms']:.3f} mm).",
            *_truth_lines(outcome.document["true_dimensions"]),
            f"Report: {outcome.files['report_pdf']}",
        ]
        reply(outcome.document, "\n".join(lines), as_json)
        if not has_passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)


def _truth_lines(dimensions: list[dict[str, Any]]) -> list[str]:
    """Return a line about how many uncertainties contain the true values."""
    if not dimensions:
        return []
    outside = [
        f"{one['name']} ({shown_number(one['error'], signed=True)} mm, U {one['uncertainty']:.3f} mm)"
        for one in dimensions
        if not one["contains_truth"]
    ]
    told = f"True values within U: {len(dimensions) - len(outside)} of {len(dimensions)}"
    return [f"{told}; outside: {', '.join(outside)}." if outside else f"{told}."]


def _ask_unit(mesh: Path) -> None:
    """Ask for the unit of a mesh file with an implausible size in millimetres. Raises InputError."""
    from measureapp.simulate.part_file import mesh_span

    if not mesh.is_file():
        return
    span = mesh_span(mesh)
    unit = likely_unit(span)
    if unit is not LengthUnit.MM:
        raise InputError(
            f"{mesh} has a size of {span:.4g}: probably {unit.words}, that is {span * unit.in_mm:.4g} mm.",
            f"Confirm with `--unit {unit}`, or give `--unit mm` if it is in millimetres.",
        )
