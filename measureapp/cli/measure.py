"""`measureapp measure`: dimensions of a cloud or mesh by an inspection program."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.calibrate.option_groups import with_groups
from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.outcome import alignment_lines, dimension_line
from measureapp.cli.part_options import PartState
from measureapp.cli.reply import JsonOption, TerminalProgress, UnitOption, reply
from measureapp.data.length_unit import LengthUnit
from measureapp.data.verdicts import ACCEPTED

if TYPE_CHECKING:
    from measureapp.inspection.settings import InspectionSettings


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    @with_groups
    def measure(
        cloud: Annotated[Path, typer.Argument(help="Cloud or mesh: PLY, STL, OBJ, PCD, XYZ.")],
        program: Annotated[Path, typer.Argument(help="Inspection program (TOML).")],
        alignment: Annotated[
            str | None,
            typer.Option(
                "--alignment",
                help="Alignment in place of the program's: best-fit, none, local:FEATURE,…, cyclic:COUNT, 3-2-1:PLANE,LINE,POINT, "
                "rps:POINT,POINT,POINT,… or datums:A,B,C.",
            ),
        ] = None,
        scale_ppm: Annotated[
            float,
            typer.Option(
                "--scale-ppm",
                min=0,
                max=1e6,
                help="Relative standard uncertainty of the length scale (class or certificate of the calibration board), in ppm.",
            ),
        ] = 0.0,
        part: PartState = PartState(),  # noqa: B008 - frozen
        unit: UnitOption = LengthUnit.MM,
        as_json: JsonOption = False,
    ) -> None:
        """Measure the dimensions of an inspection program; exit code 1 unless all pass."""
        from measureapp.data.verdicts import worst_first
        from measureapp.inspection.dimensions import inspect
        from measureapp.inspection.verdict import RULES
        from measureapp.project.geometry.files import read_cloud_or_mesh
        from measureapp.project.program_file import read_program, read_program_nominal, replace_alignment
        from measureapp.report.json_document import alignment_document, dimension_document, feature_document

        described = read_program(program)
        if alignment is not None:
            described = replace_alignment(described, alignment)
        nominal = read_program_nominal(program, described)
        settings = _settings(scale_ppm, part)
        inspection = inspect(read_cloud_or_mesh(cloud, unit=unit), described, nominal, settings, TerminalProgress())
        rule = RULES[settings.verdict_rule]
        document = {
            "program": inspection.program,
            "alignment": alignment_document(inspection.alignment),
            "alignments": {name: alignment_document(further) for name, further in inspection.further.items()},
            "features": [feature_document(feature) for feature in inspection.features],
            "dimensions": [dimension_document(dimension) for dimension in inspection.dimensions],
            "lengths": list(inspection.lengths),
            "verdict_rule": rule,
        }
        lines = [f"{inspection.program}. {alignment_lines(inspection.alignment)}"]
        lines += [f"{name}: {alignment_lines(further)}" for name, further in inspection.further.items()]
        reply(document, "\n".join([*lines, *map(dimension_line, worst_first(inspection.dimensions)), *inspection.lengths, rule]), as_json)
        if any(dimension.verdict not in ACCEPTED for dimension in inspection.dimensions):
            raise typer.Exit(OUT_OF_TOLERANCE)


def _settings(scale_ppm: float, part: PartState) -> InspectionSettings:
    """Return the settings of the options. Raises InputError for an absurd temperature."""
    from measureapp.inspection.settings import InspectionSettings, UncertaintySettings

    uncertainty = UncertaintySettings(scale_ppm=scale_ppm, scale_source="--scale-ppm" if scale_ppm else "not stated")
    return InspectionSettings(uncertainty=uncertainty, temperature=part.temperature())
