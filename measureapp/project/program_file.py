"""Files of inspection programs and their nominals."""

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
    """Read an inspection program from TOML.

    Raises
    ------
    InputError
        The file cannot be read, is not TOML (names the line), or contains an invalid value or key (names the entry).
    """
    path = Path(path)
    return _validate(read_toml(path, "Give an inspection program in TOML."), str(path))


def parse_program(text: str) -> InspectionProgram:
    """Parse an inspection program in TOML; raises InputError as `read_program`."""
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"The inspection program is not valid TOML: {error}.", "Correct the line named.") from error
    return _validate(document, "The inspection program")


def _validate(document: dict[str, Any], where: str) -> InspectionProgram:
    try:
        return InspectionProgram.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{where}: {_first_problem(error, document)}.", "Correct this entry of the inspection program.") from error


def replace_alignment(program: InspectionProgram, words: str) -> InspectionProgram:
    """Replace the alignment of ``program`` by one in the short form, such as `best-fit` or `datums:A,B,C`. Raises InputError."""
    document = {**program.model_dump(exclude_unset=True), "alignment": words}
    try:
        return InspectionProgram.model_validate(document)
    except ValidationError as error:
        problem = _first_problem(error, document).removesuffix(f": give {FORMS}")  # which the remedy says
        raise InputError(f"--alignment {words}: {problem}.", f"Give {FORMS}.") from error


def read_program_nominal(path: Path, program: InspectionProgram) -> Mesh | None:
    """Read the nominal mesh of the program at ``path``; None if it has none. Raises InputError."""
    if program.nominal is None:
        return None
    nominal = Path(path).parent / program.nominal
    if not nominal.is_file():
        raise InputError(f"{nominal}, the nominal named in {path}, does not exist.", "Copy the mesh there, or correct `nominal`.")
    return read_mesh(nominal, unit=program.nominal_unit)


def _first_problem(error: ValidationError, document: dict[str, object]) -> str:
    """Return place and message of the first validation error, with the name of its entry."""
    problem = error.errors()[0]
    place = list(problem["loc"])
    entry = _at(document, place[:2])
    if isinstance(entry, dict) and len(place) > 2 and place[2] == entry.get("shape"):
        del place[2]  # the discriminator that pydantic inserts
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
