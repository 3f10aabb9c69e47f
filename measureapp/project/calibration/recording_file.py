"""Reading of `RECORDING.toml`, of the certificate of its board, and the note that an imported project keeps about it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
from pydantic import ValidationError

from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.data.board import AnyBoard
from measureapp.data.model import Model
from measureapp.data.recording import AXES, Recording
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_text
from measureapp.project.tables import read_corners
from measureapp.project.text_document import read_toml

NOTE, KNOWN_CAMERAS = "recording.json", "known_cameras.json"
HINT = "Write the recording as `measureapp import --help` describes."
TABLES = ("board_view", "viewpoint")
MOST_NAMED = 5
LARGEST_MARK_ERROR = 0.05  # of the distance between neighbouring marks; a certificate that is further off belongs to another board


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


def certify(board: AnyBoard, path: Path) -> AnyBoard:
    """Return the board with the certified positions of its marks, moved rigidly onto the nominal grid.

    Raises
    ------
    InputError
        The certificate cannot be read, has other marks than the board, or differs from its grid by more than the printing could.
    """
    table = read_corners(path)
    positions, count = table.corners_mm.shape[:2]
    if positions != 1 or count != board.count:
        found = f"{count} marks" if positions == 1 else f"{positions} positions"
        raise InputError(
            f"{path} has {found}; a certificate of the {board.label} has one position with {board.count} marks.",
            "Number the marks from 0 row by row, all with the same position.",
        )
    nominal = board.nominal_corners_mm
    motion = rigid_motion(table.corners_mm[0], nominal)
    placed = table.corners_mm[0] @ motion[:3, :3].T + motion[:3, 3]
    off = float(np.linalg.norm(placed - nominal, axis=1).max())
    if off > LARGEST_MARK_ERROR * board.neighbour_mm:
        raise InputError(
            f"{path} is not a certificate of the {board.label} with {board.neighbour_mm:g} mm from mark to mark: "
            f"a mark is {off:.3g} mm from its place in the grid.",
            "Check the size given in [board], the unit of the certificate (mm), and that it numbers the marks row by row from 0.",
        )
    return board.model_copy(update={"certified_mm": tuple(tuple(mark) for mark in placed.tolist())})


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
