"""`measureapp join`: several set-ups of one part as one measurement."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import measurement_lines, report_event
from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.data.verdicts import has_passed
from measureapp.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from measureapp.data.setups import JoinedSetUp


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def join(
        projects: Annotated[list[Path], typer.Argument(help="Project folders, one per set-up; the first defines the part frame.")],
        out: Annotated[Path, typer.Option("--out", help="Folder of the new, joined project.", file_okay=False)],
        by: Annotated[
            Literal["overlap", "spheres", "nominal"],
            typer.Option("--by", help="Join by common surface, by reference spheres, or by common surface and the nominal."),
        ] = "overlap",
        turned: Annotated[
            list[str] | None,
            typer.Option(
                "--turned",
                metavar="NAME=X,Y,Z",
                help="Rough rotation of the part from the first set-up to this one, degrees about x, then y, then z; for a symmetric part.",
            ),
        ] = None,
        sphere_diameter: Annotated[
            float | None, typer.Option("--sphere-diameter-mm", min=1, help="Diameter of the reference spheres, for --by spheres.")
        ] = None,
        program: Annotated[Path | None, typer.Option(help="Inspection program; default: that of the first set-up that has one.")] = None,
        nominal: Annotated[
            Path | None, typer.Option(help="Nominal (STL, PLY, OBJ); default: that of the first set-up that has one.")
        ] = None,
        one_part: Annotated[
            bool, typer.Option("--one-part", help="The projects are of one part although they name it differently.")
        ] = False,
        as_json: JsonOption = False,
    ) -> None:
        """Join several set-ups of a part that was turned over or moved; exit code 1 unless all dimensions pass."""
        from measureapp.pipeline.setups import JoinOptions, join_projects
        from measureapp.project.documents import setup_document

        if by == "spheres" and sphere_diameter is None:
            raise InputError("--by spheres needs the diameter of the spheres.", "Add --sphere-diameter-mm.")
        for file in (program, nominal):
            if file is not None and not file.is_file():
                raise InputError(f"{file} does not exist.", "Give the path of an existing file.")
        options = JoinOptions(by, dict(map(_turn, turned or [])), sphere_diameter, program, nominal, one_part)
        outcome = join_projects(projects, out, options, report_event, TerminalProgress())
        setups = outcome.measurement.setups
        lines = [*measurement_lines(outcome.measurement), *_setup_lines(setups)]
        reply({**outcome.document, "setups": [setup_document(setup) for setup in setups]}, "\n".join(lines), as_json)
        if not has_passed(outcome.measurement):
            raise typer.Exit(OUT_OF_TOLERANCE)


def _turn(text: str) -> tuple[str, tuple[float, float, float]]:
    """Return name and rotation of `NAME=X,Y,Z`. Raises InputError."""
    name, _, angles = text.rpartition("=")
    try:
        x, y, z = (float(angle) for angle in angles.split(","))
    except ValueError:
        raise InputError(f"--turned {text}: not a name and three angles.", "Give --turned NAME=X,Y,Z in degrees.") from None
    if not name or not all(abs(angle) <= 360 for angle in (x, y, z)):
        raise InputError(f"--turned {text}: the name is missing, or an angle exceeds 360°.", "Give --turned NAME=X,Y,Z in degrees.")
    return name, (x, y, z)


def _setup_lines(setups: Sequence[JoinedSetUp]) -> list[str]:
    return [
        f"  {setup.name:<18}"
        + (
            "defines the part frame"
            if setup.method == "reference"
            else f"{setup.overlap:.0%} common, joint σ {setup.sigma_mm:.4f} mm and {setup.sigma_deg:.4f}°, residual {setup.residual_mm:.3f} mm"
        )
        for setup in setups
    ]
