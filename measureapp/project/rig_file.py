"""Files of rig descriptions: TOML, or the name of one shipped with the program."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.project.text_document import read_toml
from measureapp.resources import resource


def read_rig(name_or_path: str | Path) -> RigDescription:
    """Read the rig description of this name in `resources/rigs`, or a TOML file.

    Raises
    ------
    InputError
        Naming the file and the invalid field.
    """
    path = Path(name_or_path)
    if not path.suffix:
        path = _find_rig(path.name)
    document = read_toml(path, "Name a rig description (TOML).")
    try:
        return RigDescription.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the rig')}.", "Correct this field.") from error


def _find_rig(name: str) -> Path:
    known = {path.stem: path for path in sorted(resource("rigs").glob("*.toml"))}
    if name not in known:
        raise InputError(f"There is no rig {name!r}.", f"Give a rig description (TOML), or one of: {', '.join(known)}.")
    return known[name]
