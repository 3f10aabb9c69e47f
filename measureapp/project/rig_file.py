"""Files of rig descriptions: TOML, or the name of one shipped with the program."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import ValidationError

from measureapp.data.model import first_problem, toml_values
from measureapp.data.rig import RECORDED, RigDescription
from measureapp.errors import InputError
from measureapp.project.atomic import write_text
from measureapp.project.text_document import read_toml
from measureapp.resources import resource

ABSENT = "none"
AT_ORIGIN = {"position_mm": (0.0, 0.0, 0.0), "rotation_deg": (0.0, 0.0, 0.0)}
ABSENT_AXES: dict[str, Any] = {
    "robot": {
        "model": ABSENT,
        "shoulder_mm": (0.0, 0.0, 0.0),
        **dict.fromkeys(
            ("min_reach_mm", "max_reach_mm", "repeatability_mm", "absolute_accuracy_mm", "absolute_accuracy_deg"),
            0.0,
        ),
    },
    "guide": {"model": ABSENT, "limits_mm": (0.0, 0.0), "repeatability_mm": 0.0},
    "table": {
        "model": ABSENT,
        "diameter_mm": 0.0,
        "limits_deg": (0.0, 0.0),
        "accuracy_arcsec": 0.0,
        "repeatability_arcsec": 0.0,
        "centre_in_guide_mm": (0.0, 0.0, 0.0),
    },
    "flange_from_head": AT_ORIGIN,
}
"""Axes that a recorded rig may lack: at rest, and without any error of their own."""
TOML_TEXT = re.compile(r'"""(?:\\.|[^\\])*?"""|\'\'\'.*?\'\'\'|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\'', re.DOTALL)
"""The four kinds of texts in TOML, in which # begins no comment."""
UNKNOWN = "unknown"
TYPICAL_AXES: dict[str, dict[str, Any]] = {
    "robot": {"model": UNKNOWN, "repeatability_mm": 0.02, "absolute_accuracy_mm": 0.3, "absolute_accuracy_deg": 0.02},
    "guide": {"model": UNKNOWN, "repeatability_mm": 0.002},
    "table": {"model": UNKNOWN, "accuracy_arcsec": 20.0, "repeatability_arcsec": 6.0},
}
"""Typical errors of axes that have read-backs but no description."""


def read_rig(name_or_path: str | Path) -> RigDescription:
    """Read the rig description of this name in `resources/rigs`, or a TOML file.

    A recorded rig (driver "recorded") may be described without the axes that it does not have.

    Raises
    ------
    InputError
        Naming the file and the invalid field.
    """
    path = Path(name_or_path)
    if not path.suffix:
        path = _find_rig(path.name)
    document = read_toml(path, "Name a rig description (TOML).")
    if document.get("driver") == RECORDED:
        document = {**ABSENT_AXES, **document}
    try:
        return RigDescription.model_validate(document)
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the rig')}.", "Correct this field.") from error


def assume_axes(rig: RigDescription, moving: Iterable[str]) -> RigDescription:
    """Return a recorded rig with typical errors of the axes in ``moving`` ("robot", "guide", "table") that are not described."""
    assumed = {name: getattr(rig, name).model_copy(update=TYPICAL_AXES[name]) for name in moving if getattr(rig, name).model == ABSENT}
    return rig.model_copy(update=assumed)


def write_rig(path: Path, description: RigDescription) -> None:
    """Write a rig description as TOML, without what has its default value; comments of an earlier file are lost.

    Raises
    ------
    StorageError
        It cannot be written; an earlier file stays as it was.
    """
    write_text(path, tomli_w.dumps({"schema_version": description.schema_version, **toml_values(description)}))


def has_comments(path: Path) -> bool:
    """Return whether a TOML file has comments, which writing it anew would delete; a file that is not there has none.

    Raises
    ------
    InputError
        The file is there and cannot be read.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        return False
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path} cannot be read: {error}.", "Choose another file.") from error
    return "#" in TOML_TEXT.sub("", text)


def _find_rig(name: str) -> Path:
    known = {path.stem: path for path in sorted(resource("rigs").glob("*.toml"))}
    if name not in known:
        raise InputError(f"There is no rig {name!r}.", f"Give a rig description (TOML), or one of: {', '.join(known)}.")
    return known[name]
