"""Reading of `RECORDING.toml`, and the note that an imported project keeps about it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

from pydantic import ValidationError

from measureapp.data.model import Model
from measureapp.data.recording import AXES, Recording
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_text
from measureapp.project.text_document import read_toml

NOTE, KNOWN_CAMERAS = "recording.json", "known_cameras.json"
HINT = "Write the recording as `measureapp import --help` describes."
TABLES = ("board_view", "viewpoint")
MOST_NAMED = 5


class RecordingNote(Model):
    """What an imported project remembers of its recording."""

    schema_version: Literal[1] = 1
    source: str  # name of the file
    digest: str  # of the file and all files it names
    axes: tuple[str, ...]  # that have read-backs; the others stand at rest
    in_cell: tuple[str, ...] = ()  # views of the board standing in the cell, not on the table
    loose: tuple[str, ...] = ()  # views of the board without read-backs: for the cameras only
    cameras_known: bool = False  # they are in `calibration/known_cameras.json`

    @property
    def missing_axes(self) -> tuple[str, ...]:
        """Axes without read-backs."""
        return tuple(name for name in AXES if name not in self.axes)


def read_recording(path: Path) -> Recording:
    """Read the file without the files that it names.

    Raises
    ------
    InputError
        It cannot be read, or has unknown or invalid fields; up to five are named at once.
    """
    path = Path(path)
    document = read_toml(path, "Give the path of a RECORDING.toml.")
    try:
        return Recording.model_validate(document)
    except ValidationError as error:
        found = [_problem(one) for one in error.errors()]
        raise InputError(f"{path}: {join_problems(found)}.", HINT) from error


def join_problems(found: list[str]) -> str:
    """Return problems as one part of a sentence, those beyond the fifth as a number."""
    more = len(found) - MOST_NAMED
    return "; ".join(found[:MOST_NAMED]) + (f"; and {more} more" if more > 0 else "")


def _problem(one: Any) -> str:
    """Return place and reason of one validation error; tables are numbered from 1, as a reader counts them."""
    parts = list(one["loc"])
    place = ""
    if len(parts) > 1 and parts[0] in TABLES and isinstance(parts[1], int):
        place, parts = f"[[{parts[0]}]] {parts[1] + 1}, ", parts[2:]
    place = (place + ".".join(str(part) for part in parts)).removesuffix(", ")
    reason = "is not a known field" if one["type"] == "extra_forbidden" else one["msg"].removeprefix("Value error, ")
    return f"{place}: {reason}" if place else reason


def write_note(project: Path, note: RecordingNote) -> None:
    """Write the note into the folder of a project. Raises StorageError."""
    write_text(project / NOTE, note.model_dump_json(indent=2) + "\n")


def read_note(project: Path) -> RecordingNote | None:
    """Read the note of a project; None if it was not imported. Raises StorageError when it is damaged."""
    path = Path(project) / NOTE
    if not path.exists():
        return None
    try:
        return RecordingNote.model_validate(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, RecursionError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore it from a backup, or import the recording again.") from error
