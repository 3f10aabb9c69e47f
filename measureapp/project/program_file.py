"""Inspection programs and their nominals on disk."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from measureapp.data.alignment_program import FORMS
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.mesh import Mesh
from measureapp.errors import InputError
from measureapp.project.geometry.files import read_mesh
from measureapp.project.text_document import read_toml


def read_program(path: Path) -> InspectionProgram:
    """Read PROGRAM.toml.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML (the line is named), or holds a value or key that is not allowed
        (the place is named).
    """
    path = Path(path)
    return _validated(read_toml(path, "Give an inspection program in TOML."), str(path))


def program_from(text: str) -> InspectionProgram:
    """Return the program that a text in TOML is; raises InputError as `read_program`."""
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"The inspection program is not valid TOML: {error}.", "Correct the line named.") from error
    return _validated(document, "The inspection program")


def _validated(document: dict[str, Any], where: str) -> InspectionProgram:
    try:
        return InspectionProgram.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{where}: {_first_problem(error, document)}.", "Correct this entry of the inspection program.") from error


def with_alignment(program: InspectionProgram, words: str) -> InspectionProgram:
    """Return ``program`` with another alignment, given in one word like `best-fit` or `datums:A,B,C`. Raises InputError."""
    document = {**program.model_dump(exclude_unset=True), "alignment": words}
    try:
        return InspectionProgram.model_validate(document)
    except ValidationError as error:
        raise InputError(f"--alignment {words}: {_first_problem(error, document)}.", f"Give {FORMS}.") from error


def read_program_nominal(path: Path, program: InspectionProgram) -> Mesh | None:
    """Read the nominal mesh that the program at ``path`` names; None when it names none. Raises InputError."""
    if program.nominal is None:
        return None
    nominal = Path(path).parent / program.nominal
    if not nominal.is_file():
        raise InputError(f"{nominal}, the nominal named in {path}, does not exist.", "Put the mesh there or correct `nominal`.")
    return read_mesh(nominal, unit=program.nominal_unit)


def _first_problem(error: ValidationError, document: dict[str, object]) -> str:
    """Place and message of the first problem, with the name of the entry it lies in."""
    problem = error.errors()[0]
    place = list(problem["loc"])
    entry = _at(document, place[:2])
    if isinstance(entry, dict) and len(place) > 2 and place[2] == entry.get("shape"):
        del place[2]  # the shape by which pydantic told the kind of feature
    named = f" ({entry['name']!r})" if isinstance(entry, dict) and isinstance(entry.get("name"), str) else ""
    where = ".".join(str(part) for part in place)
    if problem["type"] == "extra_forbidden":
        return f"{where}{named} is not a known key"
    return f"{where or 'the program'}{named}: {problem['msg'].removeprefix('Value error, ')}"


def _at(document: Any, place: Sequence[int | str]) -> Any:
    for part in place:
        try:
            document = document[part]
        except (KeyError, IndexError, TypeError):
            return None
    return document
