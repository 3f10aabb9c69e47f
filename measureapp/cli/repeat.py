"""`measureapp repeat`: several measurements of one part."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.main import OUT_OF_TOLERANCE
from measureapp.cli.reply import JsonOption, LanguageOption, reply
from measureapp.data.shown_number import shown_number
from measureapp.language.languages import ENGLISH

if TYPE_CHECKING:
    from measureapp.data.repeats import RepeatedDimension, RepeatStudy


def register(app: typer.Typer) -> None:
    """Add the command."""

    @app.command()
    def repeat(
        projects: Annotated[list[Path], typer.Argument(help="Project folders, each one measurement of the part.")],
        out: Annotated[Path | None, typer.Option("--out", help="Folder for repeats.pdf, .csv and .json.", file_okay=False)] = None,
        one_part: Annotated[
            bool, typer.Option("--one-part", help="The projects are of one part although they name it differently.")
        ] = False,
        language: LanguageOption = ENGLISH,
        as_json: JsonOption = False,
    ) -> None:
        """Mean and spread of every dimension over several measurements of one part; exit code 1 if a spread contradicts the stated U."""
        from measureapp.pipeline.repeats import compare_repeats
        from measureapp.report.repeats.documents import write_repeats
        from measureapp.report.repeats.json_document import study_document

        study = compare_repeats(projects, one_part=one_part)
        files = {} if out is None else write_repeats(study, out, language)
        reply({**study_document(study), "files": files}, "\n".join(_lines(study) + [str(path) for path in files.values()]), as_json)
        if study.contradictions:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _lines(study: RepeatStudy) -> list[str]:
    title = f"{study.part}: {len(study.measurements)} measurements, program {study.program}."
    return [title, *map(_dimension_line, study.dimensions), *study.sentences]


def _dimension_line(one: RepeatedDimension) -> str:
    if one.mean is None or one.deviation is None:
        return f"  {one.name:<18}not measured"
    spread = "" if one.std is None else f" ± {one.mean_half_width:.4f}, s {one.std:.4f}"
    relative = "" if one.relative is None else f", {shown_number(100 * one.relative, signed=True)}%"
    return f"  {one.name:<18}{one.mean:9.3f}{spread} {one.unit} (n {one.n}; nominal {one.nominal:g}, deviation {shown_number(one.deviation, signed=True)}{relative})"
