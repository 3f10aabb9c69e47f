"""`calibrate again`: does a stored calibration follow from its stored inputs, to the last bit?"""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from measureapp.cli.calibrate.made_from import made_from_document
from measureapp.cli.main import OUT_OF_TOLERANCE, build
from measureapp.cli.reply import JsonOption, TerminalProgress, reply
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.project.differences import Difference

MOST_SHOWN = 10
SAVED = ("a calibration", "Give the file that a `calibrate` command saved with --out.")


def register(group: typer.Typer) -> None:
    """Add the command."""

    @group.command()
    def again(
        calibration: Annotated[Path, typer.Argument(help="Saved by a `calibrate` command with --out, or a project's folder.")],
        as_json: JsonOption = False,
    ) -> None:
        """Solve a stored calibration again from its inputs and compare every number; exit code 1 where one differs.

        What a wizard or `calibrate collect` accepted follows from the images that its session keeps. The inputs are checked against the
        checksums stored with the calibration first. Nothing is written.
        """
        from measureapp.pipeline.recalculate import is_collected

        place = calibration / "calibration" if (calibration / "project.json").is_file() else calibration
        if (place / "rig.json" if place.is_dir() else place).is_file() and is_collected(place):
            differences, compared, inputs = _session_again(place)
        elif calibration.is_dir():
            differences, compared, inputs = _project_again(calibration)
        else:
            differences, compared, inputs = _file_again(calibration)
        document = {
            "same": not differences,
            "numbers": compared,
            "inputs": inputs,
            "differences": [{"place": one.place, "stored": one.stored, "again": one.again} for one in differences],
        }
        reply(document, "\n".join(_lines(calibration, document)), as_json)
        if differences:
            raise typer.Exit(OUT_OF_TOLERANCE)


def _file_again(calibration: Path) -> tuple[Sequence[Difference], int, int]:
    from measureapp.project.differences import compare_documents
    from measureapp.project.text_document import read_toml_or_json

    stored = read_toml_or_json(calibration, *SAVED)
    made = made_from_document(stored, calibration)
    folder = calibration.resolve().parent / made.folder
    made.require_same_inputs(folder)
    with tempfile.TemporaryDirectory() as place:
        written = Path(place) / "again.json"
        arguments = (*made.arguments, "--out", str(written))
        with contextlib.chdir(folder), Path(os.devnull).open("w", encoding="utf-8") as nowhere, contextlib.redirect_stdout(nowhere):
            # a poor verdict (exit code 1) is not raised in this mode and is no obstacle
            build()(args=list(arguments), obj=arguments, prog_name="measureapp", standalone_mode=False)
        solved = read_toml_or_json(written, *SAVED)
    used = made_from_document(solved, calibration).inputs
    further = sorted(set(used) - set(made.inputs))
    if further:
        raise InputError(
            f"{folder / further[0]} matches now, but was not among the inputs of the calibration.", "Exclude later files from the pattern."
        )
    found, count = compare_documents(stored, solved)
    return found, count, len(made.inputs)


def _project_again(folder: Path) -> tuple[Sequence[Difference], int, int]:
    from measureapp.pipeline.recalculate import recalculate_project
    from measureapp.project.folder import ProjectFolder

    result = recalculate_project(ProjectFolder.open(folder), TerminalProgress())
    return result.differences, result.numbers, result.images


def _session_again(result: Path) -> tuple[Sequence[Difference], int, int]:
    from measureapp.pipeline.recalculate import recalculate_session

    found = recalculate_session(result, TerminalProgress())
    return found.differences, found.numbers, found.images


def _lines(calibration: Path, document: dict[str, Any]) -> list[str]:
    inputs = f"{document['inputs']} inputs have the checksums stored with it"
    if document["same"]:
        return [f"{calibration}: all {document['numbers']} numbers reproduced from its inputs, bit for bit; its {inputs}."]
    found = document["differences"]
    lines = [f"{calibration}: {len(found)} of {document['numbers']} numbers differ, though its {inputs}."]
    lines += [f"  {one['place']}: {one['stored']!r} is stored, {one['again']!r} follows" for one in found[:MOST_SHOWN]]
    return lines + ([f"  and {len(found) - MOST_SHOWN} more"] if len(found) > MOST_SHOWN else [])
